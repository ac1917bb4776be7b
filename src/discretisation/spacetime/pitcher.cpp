#include "discretisation/spacetime/pitcher.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// What a top on the lattice of times keeps of the allowed height. On a uniform mesh the front settles into
/// few shapes by itself; where sizes change, only a coarse lattice brings the same shapes back.
constexpr double kept_if_uniform = 0.9, kept_if_graded = 0.5;
constexpr double lattice_over_shortest = 1.2;  ///< time of a wave along the shortest edge; measured
constexpr int finest_step = 8;                 ///< of the lattice: 2^-8 of the height's power of two

/// Volume over the volume of a corner of a cube with the longest edge: 1 at best in 1D, 0.87 in 2D, 0.71 in
/// 3D.
template <int D>
double quality(const std::array<Point<D>, D + 1>& corner) {
  double longest = 0.0, factorial = 1.0;
  for (std::size_t i = 0; i <= D; ++i) {
    for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(corner[i], corner[j]));
    if (i > 0) factorial *= static_cast<double>(i);
  }
  return factorial * signed_volume<static_cast<std::size_t>(D)>(corner) / std::pow(longest, D);
}

}  // namespace

template <int D>
std::string complaint(const PitchOptions& options) {
  if (!(options.chi > 0.0 && options.chi <= 1.0)) return "chi must lie between 0 and 1";
  if (!(options.eps > 0.0 && options.eps <= 0.5)) return "eps must be positive and at most 1/2";
  if (!(options.height_factor > 0.0 && options.height_factor <= 1.0))
    return "the height factor must be positive and at most 1";
  if (!(options.height_cap > 0.0)) return "the height cap must be positive";
  if (!(options.smoothing >= 0.0 && options.smoothing <= 1.0)) return "smoothing must lie between 0 and 1";
  if (D != 2 && (options.progress == Progress::high_mid || options.progress == Progress::budget))
    return "this progress constraint is for two dimensions";
  return {};
}

template <int D>
Pitcher<D>::Pitcher(const SpaceMesh<D>& mesh, const PitchOptions& options) : mesh_(mesh), options_(options) {
  CLEAVE_ASSERT(complaint<D>(options).empty(), "options of the pitcher must be checked by the caller");
  // A vertex that moves changes its star.
  if (!options.repeat || options.smoothing > 0.0) return;
  shapes_ = StarShapes<D>(mesh);
  if (!shapes_.repeating()) return;
  kept_ = shapes_.graded() ? kept_if_graded : kept_if_uniform;
  double shortest = std::numeric_limits<double>::infinity();
  for (Simplex s = 0; s < mesh.simplex_count(); ++s)
    for (std::size_t i = 1; i <= D; ++i)
      shortest = std::min(shortest, distance(mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[0])],
                                             mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[i])]) /
                                        mesh.speed(s).fastest);
  // So few bits that multiples are exact, whatever the unit of length.
  int exponent = 0;
  const double share = std::frexp(lattice_over_shortest * shortest, &exponent);
  lattice_ = std::ldexp(std::round(std::ldexp(share, 16)), exponent - 16);
}

template <int D>
Front<D> Pitcher<D>::level_front(double time) const {
  Front<D> front;
  front.position = mesh_.position();
  front.time.assign(front.position.size(), time);
  if constexpr (D == 2) {
    if (options_.progress == Progress::budget) {
      front.budget.resize(static_cast<std::size_t>(mesh_.simplex_count()));
      for (Simplex s = 0; s < mesh_.simplex_count(); ++s)
        front.budget[static_cast<std::size_t>(s)] = root_budget(cell(front, s), options_.eps);
    }
  }
  return front;
}

template <int D>
bool Pitcher<D>::lowest(const Front<D>& front, Vertex v) const {
  const Key mine = key(front, v);
  for (const Vertex w : mesh_.neighbours(v))
    if (key(front, w) < mine) return false;
  return true;
}

