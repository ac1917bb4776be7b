// Targets: each kind against a solution it must give exactly or within a stated figure.
#include <gtest/gtest.h>

#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

using enum LocalSpace;

template <int D>
void expect_conserved(const March<D>& run) {
  EXPECT_EQ(run.failures, 0);
  EXPECT_LT(run.momentum, 1e-12);
  EXPECT_LT(run.energy, 1e-10);
  EXPECT_GE(run.dissipation, -1e-14);
}

/// u = sum of a (n . x - c t)^p: a polynomial of degree p that satisfies the equation of motion.
template <int D>
PointState<D> power_wave(const std::vector<PlaneWave<D>>& list, int p, const Event<D>& y) {
  PointState<D> s;
  for (const auto& w : list) {
    double phase = -w.c * y[D];
    for (int i = 0; i < D; ++i) phase += w.n[i] * y[i];
    const double value = std::pow(phase, p), slope = p * std::pow(phase, p - 1);
    for (int i = 0; i < D; ++i) {
      s.u[i] += w.a[i] * value;
      s.v[i] -= w.c * w.a[i] * slope;
      for (int j = i; j < D; ++j)
        s.strain[voigt<D>(i, j)] += 0.5 * slope * (w.a[i] * w.n[j] + w.a[j] * w.n[i]);
    }
  }
  return s;
}

template <int D>
void expect_polynomial(SpaceChoice space, double sway) {
  Case<D> c;
  c.problem.materials = {unit_material<D>()};
  c.problem.spaces = {space};
  const auto list = smooth_waves<D>(1.0);
  const int p = space.degree;
  const auto exact = [list, p](const Event<D>& y) { return power_wave<D>(list, p, y); };
  c.problem.initial = [exact](Simplex, const Event<D>& y) { return exact(y); };
  const Elastic<D> m = c.problem.materials[0];
  for (int face = 0; face < 2 * D; ++face) {
    if (face % 2 == 0) {
      c.on(face, make_displacement<D>([exact](const Event<D>& y) { return exact(y).v; }));
    } else {
      c.on(face, make_traction<D>([exact, m, face](const Event<D>& y) {
             const auto stress = m.stress(exact(y).strain);
             Vector<D> t{};
             for (int i = 0; i < D; ++i) t[i] = stress[voigt<D>(i, face / 2)];
             return t;
           }));
    }
  }
  std::array<int, D> cells{};
  Vector<D> size{};
  cells.fill(D == 3 ? 1 : 2), size.fill(1.0);
  if (sway > 0.0) cells.fill(2);
  March<D> run(box<D>(cells, size), c.problem);
  run.exact = exact;
  run.sway = sway;
  run.march(0.15);
  expect_conserved(run);
  EXPECT_LT(run.error_v, 1e-11) << D << " " << static_cast<int>(space.space) << " " << space.degree;
  EXPECT_LT(run.error_e, 1e-11);
  EXPECT_LT(run.error_u, 1e-11);
}

TEST(SpacetimeTarget, PolynomialsAreReproduced) {
  for (int p = 1; p <= 6; ++p) {
    expect_polynomial<1>({three_field, p}, 0.0);
    expect_polynomial<1>({trefftz, p}, 0.0);
    if (p > 1) expect_polynomial<1>({one_field, p}, 0.0);
  }
  for (int p = 1; p <= 4; ++p) expect_polynomial<2>({three_field, p}, p == 2 ? 0.1 : 0.0);
  for (int p = 2; p <= 6; ++p) expect_polynomial<2>({trefftz, p}, p == 3 ? 0.1 : 0.0);
  for (int p = 2; p <= 4; ++p) expect_polynomial<2>({one_field, p}, p == 2 ? 0.1 : 0.0);
  expect_polynomial<3>({three_field, 1}, 0.05);
  expect_polynomial<3>({three_field, 2}, 0.0);
  expect_polynomial<3>({one_field, 2}, 0.0);
  expect_polynomial<3>({trefftz, 2}, 0.05);
  expect_polynomial<3>({trefftz, 3}, 0.0);
}

