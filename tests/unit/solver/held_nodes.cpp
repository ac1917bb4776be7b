/// Nodes held and moved: closed forms of the motion, the reaction and its work.

#include <gtest/gtest.h>

#include <numbers>

#include "rig.hpp"

namespace cleave::solver::test {
namespace {

using model::PrescribedMotion;

PrescribedMotion motion(Index node, PrescribedMotion::Kind kind, Index curve, Vector direction = {1, 0, 0}) {
  PrescribedMotion out;
  out.nodes = {node};
  out.kind = kind;
  out.curve = curve;
  out.direction = direction;
  return out;
}

// A smooth curve sampled finely: (1 - cos t), its rate and its acceleration.
struct Sampled {
  std::vector<double> t, u, v, a;
  Sampled() {
    for (int k = 0; k <= 4000; ++k) {
      t.push_back(k * 1e-3);
      u.push_back(1.0 - std::cos(t.back()));
      v.push_back(std::sin(t.back()));
      a.push_back(std::cos(t.back()));
    }
  }
};

TEST(HeldNodes, EachKindOfMotionFollowsItsCurve) {
  const Sampled curve;
  for (const auto kind : {PrescribedMotion::Kind::displacement, PrescribedMotion::Kind::velocity,
                          PrescribedMotion::Kind::acceleration}) {
    double error[2];
    for (const int level : {0, 1}) {
      Rig rig;
      const Index a = rig.particle(2.0, {5, 1, 0});
      const auto& y = kind == PrescribedMotion::Kind::displacement ? curve.u
                      : kind == PrescribedMotion::Kind::velocity   ? curve.v
                                                                   : curve.a;
      rig.model.motions.push_back(motion(a, kind, rig.curve(curve.t, y), {0, 1, 0}));
      rig.fixed_step(level == 0 ? 0.02 : 0.01);
      double f = 0.0;
      rig.run(3.0, [&](const Frame& frame) { f = frame.reaction[1]; });
      const double t = rig.state.time;
      error[level] = std::abs(rig.x(a, 1) - 1.0 - (1.0 - std::cos(t)));
      EXPECT_EQ(rig.x(a, 0), 5.0);
      EXPECT_NEAR(f, 2.0 * std::cos(t), 1e-3);  // model: order dt^2
      // All work goes into kinetic energy.
      EXPECT_NEAR(rig.state.energy.ratio(), 1.0, 1e-12);
      EXPECT_NEAR(rig.state.energy.external, std::pow(std::sin(t), 2), 1e-3);
    }
    if (kind == PrescribedMotion::Kind::displacement)
      EXPECT_LT(error[0], 1e-12);  // exact at every step
    else
      EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1);
  }
}

TEST(HeldNodes, BirthDeathAndStartOfTheCurve) {
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}, {1, 0, 0}), b = rig.particle(1.0, {0, 1, 0}, {1, 0, 0});
  // From 1 to 2: b returns by 0.5, from where it is then; a stops. Before and after they fly.
  PrescribedMotion back = motion(b, PrescribedMotion::Kind::displacement, rig.curve({0, 1}, {0, -0.5}));
  back.birth = 1.0;
  back.death = 2.0;
  rig.model.motions.push_back(back);
  rig.fix({a}, 1);
  rig.model.fixed[0].birth = 1.0;
  rig.model.fixed[0].death = 2.0;
  rig.fixed_step(0.0625);
  rig.run(3.0);
  EXPECT_NEAR(rig.x(b), 1.0 - 0.5 - 0.5, 1e-12);
  EXPECT_NEAR(rig.x(a), 1.0, 1e-12);
  EXPECT_EQ(rig.v(a), 0.0);
  // What the support took from `a` when it was born, and what turned `b` round, is in the balance.
  EXPECT_NEAR(rig.state.energy.kinetic, 0.125, 1e-12);
  EXPECT_NEAR(rig.state.energy.total(), rig.state.energy.initial + rig.state.energy.external, 1e-12);
}

TEST(HeldNodes, FramesMixPerNode) {
  // Held along x and along (1,1,0): only z is left, whatever the angle between the directions.
  Rig rig;
  const double s = std::sqrt(0.5);
  const Index a = rig.particle(1.0, {0, 0, 0}, {3, 5, 7});
  rig.fix({a}, 1);
  rig.fix({a}, 1);
  rig.model.fixed[1].local = true;
  rig.model.fixed[1].frame.axis[0] = {s, s, 0};
  rig.model.fixed[1].frame.axis[1] = {-s, s, 0};
  rig.fixed_step(0.1);
  rig.run(1.0);
  EXPECT_NEAR(rig.x(a, 0), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(a, 1), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(a, 2), 7.0, 1e-14);
}

TEST(HeldNodes, MotionAlongAVectorAloneOrAcrossToo) {
  for (const bool only : {true, false}) {
    Rig rig;
    const Index a = rig.particle(1.0, {0, 0, 0}, {0, 4, 0});
    rig.model.motions.push_back(
        motion(a, PrescribedMotion::Kind::velocity, rig.constant(2.0), {0.6, 0, 0.8}));
    rig.model.motions[0].only_direction = only;
    rig.fixed_step(0.1);
    rig.run(1.0);
    EXPECT_NEAR(rig.x(a, 0), 1.2, 1e-14);
    EXPECT_NEAR(rig.x(a, 1), only ? 4.0 : 0.0, 1e-14);
    EXPECT_NEAR(rig.x(a, 2), 1.6, 1e-14);
  }
}

