#include "discretisation/spacetime/solution.hpp"

#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/basis.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
int unknown_count(SpaceChoice c) {
  const int p = c.degree;
  switch (c.space) {
    case LocalSpace::one_field:
      return D * polynomial_count(D + 1, p) - rigid_count<D>;
    case LocalSpace::trefftz:
      return D * (polynomial_count(D, p) + polynomial_count(D, p - 1)) - rigid_count<D>;
    case LocalSpace::three_field:
      break;
  }
  return state_count<D> * polynomial_count(D + 1, p);
}

template <int D>
bool AffineMap<D>::set(const std::array<Event<D>, D + 2>& corner) {
  constexpr int m = D + 1;
  origin = corner[0];
  // Gauss-Jordan on the edges; rows are scaled by the extent, as length and time have different units.
  double a[m][2 * m] = {};
  Event<D> extent{};
  for (int k = 0; k < m; ++k) {
    for (int l = 0; l < m; ++l) extent[k] = std::max(extent[k], std::fabs(corner[l + 1][k] - origin[k]));
    if (!(extent[k] > 0.0)) return false;
    for (int l = 0; l < m; ++l) a[k][l] = (corner[l + 1][k] - origin[k]) / extent[k];
    a[k][m + k] = 1.0 / extent[k];
  }
  for (int j = 0; j < m; ++j) {
    int best = j;
    for (int i = j + 1; i < m; ++i)
      if (std::fabs(a[i][j]) > std::fabs(a[best][j])) best = i;
    if (!(std::fabs(a[best][j]) > 1e-14)) return false;
    if (best != j) std::swap_ranges(a[j], a[j] + 2 * m, a[best]);
    const double inverse = 1.0 / a[j][j];
    for (double& x : a[j]) x *= inverse;
    for (int i = 0; i < m; ++i) {
      const double s = i == j ? 0.0 : a[i][j];
      for (int k = 0; k < 2 * m; ++k) a[i][k] -= s * a[j][k];
    }
  }
  for (int l = 0; l < m; ++l)
    for (int k = 0; k < m; ++k) gradient[l][k] = a[l][m + k];
  return true;
}

template <int D>
std::array<double, D + 2> AffineMap<D>::operator()(const Event<D>& y) const {
  std::array<double, D + 2> lambda{1.0};
  for (int l = 0; l <= D; ++l) {
    for (int k = 0; k <= D; ++k) lambda[l + 1] += gradient[l][k] * (y[k] - origin[k]);
    lambda[0] -= lambda[l + 1];
  }
  return lambda;
}

template <int D>
PointState<D> Solution<D>::at(const Event<D>& y) const {
  PointState<D> state;
  at({&y, 1}, {&state, 1});
  return state;
}

template <int D>
void Solution<D>::at(std::span<const Event<D>> events, std::span<PointState<D>> states) const {
  const auto& basis = Basis<D + 1>::get();
  const int top = std::max(degree, displacement_degree);
  const int n = polynomial_count(D + 1, degree), nu = polynomial_count(D + 1, displacement_degree);
  double phi[Basis<D + 1>::count];
  const auto dot = [&](const std::vector<double>& coefficient, int row, int count) {
    const double* c = coefficient.data() + static_cast<std::ptrdiff_t>(row) * count;
    double sum = 0.0;
    for (int a = 0; a < count; ++a) sum += c[a] * phi[a];
    return sum;
  };
  for (std::size_t q = 0; q < events.size(); ++q) {
    const auto lambda = map(events[q]);
    basis.evaluate(lambda.data(), top, phi);
    PointState<D>& s = states[q];
    for (int i = 0; i < D; ++i) s.u[i] = dot(displacement, i, nu), s.v[i] = dot(fields, i, n);
    for (int i = 0; i < strain_count<D>; ++i) s.strain[i] = dot(fields, D + i, n);
  }
}

#define CLEAVE_INSTANTIATE(D)                 \
  template int unknown_count<D>(SpaceChoice); \
  template struct AffineMap<D>;               \
  template struct Solution<D>;
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
