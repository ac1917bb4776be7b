#include "discretisation/spacetime/observe.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/cut.hpp"

namespace cleave::discretisation::spacetime {
namespace {

constexpr std::size_t grain = 256;          // simplices of one partial sum
constexpr int initial_points_per_axis = 6;  // for the initial state, which may be any function

/// Time derivative of the velocity of a solution.
template <int D>
Vector<D> acceleration(const Solution<D>& u, const Event<D>& y) {
  const auto& basis = Basis<D + 1>::get();
  const int n = polynomial_count(D + 1, u.degree);
  double phi[Basis<D + 1>::count];
  const auto lambda = u.map(y);
  basis.evaluate(lambda.data(), u.degree, phi);
  Vector<D> a{};
  for (int k = 0; k < n; ++k) {
    double rate = 0.0;
    const int below = polynomial_count(D + 1, basis.degree_of(k) - 1);
    for (int l = 1; l <= D + 1; ++l) {
      const double* slope = basis.slope(l, k);
      double sum = 0.0;
      for (int b = 0; b < below; ++b) sum += slope[b] * phi[b];
      rate += u.map.gradient[l - 1][D] * sum;
    }
    for (int i = 0; i < D; ++i) a[i] += rate * u.fields[static_cast<std::size_t>(i * n + k)];
  }
  return a;
}

template <int D>
double space_volume(const SpaceMesh<D>& mesh, Simplex s) {
  std::array<Point<D>, D + 1> corner;
  for (std::size_t c = 0; c <= D; ++c)
    corner[c] = mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[c])];
  return std::fabs(signed_volume<D>(corner));
}

template <int D>
void add(PartSums<D>& sums, const Elastic<D>& m, const PointState<D>& state, double volume) {
  const Voigt<D> stress = m.stress(state.strain);
  sums.mass += volume * m.density;
  for (std::size_t i = 0; i < D; ++i) {
    sums.momentum[i] += volume * m.density * state.v[i];
    sums.kinetic += 0.5 * volume * m.density * state.v[i] * state.v[i];
  }
  for (int c = 0; c < strain_count<D>; ++c)
    sums.internal += 0.5 * volume * work_factor<D>(c) * stress[c] * state.strain[c];
}

}  // namespace

/// Calls visit(corners in spacetime, volume, element) for each piece of the cut above a simplex; at the start
/// for the whole simplex, with no element.
template <int D>
template <class Visit>
void Instant<D>::each_piece(Simplex s, const Visit& visit) const {
  const auto volume_of = [](const std::array<Event<D>, D + 1>& corner) {
    std::array<Point<D>, D + 1> x;
    for (std::size_t c = 0; c <= D; ++c) std::copy_n(corner[c].begin(), D, x[c].begin());
    return std::fabs(signed_volume<D>(x));
  };
  std::array<Event<D>, D + 1> corner;
  if (time_ <= 0.0) {
    for (std::size_t c = 0; c <= D; ++c) {
      const Point<D>& x = body_.mesh.position()[static_cast<std::size_t>(body_.mesh.simplex(s)[c])];
      std::copy_n(x.begin(), D, corner[c].begin());
      corner[c][D] = time_;
    }
    visit(corner, volume_of(corner), static_cast<const SolvedElement<D>*>(nullptr));
    return;
  }
  for (const SolvedElement<D>& element : columns_.column(s)) {
    if (element.begin() >= time_ || element.end() < time_) continue;
    std::array<double, D + 2> time;
    for (std::size_t c = 0; c < D + 2; ++c) time[c] = element.corner[c][D];
    cut<D + 2>(time, time_, [&](const Piece<D + 2, D + 1>& piece) {
      for (std::size_t c = 0; c <= D; ++c) {
        corner[c] = {};
        for (std::size_t a = 0; a < D + 2; ++a)
          for (std::size_t k = 0; k < D; ++k) corner[c][k] += piece[c][a] * element.corner[a][k];
        corner[c][D] = time_;
      }
      visit(corner, volume_of(corner), &element);
    });
  }
}

