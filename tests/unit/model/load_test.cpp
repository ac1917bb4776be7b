/// *LOAD_*, *RIGIDWALL_PLANAR, *INITIAL_VELOCITY*, *DAMPING_*, *ELEMENT_MASS, *BOUNDARY_NON_REFLECTING.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

using deck::Severity;
using Indices = std::vector<Index>;
const std::string curve = "*DEFINE_CURVE\n9\n0,0\n2,1\n";

TEST(Load, NodesBySetRowAndFollower) {
  const Built b = build_text(cube + curve +
                             "*LOAD_NODE_POINT\n5,3,9,-2\n6,3,9,-2\n7,4,9,1,0,5,6,7\n"
                             "*SET_NODE\n1\n1,2\n*LOAD_NODE_SET\n1,1,9,0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& l = b.model.node_loads;
  ASSERT_EQ(l.size(), 3u);
  EXPECT_EQ(l[0].nodes, (Indices{4, 5}));
  EXPECT_EQ(l[0].scale, -2.0);
  EXPECT_EQ(l[0].direction.z, 1.0);
  EXPECT_TRUE(l[1].follower);
  EXPECT_EQ(l[1].follow[2], 6);
  EXPECT_EQ(l[2].scale, 1.0);  // SF = 0 means 1
  EXPECT_TRUE(build_text(cube + curve + "*LOAD_NODE_POINT\n5,6,9\n")
                  .says(Severity::error, after_cube + 5, "a moment"));
}

TEST(Load, PressureOnSegments) {
  const Built b = build_text(cube + curve +
                             "*LOAD_SEGMENT\n9,2,0.5,5,6,7,8\n9,2,0.5,1,2,6,6\n9,1,0,1,2,3,4\n"
                             "*SET_SEGMENT\n4\n5,6,7\n*LOAD_SEGMENT_SET\n4,9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& l = b.model.segment_loads;
  ASSERT_EQ(l.size(), 3u);
  EXPECT_EQ(l[0].segments.size(), 2u);
  EXPECT_EQ(l[0].arrival, 0.5);
  EXPECT_EQ(l[0].segments[1].node[3], l[0].segments[1].node[2]);
  EXPECT_EQ(l[2].segments[0].node[3], 6);
}

TEST(Load, PressureOnFacesWithMidNodes) {
  const std::string tet =
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n*SECTION_SOLID\n1,16\n*"
      "PART\ntet\n1,1,1\n"
      "*NODE\n1,0,0,0\n2,2,0,0\n3,0,2,0\n4,0,0,2\n5,1,0,0\n6,1,1,0\n7,0,1,0\n8,0,0,1\n9,1,0,1\n10,0,1,1\n"
      "*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8,9,10\n" +
      curve + "*LOAD_SEGMENT\n";
  // Edge by edge, with the edge from N3 to N4 = N3 blank or repeated; a face with corners alone beside it.
  const Built b = build_text(tet + "9,1,0,1,2,4,4,5\n9,0,8\n9,1,0,1,3,2,2,7\n6,2,5\n9,1,0,2,3,4,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.segment_loads.size(), 1u);
  const SegmentLoad& l = b.model.segment_loads[0];
  ASSERT_EQ(l.quadratic.size(), 2u);
  EXPECT_EQ(l.quadratic[0], (std::array<Index, 6>{0, 1, 3, 4, 8, 7}));
  EXPECT_EQ(l.quadratic[1], (std::array<Index, 6>{0, 2, 1, 6, 5, 4}));
  EXPECT_EQ(l.segments.size(), 1u);
  EXPECT_TRUE(build_text(tet + "9,1,0,1,2,4,4,5\n9,0,10\n").text().find("amid the edges") !=
              std::string::npos);
  EXPECT_TRUE(build_text(tet + "9,1,0,1,2,4,3,5\n9,8,10\n").text().find("eight nodes") != std::string::npos);
  const std::string mid = "*LOAD_SEGMENT\n9,1,0,5,6,7,7,1\n2,0,3\n";
  EXPECT_TRUE(build_text(cube + curve + mid).says(Severity::error, after_cube + 5, "amid the edges"));
}

TEST(Load, BodyLoadsKeepTheSignOfTheDeck) {
  const Built b = build_text(cube + curve +
                             "*LOAD_BODY_Z\n9,9810\n*LOAD_BODY_RX\n9,3,0,1,2,3\n"
                             "*LOAD_BODY_VECTOR\n9,1\n0,3,4\n*SET_PART\n2\n1\n*LOAD_BODY_PARTS\n2\n"
                             "*NODE\n9,9,9,9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& l = b.model.body_loads;
  ASSERT_EQ(l.size(), 3u);
  EXPECT_EQ(l[0].direction.z, 1.0);
  EXPECT_EQ(l[0].scale, 9810.0);
  EXPECT_TRUE(l[1].rotation);
  EXPECT_EQ(l[1].centre.y, 2.0);
  EXPECT_DOUBLE_EQ(l[2].direction.z, 0.8);
  ASSERT_EQ(l[0].nodes.size(), 9u);
  EXPECT_TRUE(l[0].nodes[7]);
  EXPECT_FALSE(l[0].nodes[8]);
}

TEST(Load, GeneralizedBodyLoadsHaveNodesOfTheirOwn) {
  const std::string sets = "*SET_NODE\n3\n1,8\n*SET_PART\n2\n1\n", range = "*LOAD_BODY_GENERALIZED\n";
  const Built b = build_text(cube + curve + sets + range +
                             "3,5,9,0,1,2,3\n0,0,9.81,0,0,0\n"
                             "*LOAD_BODY_GENERALIZED_SET_NODE\n3,0,9\n1,2,3,4,5,6,0,CORI\n"
                             "*LOAD_BODY_GENERALIZED_SET_PART\n2,0,9,0,1,0,0\n0,0,0,0,0,7,5,ROTA\n"
                             "*DEFINE_COORDINATE_SYSTEM\n5,10,0,0,10,1,0\n9,0,0\n"  // x along y, y along -x
                             "*LOAD_BODY_Z\n9,2\n*LOAD_BODY_PARTS\n2\n*NODE\n9,9,9,9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& l = b.model.body_loads;
  ASSERT_EQ(l.size(), 5u);
  EXPECT_FALSE(l[0].rotation);
  EXPECT_EQ(l[0].direction.z, 9.81);
  EXPECT_EQ(l[0].nodes, (std::vector<bool>{0, 0, 1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(l[1].direction.y, 2.0);
  EXPECT_EQ(l[1].nodes, (std::vector<bool>{1, 0, 0, 0, 0, 0, 0, 1, 0}));
  EXPECT_TRUE(l[2].rotation);
  EXPECT_EQ(l[2].angular, BodyLoad::Angular::coriolis);
  EXPECT_EQ(l[2].direction.z, 6.0);
  EXPECT_EQ(l[3].angular, BodyLoad::Angular::euler);
  EXPECT_NEAR(l[3].centre.x, 10.0, 1e-14);
  EXPECT_NEAR(l[3].centre.y, 1.0, 1e-14);
  EXPECT_FALSE(l[3].nodes[8]);
  EXPECT_FALSE(l[4].generalized);
  EXPECT_EQ(l[4].nodes.size(), 9u);
  const auto says = [&](const std::string& cards, int line, const std::string& words) {
    return build_text(cube + curve + cards).says(Severity::error, after_cube + 4 + line, words);
  };
  EXPECT_TRUE(says(range + "5,3,9\n1\n", 1, "from N1 = 5 on"));
  EXPECT_TRUE(says(range + "55,60,9\n1\n", 1, "no node has a number"));
  EXPECT_TRUE(says(range + "1,8,7\n1\n", 1, "curve 7"));
  EXPECT_TRUE(says(range + "1,8,9\n0,0,0,1,0,0,0,SPIN\n", 2, "CENT, CORI or ROTA"));
  EXPECT_TRUE(build_text(cube + curve + range + "1,8,9\n0\n")
                  .says(Severity::warning, after_cube + 6, "does nothing"));
}

TEST(Wall, TailAndHeadMakeTheNormal) {
  const Built b = build_text(cube + "*RIGIDWALL_PLANAR_ID\n         3floor\n0\n0,0,-1,0,0,4,0.25\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const RigidWall& w = b.model.walls.at(0);
  EXPECT_EQ(w.id, 3);
  EXPECT_EQ(w.title, "floor");
  EXPECT_EQ(w.nodes.size(), 8u);
  EXPECT_EQ(w.origin.z, -1.0);
  EXPECT_EQ(w.normal.z, 1.0);
  EXPECT_EQ(w.friction, 0.25);
  EXPECT_EQ(w.death, forever);
  EXPECT_TRUE(build_text(cube + "*RIGIDWALL_PLANAR\n0\n0,0,1,0,0,1\n").failed());
}

TEST(Wall, SelectsNodesBySetBoxExemptionAndOffset) {
  const Built b =
      build_text(cube +
                 "*SET_NODE\n1\n1,2,3,4,5\n*SET_NODE\n2\n2\n*DEFINE_BOX\n3,-1,2,-1,0.5,-1,2\n"
                 "*RIGIDWALL_PLANAR\n1,2,3\n0,0,0,0,0,1\n*RIGIDWALL_PLANAR\n0,0,0,0.5\n0,0,0,0,0,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.walls[0].nodes, (Indices{0, 4}));
  EXPECT_EQ(b.model.walls[1].nodes, (Indices{0, 1, 2, 3}));
}

TEST(Wall, FiniteMovingWithForces) {
  const Built b = build_text(
      cube + "*RIGIDWALL_PLANAR_FINITE_MOVING_FORCES\n0\n0,0,0,0,0,1,1.0\n2,0,0.5,3,4\n7.5,-2\n5\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const RigidWall& w = b.model.walls.at(0);
  EXPECT_TRUE(w.finite);
  EXPECT_EQ(w.edge_l.x, 1.0);  // the part of the edge that lies in the wall
  EXPECT_EQ(w.edge_m.y, 1.0);  // n x l
  EXPECT_EQ(w.length_l, 3.0);
  EXPECT_EQ(w.length_m, 4.0);
  EXPECT_EQ(w.mass, 7.5);
  EXPECT_EQ(w.speed, -2.0);
  EXPECT_EQ(w.soft_cycles, 5);
  EXPECT_TRUE(build_text(cube + "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0,1.5\n").failed());
  const Built welding = build_text(cube + "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0,3,2.5\n");
  ASSERT_FALSE(welding.failed()) << welding.text();
  EXPECT_EQ(welding.model.walls[0].friction, 3.0);
  EXPECT_EQ(welding.model.walls[0].velocity_limit, 2.5);
}

TEST(Wall, OrthotropicFriction) {
  const std::string wall = "*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,-1,0,0,0\n0.2,0.4,0.1,0.3,5,6\n";
  const Built b = build_text(cube + wall + "0,0,0,2,0\n" + wall + "1,2\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const RigidWall& w = b.model.walls.at(0);
  EXPECT_TRUE(w.orthotropic);
  EXPECT_EQ(w.static_friction[1], 0.4);
  EXPECT_EQ(w.dynamic_friction[0], 0.1);
  EXPECT_EQ(w.friction_decay[1], 6.0);
  EXPECT_EQ(w.friction_axis.y, 1.0);
  EXPECT_EQ(b.model.walls[1].friction_node[1], 1);
  EXPECT_EQ(b.model.walls[1].friction_axis.x, 1.0);
  EXPECT_TRUE(
      build_text(cube + wall + "0,0,0,0,3\n").says(Severity::error, after_cube + 4, "first direction"));
  EXPECT_TRUE(build_text(cube + wall + "0\n").says(Severity::error, after_cube + 4, "first direction"));
}

TEST(Wall, GeometricShapesInAnyOrderOfOptions) {
  const Built b = build_text(cube + curve +
                             "*RIGIDWALL_GEOMETRIC_FLAT\n0\n0,0,-1,0,0,0,0.5\n2,0,-1,3,0\n"
                             "*RIGIDWALL_GEOMETRIC_PRISM_MOTION_ID\n         "
                             "7box\n0,0,0,0.5,2\n0,0,-1,0,0,0\n2,0,-1,3,4,5\n9,1,0,0,1\n"
                             "*RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY_MOTION\n0\n0,0,-9,0,0,-8\n2.5,6,1\n0.5,0."
                             "25\n9,0,0,3,4\n77,1,2,0.3\n"
                             "*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR\n0\n0,0,0\n5\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& w = b.model.walls;
  ASSERT_EQ(w.size(), 4u);
  EXPECT_EQ(w[0].shape, RigidWall::Shape::plane);
  EXPECT_TRUE(w[0].geometric && w[0].finite);
  EXPECT_EQ(w[0].length_m, 0.0);
  EXPECT_EQ(w[1].id, 7);
  EXPECT_EQ(w[1].length_n, 5.0);
  EXPECT_EQ(w[1].motion, 0);
  EXPECT_TRUE(w[1].motion_is_displacement);
  EXPECT_EQ(w[1].motion_direction.z, 1.0);
  EXPECT_EQ(w[1].birth, 0.5);
  EXPECT_EQ(w[1].death, 2.0);
  EXPECT_EQ(w[2].shape, RigidWall::Shape::cylinder);
  EXPECT_EQ(w[2].radius, 2.5);
  EXPECT_EQ(w[2].length_n, 6.0);
  EXPECT_DOUBLE_EQ(w[2].motion_direction.z, 0.8);
  EXPECT_TRUE(b.says(Severity::warning, after_cube + 19, "has length 5"));
  EXPECT_EQ(w[3].shape, RigidWall::Shape::sphere);
  EXPECT_TRUE(w[3].interior);
  EXPECT_EQ(w[3].motion, -1);
}

TEST(Wall, GeometricCardsThatMakeNoSense) {
  const auto says = [](const std::string& deck, int line, const std::string& words) {
    const Built b = build_text(cube + curve + deck);
    return b.says(Severity::error, after_cube + 3 + line, words);
  };
  const std::string sphere = "*RIGIDWALL_GEOMETRIC_SPHERE", cylinder = "*RIGIDWALL_GEOMETRIC_CYLINDER",
                    flat = "*RIGIDWALL_GEOMETRIC_FLAT", at = "\n0\n0,0,9,0,0,10\n";
  EXPECT_TRUE(says(sphere + at + "0\n", 4, "radius above 0"));
  EXPECT_TRUE(says(cylinder + at + "-1\n", 4, "radius above 0"));
  EXPECT_TRUE(says(cylinder + at + "1,-2\n", 4, "expected a length"));
  EXPECT_TRUE(says(cylinder + "\n0\n0,0,9,0,0,9\n1\n", 3, "the axis are the same point"));
  EXPECT_TRUE(says(flat + at + "0,0,11,1,1\n", 4, "along its normal"));
  EXPECT_TRUE(says(sphere + "_MOTION" + at + "1\n0,0,1,0,0\n", 5, "no curve"));
  EXPECT_TRUE(says(sphere + "_MOTION" + at + "1\n8,0,1,0,0\n", 5, "curve 8"));
  EXPECT_TRUE(says(sphere + "_MOTION" + at + "1\n9,0,0,0,0\n", 5, "has no length"));
  EXPECT_TRUE(says(sphere + "_MOTION" + at + "1\n9,2,1,0,0\n", 5, "velocity) or 1"));
  EXPECT_TRUE(says(sphere + "\n0\n0,0,9,0,0,10,2\n1\n", 3, "expected 0 to 1"));
}

TEST(Velocity, LaterCardsReplaceAndNodesGoLast) {
  const Built b = build_text(cube +
                             "*SET_NODE\n1\n5,6,7,8\n*SET_NODE\n2\n6\n*INITIAL_VELOCITY_NODE\n5,0,0,-9\n"
                             "*INITIAL_VELOCITY\n0\n1,0,0\n*INITIAL_VELOCITY\n1,2\n0,2,0\n0,0,3\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& v = b.model.initial_velocity;
  ASSERT_EQ(v.size(), 24u);
  EXPECT_EQ((std::vector<double>(v.begin(), v.begin() + 3)), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ((std::vector<double>(v.begin() + 12, v.begin() + 15)), (std::vector<double>{0, 0, -9}));
  EXPECT_EQ((std::vector<double>(v.begin() + 15, v.begin() + 18)), (std::vector<double>{0, 0, 3}));
  EXPECT_EQ((std::vector<double>(v.begin() + 18, v.begin() + 21)), (std::vector<double>{0, 2, 0}));
}

TEST(Velocity, GenerationTurnsAboutAnAxis) {
  // omega = 10 about the line through (0, 0) along z, plus a translation along z.
  const Built b = build_text(cube + "*INITIAL_VELOCITY_GENERATION\n1,2,10,0,0,5\n0,0,0,0,0,2\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& v = b.model.initial_velocity;
  EXPECT_EQ((std::vector<double>(v.begin() + 6, v.begin() + 9)),
            (std::vector<double>{-10, 10, 5}));  // node 3 at (1, 1, 0)
  const Built by_nodes = build_text(cube + "*INITIAL_VELOCITY_GENERATION\n0,2,10,0,0,5\n0,0,0,-999,1,5\n");
  ASSERT_FALSE(by_nodes.failed()) << by_nodes.text();
  EXPECT_EQ(by_nodes.model.initial_velocity, v);
}

TEST(Damping, ReachesPartsAndTheWhole) {
  const Built b =
      build_text(cube + curve +
                 "*DAMPING_GLOBAL\n0,0.5\n*DAMPING_GLOBAL\n9,0,0,0,2\n"
                 "*DAMPING_PART_MASS\n1,9,0,1\n1,0.5\n*SET_PART\n4\n1\n*DAMPING_PART_STIFFNESS_SET\n4,0.1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.global_damping[0].factor[0], 1.0);  // all blank: 1
  EXPECT_EQ(b.model.global_damping[1].factor[0], 0.0);
  EXPECT_EQ(b.model.global_damping[1].factor[2], 2.0);
  const Part& part = b.model.parts[0];
  EXPECT_EQ(part.mass_damping, 1.0);
  EXPECT_EQ(part.mass_damping_curve, 0);
  EXPECT_EQ(part.mass_damping_factor[1], 0.5);
  EXPECT_EQ(part.mass_damping_factor[2], 0.0);
  EXPECT_EQ(part.stiffness_damping, 0.1);
}

TEST(Mass, OfNodesSetsAndParts) {
  const Built b = build_text(cube +
                             "*ELEMENT_MASS\n       1       5             0.5\n*SET_NODE\n3\n1,2\n"
                             "*ELEMENT_MASS_NODE_SET\n2,3,0.25\n*ELEMENT_MASS_PART\n1,0,8e-9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& m = b.model.point_masses;
  ASSERT_EQ(m.size(), 3u + 8u);
  EXPECT_EQ(m[0].node, 4);
  EXPECT_EQ(m[0].mass, 0.5);
  EXPECT_EQ(m[2].mass, 0.25);
  // FINMASS 8e-9 on a cube of 7.85e-9: the difference, spread evenly by symmetry.
  EXPECT_NEAR(m[3].mass, (8e-9 - 7.85e-9) / 8.0, 1e-24);
}

TEST(Absorbing, FacesAndSwitches) {
  const Built b = build_text(cube + "*SET_SEGMENT\n4\n5,6,7,8\n*BOUNDARY_NON_REFLECTING\n4,0,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_TRUE(b.model.absorbing.at(0).dilatational);
  EXPECT_FALSE(b.model.absorbing[0].shear);
}

}  // namespace
}  // namespace cleave::model
