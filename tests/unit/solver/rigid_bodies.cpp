/// Rigid bodies in the loop: what is kept over many steps, what the nodes carry, what is refused.

#include <gtest/gtest.h>

#include "body_run.hpp"

namespace cleave::solver::test {
namespace {

TEST(RigidBodies, FreeBodyKeepsEverythingFor100000Steps) {
  const BodyRun run(
      box("*CONTROL_TERMINATION\n5000.0\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,1\n*DEFINE_CURVE\n1\n0,0.05\n"
          "9999,0.05\n") +
      "*INITIAL_VELOCITY_RIGID_BODY\n1,1e-3,0,2e-3,0.02,1.0,0.03\n");
  EXPECT_GE(run.state.cycle, 100000);
  EXPECT_EQ(run.most_momentum, 0.0);  // nothing acts, so it is the same number
  EXPECT_LT(run.most_energy - run.least_energy, 1e-11 * run.most_energy);
  EXPECT_NEAR(run.distance(0, 6), std::sqrt(14.0), 1e-13);
  EXPECT_NEAR(run.distance(1, 3), std::sqrt(5.0), 1e-13);
  EXPECT_NEAR(run.last.displacement[2], 2e-3 * run.state.time, 1e-9);
}

// Lumped, a box has three times its moment of inertia: the nodes may carry a third of its mass.
TEST(RigidBodies, NodesCarryNoMoreThanTheBodyHas) {
  const BodyRun run(box("*CONTROL_TERMINATION\n0.1\n"));
  const discretisation::RigidBody& body = run.world.bodies.at(0);
  EXPECT_NEAR(body.whole.mass, 12.0, 1e-13);
  EXPECT_NEAR(body.whole.tensor.xx, 13.0, 1e-12);
  for (const double mass : body.node_mass) EXPECT_NEAR(mass, 12.0 / 8.0 / 3.0, 1e-12);
}

TEST(RigidBodies, SpinOfANodalVelocityFieldIsFound) {
  const BodyRun run(box("*CONTROL_TERMINATION\n0.1\n") +
                    "*INITIAL_VELOCITY_GENERATION\n1,2,2.0,0.5,0,0\n0,0,0,0,0,1\n");
  EXPECT_NEAR(run.first.spin[2], 2.0, 1e-13);
  EXPECT_NEAR(run.first.velocity[0], 0.5 - 2.0 * 1.0, 1e-13);  // the centre is at 0.5, 1, 1.5
  EXPECT_NEAR(run.first.velocity[1], 2.0 * 0.5, 1e-13);
}

TEST(RigidBodies, SidesThatCannotMoveAreRefused) {
  std::string deck = box("*CONTROL_TERMINATION\n0.1\n") + cube + "*SET_NODE\n4\n11,12,13,14,15,16,17,18\n" +
                     "*BOUNDARY_SPC_SET\n4,0,1,1,1\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n\n\n";
  EXPECT_FALSE(BodyRun(deck, 1).diagnostics.failed());
  deck.replace(deck.find("0.3\n0\n"), 6, "0.3\n1,7,7\n");
  EXPECT_TRUE(BodyRun(deck, 1).says("rigid without mass"));
}

// A motion and CON1 = 1 (x), or two motions along x, are said; along x and y, or one after the other, are
// not.
TEST(RigidBodies, TwoMastersOfOneDirectionAreSaid) {
  const std::string curve = "*DEFINE_CURVE\n1\n0,1\n9,1\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n";
  std::string deck = box("*CONTROL_TERMINATION\n0.1\n");
  const auto said = [](const std::string& text, std::string_view phrase) {
    return BodyRun(text, 1).says(phrase, deck::Severity::warning);
  };
  EXPECT_TRUE(said(deck + curve + "1,1,2,1,1.0\n1,1,0,1,2.0\n", "is told twice to move along"));
  EXPECT_TRUE(said(deck + curve + "1,7,2,1,1.0\n1,7,0,1,2.0\n", "is told twice to turn about"));
  EXPECT_FALSE(said(deck + curve + "1,1,2,1,1.0\n1,2,0,1,2.0\n1,5,0,1,1.0\n", "same direction"));
  EXPECT_FALSE(said(deck + curve + "1,1,2,1,1.0,0,0.05\n1,1,0,1,2.0,0,1.0,0.05\n", "same direction"));
  deck.replace(deck.find("0.3\n0\n"), 6, "0.3\n1,1,0\n");
  EXPECT_TRUE(said(deck + curve + "1,1,2,1,1.0\n", "is held and told to move along"));
  EXPECT_FALSE(said(deck + curve + "1,2,2,1,1.0\n", "same direction"));
}

// On a base that turns about z by w the box, its long axis leaning by 45 degrees from z to x, feels at its
// centre m w^2 R outward and the moment w^2 (J d) x d, which rights it: about y, w^2 (Jz - Jx) / 2.
TEST(RigidBodies, CentrifugalMomentOfABody) {
  std::string deck = box(
      "*CONTROL_TERMINATION\n0.01\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,9\n*DEFINE_CURVE\n9\n0,1e-3\n9999,1e-3\n");
  // Turn the nodes about y through the origin by 45 degrees.
  const std::size_t from = deck.find("*NODE\n") + 6, to = deck.find("*ELEMENT_SOLID");
  std::string nodes;
  const double s = std::sqrt(0.5);
  for (int a = 0; a < 8; ++a) {
    const double x = (a & 3) == 1 || (a & 3) == 2 ? 1.0 : 0.0, y = (a & 3) >= 2 ? 2.0 : 0.0,
                 z = a >= 4 ? 3.0 : 0.0;
    char text[128];
    std::snprintf(text, sizeof text, "%d,%.15g,%.15g,%.15g\n", a + 1, s * (x + z), y, s * (z - x));
    nodes += text;
  }
  deck.replace(from, to - from, nodes);
  const double w = 0.7, xx = 13.0, zz = 5.0;  // of the box about its own axes, 12 [mass]
  const BodyRun run(deck +
                    "*SET_NODE_LIST_GENERATE\n3\n1,8\n*DEFINE_CURVE\n4\n0,0.7\n9,0.7\n"
                    "*LOAD_BODY_GENERALIZED_SET_NODE\n3,0,4,0,0,0,0\n0,0,0,0,0,1.0,0,CENT\n");
  ASSERT_FALSE(run.diagnostics.failed());
  EXPECT_NEAR(run.first.acceleration[0], w * w * s * 2.0, 1e-12);
  EXPECT_NEAR(run.first.acceleration[1], w * w * 1.0, 1e-12);
  EXPECT_NEAR(run.first.acceleration[2], 0.0, 1e-12);
  EXPECT_NEAR(std::abs(run.last.momentum[1]), 0.01 * w * w * 0.5 * (xx - zz), 1e-5);
  EXPECT_NEAR(run.last.momentum[0], 0.0, 1e-12);
}

// Mass damping D: the speed falls as exp(-D t), and so does the spin about a principal axis; what it takes is
// booked.
TEST(RigidBodies, DampingOfABody) {
  for (const std::string card :
       {"*DAMPING_GLOBAL\n0,0.5\n", "*DAMPING_PART_MASS\n1,1,0.5\n*DEFINE_CURVE\n1\n0,1\n99,1\n"}) {
    const BodyRun run(box("*CONTROL_TERMINATION\n2.0\n*CONTROL_ENERGY\n2,2,2,2\n*CONTROL_TIMESTEP\n0,0.9,0,0,"
                          "0,9\n*DEFINE_CURVE\n9\n0,1e-3\n9999,1e-3\n") +
                      "*INITIAL_VELOCITY_RIGID_BODY\n1,1.0,0,0,0,0,0.8\n" + card);
    ASSERT_FALSE(run.diagnostics.failed());
    const double left = std::exp(-0.5 * run.state.time);
    EXPECT_NEAR(run.last.velocity[0], left, 1e-3 * left);
    EXPECT_NEAR(run.last.spin[2], 0.8 * left, 1e-3 * left);
    EXPECT_NEAR(run.state.energy.damping, (1.0 - left * left) * (6.0 + 0.5 * 5.0 * 0.64), 0.01);
    EXPECT_LT(run.most_energy - run.least_energy, 1e-11 * run.most_energy);
  }
}

TEST(RigidBodies, NodalBodyWithoutMassIsRefused) {
  EXPECT_TRUE(
      BodyRun(box("*CONTROL_TERMINATION\n0.1\n") +
              "*NODE\n21,5,5,5\n22,6,5,5\n*SET_NODE\n4\n21,22\n*CONSTRAINED_NODAL_RIGID_BODY\n9,0,4\n")
          .says("rigid body 9 has no mass"));
}

}  // namespace
}  // namespace cleave::solver::test
