/// Rigid walls: momentum, friction, moving walls, all in closed form.

#include <gtest/gtest.h>

#include "rig.hpp"

namespace cleave::solver::test {
namespace {

model::RigidWall wall_at(Vector origin, Vector normal, std::vector<Index> nodes) {
  model::RigidWall wall;
  wall.origin = origin;
  wall.normal = normal;
  wall.nodes = std::move(nodes);
  return wall;
}

// A node is stopped on the wall; the impulse is its momentum, the loss its kinetic energy.
TEST(RigidWall, StopsANodeOnItsSurface) {
  Rig rig;
  const Index a = rig.particle(3.0, {0, 0, 1.03}, {1, 0, -2});
  rig.model.walls.push_back(wall_at({0, 0, 0.25}, {0, 0, 1}, {a}));
  rig.fixed_step(0.1);
  double impulse = 0.0, lowest = 1e9;
  rig.run(1.0, [&](const Frame& frame) {
    impulse += frame.walls[0].normal * 0.5 * (frame.state.step + frame.state.next_step);
    lowest = std::min(lowest, frame.state.position[2]);
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.initial, 1e-12);
  });
  EXPECT_NEAR(impulse, 6.0, 1e-12);
  EXPECT_NEAR(lowest, 0.25, 1e-15);
  EXPECT_NEAR(rig.x(a, 2), 0.25, 1e-15);
  EXPECT_NEAR(rig.x(a, 0), 1.0, 1e-14);
  EXPECT_NEAR(rig.state.energy.wall, 6.0, 1e-12);
  EXPECT_EQ(rig.state.energy.external, 0.0);
}

// An elastic chain at the Courant step rebounds as the exact rod does: contact lasts 2 L / c, then it flies
// back. The node on the wall loses its share of energy, so speed and energy tend to the rod's with the mesh.
// (Later the highest mode of the free chain, exactly at its stability limit, would grow linearly.)
TEST(RigidWall, ElasticRodRebounds) {
  for (const int count : {20, 80}) {
    Rig rig;
    const double h = 1.0 / count;
    std::vector<Springs::Spring> list;
    std::vector<Index> all;
    for (int a = 0; a <= count; ++a) {
      all.push_back(rig.node(0, 0, a * h));
      rig.velocity(all.back(), {0, 0, -0.1});
    }
    for (Index e = 0; e < count; ++e) list.push_back({{e, e + 1}, 1.0 / h, h});
    rig.springs(std::move(list));
    rig.model.walls.push_back(wall_at({0, 0, 0}, {0, 0, 1}, all));
    double impulse = 0.0, last_contact = 0.0;
    rig.run(2.0 + 0.5 * h, [&](const Frame& frame) {
      const double dt = 0.5 * (frame.state.step + frame.state.next_step);
      impulse += frame.walls[0].normal * dt;
      if (frame.walls[0].normal > 1e-3) last_contact = frame.state.time;
      EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.initial, 0.05 * h);  // order h
    });
    double momentum = 0.0;
    for (const Index a : all) momentum += rig.state.mass[static_cast<std::size_t>(a)] * rig.v(a, 2);
    EXPECT_NEAR(momentum + 0.1, impulse, 1e-13);  // exact
    EXPECT_NEAR(momentum, 0.1, 0.2 * h);          // order h
    EXPECT_NEAR(last_contact, 2.0, 1.5 * h);
    EXPECT_NEAR(rig.state.energy.wall, 0.5 * 0.01 * 0.5 * h, 1e-6);  // half of one node's mass, stopped once
  }
}

// A block under gravity g slides to rest on the wall: stop distance v^2 / 2 mu g, heat = its kinetic energy.
TEST(RigidWall, FrictionStopsABlock) {
  const double mu = 0.3, g = 10.0, v = 2.0;
  Rig rig;
  const Index a = rig.particle(2.0, {0, 0, 0}, {v, 0, 0});
  rig.model.walls.push_back(wall_at({0, 0, 0}, {0, 0, 1}, {a}));
  rig.model.walls[0].friction = mu;
  rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
  rig.fixed_step(1e-3);
  double force = 0.0;
  rig.run(1.5 * v / (mu * g), [&](const Frame& frame) {
    if (frame.state.cycle == 100) force = frame.walls[0].force[0];
  });
  EXPECT_NEAR(rig.x(a), v * v / (2.0 * mu * g), 1e-5);  // order dt^2
  EXPECT_NEAR(rig.v(a), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(a, 2), 0.0, 1e-15);
  EXPECT_NEAR(force, -mu * 2.0 * g, 1e-9);
  EXPECT_NEAR(rig.state.energy.wall, 4.0, 1e-9);
}

// On an incline a block rests below the angle of friction and slides with g (sin - mu cos) above it.
TEST(RigidWall, InclineSticksOrSlides) {
  for (const double mu : {0.6, 0.2}) {
    Rig rig;
    const Index a = rig.particle(1.0, {0, 0, 0});
    rig.model.walls.push_back(wall_at({0, 0, 0}, {0.5, 0, std::sqrt(0.75)}, {a}));  // 30 degrees, tan = 0.577
    rig.model.walls[0].friction = mu;
    rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(10.0), 1.0, {}});
    rig.fixed_step(1e-3);
    rig.run(1.0);
    const double t = rig.state.time,
                 slide = mu > 0.577 ? 0.0 : 0.5 * 10.0 * (0.5 - mu * std::sqrt(0.75)) * t * t;
    EXPECT_NEAR(std::hypot(rig.x(a), rig.x(a, 2)), slide, 1e-9);
  }
}

