/// Rigid walls of simple geometry: where they hold nodes, momentum, sliding along them, motion; closed forms.

#include <gtest/gtest.h>

#include "rig.hpp"

namespace cleave::solver::test {
namespace {

using Shape = model::RigidWall::Shape;

model::RigidWall geometric(Shape shape, Vector origin, double radius, std::vector<Index> nodes) {
  model::RigidWall wall;
  wall.geometric = true;
  wall.keyword = "RIGIDWALL_GEOMETRIC_SPHERE";
  wall.shape = shape;
  wall.origin = origin;
  wall.normal = {0, 0, 1};
  wall.radius = radius;
  wall.nodes = std::move(nodes);
  return wall;
}

double impulse_of(const Frame& frame, int i) {
  return frame.walls[0].force[i] * 0.5 * (frame.state.step + frame.state.next_step);
}

// A node that hits a sphere off its middle: the impulse is along the radius and takes the normal velocity; it
// flies on with what is tangential. Momentum of the node = impulse of the wall, energy = its loss.
TEST(GeometricWall, ImpactOnASphereIsNormalToIt) {
  Rig rig;
  const double m = 3.0, v = 2.0, offset = 0.6;  // of a radius 1: the normal is (0.6, 0, 0.8)
  const Index a = rig.particle(m, {offset, 0, 3.0}, {0, 0, -v});
  rig.model.walls.push_back(geometric(Shape::sphere, {0, 0, 0}, 1.0, {a}));
  rig.fixed_step(1e-4);
  double impulse[3] = {0, 0, 0}, normal = 0.0;
  rig.run(2.0, [&](const Frame& frame) {
    for (int i = 0; i < 3; ++i) impulse[i] += impulse_of(frame, i);
    normal += frame.walls[0].normal * 0.5 * (frame.state.step + frame.state.next_step);
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.initial, 1e-12);
  });
  const Vector n{0.6, 0, 0.8};
  const Vector after = Vector{0, 0, -v} + (v * n.z) * n;
  const double order = v * 1e-4;  // how far the normal turns within a step
  EXPECT_NEAR(rig.v(a, 0), after.x, order);
  EXPECT_NEAR(rig.v(a, 2), after.z, order);
  EXPECT_NEAR(normal, m * v * n.z, m * order);
  EXPECT_NEAR(rig.state.energy.wall, 0.5 * m * std::pow(v * n.z, 2), m * order);
  // Whatever the step: what the node gains is what the wall gives, and the loss is what the node loses.
  EXPECT_NEAR(impulse[0], m * rig.v(a, 0), 1e-12);
  EXPECT_NEAR(impulse[2], m * (rig.v(a, 2) + v), 1e-12);
  const double kept = rig.v(a, 0) * rig.v(a, 0) + rig.v(a, 2) * rig.v(a, 2);
  EXPECT_NEAR(rig.state.energy.wall, 0.5 * m * (v * v - kept), 1e-12);
}

// Without friction a particle leaves a sphere where its height above the middle is two thirds of the radius.
TEST(GeometricWall, ParticleSlidesDownASphereAndLeavesIt) {
  const double g = 10.0, radius = 1.0, start = 0.1;
  double error[2];
  for (int fine = 0; fine < 2; ++fine) {
    Rig rig;
    const Index a = rig.particle(2.0, {radius * std::sin(start), 0, radius * std::cos(start)});
    rig.model.walls.push_back(geometric(Shape::sphere, {0, 0, 0}, radius, {a}));
    rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
    rig.fixed_step(fine ? 1e-3 : 2e-3);
    double height = 0.0;
    rig.run(1.5, [&](const Frame& frame) {
      if (frame.walls[0].normal <= 0.0) return;
      height = frame.state.position[2];
      EXPECT_NEAR(std::hypot(frame.state.position[0], frame.state.position[2]), radius, 1e-14);
    });
    error[fine] = std::abs(height - 2.0 / 3.0 * radius * std::cos(start));
    EXPECT_LT(error[fine], fine ? 2e-3 : 4e-3);  // a step moves it by 3 mm there
    EXPECT_NEAR(rig.state.energy.wall, 0.0, 1e-4 * rig.state.energy.kinetic);
  }
}

// A particle in a hollow cylinder runs around for ever: on the circle to the bit, speed kept, force m v^2 /
// R.
TEST(GeometricWall, ParticleRunsAroundInAHollowCylinder) {
  Rig rig;
  const double m = 2.0, v = 3.0, radius = 0.5;
  const Index a = rig.particle(m, {radius, 0, 0}, {0, v, 0.25});
  rig.model.walls.push_back(geometric(Shape::cylinder, {0, 0, 0}, radius, {a}));
  rig.model.walls[0].interior = true;
  const double dt = 1e-3;
  rig.fixed_step(dt);
  double least = 1e9, most = 0.0;
  rig.run(10.0, [&](const Frame& frame) {  // 9.5 turns
    EXPECT_NEAR(std::hypot(frame.state.position[0], frame.state.position[1]), radius, 1e-14);
    if (frame.state.cycle < 2) return;
    least = std::min(least, frame.walls[0].normal);
    most = std::max(most, frame.walls[0].normal);
  });
  EXPECT_NEAR(std::hypot(rig.v(a, 0), rig.v(a, 1)), v, v * std::pow(v * dt / radius, 2));
  EXPECT_NEAR(rig.v(a, 2), 0.25, 1e-12);
  EXPECT_NEAR(least, m * v * v / radius, 1e-4 * m * v * v / radius);
  EXPECT_NEAR(most, m * v * v / radius, 1e-4 * m * v * v / radius);
  // Place after the time of the run: the angle grows by v t / R.
  const double angle = std::atan2(rig.x(a, 1), rig.x(a, 0));
  EXPECT_NEAR(std::cos(angle), std::cos(v * rig.state.time / radius), 2e-3);
}

// In a hollow sphere under gravity a small swing has the period of a pendulum of that length.
TEST(GeometricWall, HollowSphereIsAPendulum) {
  Rig rig;
  const double g = 10.0, radius = 1.0, swing = 0.02;
  const Index a = rig.particle(1.0, {radius * std::sin(swing), 0, -radius * std::cos(swing)});
  rig.model.walls.push_back(geometric(Shape::sphere, {0, 0, 0}, radius, {a}));
  rig.model.walls[0].interior = true;
  rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
  rig.fixed_step(1e-3);
  std::vector<double> crossings;
  double before = 1.0;
  rig.run(10.0, [&](const Frame& frame) {
    const double x = frame.state.position[0];
    if (before < 0.0 && x >= 0.0) crossings.push_back(frame.state.time - frame.state.step * x / (x - before));
    before = x;
  });
  ASSERT_GE(crossings.size(), 4u);
  const double period = 2.0 * M_PI * std::sqrt(radius / g) * (1.0 + swing * swing / 16.0);
  EXPECT_NEAR((crossings[3] - crossings[0]) / 3.0, period, 1e-5 * period);
}

// A hollow cylinder that starts to move takes along what lies on its trailing half: each node gets the normal
// velocity of the wall, then slides along it with what is tangential, V sin(angle), and stays on it to the
// bit.
TEST(GeometricWall, NodesLieOnAMovingHollowCylinder) {
  Rig rig;
  const double radius = 2.0, v = 0.5, dt = 1e-3;
  std::vector<Index> ring;
  std::vector<double> start;
  for (int k = 0; k < 9; ++k) {
    start.push_back(M_PI + 0.3 * (k - 4));
    ring.push_back(
        rig.particle(1.0, {radius * std::cos(start.back()), radius * std::sin(start.back()), 0.1 * k}));
  }
  rig.model.walls.push_back(geometric(Shape::cylinder, {0, 0, 0}, radius, ring));
  auto& wall = rig.model.walls[0];
  wall.interior = true;
  wall.motion = rig.curve({0, 1, 100}, {0, v, 99 * v + v});
  wall.motion_is_displacement = true;
  wall.motion_direction = {1, 0, 0};
  rig.fixed_step(dt);
  double impulse = 0.0, coming = 0.0;  // that of the last frame acts in the step after it
  rig.run(2.0, [&](const Frame& frame) {
    impulse += coming;
    coming = impulse_of(frame, 0);
    EXPECT_NEAR(frame.walls[0].position, v * frame.state.time, 1e-12);
    for (const Index node : ring) {
      const double* x = &frame.state.position[3 * static_cast<std::size_t>(node)];
      EXPECT_NEAR(std::hypot(x[0] - frame.walls[0].position, x[1]), radius, 1e-12);  // 2000 roundings
    }
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.external, 1e-12);
  });
  const double t = rig.state.time;
  double momentum = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double angle = std::atan2(rig.x(ring[k], 1), rig.x(ring[k]) - v * t);
    const double expected = start[k] + v * std::sin(start[k]) * t / radius;
    EXPECT_NEAR(std::remainder(angle - expected, 2.0 * M_PI), 0.0, v * dt);
    EXPECT_NEAR(rig.x(ring[k], 2), 0.1 * static_cast<double>(k), 1e-15);
    momentum += rig.v(ring[k]);
  }
  EXPECT_NEAR(impulse, momentum, 1e-12);
}