template <int D>
Cell<D> Pitcher<D>::cell(const Front<D>& front, Simplex s) const {
  Cell<D> cell;
  const auto& simplex = mesh_.simplex(s);
  for (std::size_t i = 0; i <= D; ++i) {
    cell.corner[i] = front.position[static_cast<std::size_t>(simplex[i])];
    cell.time[i] = front.time[static_cast<std::size_t>(simplex[i])];
  }
  cell.bound = options_.chi / mesh_.speed(s).fastest;
  if (!front.budget.empty()) cell.budget = front.budget[static_cast<std::size_t>(s)];
  return cell;
}

template <int D>
std::size_t Pitcher<D>::corner_of(Simplex s, Vertex v) const {
  const auto& simplex = mesh_.simplex(s);
  return static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), v) - simplex.begin());
}

template <int D>
double Pitcher<D>::limit(const Front<D>& front, Vertex v) const {
  double limit = std::numeric_limits<double>::infinity();
  for (const Simplex s : mesh_.star(v))
    limit = std::min(limit, rise_limit<D>(cell(front, s), corner_of(s, v), options_.progress, options_.eps));
  return limit;
}

/// The height policy: factor, cap, lattice, and no slivers before the end.
template <int D>
double Pitcher<D>::top_time(double foot, double limit, double end_time) const {
  const double height = std::min(options_.height_factor * (limit - foot), options_.height_cap);
  const double top = foot + height, left = end_time - top;
  if (left <= 1e-12 * height) return end_time;
  if (left < 0.3 * height) return foot + 0.5 * (end_time - foot);
  if (kept_ == 1.0 || !(height > 0.0)) return top;
  double step = lattice_ * std::exp2(std::floor(std::log2(height / lattice_)));
  for (int k = 0; k <= finest_step; ++k, step *= 0.5) {
    const double on_lattice = std::floor(top / step) * step;
    if (on_lattice - foot >= kept_ * height) return on_lattice;
  }
  return top;
}

template <int D>
Pole<D> Pitcher<D>::pitch(const Front<D>& front, Vertex v, double end_time) const {
  Point<D> displacement{};
  if (options_.smoothing > 0.0) {
    const auto around = mesh_.neighbours(v);
    for (const Vertex w : around)
      for (std::size_t k = 0; k < D; ++k) displacement[k] += front.position[static_cast<std::size_t>(w)][k];
    for (std::size_t k = 0; k < D; ++k)
      displacement[k] = options_.smoothing * (displacement[k] / static_cast<double>(around.size()) -
                                              front.position[static_cast<std::size_t>(v)][k]);
  }
  return pitch_towards(front, v, end_time, displacement);
}

template <int D>
Pole<D> Pitcher<D>::pitch_towards(const Front<D>& front, Vertex v, double end_time,
                                  Point<D> displacement) const {
  Pole<D> pole{
      .vertex = v, .foot = front.event(v), .top = front.event(v), .inclined = false, .shape = nullptr};
  if (kept_ < 1.0) pole.shape = shapes_.of(v);
  pole.top[D] = top_time(pole.foot[D], limit(front, v), end_time);
  const double height = pole.height();
  // What rounding leaves of a stalled vertex is no tent.
  double crossing = std::numeric_limits<double>::infinity();  // time of a wave to the nearest neighbour
  for (const Simplex s : mesh_.star(v))
    for (const Vertex w : mesh_.simplex(s))
      if (w != v)
        crossing = std::min(crossing, distance(front.position[static_cast<std::size_t>(v)],
                                               front.position[static_cast<std::size_t>(w)]) /
                                          mesh_.speed(s).fastest);
  if (!(height > 1e-12 * crossing)) {
    if (!(pole.top[D] == end_time && height > 0.0)) pole.top[D] = pole.foot[D];
    return pole;
  }

  mesh_.keep_on_boundary(v, displacement);
  if (norm(displacement) == 0.0) return pole;
  double slowest = std::numeric_limits<double>::infinity(), size = 0.0;
  for (const Simplex s : mesh_.star(v)) slowest = std::min(slowest, mesh_.speed(s).slowest);
  for (const Vertex w : mesh_.neighbours(v))
    size = std::max(size, distance(front.position[static_cast<std::size_t>(v)],
                                   front.position[static_cast<std::size_t>(w)]));
  double length = norm(displacement);
  const double reach = 0.5 * slowest * height;
  if (length > reach)
    for (double& component : displacement) component *= reach / length;
  for (int halving = 0; halving <= 4; ++halving) {
    length = norm(displacement);
    if (length <= 1e-6 * size) break;  // not worth a tilted facet
    if (incline(front, end_time, height, displacement, pole)) break;
    for (double& component : displacement) component *= 0.5;
  }
  return pole;
}

