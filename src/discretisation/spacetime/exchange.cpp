#include "discretisation/spacetime/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "discretisation/spacetime/cut.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// The corner of a piece of a simplex in spacetime.
template <int D, std::size_t C>
Event<D> event_at(const std::array<Event<D>, C>& corner, const std::array<double, C>& lambda) {
  Event<D> y{};
  for (std::size_t c = 0; c < C; ++c)
    for (std::size_t k = 0; k <= D; ++k) y[k] += lambda[c] * corner[c][k];
  return y;
}

/// Events of a rule on a piece given by its corners.
template <int D, std::size_t K>
void rule_points(const std::array<Event<D>, K>& corner, const SimplexRule& rule, std::vector<Event<D>>& out) {
  out.assign(static_cast<std::size_t>(rule.points), Event<D>{});
  for (std::size_t q = 0; q < out.size(); ++q)
    for (std::size_t c = 0; c < K; ++c)
      for (std::size_t k = 0; k <= D; ++k) out[q][k] += rule.barycentric[q * K + c] * corner[c][k];
}

}  // namespace

template <int D>
Outside<D>::Outside(const Body<D>& body) : body_(body) {
  for (const BoundaryFace<D>& face : body.mesh.boundary()) {
    const auto material = static_cast<std::size_t>(body.mesh.material(face.simplex));
    impedance_.push_back(body.problem.materials[material].impedance(face.normal));
  }
}

/// Facets of an element that contain its pole and lie on the boundary of the body.
template <int D>
template <class Visit>
void Outside<D>::each_facet(const SolvedElement<D>& element, const Visit& visit) const {
  for (std::size_t i = 0; i < D; ++i) {
    if (element.boundary[i] < 0) continue;
    Facet facet;
    facet.face = element.boundary[i];
    for (std::size_t c = 0, to = 0; c < D + 2; ++c)
      if (c != 1 + i) facet.corner[to++] = element.corner[c];
    for (std::size_t c = 0; c <= D; ++c) facet.time[c] = facet.corner[c][D];
    const Event<D> normal = area_vector<D + 1>(facet.corner, element.corner[1 + i]);
    facet.measure = 0.0;
    for (std::size_t k = 0; k < D; ++k) facet.measure += normal[k] * normal[k];
    facet.measure = std::sqrt(facet.measure);
    visit(facet);
  }
}

template <int D>
void Outside<D>::star(const SolvedElement<D>& element, std::int32_t face, std::span<const Event<D>> at,
                      std::span<Star<D>> values) const {
  const auto f = static_cast<std::size_t>(face);
  const Target<D>& target = *body_.problem.targets[f];
  const Interface<D> interface {
    .n = body_.mesh.boundary()[f].normal, .minus = element.solution.material, .z_minus = impedance_[f]
  };
  thread_local std::vector<PointState<D>> states;
  thread_local std::vector<Traces<D>> traces;
  thread_local std::vector<StarMap<D>> maps;
  states.resize(at.size());
  traces.assign(at.size(), {});
  element.solution.at(at, states);
  for (std::size_t q = 0; q < at.size(); ++q) {
    const Voigt<D> stress = element.solution.material->stress(states[q].strain);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) traces[q].s_minus[i] += stress[voigt<D>(i, j)] * interface.n[j];
    traces[q].v_minus = states[q].v;
    traces[q].u_minus = states[q].u;
  }
  maps.assign(target.linear() ? 1 : at.size(), {});
  std::fill(values.begin(), values.end(), Star<D>{});
  target.star(interface, at, traces, maps, values);
  for (std::size_t q = 0; q < at.size(); ++q)
    values[q] = maps[maps.size() == 1 ? 0 : q].apply(traces[q], values[q]);
}