// A prism: each face holds what comes through it, along its own normal, edges included; a node that runs off
// an edge is free.
TEST(GeometricWall, FacesAndEdgesOfAPrism) {
  Rig rig;
  const Index top = rig.particle(1.0, {0.5, 0.5, 1.0}, {0, 0, -1}),
              side = rig.particle(1.0, {2.0, 0.5, -0.5}, {-1, 0, 0}),
              edge = rig.particle(1.0, {0.98, 0.5, 0.5}, {0.005, 0, -1}),  // through the top, near the edge
      corner = rig.particle(1.0, {1.5, 0.5, -0.02}, {-1, 0, 0.001}),       // through the side, near the top
      under = rig.particle(1.0, {0.5, 0.5, -3.0}, {0, 0, 1}),
              beside = rig.particle(1.0, {1.2, 0.5, 1.0}, {0, 0, -1}),
              off = rig.particle(1.0, {0.5, 0.25, 0.0}, {1, 0, -0.5});  // slides over the top and off it
  auto wall = geometric(Shape::prism, {0, 0, 0}, 0.0, {top, side, edge, corner, under, beside, off});
  wall.edge_l = {1, 0, 0};
  wall.edge_m = {0, 1, 0};
  wall.length_l = wall.length_m = 1.0;
  wall.length_n = 2.0;
  rig.model.walls.push_back(wall);
  rig.fixed_step(0.01);
  rig.run(3.0);
  EXPECT_NEAR(rig.x(top, 2), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(side, 0), 1.0, 1e-14);
  EXPECT_NEAR(rig.x(edge, 2), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(corner, 0), 1.0, 1e-14);
  EXPECT_NEAR(rig.v(corner, 2), 0.001, 1e-15);
  EXPECT_NEAR(rig.x(under, 2), -2.0, 1e-14);
  EXPECT_NEAR(rig.x(beside, 2), 1.0 - rig.state.time, 1e-12);
  EXPECT_NEAR(rig.x(off, 2), 0.0, 1e-14);
  EXPECT_NEAR(rig.x(off, 0), 0.5 + rig.state.time, 1e-12);
}

