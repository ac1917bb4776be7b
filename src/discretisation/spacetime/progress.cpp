#include "discretisation/spacetime/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/assert.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Corner i over all others.
template <int D>
Foot over_all(const Cell<D>& cell, std::size_t i) {
  std::array<Point<D>, D> other;
  std::array<double, D> time;
  for (std::size_t j = 0, to = 0; j <= D; ++j)
    if (j != i) {
      other[to] = cell.corner[j];
      time[to++] = cell.time[j];
    }
  return foot_of<D, D>(cell.corner[i], other, time);
}

// --- (b) slope bounds of sub-simplices --------------------------------------------------------------------

/// Bound of the edge jk of a triangle whose bound is `bound`; i is the corner opposite.
template <int D>
double edge_bound(const Point<D>& i, const Point<D>& j, const Point<D>& k, double bound, double eps) {
  return (1.0 - eps) * openness_of_edge<D>(i, j, k) * bound;
}

/// Bound of the face opposite corner i of a tetrahedron.
double face_bound(const Cell<3>& cell, std::size_t i, double eps) {
  std::array<Point<3>, 3> face;
  for (std::size_t j = 0, to = 0; j < 4; ++j)
    if (j != i) face[to++] = cell.corner[j];
  return (1.0 - eps) * openness_of_triangle(cell.corner[i], face) * cell.bound;
}

/// Calls visit(other corners..., bound) for the proper sub-simplices that contain corner i.
template <int D, class OnEdge, class OnFace>
void visit_subsimplices(const Cell<D>& cell, std::size_t i, double eps, const OnEdge& on_edge,
                        const OnFace& on_face) {
  if constexpr (D == 2) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    on_edge(j, edge_bound<2>(cell.corner[k], cell.corner[i], cell.corner[j], cell.bound, eps));
    on_edge(k, edge_bound<2>(cell.corner[j], cell.corner[i], cell.corner[k], cell.bound, eps));
  } else if constexpr (D == 3) {
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      if (opposite == i) continue;
      const double bound = face_bound(cell, opposite, eps);
      std::array<std::size_t, 2> jk;
      for (std::size_t j = 0, to = 0; j < 4; ++j)
        if (j != i && j != opposite) jk[to++] = j;
      const auto [j, k] = jk;
      on_face(j, k, bound);
      on_edge(j, edge_bound<3>(cell.corner[k], cell.corner[i], cell.corner[j], bound, eps));
      on_edge(k, edge_bound<3>(cell.corner[j], cell.corner[i], cell.corner[k], bound, eps));
    }
  }
}

// --- (c) budgets ------------------------------------------------------------------------------------------

struct BudgetTimes {
  double a, b, c, step;  ///< a is the time of the newest corner
};

BudgetTimes budget_times(const Cell<2>& cell) {
  const auto a = static_cast<std::size_t>(cell.budget.newest);
  return {cell.time[a], cell.time[(a + 1) % 3], cell.time[(a + 2) % 3], cell.budget.step};
}

double budget_limit(const Cell<2>& cell, std::size_t i) {
  const auto [a, b, c, s] = budget_times(cell);
  const auto newest = static_cast<std::size_t>(cell.budget.newest);
  if (i == newest) return std::min(std::min(b, c) + std::numbers::sqrt2 * s, 0.5 * (b + c) + s);
  const double other = i == (newest + 1) % 3 ? c : b;
  return std::min({other + 2.0 * s, a + std::numbers::sqrt2 * s, 2.0 * (a + s) - other});
}

/// Largest slope allowed along each edge direction of all shapes: of ab, ac, bc and the median am.
std::array<double, 4> direction_bounds(const Point<2>& a, const Point<2>& b, const Point<2>& c, double bound,
                                       double eps) {
  enum { ab, ac, bc, am };
  const auto middle = [](const Point<2>& p, const Point<2>& q) {
    return Point<2>{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
  };
  const Point<2> m = middle(b, c), e = middle(a, b);
  struct Shape {
    std::array<Point<2>, 3> corner;
    std::array<int, 3> direction;  ///< of the edge opposite each corner
  };
  const Shape shapes[] = {{{a, b, c}, {bc, ac, ab}},
                          {{m, a, b}, {ab, bc, am}},
                          {{m, a, c}, {ac, bc, am}},
                          {{e, m, a}, {am, ab, ac}}};
  std::array<double, 4> least;
  least.fill((1.0 - eps) * bound);
  for (const Shape& shape : shapes)
    for (std::size_t i = 0; i < 3; ++i) {
      const Point<2>&p = shape.corner[(i + 1) % 3], &q = shape.corner[(i + 2) % 3];
      double& entry = least[static_cast<std::size_t>(shape.direction[i])];
      entry = std::min(entry, edge_bound<2>(shape.corner[i], p, q, bound, eps));
    }
  return least;
}

}  // namespace