template <int D>
std::vector<PartSums<D>> Instant<D>::sums() const {
  const std::size_t parts = body_.problem.materials.size();
  const auto count = static_cast<std::size_t>(body_.mesh.simplex_count());
  std::vector<std::vector<PartSums<D>>> partial((count + grain - 1) / grain);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<PartSums<D>> mine(parts);
    std::vector<Event<D>> points;
    std::vector<PointState<D>> states;
    for (std::size_t k = begin; k < end; ++k) {
      const auto s = static_cast<Simplex>(k);
      const auto material = static_cast<std::size_t>(body_.mesh.material(s));
      const Elastic<D>& elastic = body_.problem.materials[material];
      each_piece(s, [&](const auto& corner, double volume, const SolvedElement<D>* element) {
        const SimplexRule& rule =
            simplex_rule(D, element ? element->solution.degree + 1 : initial_points_per_axis);
        points.assign(static_cast<std::size_t>(rule.points), Event<D>{});
        states.assign(points.size(), {});
        for (std::size_t q = 0; q < points.size(); ++q)
          for (std::size_t c = 0; c <= D; ++c)
            for (std::size_t i = 0; i <= D; ++i)
              points[q][i] += rule.barycentric[q * (D + 1) + c] * corner[c][i];
        if (element) {
          element->solution.at(points, states);
        } else if (body_.problem.initial) {
          for (std::size_t q = 0; q < points.size(); ++q) states[q] = body_.problem.initial(s, points[q]);
        }
        for (std::size_t q = 0; q < points.size(); ++q)
          add(mine[material], elastic, states[q], volume * rule.weight[q]);
      });
    }
    partial[begin / grain] = std::move(mine);
  });
  std::vector<PartSums<D>> total(parts);
  for (const auto& mine : partial)
    for (std::size_t p = 0; p < parts; ++p) {
      total[p].mass += mine[p].mass;
      total[p].kinetic += mine[p].kinetic;
      total[p].internal += mine[p].internal;
      for (std::size_t i = 0; i < D; ++i) total[p].momentum[i] += mine[p].momentum[i];
    }
  return total;
}

template <int D>
Exchange<D> Instant<D>::exchanged(const Outside<D>& outside) const {
  const auto count = static_cast<std::size_t>(body_.mesh.simplex_count());
  std::vector<Exchange<D>> partial((count + grain - 1) / grain);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    Exchange<D>& mine = partial[begin / grain];
    for (std::size_t s = begin; s < end; ++s) {
      mine += columns_.past()[s];
      for (const SolvedElement<D>& element : columns_.column(static_cast<Simplex>(s))) {
        if (element.end() <= time_)
          mine += element.exchange;
        else if (element.begin() < time_)
          mine += outside.before(static_cast<Simplex>(s), element, time_);
      }
    }
  });
  Exchange<D> total;
  for (const Exchange<D>& mine : partial) total += mine;
  return total;
}

template <int D>
void Instant<D>::reactions(const Outside<D>& outside, std::span<const char> wanted,
                           std::span<Vector<D>> force) const {
  Simplex last = -1;  // faces are listed by simplex
  for (const BoundaryFace<D>& face : body_.mesh.boundary()) {
    if (face.simplex == last) continue;
    last = face.simplex;
    for (const SolvedElement<D>& element : columns_.column(face.simplex))
      outside.reactions(face.simplex, element, time_, wanted, force);
  }
}

template <int D>
double Instant<D>::volume() const {
  double sum = 0.0;
  for (Simplex s = 0; s < body_.mesh.simplex_count(); ++s)
    each_piece(s, [&](const auto&, double volume, const SolvedElement<D>*) { sum += volume; });
  return sum;
}

template <int D>
PlaceState<D> Instant<D>::at(Simplex s, const Point<D>& x) const {
  Event<D> y;
  std::copy_n(x.begin(), D, y.begin());
  y[D] = time_;
  const Elastic<D>& elastic = body_.problem.materials[static_cast<std::size_t>(body_.mesh.material(s))];
  PlaceState<D> out;
  const SolvedElement<D>* best = nullptr;
  double depth = 0.0;
  for (const SolvedElement<D>& element : columns_.column(s)) {
    if (time_ <= 0.0 || element.begin() >= time_ || element.end() < time_) continue;
    const auto lambda = element.solution.map(y);
    const double inside = *std::min_element(lambda.begin(), lambda.end());
    if (!best || inside > depth + 1e-12) best = &element, depth = inside;
  }
  if (best) {
    out.state = best->solution.at(y);
    out.acceleration = acceleration(best->solution, y);
  } else if (body_.problem.initial) {
    out.state = body_.problem.initial(s, y);
  }
  out.stress = elastic.stress(out.state.strain);
  out.across = elastic.stress_across(out.state.strain);
  return out;
}

template <int D>
PlaceState<D> Instant<D>::at_vertex(Vertex v) const {
  PlaceState<D> mean;
  double total = 0.0;
  const Point<D>& x = body_.mesh.position()[static_cast<std::size_t>(v)];
  for (const Simplex s : body_.mesh.star(v)) {
    const PlaceState<D> one = at(s, x);
    const double weight = space_volume(body_.mesh, s);
    total += weight;
    const auto add_to = [&](auto& sum, const auto& value) {
      for (std::size_t i = 0; i < value.size(); ++i) sum[i] += weight * value[i];
    };
    add_to(mean.state.u, one.state.u);
    add_to(mean.state.v, one.state.v);
    add_to(mean.state.strain, one.state.strain);
    add_to(mean.acceleration, one.acceleration);
    add_to(mean.stress, one.stress);
    mean.across += weight * one.across;
  }
  const auto divide = [&](auto& sum) {
    for (double& component : sum) component /= total;
  };
  divide(mean.state.u);
  divide(mean.state.v);
  divide(mean.state.strain);
  divide(mean.acceleration);
  divide(mean.stress);
  mean.across /= total;
  return mean;
}

template class Instant<1>;
template class Instant<2>;
template class Instant<3>;

}  // namespace cleave::discretisation::spacetime