// Friction on a cylinder that turns no node around it: along its axis Coulomb's law as on a plane.
TEST(GeometricWall, FrictionAlongACylinder) {
  const double mu = 0.3, g = 10.0, v = 2.0;
  Rig rig;
  const Index a = rig.particle(2.0, {0, 0, 1}, {v, 0, 0}), b = rig.particle(2.0, {0, 0, 1}, {v, 0, 0});
  auto wall = geometric(Shape::cylinder, {-5, 0, 0}, 1.0, {a});
  wall.normal = {1, 0, 0};
  wall.edge_l = {0, 1, 0};
  wall.friction = mu;
  rig.model.walls.push_back(wall);
  wall.nodes = {b};
  wall.friction = 1.0;
  rig.model.walls.push_back(wall);
  rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
  rig.fixed_step(1e-3);
  rig.run(1.5 * v / (mu * g));
  EXPECT_NEAR(rig.x(a), v * v / (2.0 * mu * g), 1e-5);
  EXPECT_NEAR(rig.x(a, 2), 1.0, 1e-14);
  EXPECT_NEAR(rig.x(b), 0.0, 1e-14);
}

// The curve of a motion begins at birth. A wall that starts at once takes a node along: plastic impact
// against an infinite mass, so the work is m V^2, half of it lost.
TEST(GeometricWall, VelocityCurveBeginsAtBirth) {
  Rig rig;
  const double m = 2.0, v = 0.5;
  const Index a = rig.particle(m, {0, 0, 1.05});
  auto wall = geometric(Shape::plane, {0, 0, 1.0}, 0.0, {a});
  wall.motion = rig.curve({0, 100}, {v, v});
  wall.motion_direction = {0, 0, 1};
  wall.birth = 1.0;
  rig.model.walls.push_back(wall);
  rig.fixed_step(0.01);
  double impulse = 0.0;
  rig.run(2.0, [&](const Frame& frame) {
    impulse += impulse_of(frame, 2);
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.external, 1e-12);
    EXPECT_NEAR(frame.walls[0].position, v * std::max(frame.state.time - 1.0, 0.0), 1e-12);
  });
  EXPECT_NEAR(rig.x(a, 2), 1.0 + v * (rig.state.time - 1.0), 1e-12);
  EXPECT_NEAR(impulse, m * v, 1e-12);
  EXPECT_NEAR(rig.state.energy.external, m * v * v, 1e-12);
  EXPECT_NEAR(rig.state.energy.wall, 0.5 * m * v * v, 1e-12);
}

