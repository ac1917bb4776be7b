/// Rigid bodies on planar rigid walls, by penalty (RWPNAL): impulse, energy, friction, walls with a mass.

#include "body_run.hpp"
#include "rig.hpp"

namespace cleave::solver::test {
namespace {

using deck::Severity;

/// The box of 12 [mass], its lower face at z = 0, over a wall; a step of 0.01.
std::string over_wall(const std::string& penalty, const std::string& end, const std::string& velocity,
                      const std::string& wall, const std::string& step = "0.01") {
  return box("*CONTROL_TERMINATION\n" + end + "\n*CONTROL_ENERGY\n1,2,2,1\n*CONTROL_CONTACT\n0.1," + penalty +
             "\n\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,9\n*DEFINE_CURVE\n9\n0," + step + "\n9999," + step + "\n") +
         "*INITIAL_VELOCITY_RIGID_BODY\n1," + velocity + "\n" + wall;
}
const std::string plane = "*RIGIDWALL_PLANAR\n0\n0,0,-0.1,0,0,1\n";
const std::string gravity = "*LOAD_BODY_Z\n8,1.0\n*DEFINE_CURVE\n8\n0,10.0\n9999,10.0\n";

// The speed comes back, nothing else changes; what the wall gave is what the box got, to rounding. All of the
// energy that the springs take comes back but for what the corners of the force in time leave.
TEST(RigidWallPenalty, BoxBouncesFlat) {
  double impulse = 0.0, most = 0.0;
  const BodyRun run(over_wall("1.0", "1.0", "0.3,0,-2.0,0,0,0", plane), 0, [&](const Frame& frame) {
    impulse += frame.walls[0].normal * 0.5 * (frame.state.step + frame.state.next_step);
    most = std::max(most, frame.state.energy.wall);
  });
  ASSERT_FALSE(run.diagnostics.failed());
  EXPECT_NEAR(run.last.velocity[2], 2.0, 0.01);
  EXPECT_NEAR(impulse, 12.0 * (run.last.velocity[2] + 2.0), 1e-11);
  EXPECT_NEAR(run.last.velocity[0], 0.3, 1e-13);
  for (const double spin : run.last.spin) EXPECT_NEAR(spin, 0.0, 1e-12);
  EXPECT_NEAR(most, 24.0, 0.5);  // at the turn the springs hold m v^2 / 2
  EXPECT_NEAR(run.state.energy.wall, 0.0, 0.25);
  EXPECT_LT(run.most_energy - run.least_energy, 1e-11 * run.most_energy);
}

// A corner first: an impulse J at the corner r from the centre. Newton and Euler give velocity and spin, the
// kept energy gives J.
TEST(RigidWallPenalty, BoxBouncesOnAnEdge) {
  // A ledge under the edge x = 0: a wall that ends, half a unit wide.
  const std::string ledge = "*RIGIDWALL_PLANAR_FINITE\n0\n-0.25,-1,-0.1,-0.25,-1,1\n1,-1,-0.1,0.5,4\n";
  const BodyRun run(over_wall("1.0", "0.2", "0,0,-2.0,0,0,0", ledge, "0.001"));
  // J (1/m + x^2 / Jy) = 2 v with the arm x = 1/2 and Jy = m (1 + 9) / 12 about the centre.
  const double inertia = 12.0 * 10.0 / 12.0, impulse = 4.0 / (1.0 / 12.0 + 0.25 / inertia);
  EXPECT_NEAR(run.last.velocity[2], -2.0 + impulse / 12.0, 0.04);
  EXPECT_NEAR(run.last.spin[1], 0.5 * impulse / inertia, 0.04);
  EXPECT_LT(run.most_energy - run.least_energy, 2e-4 * run.most_energy);  // order: the nodes' way is a chord
}

// At rest the mean force is the weight; it swings from 0 to twice the depth W / k, k = 0.1 RWPNAL m / dt^2 of
// four nodes that together have a sixth of the mass.
TEST(RigidWallPenalty, BoxRestsUnderItsWeight) {
  for (const double scale : {1.0, 2.0}) {
    double sum = 0.0, deepest = 0.0;
    const BodyRun run(over_wall(std::to_string(scale), "5.0", "0,0,0,0,0,0",
                                "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1\n" + gravity),
                      0, [&](const Frame& frame) {
                        sum += frame.walls[0].normal * frame.state.next_step;
                        deepest = std::min(deepest, frame.state.position[2]);
                      });
    const double stiffness = 0.1 * scale * 2.0 / 1e-4, swing = std::sqrt(stiffness / 12.0) * run.state.time;
    EXPECT_NEAR(sum / run.state.time, 120.0 * (1.0 - std::sin(swing) / swing), 0.5);
    EXPECT_NEAR(deepest, -2.0 * 120.0 / stiffness, 0.002);
    EXPECT_LT(run.most_energy - run.least_energy, 1e-10 * std::abs(run.most_energy) + 1e-9);
  }
}

// What lies behind at the start may leave freely; if it goes deeper it comes back.
TEST(RigidWallPenalty, BehindAtTheStart) {
  const std::string above = "*RIGIDWALL_PLANAR\n0\n0,0,0.1,0,0,1\n";
  const BodyRun leaves(over_wall("1.0", "1.0", "0,0,0.5,0,0,0", above));
  EXPECT_NEAR(leaves.last.velocity[2], 0.5, 1e-13);
  EXPECT_NEAR(leaves.last.displacement[2], 0.5 * leaves.state.time, 1e-12);
  const BodyRun deeper(over_wall("1.0", "1.0", "0,0,-0.5,0,0,0", above));
  EXPECT_NEAR(deeper.last.velocity[2], 0.5, 0.005);
}

// Sliding to rest: v^2 / 2 mu g, the heat is what it had.
TEST(RigidWallPenalty, FrictionStopsABox) {
  const std::string rough = "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1,0.2\n";
  const BodyRun run(over_wall("1.0", "1.2", "0,2.0,0,0,0,0", rough + gravity, "0.0005"));
  EXPECT_NEAR(run.last.displacement[1], 4.0 / (2.0 * 0.2 * 10.0), 0.01);
  EXPECT_NEAR(run.last.velocity[1], 0.0, 0.02);
  EXPECT_NEAR(run.state.energy.wall, 24.0, 0.5);
  EXPECT_LT(run.most_energy - run.least_energy, 1e-6);
}

// FRIC 1 holds a box that would slide, and FRIC 3 one that would fall off.
TEST(RigidWallPenalty, HoldsAndWelds) {
  const std::string along =
      "*LOAD_BODY_Y\n7,1.0\n*DEFINE_CURVE\n7\n0,0\n1,0\n1.5,5.0\n9999,5.0\n*DAMPING_GLOBAL\n0,10.0\n";
  const BodyRun held(over_wall("1.0", "3.0", "0,0,0,0,0,0",
                               "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1,1.0\n" + gravity + along, "0.005"));
  // It gives way as its springs do: 12 times 5 over 0.1 times 2 / dt^2.
  EXPECT_NEAR(held.state.position[1], -60.0 / (0.1 * 2.0 / 2.5e-5), 5e-4);
  const std::string up = "*LOAD_BODY_Z\n8,1.0\n*DEFINE_CURVE\n8\n0,-10.0\n9999,-10.0\n";
  const auto from = [&](const std::string& friction) {
    return over_wall("1.0", "1.0", "0,0,-1.0,0,0,0",
                     "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1," + friction + ",0.5\n" + up, "0.005");
  };
  EXPECT_LT(BodyRun(from("3.0")).last.displacement[2], 0.1);
  EXPECT_GT(BodyRun(from("1.0")).last.displacement[2], 1.0);
}

// A wall as heavy as the box gives it its whole speed; the momentum of both is kept to rounding.
TEST(RigidWallPenalty, MovingWallGivesItsMomentum) {
  double wall_speed = 0.0, worst = 0.0;
  const BodyRun run(
      over_wall("1.0", "1.0", "0,0,0,0,0,0", "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,-0.1,0,0,1\n12.0,2.0\n"), 0,
      [&](const Frame& frame) {
        wall_speed = frame.walls[0].velocity;
        worst = std::max(worst, std::abs(wall_speed + frame.state.velocity[2] - 2.0));
      });
  EXPECT_NEAR(run.last.velocity[2], 2.0, 0.01);
  EXPECT_NEAR(wall_speed, 0.0, 0.01);
  EXPECT_LT(run.most_energy - run.least_energy, 1e-10);
  EXPECT_NEAR(run.state.energy.wall, 0.0, 0.25);
}

// A wall that ends lets pass what falls beside it, and what has passed does not meet it from behind.
TEST(RigidWallPenalty, PassesBesideAWallThatEnds) {
  const BodyRun run(over_wall("1.0", "2.0", "0,0,-2.0,0,0,0",
                              "*RIGIDWALL_PLANAR_FINITE\n0\n2,0,-0.1,2,0,1\n3,0,-0.1,1,1\n"));
  EXPECT_NEAR(run.last.velocity[2], -2.0, 1e-13);
  EXPECT_NEAR(run.last.displacement[2], -4.0, 1e-9);
  // Nor does what comes from below meet one right above it.
  const BodyRun below(over_wall("1.0", "2.0", "0,0,2.0,0,0,0",
                                "*RIGIDWALL_PLANAR_FINITE\n0\n-1,-1,3.5,-1,-1,4\n9,-1,3.5,9,9\n"));
  EXPECT_NEAR(below.last.velocity[2], 2.0, 1e-13);
  EXPECT_NEAR(below.last.displacement[2], 4.0, 1e-9);
  const BodyRun above(over_wall("1.0", "2.0", "0,0,-2.0,0,0,0",
                                "*RIGIDWALL_PLANAR_FINITE\n0\n-1,-1,-0.1,-1,-1,4\n9,-1,-0.1,9,9\n"));
  EXPECT_NEAR(above.last.velocity[2], 2.0, 0.01);  // but what comes from above does
}

TEST(RigidWallPenalty, WithoutItBodiesPassWithAWarning) {
  const BodyRun run(over_wall("0.0", "1.0", "0,0,-2.0,0,0,0", plane));
  EXPECT_TRUE(run.says("pass rigid walls", Severity::warning));
  EXPECT_NEAR(run.last.velocity[2], -2.0, 1e-13);
  EXPECT_TRUE(BodyRun(over_wall("9.0", "1.0", "0,0,0,0,0,0", plane)).says("expected -5 to 5"));
}

// RWPNAL below 0: nodes of no rigid body are met by springs as well, so a single one bounces; else the wall
// stops it.
TEST(RigidWallPenalty, AllNodesByPenalty) {
  for (const double scale : {0.0, 1.0, -1.0}) {
    Rig rig;
    const Index a = rig.particle(3.0, {0, 0, 1.0}, {1, 0, -2});
    model::RigidWall wall;
    wall.origin = {0, 0, 0};
    wall.normal = {0, 0, 1};
    wall.nodes = {a};
    wall.penalty = scale;
    rig.model.walls.push_back(wall);
    rig.fixed_step(0.01);
    rig.run(1.0, [&](const Frame& frame) {
      EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.initial, 1e-11);
    });
    EXPECT_NEAR(rig.v(a, 2), scale < 0.0 ? 2.0 : 0.0, 0.1) << scale;
    EXPECT_NEAR(rig.v(a, 0), 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace cleave::solver::test
