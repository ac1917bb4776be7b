// The patch solver against exact solutions: polynomials, smooth waves and their orders, conservation.
#include <gtest/gtest.h>

#include <cstdio>

#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

constexpr double roundoff_momentum = 1e-12, roundoff_energy = 1e-10;

template <int D>
void expect_conserved(const March<D>& run, double volume) {
  EXPECT_EQ(run.failures, 0);
  EXPECT_LT(run.momentum, roundoff_momentum);
  EXPECT_LT(run.energy, roundoff_energy);
  EXPECT_GE(run.dissipation, 0.0);
  EXPECT_NEAR(run.volume, volume, 1e-12 * volume);
}

struct Errors {
  double v, e, u;
};

/// V1: plane waves in the unit box with the exact velocity on the boundary.
template <int D>
Errors smooth(SpaceChoice space, int n, double end, double sway, bool traction = false) {
  Case<D> c;
  c.problem.materials = {unit_material<D>()};
  c.problem.spaces = {space};
  const auto list = smooth_waves<D>(D == 3 ? 3.0 : 2.0 * std::numbers::pi);
  c.problem.initial = [list](Simplex, const Event<D>& y) { return waves<D>(list, y); };
  if (traction) {
    const Elastic<D> m = c.problem.materials[0];
    for (int face = 0; face < 2 * D; ++face)
      c.on(face, make_traction<D>([list, m, face](const Event<D>& y) {
             const auto stress = m.stress(waves<D>(list, y).strain);
             Vector<D> t{};
             for (int i = 0; i < D; ++i) t[i] = (face % 2 ? 1.0 : -1.0) * stress[voigt<D>(i, face / 2)];
             return t;
           }));
  } else {
    c.everywhere(make_velocity<D>([list](const Event<D>& y) { return waves<D>(list, y).v; }));
  }
  Vector<D> size{};
  std::array<int, D> cells{};
  size.fill(1.0), cells.fill(n);
  March<D> run(box<D>(cells, size), c.problem);
  run.exact = [list](const Event<D>& y) { return waves<D>(list, y); };
  run.sway = sway;
  run.march(end);
  expect_conserved(run, end);
  EXPECT_EQ(run.tilted > 0, sway > 0.0);
  return {run.error_v, run.error_e, run.error_u};
}

template <int D>
void expect_order(SpaceChoice space, std::vector<int> meshes, double end, double sway, double order,
                  double u_order) {
  std::vector<Errors> all;
  for (const int n : meshes) {
    all.push_back(smooth<D>(space, n, end, sway));
    std::printf("space %d degree %d n %2d  v %.3e E %.3e u %.3e", static_cast<int>(space.space), space.degree,
                n, all.back().v, all.back().e, all.back().u);
    if (all.size() > 1) {
      const double r = std::log(double(n) / meshes[all.size() - 2]);
      const Errors &a = all[all.size() - 2], &b = all.back();
      std::printf("   orders %.2f %.2f %.2f", std::log(a.v / b.v) / r, std::log(a.e / b.e) / r,
                  std::log(a.u / b.u) / r);
    }
    std::printf("\n");
  }
  const Errors &a = all[all.size() - 2], &b = all.back();
  const double r = std::log(double(meshes.back()) / meshes[meshes.size() - 2]);
  EXPECT_GT(std::log(a.v / b.v) / r, order - 0.25);
  EXPECT_GT(std::log(a.e / b.e) / r, order - 0.25);
  EXPECT_GT(std::log(a.u / b.u) / r, u_order - 0.25);
}

using enum LocalSpace;
/// Two layers of the coarsest mesh, so that all meshes are pitched alike.
const double end2d = 0.9 / std::sqrt(6.0);

const double end1d = 0.9 / std::sqrt(3.0);

// Velocity and strain: p + 1 for three fields, P for displacement spaces. Displacement: p + 1 for three
// fields; for displacement spaces between P and P + 1, as the rigid motions carry the error of the older
// elements.
TEST(SpacetimeOrder, ThreeField1D) {
  for (int p = 1; p <= 3; ++p) expect_order<1>({three_field, p}, {4, 8, 16, 32}, end1d, 0.0, p + 1, p + 1);
}
TEST(SpacetimeOrder, OneField1D) {
  for (int p = 2; p <= 3; ++p) expect_order<1>({one_field, p}, {8, 16, 32}, end1d, 0.0, p, p + 0.9);
}
TEST(SpacetimeOrder, Trefftz1D) {
  for (int p = 2; p <= 4; ++p) expect_order<1>({trefftz, p}, {4, 8, 16}, end1d, 0.0, p, p + 0.3);
}
TEST(SpacetimeOrder, ThreeField2D) {
  for (int p = 1; p <= 3; ++p) expect_order<2>({three_field, p}, {2, 4, 8}, end2d, 0.0, p + 1, p + 1);
}
TEST(SpacetimeOrder, Trefftz2D) {
  for (int p = 2; p <= 4; ++p) expect_order<2>({trefftz, p}, {2, 4, 8}, end2d, 0.0, p, p + 0.3);
}
TEST(SpacetimeOrder, OneField2D) {
  for (int p = 2; p <= 3; ++p) expect_order<2>({one_field, p}, {2, 4, 8}, end2d, 0.0, p, p + 0.5);
}
TEST(SpacetimeOrder, InclinedPoles) {
  expect_order<2>({three_field, 2}, {2, 4, 8}, end2d, 0.06, 3, 3);
}
TEST(SpacetimeOrder, PrescribedTraction) {
  const Errors a = smooth<2>({three_field, 2}, 2, end2d, 0.0, true),
               b = smooth<2>({three_field, 2}, 4, end2d, 0.0, true);
  EXPECT_GT(std::log2(a.v / b.v), 2.5);
  EXPECT_GT(std::log2(a.e / b.e), 2.5);
}

/// Identities in three dimensions, and error below that of a coarse mesh.
TEST(SpacetimePatch, ThreeDimensions) {
  const Errors a = smooth<3>({three_field, 1}, 1, 0.2, 0.0), b = smooth<3>({three_field, 1}, 2, 0.2, 0.0);
  EXPECT_LT(b.v, 0.45 * a.v);
  EXPECT_LT(b.u, 0.45 * a.u);
  const Errors t = smooth<3>({trefftz, 2}, 2, 0.2, 0.0), o = smooth<3>({one_field, 2}, 1, 0.2, 0.0);
  EXPECT_LT(t.v, 1.3 * b.v);
  EXPECT_LT(o.v, 1.3 * a.v);
  smooth<3>({three_field, 1}, 2, 0.1, 0.05);  // inclined poles: identities
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