// What is inside at the start is counted in a warning; it may leave but not go deeper.
TEST(GeometricWall, NodesInsideMayLeaveButNotGoDeeper) {
  Rig rig;
  const Index deep = rig.particle(1.0, {0, 0, 0.9}, {0, 0, -1}),
              leaves = rig.particle(1.0, {0.9, 0, 0}, {1, 0, 0});
  rig.model.walls.push_back(geometric(Shape::sphere, {0, 0, 0}, 1.0, {deep, leaves}));
  rig.fixed_step(0.01);
  rig.run(1.0);
  EXPECT_NEAR(rig.x(deep, 2), 0.9, 1e-14);
  EXPECT_NEAR(rig.x(leaves), 0.9 + rig.state.time, 1e-12);
  ASSERT_EQ(rig.diagnostics.all().size(), 1u);
  EXPECT_EQ(rig.diagnostics.all()[0].message.find("2 nodes lie inside rigid wall"), 0u);
}

// Friction that differs along two directions: a slide along one of them feels its coefficient alone; a slide
// across both is held while the impulse lies in the ellipse; the force lies on the ellipse when it slides.
TEST(RigidWallOrthotropic, EachDirectionHasItsFriction) {
  const double g = 10.0, v = 2.0, mu[2] = {0.2, 0.4};
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}, {v, 0, 0}), b = rig.particle(1.0, {0, 0, 0}, {0, v, 0}),
              c = rig.particle(1.0, {0, 0, 0}, {v, v, 0});
  model::RigidWall wall;
  wall.normal = {0, 0, 1};
  wall.orthotropic = true;
  wall.friction_axis = {1, 0, 0};
  for (int k = 0; k < 2; ++k) wall.static_friction[k] = wall.dynamic_friction[k] = mu[k];
  for (const Index node : {a, b, c}) {
    wall.nodes = {node};
    rig.model.walls.push_back(wall);
  }
  rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
  rig.fixed_step(1e-3);
  rig.run(1.5, [&](const Frame& frame) {
    const double* f = frame.walls[2].force;
    const double speed = std::hypot(frame.state.velocity[6], frame.state.velocity[7]);
    if (frame.state.cycle == 0 || speed < 0.1) return;
    EXPECT_NEAR(std::pow(f[0] / (mu[0] * g), 2) + std::pow(f[1] / (mu[1] * g), 2), 1.0, 1e-9);
  });
  EXPECT_NEAR(rig.x(a), v * v / (2.0 * mu[0] * g), 1e-5);
  EXPECT_NEAR(rig.x(b, 1), v * v / (2.0 * mu[1] * g), 1e-5);
  EXPECT_NEAR(std::hypot(rig.v(c, 0), rig.v(c, 1)), 0.0, 1e-12);
  // The rougher direction stops sooner.
  EXPECT_GT(rig.x(c, 0), rig.x(c, 1));
}

// Coefficients that fall with the speed: a block on an incline of 30 degrees rests if static friction holds
// it, and once it slides fast it feels the dynamic coefficient alone.
TEST(RigidWallOrthotropic, FrictionFallsWithSpeed) {
  const double g = 10.0, slope = M_PI / 6.0;
  for (const bool pushed : {false, true}) {
    Rig rig;
    const Vector normal{std::sin(slope), 0, std::cos(slope)}, down{std::cos(slope), 0, -std::sin(slope)};
    const Index a = rig.particle(1.0, {0, 0, 0}, (pushed ? 50.0 : 0.0) * down);
    model::RigidWall wall;
    wall.normal = normal;
    wall.orthotropic = true;
    wall.friction_axis = {0, 1, 0};
    wall.nodes = {a};
    wall.static_friction[0] = wall.static_friction[1] = 0.7;
    wall.dynamic_friction[0] = wall.dynamic_friction[1] = 0.2;
    wall.friction_decay[0] = wall.friction_decay[1] = 1.0;
    rig.model.walls.push_back(wall);
    rig.model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, rig.constant(g), 1.0, {}});
    rig.fixed_step(1e-3);
    rig.run(1.0);
    const double t = rig.state.time, moved = base::dot({rig.x(a, 0), rig.x(a, 1), rig.x(a, 2)}, down);
    const double acceleration = g * (std::sin(slope) - 0.2 * std::cos(slope));
    EXPECT_NEAR(moved, pushed ? 50.0 * t + 0.5 * acceleration * t * t : 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace cleave::solver::test
