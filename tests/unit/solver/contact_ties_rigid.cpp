/// Ties and rigid bodies: nodes that become the body's own, springs with an offset, angular momentum.

#include "body_run.hpp"
#include "solver/contact/tied_springs.hpp"

namespace cleave::solver::test {
namespace {

using deck::Severity;

const std::string control = "*CONTROL_TERMINATION\n1.0\n*CONTROL_ENERGY\n2,2,2,2\n*CONTROL_TIMESTEP\n0,0.9\n";

/// Momentum of everything, with the velocity of the half step [0..2], and angular momentum [3..5].
struct Sum {
  double value[6] = {0, 0, 0, 0, 0, 0};
  void add(const double* x, const double* v, double mass) {
    const Vector at{x[0], x[1], x[2]}, speed{v[0], v[1], v[2]};
    const Vector spin = base::cross(at, speed);
    const double more[6] = {speed.x, speed.y, speed.z, spin.x, spin.y, spin.z};
    for (int i = 0; i < 6; ++i) value[i] += mass * more[i];
  }
};
Sum of_bodies(const Frame& frame) {
  Sum sum;
  for (const BodyMotion& body : frame.bodies) {
    sum.add(body.position, body.velocity, body.mass);
    for (int i = 0; i < 3; ++i) sum.value[3 + i] += body.momentum[i];
  }
  return sum;
}

// The lower face of a soft cube lies on a face of the turning box: its nodes are nodes of the box, with their
// mass, and the momentum of both is kept.
TEST(RigidTies, NodesOnAFaceBecomeTheBodys) {
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"}) {
    double start = 0.0, end = 0.0;
    const BodyRun run(box(control) + cube + "*CONTACT_TIED_" + kind + "\n2,1,3,3\n\n\n" +
                          "*INITIAL_VELOCITY_GENERATION\n1,2,0.7,0.1,0,0\n0,0,0,0,1,0\n"
                          "2,2,0.7,0.1,0,0\n0,0,0,0,1,0\n",
                      0, [&](const Frame& frame) {
                        double sum = frame.bodies[0].mass * frame.bodies[0].velocity[0];
                        for (int a = 12; a < 16; ++a)
                          sum += frame.state.mass[a] * (frame.state.velocity[3 * a] +
                                                        0.5 * frame.state.step * frame.acceleration[3 * a]);
                        if (frame.state.cycle == 0) start = sum;
                        end = sum;
                      });
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_TRUE(run.says("4 nodes of tied contact 1 lie on faces of rigid body 1", Severity::note));
    EXPECT_EQ(run.model.rigid_bodies[0].nodes.size(), 12u);
    EXPECT_EQ(run.model.rigid_bodies[0].extra, (std::vector<Index>{8, 9, 10, 11}));
    EXPECT_NEAR(run.world.bodies[0].whole.mass, 12.0 + 2.0, 1e-12);  // half of the cube's 4
    EXPECT_NEAR(run.distance(0, 8), 3.0, 1e-12);
    EXPECT_NEAR(end, start, 1e-12);
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01);
  }
}

// A couple is a moment and no force, on a warped quadrilateral as on a triangle; the bound holds it.
TEST(RigidTies, CouplesAreMomentsAlone) {
  const std::vector<double> x{0, 0, 3, 1, 0, 3.1, 1.2, 2, 3, -0.1, 2, 2.9};
  const Vector moment{0.3, -0.7, 0.5};
  for (const Index last : {3, 2}) {
    const Index node[4] = {0, 1, 2, last};
    Vector force[4], sum{0, 0, 0}, turn{0, 0, 0};
    double bound[4];
    couple_of(x, node, moment, force);
    couple_bound(x, node, bound);
    for (int k = 0; k < 4; ++k) {
      sum = sum + force[k];
      turn = turn + base::cross(vector_at(x, node[k]), force[k]);
      EXPECT_LE(norm(force[k]), bound[k] * norm(moment) + 1e-15);
    }
    EXPECT_LT(norm(sum), 1e-15);
    EXPECT_LT(norm(turn - moment), 1e-14);
  }
}