/// V2: a sudden traction on the end of a bar.
TEST(SpacetimeTarget, StepWaveOvershootsLittle) {
  for (const SpaceChoice space : {SpaceChoice{three_field, 1}, SpaceChoice{three_field, 2},
                                  SpaceChoice{three_field, 3}, SpaceChoice{trefftz, 3}}) {
    Case<1> c;
    c.problem.materials = {unit_material<1>()};
    c.problem.spaces = {space};
    c.on(0, make_traction<1>([](const Event<1>&) { return Vector<1>{1.0}; }));
    c.on(1, make_traction<1>({}));
    const int n = 40;
    March<1> run(box<1>({n}, {1.0}), c.problem);
    const double speed = std::sqrt(3.0), end = 0.5 / speed,
                 plateau = -1.0 / speed;  // t = sigma n = 1, n = -1
    run.march(end);
    expect_conserved(run);
    double largest = 0.0, total = 0.0, arrival = 0.0;
    for (int i = 0; i < n * 20; ++i) {
      const double x = (i + 0.5) / (n * 20);
      const auto cell = static_cast<std::size_t>(x * n);
      const double v = run.solution[cell].at({x, end}).v[0] / -plateau;  // +1 behind the front
      largest = std::max(largest, v);
      total += v / (n * 20);
      if (v > 0.5) arrival = x;
    }
    EXPECT_LT(largest, 1.12) << space.degree;
    EXPECT_GT(largest, 0.99);
    EXPECT_NEAR(arrival, 0.5, 1.0 / (n * field_degree(space)));
    EXPECT_NEAR(total, 0.5, 2e-3);  // momentum: impulse of the traction
  }
}

/// A smooth pulse meets an interface head on: transmitted and reflected velocity and traction.
TEST(SpacetimeTarget, BimaterialTransmission) {
  Case<1> c;
  c.problem.materials.resize(2);
  ASSERT_EQ(make_isotropic<1>(1.0, 1.0, 0.0, PlaneKind::stress, c.problem.materials[0]), "");  // Z = 1, c = 1
  ASSERT_EQ(make_isotropic<1>(2.0, 8.0, 0.3, PlaneKind::stress, c.problem.materials[1]), "");  // Z = 4, c = 2
  c.problem.spaces = {{three_field, 3}, {trefftz, 4}};
  const auto pulse = [](double x) {
    return x > 0.1 && x < 0.5 ? std::pow(std::sin((x - 0.1) / 0.4 * 3.14159265358979), 4) : 0.0;
  };
  c.problem.initial = [&](Simplex, const Event<1>& y) {
    PointState<1> s;
    s.v = {pulse(y[0])}, s.strain = {-pulse(y[0])};
    return s;
  };
  c.on(0, make_silent<1>({})), c.on(1, make_silent<1>({}));
  auto mesh = box<1>({100}, {2.0});
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) mesh.part[e] = e >= 50 ? 1 : 0;
  March<1> run(mesh, c.problem);
  run.march(1.0);  // the crest, at 0.3 + 1, is 0.3 behind the interface in time: at 1.6 and 0.7
  expect_conserved(run);
  const auto right = run.solution[80].at({1.6, 1.0}), left = run.solution[35].at({0.7, 1.0});
  EXPECT_NEAR(right.v[0], 0.4, 0.4e-3);              // 2 Z- / (Z+ + Z-)
  EXPECT_NEAR(8.0 * right.strain[0], -1.6, 1.6e-3);  // 2 Z+ / (Z+ + Z-)
  EXPECT_NEAR(left.v[0], -0.6, 0.6e-3);
}