Budget root_budget(const Cell<2>& cell, double eps) {
  std::size_t newest = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = distance(cell.corner[(i + 1) % 3], cell.corner[(i + 2) % 3]);
    if (length > longest) {
      longest = length;
      newest = i;
    }
  }
  const Point<2>&a = cell.corner[newest], &b = cell.corner[(newest + 1) % 3],
        &c = cell.corner[(newest + 2) % 3];
  const auto [on_ab, on_ac, on_bc, on_am] = direction_bounds(a, b, c, cell.bound, eps);
  const Point<2> m{0.5 * (b[0] + c[0]), 0.5 * (b[1] + c[1])};
  const double step = std::min({on_bc * distance(b, c) * 0.5, on_ab * distance(a, b) / std::numbers::sqrt2,
                                on_ac * distance(a, c) / std::numbers::sqrt2, on_am * distance(a, m)});
  return {.step = step, .newest = static_cast<std::uint8_t>(newest)};
}

template <int D>
double rise_limit(const Cell<D>& cell, std::size_t i, Progress progress, double eps) {
  const Foot foot = over_all<D>(cell, i);
  double limit = highest(foot, cell.bound);
  if constexpr (D > 1) {
    if (progress == Progress::subsimplex)
      visit_subsimplices<D>(
          cell, i, eps,
          [&](std::size_t j, double bound) {
            limit = std::min(limit, cell.time[j] + bound * distance(cell.corner[i], cell.corner[j]));
          },
          [&](std::size_t j, std::size_t k, double bound) {
            limit = std::min(limit, highest(foot_of<D, 2>(cell.corner[i], {cell.corner[j], cell.corner[k]},
                                                          {cell.time[j], cell.time[k]}),
                                            bound));
          });
  }
  if constexpr (D == 2) {
    if (progress == Progress::high_mid)
      limit = std::min(limit, std::max(cell.time[(i + 1) % 3], cell.time[(i + 2) % 3]) +
                                  (1.0 - eps) * foot.height * cell.bound);
    if (progress == Progress::budget) limit = std::min(limit, budget_limit(cell, i));
  }
  return limit;
}

template <int D>
double sure_gain(const Cell<D>& cell, std::size_t i, Progress progress, double eps) {
  if constexpr (D == 1) {
    return over_all<1>(cell, i).height * cell.bound;
  } else {
    if (progress == Progress::causality) return 0.0;
    double gain = eps * over_all<D>(cell, i).height * cell.bound;
    if (progress == Progress::subsimplex)
      visit_subsimplices<D>(
          cell, i, eps,
          [&](std::size_t j, double bound) {
            gain = std::min(gain, bound * distance(cell.corner[i], cell.corner[j]));
          },
          [&](std::size_t j, std::size_t k, double bound) {
            gain = std::min(
                gain, eps * bound * distance_to_line<D>(cell.corner[i], cell.corner[j], cell.corner[k]));
          });
    if (progress == Progress::budget) gain = std::min(gain, (2.0 - std::numbers::sqrt2) * cell.budget.step);
    return gain;
  }
}

template <int D>
double strain_on_bounds(const Cell<D>& cell, Progress progress, double eps) {
  double worst = slope(over_all<D>(cell, 0), cell.time[0]) / cell.bound;
  if constexpr (D > 1) {
    if (progress == Progress::subsimplex)
      for (std::size_t i = 0; i <= D; ++i)
        visit_subsimplices<D>(
            cell, i, eps,
            [&](std::size_t j, double bound) {
              const double length = distance(cell.corner[i], cell.corner[j]);
              worst = std::max(worst, std::abs(cell.time[i] - cell.time[j]) / (bound * length));
            },
            [&](std::size_t j, std::size_t k, double bound) {
              const Foot foot = foot_of<D, 2>(cell.corner[i], {cell.corner[j], cell.corner[k]},
                                              {cell.time[j], cell.time[k]});
              worst = std::max(worst, slope(foot, cell.time[i]) / bound);
            });
  }
  if constexpr (D == 2) {
    if (progress == Progress::high_mid) {
      std::array<std::size_t, 3> order{0, 1, 2};
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return cell.time[a] < cell.time[b]; });
      const double rise = cell.time[order[2]] - cell.time[order[1]];
      worst = std::max(worst, rise / ((1.0 - eps) * over_all<2>(cell, order[2]).height * cell.bound));
    }
    if (progress == Progress::budget) {
      const auto [a, b, c, s] = budget_times(cell);
      worst = std::max({worst, std::abs(b - c) / (2.0 * s), std::abs(a - b) / (std::numbers::sqrt2 * s),
                        std::abs(a - c) / (std::numbers::sqrt2 * s), std::abs(0.5 * (b + c) - a) / s});
    }
  }
  return worst;
}

template double rise_limit<1>(const Cell<1>&, std::size_t, Progress, double);
template double rise_limit<2>(const Cell<2>&, std::size_t, Progress, double);
template double rise_limit<3>(const Cell<3>&, std::size_t, Progress, double);
template double sure_gain<1>(const Cell<1>&, std::size_t, Progress, double);
template double sure_gain<2>(const Cell<2>&, std::size_t, Progress, double);
template double sure_gain<3>(const Cell<3>&, std::size_t, Progress, double);
template double strain_on_bounds<1>(const Cell<1>&, Progress, double);
template double strain_on_bounds<2>(const Cell<2>&, Progress, double);
template double strain_on_bounds<3>(const Cell<3>&, Progress, double);

}  // namespace cleave::discretisation::spacetime