// With _CONSTRAINED_OFFSET the cube may float half an element above the body.
TEST(RigidTies, ConstrainedOffsetJoinsFromAbove) {
  std::string deck = box(control) + cube;
  for (const char* from : {"11,0,0,3", "12,1,0,3", "13,1,2,3", "14,0,2,3"})
    deck.replace(deck.find(from), 8, std::string(from, 7) + "3.3");
  const std::string card = "\n2,1,3,3\n\n\n*INITIAL_VELOCITY_RIGID_BODY\n1,0.1,0,0,0.2,0.3,0.4\n";
  const BodyRun near(deck + "*CONTACT_TIED_NODES_TO_SURFACE" + card);
  EXPECT_TRUE(near.says("is near a face of side B"));
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"}) {
    std::size_t springs = 0;
    const BodyRun run(deck + "*CONTACT_TIED_" + kind + "_CONSTRAINED_OFFSET" + card, 0,
                      [&](const Frame& frame) {
                        for (const InterfaceForce& one : frame.interfaces)
                          springs = std::max<std::size_t>(springs, one.touches);
                      });
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_EQ(run.model.rigid_bodies[0].nodes.size(), 12u);
    EXPECT_NEAR(run.distance(0, 8), 3.3, 1e-12);
    EXPECT_EQ(springs, 0u) << "between a body and itself";
  }
}