TEST(SpacetimeTarget, SilentBoundaryLetsWavesInAndOut) {
  Case<1> c;
  c.problem.materials = {unit_material<1>()};
  c.problem.spaces = {{three_field, 3}};
  const double speed = std::sqrt(3.0);
  const auto pulse = [](double t) {
    return t > 0.0 && t < 0.4 ? std::pow(std::sin(t / 0.4 * 3.14159265358979), 4) : 0.0;
  };
  c.on(0, make_silent<1>([&](const Event<1>& y) { return Vector<1>{2.0 * speed * pulse(y[1])}; }));
  c.on(1, make_silent<1>({}));
  March<1> run(box<1>({40}, {1.0}), c.problem);
  run.march(0.4);
  const double x = speed * 0.2;
  EXPECT_NEAR(run.solution[static_cast<std::size_t>(x * 40)].at({x, 0.4}).v[0], 1.0, 1e-3);
  EXPECT_NEAR(run.solution[static_cast<std::size_t>(x * 40)].at({x, 0.4}).strain[0], -1.0 / speed, 1e-3);
  run.march(1.1);
  expect_conserved(run);
  for (int e = 0; e < 40; ++e)
    EXPECT_LT(std::fabs(run.solution[static_cast<std::size_t>(e)].at({(e + 0.5) / 40, 1.1}).v[0]), 1e-4);
}

/// Standing waves between planes of symmetry, or of antisymmetry, or the same stated component by component.
/// The patch solver reads only the star velocities: each side must be left by the characteristic that
/// travels towards the facet, s* - Z v* = s - Z v with the outward normal of the side, whatever the target.
void expect_outgoing_kept(const Target<2>& target, bool interior) {
  Elastic<2> soft, stiff;
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::strain, soft), "");
  ASSERT_EQ(make_anisotropic<2>(3.0, {{{9.0, 2.0, 0.5}, {2.0, 6.0, 0.3}, {0.5, 0.3, 2.0}}}, stiff), "");
  Interface<2> facet{.n = {0.6, 0.8}, .minus = &soft, .plus = interior ? &stiff : nullptr};
  facet.z_minus = soft.impedance(facet.n);
  if (interior) facet.z_plus = stiff.impedance(facet.n);
  const Traces<2> traces{.v_minus = {0.3, -1.1},
                         .s_minus = {2.0, 0.7},
                         .u_minus = {0.0, 0.0},
                         .v_plus = {-0.4, 0.9},
                         .s_plus = {-1.3, 0.2},
                         .u_plus = {0.0, 0.0}};
  const Event<2> at{0.2, 0.4, 0.6};
  StarMap<2> map;
  Star<2> load;
  target.star(facet, {&at, 1}, {&traces, 1}, {&map, 1}, {&load, 1});
  const Star<2> star = map.apply(traces, load);
  const auto keeps = [](const Matrix<2>& z, double sign, const Vector<2>& s_star, const Vector<2>& v_star,
                        const Vector<2>& s, const Vector<2>& v) {
    for (std::size_t i = 0; i < 2; ++i) {
      double difference = s_star[i] - s[i];
      for (std::size_t j = 0; j < 2; ++j) difference -= sign * z[i][j] * (v_star[j] - v[j]);
      EXPECT_NEAR(difference, 0.0, 1e-13);
    }
  };
  keeps(facet.z_minus, 1.0, star.s, star.v_minus, traces.s_minus, traces.v_minus);
  if (interior) keeps(facet.z_plus, -1.0, star.s, star.v_plus, traces.s_plus, traces.v_plus);
}

TEST(SpacetimeTarget, StarValuesKeepTheOutgoingCharacteristic) {
  const VectorField<2> field = [](const Event<2>& y) { return Vector<2>{1.0 + y[0], y[1] - y[2]}; };
  expect_outgoing_kept(*make_bonded<2>(), true);
  expect_outgoing_kept(*make_traction<2>(field), false);
  expect_outgoing_kept(*make_traction<2>({}), false);
  expect_outgoing_kept(*make_velocity<2>(field), false);
  expect_outgoing_kept(*make_displacement<2>(field), false);
  expect_outgoing_kept(*make_symmetry<2>(), false);
  expect_outgoing_kept(*make_antisymmetry<2>(), false);
  expect_outgoing_kept(*make_mixed<2>({true, false}, field, field), false);
  expect_outgoing_kept(*make_projected<2>({{{0.36, 0.48}, {0.48, 0.64}}}, field, field), false);
  expect_outgoing_kept(*make_silent<2>(field), false);
}

