/// Rigid bodies in the loop: what is kept over many steps, what the nodes carry, what is refused.

#include <gtest/gtest.h>

#include <cmath>

#include "deck/deck.hpp"
#include "solver/solver.hpp"

namespace cleave::solver::test {
namespace {

using model::Vector;

/// A run of deck text.
struct BodyRun final : Observer {
  deck::Diagnostics diagnostics;
  model::Account account;
  model::Model model;
  discretisation::World world;
  discretisation::State state;
  Outcome outcome;
  BodyMotion first, last;
  double least_energy = 1e300, most_energy = -1e300, most_momentum = 0.0;

  explicit BodyRun(const std::string& text, std::int64_t stop = 0) {
    const deck::Deck deck = deck::Deck::read_text(text + "*END\n", "test.k", {}, diagnostics);
    model = model::build(deck, {}, diagnostics, account);
    if (diagnostics.failed()) return;
    world = discretisation::build(model, diagnostics);
    const auto solver = make_explicit(world, {stop}, diagnostics);
    if (diagnostics.failed()) return;
    EXPECT_TRUE(discretisation::initialise(world, state).ok);
    Wishes wishes;
    Observer* const observers[] = {this};
    outcome = solver->advance(state, observers, wishes);
  }
  void begin(const Frame& frame) override {
    first = frame.bodies.empty() ? BodyMotion{} : frame.bodies[0];
    after_step(frame);
  }
  void after_step(const Frame& frame) override {
    if (frame.bodies.empty()) return;
    last = frame.bodies[0];
    least_energy = std::min(least_energy, frame.state.energy.total());
    most_energy = std::max(most_energy, frame.state.energy.total());
    for (int i = 0; i < 3; ++i)
      most_momentum = std::max(most_momentum, std::abs(last.momentum[i] - first.momentum[i]));
  }
  void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}

  bool says(std::string_view phrase) const {
    for (const auto& d : diagnostics.all())
      if (d.severity == deck::Severity::error && d.message.find(phrase) != std::string::npos) return true;
    return false;
  }
  double distance(std::size_t a, std::size_t b) const {
    double square = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      square += std::pow(state.position[3 * a + i] - state.position[3 * b + i], 2);
    return std::sqrt(square);
  }
};

/// A rigid box 1 x 2 x 3, nodes 1 to 8, part 1, density 2.
std::string box(const std::string& control) {
  return "*KEYWORD\n" + control +
         "*MAT_RIGID\n1,2.0,1.0,0.3\n0\n\n*SECTION_SOLID\n1,1\n*PART\nbox\n1,1,1\n*NODE\n1,0,0,0\n2,1,0,0\n"
         "3,1,2,0\n4,0,2,0\n5,0,0,3\n6,1,0,3\n7,1,2,3\n8,0,2,3\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";
}

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

// A soft cube above the box, with a common face that does not share nodes.
const std::string cube =
    "*MAT_ELASTIC\n2,2.0,1e3,0.3\n*PART\nsoft\n2,1,2\n*NODE\n11,0,0,3\n12,1,0,3\n13,1,2,3\n14,0,2,3\n15,0,0,"
    "4\n"
    "16,1,0,4\n17,1,2,4\n18,0,2,4\n*ELEMENT_SOLID\n2,2,11,12,13,14,15,16,17,18\n";

TEST(RigidBodies, TiesWithoutSpringsAreRefused) {
  const std::string deck = box("*CONTROL_TERMINATION\n0.1\n") + cube;
  EXPECT_TRUE(
      BodyRun(deck + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n\n\n").says("belongs to a rigid body"));
  EXPECT_FALSE(BodyRun(deck + "*CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET\n2,1,3,3\n\n\n").diagnostics.failed());
}

TEST(RigidBodies, SidesThatCannotMoveAreRefused) {
  std::string deck = box("*CONTROL_TERMINATION\n0.1\n") + cube + "*SET_NODE\n4\n11,12,13,14,15,16,17,18\n" +
                     "*BOUNDARY_SPC_SET\n4,0,1,1,1\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n\n\n";
  EXPECT_FALSE(BodyRun(deck, 1).diagnostics.failed());
  deck.replace(deck.find("0.3\n0\n"), 6, "0.3\n1,7,7\n");
  EXPECT_TRUE(BodyRun(deck, 1).says("rigid without mass"));
}

TEST(RigidBodies, NodalBodyWithoutMassIsRefused) {
  EXPECT_TRUE(
      BodyRun(box("*CONTROL_TERMINATION\n0.1\n") +
              "*NODE\n21,5,5,5\n22,6,5,5\n*SET_NODE\n4\n21,22\n*CONSTRAINED_NODAL_RIGID_BODY\n9,0,4\n")
          .says("rigid body 9 has no mass"));
}

}  // namespace
}  // namespace cleave::solver::test
