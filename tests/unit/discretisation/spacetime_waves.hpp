#pragma once
/// Exact solutions for the tests of the patch solver.

#include <numbers>

#include "spacetime_tents.hpp"

namespace cleave::discretisation::spacetime::test {

/// Sum of plane waves sin(k (n . x - c t)) a.
template <int D>
struct PlaneWave {
  Vector<D> n, a;
  double c, k;
};

template <int D>
PointState<D> waves(const std::vector<PlaneWave<D>>& list, const Event<D>& y) {
  PointState<D> s;
  for (const auto& w : list) {
    double phase = -w.c * y[D];
    for (int i = 0; i < D; ++i) phase += w.n[i] * y[i];
    const double sine = std::sin(w.k * phase), slope = w.k * std::cos(w.k * phase);
    for (int i = 0; i < D; ++i) {
      s.u[i] += w.a[i] * sine;
      s.v[i] -= w.c * w.a[i] * slope;
      for (int j = i; j < D; ++j)
        s.strain[voigt<D>(i, j)] += 0.5 * slope * (w.a[i] * w.n[j] + w.a[j] * w.n[i]);
    }
  }
  return s;
}

/// The P and S waves of the specification's case V1 for rho = lambda = mu = 1.
template <int D>
std::vector<PlaneWave<D>> smooth_waves(double k) {
  const double cd = std::sqrt(3.0);
  if constexpr (D == 1) return {{{1.0}, {1.0}, cd, k}, {{-1.0}, {0.7}, cd, k}};
  if constexpr (D == 2)
    return {{{std::cos(0.5), std::sin(0.5)}, {std::cos(0.5), std::sin(0.5)}, cd, k},
            {{std::cos(1.9), std::sin(1.9)}, {-0.7 * std::sin(1.9), 0.7 * std::cos(1.9)}, 1.0, k}};
  if constexpr (D == 3)
    return {{{0.6, 0.48, 0.64}, {0.6, 0.48, 0.64}, cd, k}, {{0.0, 0.8, 0.6}, {0.7, 0.0, 0.0}, 1.0, k}};
  return {};
}

template <int D>
Elastic<D> unit_material() {
  Elastic<D> m;
  EXPECT_EQ(make_isotropic<D>(1.0, 2.5, 0.25, PlaneKind::strain, m), "");
  return m;
}

/// Owns the targets that a problem points to.
template <int D>
struct Case {
  Problem<D> problem;
  std::vector<TargetPtr<D>> targets;
  void everywhere(TargetPtr<D> t) {
    problem.targets.assign(2 * D, t.get());
    targets.push_back(std::move(t));
  }
  void on(int face, TargetPtr<D> t) {
    problem.targets.resize(2 * D);
    problem.targets[static_cast<std::size_t>(face)] = t.get();
    targets.push_back(std::move(t));
  }
};

}  // namespace cleave::discretisation::spacetime::test