TEST(SpacetimeTarget, MirrorPlanes) {
  for (int kind = 0; kind < 4; ++kind) {
    Case<2> c;
    c.problem.materials = {unit_material<2>()};
    c.problem.spaces = {{three_field, 3}};
    const bool symmetric = kind % 2 == 0;
    const double pi = 3.14159265358979, speed = std::sqrt(3.0);
    const auto exact = [=](const Event<2>& y) {
      PointState<2> s;
      const double phase = pi * y[0], shape = symmetric ? std::sin(phase) : std::cos(phase);
      s.u[0] = shape * std::cos(pi * speed * y[2]);
      s.v[0] = -pi * speed * shape * std::sin(pi * speed * y[2]);
      s.strain[0] = pi * (symmetric ? std::cos(phase) : -std::sin(phase)) * std::cos(pi * speed * y[2]);
      return s;
    };
    c.problem.initial = [&](Simplex, const Event<2>& y) { return exact(y); };
    for (int face = 0; face < 2; ++face) {
      if (kind == 0) c.on(face, make_symmetry<2>());
      if (kind == 1) c.on(face, make_antisymmetry<2>());
      if (kind >= 2) c.on(face, make_mixed<2>({symmetric, !symmetric}, {}, {}));
    }
    c.on(2, make_symmetry<2>()), c.on(3, make_mixed<2>({false, true}, {}, {}));
    March<2> run(box<2>({4, 4}, {1.0, 1.0}), c.problem);
    run.exact = exact;
    run.march(0.25);
    expect_conserved(run);
    EXPECT_LT(run.error_v, 5e-3);
    EXPECT_LT(run.error_e, 5e-3);
    EXPECT_NEAR(run.boundary_work, 0.0, 1e-12);  // mirrors do no work
  }
}

/// Quasi-longitudinal plane wave in an orthotropic sheet, oblique: only the right speed and impedance carry
/// it.
TEST(SpacetimeTarget, AnisotropicPlaneWave) {
  Case<2> c;
  c.problem.materials.resize(1);
  Elastic<2>& m = c.problem.materials[0];
  ASSERT_EQ(make_anisotropic<2>(1.3, {{{10.0, 2.0, 0.5}, {2.0, 4.0, 0.2}, {0.5, 0.2, 1.5}}}, m), "");
  const Vector<2> n{std::cos(0.6), std::sin(0.6)};
  // Christoffel matrix by hand; its larger eigenvalue is rho c^2.
  const double c11 = 10 * n[0] * n[0] + 2 * 0.5 * n[0] * n[1] + 1.5 * n[1] * n[1];
  const double c22 = 1.5 * n[0] * n[0] + 2 * 0.2 * n[0] * n[1] + 4 * n[1] * n[1];
  const double c12 = 0.5 * n[0] * n[0] + (2 + 1.5) * n[0] * n[1] + 0.2 * n[1] * n[1];
  const double value = 0.5 * (c11 + c22) + std::sqrt(0.25 * (c11 - c22) * (c11 - c22) + c12 * c12);
  Vector<2> a{c12, value - c11};
  const double norm = std::hypot(a[0], a[1]);
  a = {a[0] / norm, a[1] / norm};
  const double speed = std::sqrt(value / 1.3);
  EXPECT_NEAR(m.speeds(n)[1], speed, 1e-12 * speed);
  EXPECT_GE(m.fastest, speed);
  const std::vector<PlaneWave<2>> list = {{n, a, speed, 3.0}};
  c.problem.initial = [&](Simplex, const Event<2>& y) { return waves<2>(list, y); };
  c.everywhere(make_velocity<2>([&](const Event<2>& y) { return waves<2>(list, y).v; }));
  double error[2];
  for (const SpaceChoice space : {SpaceChoice{three_field, 2}, SpaceChoice{trefftz, 3}}) {
    c.problem.spaces = {space};
    for (int k = 0; k < 2; ++k) {
      March<2> run(box<2>({2 << k, 2 << k}, {1.0, 1.0}), c.problem);
      run.exact = [&](const Event<2>& y) { return waves<2>(list, y); };
      run.march(0.2);
      expect_conserved(run);
      error[k] = run.error_v;
    }
    EXPECT_LT(error[1], 2e-2);
    EXPECT_GT(std::log2(error[0] / error[1]), 2.5);
  }
}