// Walls stop the nodes of bodies by penalty or not at all: those that a tie gives to a body leave the wall.
TEST(RigidTies, NodesOfTheBodyLeaveWalls) {
  const std::string deck = box(control) + cube + "*RIGIDWALL_PLANAR\n0\n0,0,-9,0,0,1\n";
  const BodyRun apart(deck), tied(deck + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n\n\n");
  EXPECT_EQ(apart.model.walls[0].nodes, (std::vector<Index>{8, 9, 10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(tied.model.walls[0].nodes, (std::vector<Index>{12, 13, 14, 15}));
}

/// The box and a rigid cube 0.4 above it.
std::string two_boxes(const std::string& end, const std::string& safety) {
  std::string deck = box("*CONTROL_TERMINATION\n" + end +
                         "\n*CONTROL_ENERGY\n2,2,2,2\n*CONTROL_TIMESTEP\n0," + safety + "\n");
  deck.replace(deck.find("2.0,1.0,0.3"), 11, "2.0,1e3,0.3");
  std::string upper = cube;
  upper.replace(upper.find("*MAT_ELASTIC\n2,2.0,1e3,0.3\n"), 27, "*MAT_RIGID\n2,2.0,1e3,0.3\n0\n\n");
  for (const char* from : {"11,0,0,3", "12,1,0,3", "13,1,2,3", "14,0,2,3"})
    upper.replace(upper.find(from), 8, std::string(from, 7) + "3.4");
  return deck + upper;
}

// They turn together by a right angle, about the centre of both: the springs turn with them and only hold
// against what pulls them apart, 7.2 w^2 over their stiffness of 222.
TEST(RigidTies, SpringsTurnWithTheFace) {
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"}) {
    double energy = 0.0, spin = 0.0;
    const BodyRun run(two_boxes("2.0", "0.2") + "*CONTACT_TIED_" + kind +
                          "_OFFSET\n2,1,3,3\n\n\n*INITIAL_VELOCITY_GENERATION\n1,2,0.8,0,0,0\n0,1,2.1,1,0,0\n"
                          "2,2,0.8,0,0,0\n0,1,2.1,1,0,0\n",
                      0, [&](const Frame& frame) {
                        energy = std::max(energy, frame.interfaces[0].normal_energy);
                        for (const BodyMotion& body : frame.bodies)
                          spin = std::max(spin, std::abs(body.spin[0] - 0.8));
                      });
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    const double pull = 7.2 * 0.64;  // they swing, to at most twice the stretch of rest
    EXPECT_LT(energy, 0.5 * 4.0 * pull * pull / 222.0);
    EXPECT_GT(energy, 0.0);
    EXPECT_LT(spin, 0.1 * 0.8);
  }
}

// Springs a thousand times as stiff set the step: the boxes swing against each other with w^2 = k (1/12 +
// 1/4).
TEST(RigidTies, SpringsLimitTheStep) {
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"}) {
    const BodyRun run(two_boxes("1.0", "0.9") + "*CONTACT_TIED_" + kind +
                      "_OFFSET\n2,1,3,3\n\n1000,1000\n*INITIAL_VELOCITY_RIGID_BODY\n2,0,0,0.1,0,0,0\n");
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_EQ(run.outcome.ending, Ending::end_time) << run.outcome.status.what;
    EXPECT_LT(run.state.step, 2.0 / std::sqrt(222e3 / 3.0)) << kind;
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.05) << kind;
  }
}

// Two rigid boxes, 0.4 apart, hang together by springs: no moment comes from nowhere, though the springs do
// not lie along their rest while the boxes turn against each other.
TEST(RigidTies, SpringsWithAnOffsetKeepAngularMomentum) {
  const std::string deck = two_boxes("1.0", "0.2");
  for (const std::string kind : {"NODES_TO_SURFACE", "SURFACE_TO_SURFACE"}) {
    Sum start, now;
    double worst = 0.0, stretch = 0.0;
    const BodyRun run(deck + "*CONTACT_TIED_" + kind + "_OFFSET\n2,1,3,3\n\n\n" +
                          "*INITIAL_VELOCITY_RIGID_BODY\n1,0,0,0,0,0,0.3\n2,0.2,0.1,0,0.4,-0.3,-0.5\n",
                      0, [&](const Frame& frame) {
                        now = of_bodies(frame);
                        if (frame.state.cycle == 0) start = now;
                        for (int i = 0; i < 6; ++i)
                          worst = std::max(worst, std::abs(now.value[i] - start.value[i]));
                        const double* x = frame.state.position.data();
                        stretch = std::max(stretch, std::abs(x[3 * 8 + 1] - x[1]));
                      });
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_GT(run.state.cycle, 200);
    EXPECT_GT(stretch, 0.01) << "they did not move against each other";
    EXPECT_LT(worst, 1e-6) << kind;  // of 1.7: forces are integers, rounded corner by corner
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 1e-3) << kind;  // order: second in the step
  }
}

TEST(RigidTies, WhatCannotBeTiedIsRefused) {
  const std::string deck = box(control) + cube;
  // The body's own nodes cannot follow a face that deforms.
  EXPECT_TRUE(
      BodyRun(deck + "*CONTACT_TIED_NODES_TO_SURFACE\n1,2,3,3\n\n\n").says("belongs to a rigid body"));
  EXPECT_FALSE(BodyRun(deck + "*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n1,2,3,3\n\n\n").diagnostics.failed());
  EXPECT_TRUE(BodyRun(deck + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n0,0,0,0,0,0,0.5\n\n")
                  .says("begins or ends within the run"));
  EXPECT_TRUE(BodyRun(deck + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n\n\n*BOUNDARY_SPC_NODE\n11,0,1\n")
                  .says("held or moved by itself"));
  std::string rigid = deck;
  rigid.replace(rigid.find("*MAT_ELASTIC\n2,2.0,1e3,0.3\n"), 27, "*MAT_RIGID\n2,2.0,1e3,0.3\n0\n\n");
  EXPECT_TRUE(BodyRun(rigid + "*CONTACT_TIED_NODES_TO_SURFACE\n2,1,3,3\n\n\n").says("is tied to another"));
}

}  // namespace
}  // namespace cleave::solver::test
