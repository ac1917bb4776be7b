/// Free rotation: what is conserved, and the closed forms of tops.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/rigid/rotation.hpp"

namespace cleave::solver {
namespace {

double size(const Vector& v) {
  return std::sqrt(base::dot(v, v));
}

struct Top {
  double moment[3];
  Vector momentum;  // in space
  Rotation rotation{};

  Vector in_body() const { return rotation.inverse()(momentum); }
  double energy() const {
    const Vector l = in_body();
    return 0.5 * (l.x * l.x / moment[0] + l.y * l.y / moment[1] + l.z * l.z / moment[2]);
  }
  void step(double dt) {
    const double inverse[3] = {1 / moment[0], 1 / moment[1], 1 / moment[2]};
    rotation = cayley(rotation(free_turn(in_body(), inverse, dt))) * rotation;
  }
};

// Around its middle axis a body is unstable: it tumbles for ever.
TEST(FreeTurn, KeepsMomentumAndEnergyFor100000Steps) {
  Top top{{1.0, 2.0, 3.0}, {0.02, 2.0, 0.01}};
  const double energy = top.energy(), length = size(top.in_body());
  double worst_energy = 0.0, worst_momentum = 0.0, least = 1.0;
  for (int n = 0; n < 100000; ++n) {
    top.step(0.05);
    worst_energy = std::max(worst_energy, std::abs(top.energy() / energy - 1.0));
    worst_momentum = std::max(worst_momentum, std::abs(size(top.in_body()) / length - 1.0));
    least = std::min(least, top.in_body().y / length);
  }
  EXPECT_LT(least, -0.99);  // it did turn over
  EXPECT_LT(worst_energy, 2e-12);
  EXPECT_LT(worst_momentum, 1e-14);
  EXPECT_NEAR(top.rotation.w * top.rotation.w + base::dot(top.rotation.v, top.rotation.v), 1.0, 1e-14);
}

TEST(FreeTurn, SpinAboutAPrincipalAxisTurnsByTheExactAngle) {
  Top top{{1.0, 2.0, 3.0}, {0.0, 0.0, 3.0}};
  for (int n = 0; n < 1000; ++n) top.step(0.01);
  EXPECT_NEAR(top.rotation.w, std::cos(5.0), 1e-13);
  EXPECT_NEAR(top.rotation.v.z, std::sin(5.0), 1e-13);
}

// Landau & Lifshitz, Mechanics, sec. 33: the axis of a symmetric top goes round the momentum M at the rate
// M / A, while the top turns about its axis at M cos(theta) (1/C - 1/A) besides.
TEST(FreeTurn, SymmetricTopPrecesses) {
  const double a = 2.0, c = 0.5, theta = 0.4, m = 3.0, end = 5.0;
  double error[3];
  for (int level = 0; level < 3; ++level) {
    // The axis starts along z, and the momentum leans by theta towards x.
    Top top{{a, a, c}, {m * std::sin(theta), 0.0, m * std::cos(theta)}};
    const int steps = 200 << level;
    for (int n = 0; n < steps; ++n) top.step(end / steps);
    const Rotation round = turn((end * m / a) * ((1.0 / m) * top.momentum));
    const Rotation own = turn({0.0, 0.0, end * m * std::cos(theta) * (1.0 / c - 1.0 / a)});
    const Rotation expected = round * own;
    error[level] = size(top.rotation(Vector{1, 0, 0}) - expected(Vector{1, 0, 0})) +
                   size(top.rotation(Vector{0, 0, 1}) - expected(Vector{0, 0, 1}));
  }
  EXPECT_LT(error[2], 1e-3);
  for (int level = 0; level < 2; ++level) {
    const double order = std::log2(error[level] / error[level + 1]);
    EXPECT_GT(order, 1.9);
    EXPECT_LT(order, 2.1);
  }
}

TEST(FreeTurn, BodyWithoutInertiaAboutAnAxisDoesNotTurnAboutIt) {
  const double inverse[3] = {1.0, 1.0, 0.0};  // a rod along z
  const Vector by = free_turn({0.3, 0.1, 0.0}, inverse, 0.1);
  EXPECT_EQ(by.z, 0.0);
  EXPECT_NEAR(by.x / by.y, 3.0, 1e-12);
}

}  // namespace
}  // namespace cleave::solver