/// Neighbouring cells with different spaces and degrees: they meet through traces only.
TEST(SpacetimeTarget, SpacesMix) {
  Case<2> c;
  c.problem.materials = {unit_material<2>()};
  c.problem.spaces = {{three_field, 2}};
  const auto list = smooth_waves<2>(3.0);
  c.problem.initial = [&](Simplex, const Event<2>& y) { return waves<2>(list, y); };
  c.everywhere(make_velocity<2>([&](const Event<2>& y) { return waves<2>(list, y).v; }));
  for (const double sway : {0.0, 0.1}) {
    March<2> run(box<2>({4, 4}, {1.0, 1.0}), c.problem);
    const SpaceChoice cycle[] = {
        {three_field, 2}, {trefftz, 3}, {one_field, 3}, {three_field, 3}, {trefftz, 4}};
    run.choose = [&](int cell) { return cycle[cell % 5]; };
    run.exact = [&](const Event<2>& y) { return waves<2>(list, y); };
    run.sway = sway;
    run.march(0.2);
    expect_conserved(run);
    EXPECT_LT(run.error_v, 1e-2);
    EXPECT_LT(run.error_u, 2e-3);
  }
}

/// Free fall is a polynomial; Trefftz elements fall back to three fields.
TEST(SpacetimeTarget, BodyForce) {
  for (const SpaceChoice space :
       {SpaceChoice{three_field, 2}, SpaceChoice{one_field, 2}, SpaceChoice{trefftz, 3}}) {
    Case<2> c;
    c.problem.materials = {unit_material<2>()};
    c.problem.spaces = {space};
    c.problem.body_force = [](const Event<2>&) { return Vector<2>{0.3, -9.81}; };
    c.everywhere(make_traction<2>({}));
    March<2> run(box<2>({2, 2}, {1.0, 1.0}), c.problem);
    run.exact = [](const Event<2>& y) {
      PointState<2> s;
      s.v = {0.3 * y[2], -9.81 * y[2]};
      s.u = {0.15 * y[2] * y[2], -4.905 * y[2] * y[2]};
      return s;
    };
    run.march(0.4);
    expect_conserved(run);
    EXPECT_LT(run.error_v + run.error_e + run.error_u, 1e-11);
  }
}

/// A rigid wall that pushes but does not pull: the seam for nonlinear targets.
class Wall final : public Target<1> {
 public:
  bool linear() const override { return false; }
  void star(const Interface<1>& facet, std::span<const Event<1>> at, std::span<const Traces<1>> now,
            std::span<StarMap<1>> map, std::span<Star<1>>) const override {
    const double z = facet.z_minus[0][0];
    for (std::size_t q = 0; q < at.size(); ++q) {
      if (now[q].s_minus[0] - z * now[q].v_minus[0] >= 0.0) {
        map[q].map[1] = {1.0, -1.0 / z, 0.0, 0.0};  // apart: s* = 0
      } else {
        map[q].map[0] = {-z, 1.0, 0.0, 0.0};  // pressed: v* = 0
      }
    }
  }
};

TEST(SpacetimeTarget, NonlinearTargetIterates) {
  Case<1> c;
  c.problem.materials = {unit_material<1>()};
  c.problem.spaces = {{three_field, 2}};
  c.problem.initial = [](Simplex, const Event<1>&) {
    PointState<1> s;
    s.v = {1.0};
    return s;
  };
  c.on(0, make_traction<1>({}));
  c.on(1, std::make_unique<Wall>());
  March<1> run(box<1>({20}, {1.0}), c.problem);
  run.march(1.0 / std::sqrt(3.0));
  EXPECT_NEAR(run.solution[10].at({0.525, 1.0 / std::sqrt(3.0)}).v[0], 0.0, 0.02);
  run.march(2.5 /
            std::sqrt(3.0));  // contact lasts 2 L / c, then the bar flies off with its velocity reversed
  expect_conserved(run);
  EXPECT_GT(run.iterations, 1);
  double mean = 0.0;
  for (int e = 0; e < 20; ++e)
    mean += run.solution[static_cast<std::size_t>(e)].at({(e + 0.5) / 20, 2.5 / std::sqrt(3.0)}).v[0] / 20;
  EXPECT_NEAR(mean, -1.0, 0.02);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