template <int D>
Exchange<D> Outside<D>::before(Simplex s, const SolvedElement<D>& element, double t) const {
  Exchange<D> sum;
  if (element.begin() >= t) return sum;
  const bool whole = element.end() <= t;
  const double until = whole ? std::numeric_limits<double>::infinity() : t;
  thread_local std::vector<Event<D>> points;
  thread_local std::vector<Star<D>> stars;

  each_facet(element, [&](const Facet& facet) {
    const SimplexRule& rule = simplex_rule(D, element.solution.degree + 1);
    clip<D + 1>(facet.time, until, [&](const Piece<D + 1, D + 1>& piece) {
      std::array<Event<D>, D + 1> corner;
      for (std::size_t c = 0; c <= D; ++c) corner[c] = event_at<D>(facet.corner, piece[c]);
      rule_points<D>(corner, rule, points);
      stars.resize(points.size());
      star(element, facet.face, points, stars);
      const double measure = facet.measure * std::fabs(determinant<D + 1>(piece));
      for (std::size_t q = 0; q < points.size(); ++q)
        for (std::size_t i = 0; i < D; ++i) {
          sum.boundary_work += measure * rule.weight[q] * stars[q].s[i] * stars[q].v_minus[i];
          sum.impulse[i] += measure * rule.weight[q] * stars[q].s[i];
        }
    });
  });

  if (whole && !body_.problem.body_force) {
    sum.dissipation = element.exchange.dissipation;
    sum.volume = element.exchange.volume;
    return sum;
  }
  std::array<double, D + 2> time;
  for (std::size_t c = 0; c < D + 2; ++c) time[c] = element.corner[c][D];
  const double volume = std::fabs(signed_volume<D + 1>(element.corner));
  const SimplexRule& rule = simplex_rule(D + 1, element.solution.degree + 2);
  const double density = body_.problem.materials[static_cast<std::size_t>(body_.mesh.material(s))].density;
  clip<D + 2>(time, until, [&](const Piece<D + 2, D + 2>& piece) {
    const double share = std::fabs(determinant<D + 2>(piece));
    sum.dissipation += share * element.exchange.dissipation;
    sum.volume += share * element.exchange.volume;
    if (!body_.problem.body_force) return;
    std::array<Event<D>, D + 2> corner;
    for (std::size_t c = 0; c < D + 2; ++c) corner[c] = event_at<D>(element.corner, piece[c]);
    rule_points<D>(corner, rule, points);
    for (std::size_t q = 0; q < points.size(); ++q) {
      const Vector<D> b = body_.problem.body_force(points[q]), v = element.solution.at(points[q]).v;
      for (std::size_t i = 0; i < D; ++i) {
        const double force = density * volume * share * rule.weight[q] * b[i];
        sum.body_work += force * v[i];
        sum.impulse[i] += force;
      }
    }
  });
  return sum;
}

template <int D>
void Outside<D>::reactions(Simplex s, const SolvedElement<D>& element, double t, std::span<const char> wanted,
                           std::span<Vector<D>> force) const {
  if (!(element.begin() < t && element.end() >= t)) return;
  thread_local std::vector<Event<D>> points;
  thread_local std::vector<Star<D>> stars;
  const SimplexRule& rule = simplex_rule(D - 1, element.solution.degree + 1);
  each_facet(element, [&](const Facet& facet) {
    if (!wanted[static_cast<std::size_t>(facet.face)]) return;
    const BoundaryFace<D>& face = body_.mesh.boundary()[static_cast<std::size_t>(facet.face)];
    cut<D + 1>(facet.time, t, [&](const Piece<D + 1, D>& piece) {
      std::array<Event<D>, D> corner;
      for (std::size_t c = 0; c < D; ++c) corner[c] = event_at<D>(facet.corner, piece[c]);
      double area = 1.0;
      if constexpr (D == 2) {
        area = std::hypot(corner[1][0] - corner[0][0], corner[1][1] - corner[0][1]);
      } else if constexpr (D == 3) {
        const auto e = difference(corner[1], corner[0]), f = difference(corner[2], corner[0]);
        const double x = e[1] * f[2] - e[2] * f[1], y = e[2] * f[0] - e[0] * f[2],
                     z = e[0] * f[1] - e[1] * f[0];
        area = 0.5 * std::sqrt(x * x + y * y + z * z);
      }
      rule_points<D>(corner, rule, points);
      stars.resize(points.size());
      star(element, facet.face, points, stars);
      for (std::size_t q = 0; q < points.size(); ++q) {
        // Linear functions of the face are those of its simplex: barycentric coordinates in space.
        const auto& simplex = body_.mesh.simplex(s);
        const auto& position = body_.mesh.position();
        const auto at = [&](std::size_t c) { return position[static_cast<std::size_t>(simplex[c])]; };
        std::array<Point<D>, D + 1> whole;
        for (std::size_t c = 0; c <= D; ++c) whole[c] = at(c);
        Point<D> x;
        for (std::size_t k = 0; k < D; ++k) x[k] = points[q][k];
        const double volume = signed_volume<D>(whole);
        for (std::size_t c = 0; c <= D; ++c) {
          if (static_cast<std::int32_t>(c) == face.opposite) continue;
          auto moved = whole;
          moved[c] = x;
          const double weight = area * rule.weight[q] * signed_volume<D>(moved) / volume;
          for (std::size_t i = 0; i < D; ++i)
            force[static_cast<std::size_t>(simplex[c])][i] += weight * stars[q].s[i];
        }
      }
    });
  });
}

template class Outside<1>;
template class Outside<2>;
template class Outside<3>;

}  // namespace cleave::discretisation::spacetime