TEST(RigidWall, FrictionOneDoesNotSlideAndTwoOrThreeWeld) {
  for (const double friction : {0.0, 1.0, 2.0, 3.0}) {
    Rig rig;
    const Index a = rig.particle(1.0, {0, 0, 0.5}, {1, 0, -1});
    rig.model.walls.push_back(wall_at({0, 0, 0}, {0, 0, 1}, {a}));
    rig.model.walls[0].friction = friction;
    rig.model.walls[0].velocity_limit = 0.5;
    // After the impact the base falls away: only a weld holds the node.
    rig.model.body_loads.push_back(
        {{0, 0, 1}, false, {0, 0, 0}, rig.curve({0, 1, 1, 9}, {0, 0, -2, -2}), 1.0, {}});
    rig.fixed_step(0.1);
    rig.run(2.0);
    const bool welds = friction >= 2.0, slides = friction == 0.0 || friction == 2.0;
    EXPECT_NEAR(rig.x(a), slides ? rig.state.time : 0.5, 1e-9) << friction;
    if (welds)
      EXPECT_NEAR(rig.x(a, 2), 0.0, 1e-12);
    else
      EXPECT_GT(rig.x(a, 2), 0.5);
  }
}

// Two bodies, plastic impact: common velocity M V / (M + m), loss M m V^2 / 2 (M + m).
TEST(RigidWall, MovingWallSharesItsMomentum) {
  const double wall_mass = 5.0, speed = 2.0;
  Rig rig;
  const Index a = rig.particle(2.0, {0, 0, 1.0}), b = rig.particle(1.0, {1, 0, 1.0}),
              far = rig.particle(1.0, {2, 0, 9});
  rig.model.walls.push_back(wall_at({0, 0, 0.05}, {0, 0, 1}, {a, b, far}));
  rig.model.walls[0].mass = wall_mass;
  rig.model.walls[0].speed = speed;
  rig.fixed_step(0.1);
  double last = 0.0;
  rig.run(2.0, [&](const Frame& frame) {
    last = frame.walls[0].velocity;
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.external, 1e-12);
  });
  const double common = wall_mass * speed / (wall_mass + 3.0);
  EXPECT_NEAR(last, common, 1e-13);
  EXPECT_NEAR(rig.v(a, 2), common, 1e-13);
  EXPECT_NEAR(rig.v(b, 2), common, 1e-13);
  EXPECT_EQ(rig.v(far, 2), 0.0);
  // The wall gave what it lost; the plastic impact lost M m V^2 / 2 (M + m).
  EXPECT_NEAR(rig.state.energy.external, 0.5 * wall_mass * (speed * speed - common * common), 1e-12);
  EXPECT_NEAR(rig.state.energy.wall, 0.5 * wall_mass * 3.0 / (wall_mass + 3.0) * speed * speed, 1e-12);
}

TEST(RigidWall, FiniteWallCatchesOnlyWhatHitsIt) {
  Rig rig;
  const Index inside = rig.particle(1.0, {0.5, 0.5, 1}, {0, 0, -1}),
              beside = rig.particle(1.0, {2.5, 0.5, 1}, {0, 0, -1});
  // Passes beside the wall, then comes under it: must not be caught from behind.
  const Index under = rig.particle(1.0, {3.0, 0.5, 0.5}, {-1.5, 0, -1});
  auto wall = wall_at({0, 0, 0}, {0, 0, 1}, {inside, beside, under});
  wall.finite = true;
  wall.length_l = 2.0;
  wall.length_m = 1.0;
  rig.model.walls.push_back(wall);
  rig.fixed_step(0.1);
  rig.run(2.0);
  EXPECT_NEAR(rig.x(inside, 2), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(beside, 2), 1.0 - rig.state.time, 1e-12);
  EXPECT_NEAR(rig.x(under, 2), 0.5 - rig.state.time, 1e-12);
}

TEST(RigidWall, SoftTakesTheVelocityOverSomeCycles) {
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}, {0, 0, -1});
  rig.model.walls.push_back(wall_at({0, 0, 0}, {0, 0, 1}, {a}));
  rig.model.walls[0].soft_cycles = 4;
  rig.fixed_step(0.1);
  std::vector<double> v;
  double impulse = 0.0;
  rig.run(1.0, [&](const Frame& frame) {
    if (frame.state.cycle > 0) v.push_back(frame.state.velocity[2]);
    impulse += frame.walls[0].normal * 0.5 * (frame.state.step + frame.state.next_step);
  });
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(v[static_cast<std::size_t>(k)], -0.75 + 0.25 * k, 1e-12);
  EXPECT_NEAR(v.back(), 0.0, 1e-14);
  EXPECT_NEAR(impulse, 1.0, 1e-12);
}

TEST(RigidWall, BirthAndDeath) {
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}, {0, 0, -1});
  rig.model.walls.push_back(wall_at({0, 0, -1.2}, {0, 0, 1}, {a}));
  rig.model.walls[0].death = 1.0;
  rig.fixed_step(0.1);
  rig.run(2.0);
  EXPECT_NEAR(rig.x(a, 2), -2.0, 1e-12);
}

}  // namespace
}  // namespace cleave::solver::test