TEST(HeldNodes, LastMotionPrevailsWithOneWarning) {
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}), b = rig.particle(1.0, {1, 0, 0});
  for (const double v : {1.0, 2.0})
    for (const Index node : {a, b})
      rig.model.motions.push_back(motion(node, PrescribedMotion::Kind::velocity, rig.constant(v)));
  rig.fix({a}, 1);
  rig.fixed_step(0.1);
  rig.run(1.0);
  EXPECT_NEAR(rig.x(a), 2.0, 1e-14);
  EXPECT_NEAR(rig.x(b), 3.0, 1e-14);
  EXPECT_EQ(rig.diagnostics.count(deck::Severity::warning), 1u);
}

// A spring pulled slowly: the reaction is its force, the work its energy.
TEST(HeldNodes, ReactionOfASpring) {
  Rig rig;
  const Index a = rig.node(0), b = rig.node(1);
  rig.springs({{{a, b}, 8.0, 1e-4}});
  rig.fix({a}, 7);
  rig.model.motions.push_back(motion(b, PrescribedMotion::Kind::displacement, rig.curve({0, 1}, {0, 0.5})));
  rig.model.control.step.safety = 0.9;
  double left = 0.0, right = 0.0;
  rig.run(0.99, [&](const Frame& frame) {
    left = frame.reaction[0];
    right = frame.reaction[3];
  });
  const double stretch = 0.5 * rig.state.time;
  EXPECT_NEAR(right, 8.0 * stretch, 1e-12);
  EXPECT_NEAR(left, -right, 1e-12);
  EXPECT_NEAR(rig.state.energy.internal, 4.0 * stretch * stretch, 1e-12);
  EXPECT_NEAR(rig.state.energy.external, rig.state.energy.internal + rig.state.energy.kinetic, 1e-12);
}

// Rotation about an axis off the node: it lies on its circle to rounding, at the angle of the curve, whether
// the curve is an angle, a speed of rotation or its rate; without the radial row the distance is free.
TEST(HeldNodes, RotationKeepsToItsCircle) {
  using Kind = model::PrescribedMotion::Kind;
  const Vector centre{1, 0, 2};
  for (const Kind kind : {Kind::displacement, Kind::velocity, Kind::acceleration}) {
    Rig rig;
    const double radius = 5.0, start = std::atan2(4.0, 3.0), end = 3.0;  // arm (z, x) = (3, 4), about y
    const double rate = 0.7;                                             // angle 0.35 t^2
    const Index a = rig.particle(2.0, {centre.x + 4, 7, centre.z + 3});
    model::PrescribedMotion motion;
    motion.nodes = {a};
    motion.kind = kind;
    motion.rotation = true;
    motion.direction = {0, 1, 0};
    motion.centre = centre;
    std::vector<double> t, angle;
    for (int k = 0; k <= 4000; ++k) {
      t.push_back(0.001 * k);
      angle.push_back(0.5 * rate * t.back() * t.back());
    }
    motion.curve = kind == Kind::displacement ? rig.curve(t, angle)
                   : kind == Kind::velocity   ? rig.curve({0, 10}, {0, 10 * rate})
                                              : rig.constant(rate);
    rig.model.motions.push_back(motion);
    rig.fixed_step(0.01);
    rig.run(end, [&](const Frame& frame) {
      const double z = frame.state.position[2] - centre.z, x = frame.state.position[0] - centre.x;
      EXPECT_NEAR(std::hypot(z, x), radius, 1e-13);
      const double now = frame.state.time, turned = start + 0.5 * rate * now * now;
      EXPECT_NEAR(z, radius * std::cos(turned), 1e-11) << now;
      EXPECT_NEAR(x, radius * std::sin(turned), 1e-11) << now;
    });
    EXPECT_EQ(rig.x(a, 1), 7.0);
  }
}

TEST(HeldNodes, RotationMayLeaveTheRadiusFree) {
  Rig rig;
  const Index hub = rig.node(0, 0, 0), a = rig.node(1, 0, 0);
  rig.springs({{{hub, a}, 100.0, 2.0}});
  rig.fix({hub}, 7);
  model::PrescribedMotion motion;
  motion.nodes = {a};
  motion.rotation = motion.radial_free = true;
  motion.direction = {0, 0, 1};
  motion.curve = rig.constant(3.0);
  rig.model.motions.push_back(motion);
  rig.velocity(a, {0, 3.0, 0});
  rig.fixed_step(1e-3);
  double most = 0.0;
  rig.run(2.0, [&](const Frame& frame) {
    const double *x = &frame.state.position[3], t = frame.state.time;
    EXPECT_NEAR(std::remainder(std::atan2(x[1], x[0]) - 3.0 * t, 2 * M_PI), 0.0, 1e-12);
    most = std::max(most, std::hypot(x[0], x[1]));
  });
  // m r'' = m w^2 r - k (r - 1): the mean is 1 / (1 - m w^2 / k), the swing as far beyond it. m = 1.
  EXPECT_NEAR(most, 2.0 / (1.0 - 9.0 / 100.0) - 1.0, 5e-4);  // first order in the step
}

// v = 2 (1 - u): the displacement tends to 1 as 1 - exp(-2 t), in second order.
TEST(HeldNodes, VelocityOverDisplacement) {
  double error[2];
  for (const int level : {0, 1}) {
    Rig rig;
    const Index a = rig.particle(2.0, {5, 0, 0});
    model::PrescribedMotion motion;
    motion.nodes = {a};
    motion.kind = model::PrescribedMotion::Kind::velocity_by_displacement;
    motion.curve = rig.curve({0, 2}, {1, -1});
    motion.scale = 2.0;
    rig.model.motions.push_back(motion);
    rig.fixed_step(level == 0 ? 0.02 : 0.01);
    rig.run(1.0);
    error[level] = std::abs(rig.x(a) - 5.0 - (1.0 - std::exp(-2.0 * rig.state.time)));
  }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.2);
}

}  // namespace
}  // namespace cleave::solver::test
