/// Central differences against what is known of them in closed form.

#include <gtest/gtest.h>

#include <numbers>

#include "rig.hpp"

namespace cleave::solver::test {
namespace {

/// Chain of `count` springs along x, total length 1, speed of sound 1, density times area 1; fixed at x = 1.
void build_chain(Rig& rig, int count) {
  const double h = 1.0 / count;
  std::vector<Springs::Spring> list;
  for (int a = 0; a <= count; ++a) rig.node(a * h);
  for (Index e = 0; e < count; ++e) list.push_back({{e, e + 1}, 1.0 / h, h});
  rig.springs(std::move(list));
}

// With dt = h/c and a lumped mass, central differences carry d'Alembert's solution from node to node without
// error (validation A12 i). A moving chain hits a wall: every node stops when the wave reaches it.
TEST(TimeIntegration, ChainAtTheCourantStepIsExact) {
  constexpr int count = 40;
  Rig rig;
  build_chain(rig, count);
  for (Index a = 0; a < count; ++a) rig.velocity(a, {0.1, 0, 0});
  rig.fix({count}, 7);
  double worst = 0.0;
  rig.run(1.5, [&](const Frame& frame) {
    // Displacement of x at t: moves with 0.1 until the wave from the wall arrives at 1 - x, then stands until
    // the wave from the free end comes back at 1 + x, then returns.
    for (int a = 0; a <= count; ++a) {
      const double x = static_cast<double>(a) / count, t = frame.state.time;
      const double u = 0.1 * (t < 1.0 - x ? t : t < 1.0 + x ? 1.0 - x : 2.0 - t);
      worst = std::max(worst, std::abs(frame.state.position[3 * static_cast<std::size_t>(a)] - x - u));
    }
  });
  EXPECT_LT(worst, 1e-12);  // roundoff
}

struct Oscillator : Rig {
  Index mass;
  /// Mass 1 on a spring 1 to a fixed point, pulled with velocity 1 at t = 0: u = sin t.
  explicit Oscillator(double dt) {
    const Index wall = node(0.0);
    mass = particle(1.0, {10.0, 0, 0}, {1.0, 0, 0});
    springs({{{wall, mass}, 1.0, 0.0}});
    fix({wall}, 7);
    fixed_step(dt);
  }
  double u() const { return x(mass) - 10.0; }
};

// The difference scheme oscillates at (2/dt) asin(dt/2) (validation A12 ii), and starting from rest at zero
// its solution is U sin(omega' t) with U = dt / sin(omega' dt): known in closed form at every step.
TEST(TimeIntegration, OscillatorFollowsTheDifferenceEquation) {
  const double dt = 0.5, omega = 2.0 / dt * std::asin(0.5 * dt);
  Oscillator rig(dt);
  double worst = 0.0;
  rig.run(200.0, [&](const Frame& frame) {
    const double u = frame.state.position[3 * static_cast<std::size_t>(rig.mass)] - 10.0;
    worst = std::max(worst, std::abs(u - dt / std::sin(omega * dt) * std::sin(omega * frame.state.time)));
  });
  EXPECT_LT(worst, 1e-11);                        // roundoff of 400 steps
  EXPECT_NEAR(1.0 / omega - 1.0, -0.0106, 5e-5);  // the period error quoted for this step
}

// Position and velocity at a fixed time, and the worst energy error on the way, shrink with dt^2.
TEST(TimeIntegration, OrderIsTwo) {
  double position[3], speed[3], energy[3];
  for (int level = 0; level < 3; ++level) {
    const double dt = std::numbers::pi / (16 << level) * 0.75;
    Oscillator rig(dt);
    double worst = 0.0, v = 0.0;
    rig.run(3.0 * std::numbers::pi / 4.0, [&](const Frame& frame) {
      worst = std::max(worst, std::abs(frame.state.energy.total() - 0.5));
      v = frame.velocity[3 * static_cast<std::size_t>(rig.mass)];
    });
    position[level] = std::abs(rig.u() - std::sin(rig.state.time));
    speed[level] = std::abs(v - std::cos(rig.state.time));
    energy[level] = worst;
  }
  for (int level = 0; level < 2; ++level) {
    EXPECT_NEAR(std::log2(position[level] / position[level + 1]), 2.0, 0.1);
    EXPECT_NEAR(std::log2(speed[level] / speed[level + 1]), 2.0, 0.1);
    EXPECT_NEAR(std::log2(energy[level] / energy[level + 1]), 2.0, 0.1);
  }
}

// 0.99 of the limit 2/omega is stable for 1e5 steps, 1.01 is not (validation A12 iv).
TEST(TimeIntegration, StabilityLimit) {
  Oscillator stable(0.99 * 2.0);
  double worst = 0.0;
  EXPECT_EQ(stable
                .run(1e5 * 1.98,
                     [&](const Frame& frame) {
                       worst = std::max(
                           worst,
                           std::abs(frame.state.position[3 * static_cast<std::size_t>(stable.mass)] - 10.0));
                     })
                .ending,
            Ending::end_time);
  EXPECT_LT(worst, 15.0);  // amplitude dt / sin(omega' dt) = 7.0

  Oscillator wild(1.01 * 2.0);
  const Outcome outcome = wild.run(1e4);
  EXPECT_EQ(outcome.ending, Ending::physics);
  EXPECT_NE(outcome.status.what.find("energy grows"), std::string::npos);
  EXPECT_LT(wild.state.time, 200.0);
}

// A constant acceleration is integrated without error.
TEST(TimeIntegration, FreeFallIsExact) {
  Rig rig;
  const Index ball = rig.particle(3.0, {0, 0, 5.0}, {1.0, 0, 2.0});
  rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(9.81), 1.0, {}});
  rig.fixed_step(0.125);
  double v = 0.0;
  rig.run(2.0, [&](const Frame& frame) { v = frame.velocity[2]; });
  EXPECT_DOUBLE_EQ(rig.state.time, 2.0);
  EXPECT_NEAR(rig.x(ball, 0), 2.0, 1e-14);
  EXPECT_NEAR(rig.x(ball, 2), 5.0 + 2.0 * 2.0 - 0.5 * 9.81 * 4.0, 1e-13);
  EXPECT_NEAR(v, 2.0 - 9.81 * 2.0, 1e-13);
  EXPECT_NEAR(rig.state.energy.external, 3.0 * 9.81 * (0.5 * 9.81 * 4.0 - 4.0), 1e-11);
  EXPECT_NEAR(rig.state.energy.ratio(), 1.0, 1e-13);
}

// Free chains: momentum does not change by a bit, because internal forces cancel as integers.
TEST(TimeIntegration, MomentumOfAFreeBodyIsExact) {
  Rig rig;
  build_chain(rig, 8);
  rig.model.control.step.safety = 0.5;
  rig.velocity(0, {0.01, 0, 0});
  rig.run(20.0);
  double momentum = 0.0;
  for (Index a = 0; a <= 8; ++a) momentum += rig.state.mass[static_cast<std::size_t>(a)] * rig.v(a);
  EXPECT_NEAR(momentum, 0.01 * rig.state.mass[0], 1e-17);
}

}  // namespace
}  // namespace cleave::solver::test
