/// *BOUNDARY_SPC, *BOUNDARY_PRESCRIBED_MOTION, *CONSTRAINED_GLOBAL/LOCAL, symmetry planes, coordinate
/// systems.

#include <gtest/gtest.h>

#include <cmath>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

using deck::Severity;
using Indices = std::vector<Index>;

TEST(Spc, EveryRowCountsAndNodesOfEqualRowsJoin) {
  const Built b = build_text(cube + "*BOUNDARY_SPC_NODE\n1,0,1,0,1\n2,0,1,0,1\n3,0,0,1,0,1,1,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.fixed.size(), 2u);
  EXPECT_EQ(b.model.fixed[0].nodes, (Indices{0, 1}));
  EXPECT_EQ(b.model.fixed[0].directions, 5u);
  EXPECT_EQ(b.model.fixed[1].directions, 2u | 7u << 3);
  EXPECT_EQ(b.model.fixed[0].death, forever);
}

TEST(Spc, IdBirthDeathAndLocalAxes) {
  const Built b = build_text(cube +
                             "*DEFINE_COORDINATE_SYSTEM\n3,0,0,0,0,2,0\n-3,0,0\n*SET_NODE\n5\n5,6\n"
                             "*BOUNDARY_SPC_SET_BIRTH_DEATH_ID\n        17edge\n5,3,1\n0.5,0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const FixedNodes& f = b.model.fixed.at(0);
  EXPECT_EQ(f.id, 17);
  EXPECT_EQ(f.title, "edge");
  EXPECT_EQ(f.birth, 0.5);
  EXPECT_EQ(f.death, forever);
  EXPECT_TRUE(f.local);
  EXPECT_EQ(f.frame.axis[0].y, 1.0);
  EXPECT_EQ(f.frame.axis[1].x, -1.0);
  EXPECT_EQ(f.frame.axis[2].z, 1.0);
  EXPECT_TRUE(build_text(cube + "*BOUNDARY_SPC_NODE\n1,9,1\n")
                  .says(Severity::error, after_cube + 1, "coordinate system 9"));
  EXPECT_TRUE(build_text(cube + "*BOUNDARY_SPC_NODE\n1,0,2\n").failed());
}

TEST(Frames, OfNodesFollowTheirDirection) {
  const std::string text = cube + "*BOUNDARY_SPC_NODE\n1,4,1\n*DEFINE_COORDINATE_NODES\n4,1,2,4,0,Y\n";
  const Built b = build_text(text);
  ASSERT_FALSE(b.failed()) << b.text();
  // N1-N2 (global x) is local y; N3 lies along global y, which is then local z.
  EXPECT_EQ(b.model.fixed[0].frame.axis[1].x, 1.0);
  EXPECT_EQ(b.model.fixed[0].frame.axis[2].y, 1.0);
  EXPECT_EQ(b.model.fixed[0].frame.axis[0].z, 1.0);
  EXPECT_TRUE(build_text(cube + "*DEFINE_COORDINATE_NODES\n4,1,2,2\n").failed());
}

TEST(Motion, KindsDirectionsAndTimes) {
  const std::string curve = "*DEFINE_CURVE\n9\n0,0\n1,1\n*DEFINE_VECTOR\n6,0,0,0,0,3,4\n";
  const Built b = build_text(
      cube + curve +
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,9\n2,2,1,9,2.5,0,0.5,0.25\n3,4,2,9,0,6,0\n4,-4,2,9,0,6\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& m = b.model.motions;
  ASSERT_EQ(m.size(), 4u);
  EXPECT_EQ(m[0].kind, PrescribedMotion::Kind::velocity);
  EXPECT_EQ(m[0].scale, 1.0);
  EXPECT_EQ(m[1].kind, PrescribedMotion::Kind::acceleration);
  EXPECT_EQ(m[1].death, 0.5);
  EXPECT_EQ(m[1].birth, 0.25);
  EXPECT_EQ(m[2].kind, PrescribedMotion::Kind::displacement);
  EXPECT_DOUBLE_EQ(m[2].direction.y, 0.6);
  EXPECT_DOUBLE_EQ(m[2].direction.z, 0.8);
  EXPECT_EQ(m[2].death, forever);  // DEATH = 0
  EXPECT_TRUE(m[2].only_direction);
  EXPECT_FALSE(m[3].only_direction);
}

TEST(Motion, WhatCannotBeDoneIsSaid) {
  const std::string curve = "*DEFINE_CURVE\n9\n0,0\n1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
  const int line = after_cube + 5;
  EXPECT_TRUE(build_text(cube + curve + "1,5,2,9\n").says(Severity::error, line, "a rotation"));
  EXPECT_TRUE(build_text(cube + curve + "1,1,4,9\n").says(Severity::error, line, "VAD 4"));
  EXPECT_TRUE(build_text(cube + curve + "1,1,5,9\n").says(Severity::error, line, "expected 0 to 4"));
  EXPECT_TRUE(build_text(cube + curve + "1,12,2,9\n").says(Severity::error, line, "DOF 12"));
  EXPECT_TRUE(build_text(cube + curve + "1,9,3,9\n0,0\n").says(Severity::error, line, "VAD 3"));
  EXPECT_TRUE(build_text(cube + curve + "1,9,2,9\n0,0,77\n").says(Severity::error, line + 1, "a rigid body"));
  EXPECT_TRUE(build_text(cube + curve + "1,4,2,9\n").says(Severity::error, line, "vector 0"));
  EXPECT_TRUE(build_text(cube + curve + "1,1,2,8\n").says(Severity::error, line, "curve 8"));
  EXPECT_TRUE(build_text(cube + curve + "99,1,2,9\n").says(Severity::error, line, "node 99"));
  EXPECT_TRUE(build_text(cube + curve + "1,0,2,9\n").says(Severity::error, line, "found 0"));
}

TEST(Motion, RotationsHaveTheirAxisInThePlaneOfTheOffsets) {
  const Built b = build_text(cube +
                             "*DEFINE_CURVE\n9\n0,0\n2,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
                             "1,9,2,9\n2,3\n2,9,2,9\n2,3\n3,-10,0,9\n2,3\n4,11,1,9\n2,3\n5,1,3,9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& m = b.model.motions;
  ASSERT_EQ(m.size(), 4u);
  EXPECT_EQ(m[0].nodes.size(), 2u);
  EXPECT_TRUE(m[0].rotation);
  EXPECT_FALSE(m[0].radial_free);
  EXPECT_EQ(m[0].direction.x, 1.0);
  EXPECT_EQ(m[0].centre.y, 2.0);
  EXPECT_EQ(m[0].centre.z, 3.0);
  EXPECT_TRUE(m[1].radial_free);
  EXPECT_EQ(m[1].centre.z, 2.0);
  EXPECT_EQ(m[1].centre.x, 3.0);
  EXPECT_EQ(m[2].kind, PrescribedMotion::Kind::acceleration);
  EXPECT_EQ(m[2].centre.x, 2.0);
  EXPECT_EQ(m[2].centre.y, 3.0);
  EXPECT_EQ(m[3].kind, PrescribedMotion::Kind::velocity_by_displacement);
}

TEST(Constrained, PlanesHoldTheNodesThatLieOnThem) {
  const Built b = build_text(cube + "*CONSTRAINED_GLOBAL\n6,0,3,0,0,1\n7,0,1,0.5,0,0,0.6\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.fixed[0].nodes, (Indices{4, 5, 6, 7}));
  EXPECT_EQ(b.model.fixed[0].directions, 5u);  // 6: z and x
  EXPECT_EQ(b.model.fixed[1].nodes.size(), 8u);
}

TEST(Constrained, LocalPlanesTurn) {
  // Local x is global y: the plane local x = 1 holds nodes with y = 1.
  const Built b =
      build_text(cube + "*DEFINE_COORDINATE_VECTOR\n2,0,1,0,-1,0,0\n*CONSTRAINED_LOCAL\n1,0,1,1,0,0,2\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.fixed[0].nodes, (Indices{2, 3, 6, 7}));
  EXPECT_EQ(b.model.fixed[0].frame.axis[0].y, 1.0);
  EXPECT_EQ(b.model.fixed[0].directions, 1u);
}

TEST(Constrained, SymmetryPlaneHoldsTheNormalAndTurnsOutOfPlane) {
  const Built b = build_text(cube + "*BOUNDARY_SPC_SYMMETRY_PLANE\n1,1,0,0,0,1,-1,0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const FixedNodes& f = b.model.fixed.at(0);
  EXPECT_EQ(f.nodes, (Indices{0, 2, 4, 6}));  // x = y
  EXPECT_EQ(f.directions, 1u | 1u << 4 | 1u << 5);
  EXPECT_NEAR(f.frame.axis[0].x, std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace cleave::model