/// Tries a pole whose top is displaced; changes it when every check passes.
template <int D>
bool Pitcher<D>::incline(const Front<D>& front, double end_time, double vertical_height,
                         const Point<D>& displacement, Pole<D>& pole) const {
  const Vertex v = pole.vertex;
  const auto star = mesh_.star(v);
  Point<D> moved = front.position[static_cast<std::size_t>(v)];
  for (std::size_t k = 0; k < D; ++k) moved[k] += displacement[k];

  const auto moved_cell = [&](Simplex s) {
    Cell<D> after = cell(front, s);
    after.corner[corner_of(s, v)] = moved;
    if constexpr (D == 2) {  // its budget restarts with the new shape
      if (options_.progress == Progress::budget) after.budget = root_budget(after, options_.eps);
    }
    return after;
  };

  // (i) orientation and quality, (ii) how high the moved top may stand
  double worst_before = 1.0, worst_after = 1.0, latest = std::numeric_limits<double>::infinity();
  double slowest = std::numeric_limits<double>::infinity();
  for (const Simplex s : star) {
    const Cell<D> after = moved_cell(s);
    worst_before = std::min(worst_before, quality<D>(cell(front, s).corner));
    worst_after = std::min(worst_after, quality<D>(after.corner));
    if (!(worst_after > 0.0)) return false;
    latest = std::min(latest, rise_limit<D>(after, corner_of(s, v), options_.progress, options_.eps));
    slowest = std::min(slowest, mesh_.speed(s).slowest);
  }
  if (worst_after < std::min(options_.quality_floor, worst_before)) return false;
  const double top = top_time(pole.foot[D], latest, end_time), height = top - pole.foot[D];
  if (!(height >= 0.5 * vertical_height)) return false;  // smoothing must not starve the front

  // (iii) every bound of the moved simplices, not only those that limit v, (iv) the facets stay subsonic
  if (norm(displacement) > 0.5 * slowest * height) return false;
  for (const Simplex s : star) {
    Cell<D> after = moved_cell(s);
    after.time[corner_of(s, v)] = top;
    if (!(spacetime::strain_on_bounds<D>(after, options_.progress, options_.eps) <= 1.0 + 1e-12))
      return false;
  }
  for (std::size_t k = 0; k < D; ++k) pole.top[k] = moved[k];
  pole.top[D] = top;
  pole.inclined = true;
  return true;
}

template <int D>
void Pitcher<D>::commit(Front<D>& front, const Pole<D>& pole) const {
  const auto v = static_cast<std::size_t>(pole.vertex);
  front.time[v] = pole.top[D];
  if (!pole.inclined) return;
  for (std::size_t k = 0; k < D; ++k) front.position[v][k] = pole.top[k];
  if constexpr (D == 2) {
    if (!front.budget.empty())
      for (const Simplex s : mesh_.star(pole.vertex))
        front.budget[static_cast<std::size_t>(s)] = root_budget(cell(front, s), options_.eps);
  }
}

template <int D>
double Pitcher<D>::sure_gain(const Front<D>& front, Vertex v) const {
  double gain = std::numeric_limits<double>::infinity();
  for (const Simplex s : mesh_.star(v))
    gain = std::min(
        gain, spacetime::sure_gain<D>(cell(front, s), corner_of(s, v), options_.progress, options_.eps));
  return gain;
}

template <int D>
double Pitcher<D>::strain_on_bounds(const Front<D>& front, Simplex s) const {
  return spacetime::strain_on_bounds<D>(cell(front, s), options_.progress, options_.eps);
}

template std::string complaint<1>(const PitchOptions&);
template std::string complaint<2>(const PitchOptions&);
template std::string complaint<3>(const PitchOptions&);
template class Pitcher<1>;
template class Pitcher<2>;
template class Pitcher<3>;

}  // namespace cleave::discretisation::spacetime
