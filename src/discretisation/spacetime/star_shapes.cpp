#include "discretisation/spacetime/star_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace cleave::discretisation::spacetime {
namespace {

constexpr int many = 8;           ///< simplices to one shape where a mesh repeats itself
constexpr double rounding = 8.0;  ///< times the machine's precision: what congruent coordinates differ by
constexpr double coarse = 1.0 / 4096;  ///< of the star's size: rounded numbers by which stars are sorted

constexpr double relative = 1e-6;  ///< difference of lengths that are not the same

/// A star with what must agree exactly.
template <int D>
struct Star {
  StarShape<D> shape;
  std::vector<std::int64_t> sorted_by;
  double size = 0.0;
};

template <int D>
Star<D> star_at(const SpaceMesh<D>& mesh, Vertex v) {
  Star<D> out;
  const auto star = mesh.star(v);
  const Point<D>& centre = mesh.position()[static_cast<std::size_t>(v)];
  for (const Simplex s : star) {
    std::array<std::pair<Vertex, int>, D> others;
    for (int i = 0, to = 0; i <= D; ++i)
      if (const Vertex w = mesh.simplex(s)[static_cast<std::size_t>(i)]; w != v)
        others[static_cast<std::size_t>(to++)] = {w, i};
    std::sort(others.begin(), others.end());
    auto& corner = out.shape.corner.emplace_back();
    out.sorted_by.push_back(mesh.material(s));
    for (std::size_t i = 0; i < D; ++i) {
      corner[i] = difference(mesh.position()[static_cast<std::size_t>(others[i].first)], centre);
      out.size = std::max(out.size, norm(corner[i]));
      const Simplex across = mesh.across(s, others[i].second);
      out.sorted_by.push_back(across < 0 ? -1
                                         : std::lower_bound(star.begin(), star.end(), across) - star.begin());
    }
  }
  // A size that is a power of two must not fall to either side of it.
  const double unit = coarse * std::exp2(std::floor(std::log2(1.1 * out.size)));
  for (const auto& corner : out.shape.corner)
    for (const Point<D>& x : corner)
      for (const double c : x) out.sorted_by.push_back(std::llround(c / unit));
  out.sorted_by.push_back(std::llround(std::log2(unit) * 64.0));
  return out;
}

template <int D>
bool alike(const StarShape<D>& a, const StarShape<D>& b, double tolerance) {
  for (std::size_t e = 0; e < a.corner.size(); ++e)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k)
        if (!(std::fabs(a.corner[e][i][k] - b.corner[e][i][k]) <= tolerance)) return false;
  return true;
}

/// Are there few lengths of edges among the simplices? @param graded  do their sizes differ?
template <int D>
bool repeats(const SpaceMesh<D>& mesh, bool& graded) {
  std::set<std::array<std::int64_t, D*(D + 1) / 2 + 1>> shapes;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (Simplex s = 0; s < mesh.simplex_count(); ++s) {
    std::array<double, D*(D + 1) / 2> length;
    std::size_t at = 0;
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t j = 0; j < i; ++j)
        length[at++] = distance(mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[i])],
                                mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[j])]);
    std::sort(length.begin(), length.end());
    least = std::min(least, length.back()), most = std::max(most, length.back());
    std::array<std::int64_t, D*(D + 1) / 2 + 1> key{mesh.material(s)};
    for (std::size_t i = 0; i < length.size(); ++i) key[i + 1] = std::llround(std::log(length[i]) / relative);
    shapes.insert(key);
    if (many * static_cast<Simplex>(shapes.size()) > mesh.simplex_count()) return false;
  }
  graded = most > 1.5 * least;
  return true;
}

}  // namespace

template <int D>
StarShapes<D>::StarShapes(const SpaceMesh<D>& mesh)
    : shape_of_(static_cast<std::size_t>(mesh.vertex_count()), -1) {
  double largest = 0.0;
  for (const Point<D>& x : mesh.position())
    for (const double c : x) largest = std::max(largest, std::fabs(c));
  const double tolerance = rounding * std::numeric_limits<double>::epsilon() * largest;

  if (!repeats(mesh, graded_)) return;
  repeating_ = true;
  std::map<std::vector<std::int64_t>, std::vector<std::int32_t>> known;
  for (Vertex v = 0; v < mesh.vertex_count(); ++v) {
    Star<D> star = star_at(mesh, v);
    auto& candidates = known[star.sorted_by];
    std::int32_t& shape = shape_of_[static_cast<std::size_t>(v)];
    for (const std::int32_t c : candidates)
      if (alike(shapes_[static_cast<std::size_t>(c)], star.shape, tolerance)) shape = c;
    if (shape >= 0) continue;
    shape = static_cast<std::int32_t>(shapes_.size());
    candidates.push_back(shape);
    shapes_.push_back(std::move(star.shape));
  }
}

template class StarShapes<1>;
template class StarShapes<2>;
template class StarShapes<3>;

}  // namespace cleave::discretisation::spacetime
