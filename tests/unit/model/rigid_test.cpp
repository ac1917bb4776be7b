/// Keywords of rigid bodies: what they make, what they refuse, and the way back to a deck.

#include <gtest/gtest.h>

#include <algorithm>

#include "round_trip.hpp"

namespace cleave::model {
namespace {

using deck::Severity;
using Indices = std::vector<Index>;

/// Two unit cubes, parts 1 and 2, of *MAT_RIGID 1, and a deformable one, part 3; nodes 1-8, 11-18, 21-28; a
/// loose node 31.
std::string three(const std::string& material = "0\n\n") {
  std::string text =
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*DEFINE_CURVE\n1\n0,0\n9,9\n"
      "*MAT_RIGID\n1,2.0,1e5,0.3\n" +
      material +
      "*MAT_ELASTIC\n2,2.0,1e5,0.3\n*SECTION_SOLID\n1,1\n*PART\none\n1,1,1\n*PART\ntwo\n2,1,1\n*PART\nsoft\n"
      "3,1,2\n*NODE\n31,9,9,9\n";
  for (int part = 0; part < 3; ++part)
    for (int a = 0; a < 8; ++a) {
      const int x = (a & 3) == 1 || (a & 3) == 2, y = (a & 3) >= 2, z = a >= 4;
      text += std::to_string(10 * part + a + 1) + ',' + std::to_string(x + 2 * part) + ',' +
              std::to_string(y) + ',' + std::to_string(z) + '\n';
    }
  text += "*ELEMENT_SOLID\n";
  for (int part = 0; part < 3; ++part) {
    text += std::to_string(part + 1) + ',' + std::to_string(part + 1);
    for (int a = 1; a <= 8; ++a) text += ',' + std::to_string(10 * part + a);
    text += '\n';
  }
  return text;
}
int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Rigid, PartsAreBodiesAndMergeOrNot) {
  const Built apart = build_text(three());
  ASSERT_FALSE(apart.failed()) << apart.text();
  ASSERT_EQ(apart.model.rigid_bodies.size(), 2u);
  EXPECT_EQ(apart.model.rigid_bodies[1].id, 2);
  EXPECT_EQ(apart.model.rigid_bodies[1].nodes, (Indices{8, 9, 10, 11, 12, 13, 14, 15}));
  EXPECT_TRUE(apart.model.parts[0].rigid && !apart.model.parts[2].rigid);

  const Built merged = build_text(three() + "*CONSTRAINED_RIGID_BODIES\n2,1\n");
  ASSERT_FALSE(merged.failed()) << merged.text();
  ASSERT_EQ(merged.model.rigid_bodies.size(), 1u);
  EXPECT_EQ(merged.model.rigid_bodies[0].parts, (Indices{1, 0}));
  EXPECT_EQ(merged.model.rigid_bodies[0].nodes.size(), 16u);
}

TEST(Rigid, CentreIsHeldInGlobalOrLocalDirections) {
  const Built global = build_text(three("1,4,7\n\n"));
  ASSERT_FALSE(global.failed()) << global.text();
  EXPECT_EQ(global.model.rigid_bodies[0].hold.directions, 1u | 2u | 7u << 3);
  const std::string axes = "*DEFINE_COORDINATE_VECTOR\n5,0,1,0,-1,0,0\n";
  const Built local = build_text(three("-1,5,110111\n5\n") + axes);
  ASSERT_FALSE(local.failed()) << local.text();
  const RigidBody& body = local.model.rigid_bodies[0];
  EXPECT_EQ(body.hold.directions, 0b111011u);
  EXPECT_TRUE(body.hold.local && body.has_axes);
  EXPECT_EQ(body.hold.frame.axis[0].y, 1.0);
  EXPECT_TRUE(
      build_text(three("-1,6,1\n\n")).says(Severity::error, 10, "coordinate system 6 is not defined"));
  EXPECT_TRUE(build_text(three("-1,0,12\n\n")).says(Severity::error, 10, "expected six digits"));
  EXPECT_TRUE(build_text(three("1,9,0\n\n")).says(Severity::error, 10, "expected 0 to 7"));
}

TEST(Rigid, WhatMadymoWouldNeedIsRefused) {
  std::string text = three();
  text.replace(text.find("1,2.0,1e5,0.3"), 13, "1,2.0,1e5,0.3,0,1,2");
  const Built b = build_text(text);
  EXPECT_TRUE(b.says(Severity::error, 9, "not honoured"));
  EXPECT_NE(b.text().find("COUPLE"), std::string::npos);
}

TEST(Rigid, NodesHaveOneMaster) {
  const int row = lines(three()) + 2;
  const auto says = [&](const std::string& cards, int line, std::string_view phrase) {
    const Built b = build_text(three() + cards);
    EXPECT_TRUE(b.says(Severity::error, line, phrase)) << b.text();
  };
  says("*BOUNDARY_SPC_NODE\n3,0,1,1,1\n", row,
       "node 3 (and perhaps more) belongs to rigid body 1 and is held");
  says("*BOUNDARY_PRESCRIBED_MOTION_NODE\n12,1,0,1\n", row, "belongs to rigid body 2 and is moved by itself");
  says("*CONSTRAINED_EXTRA_NODES_NODE\n1,31\n2,31\n", row + 1,
       "node 31 belongs to two rigid bodies, 1 and 2");
  says("*SET_NODE\n4\n5,6\n*CONSTRAINED_NODAL_RIGID_BODY\n9,0,4\n", row + 3,
       "node 5 belongs to two rigid bodies, 1 and 9");
  says("*SET_NODE\n4\n0,0\n*CONSTRAINED_NODAL_RIGID_BODY\n9,0,4\n", row + 3,
       "set of this nodal rigid body is empty");
  says("*CONSTRAINED_EXTRA_NODES_NODE\n3,31\n", row, "part 3 is not rigid");
  says("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n3,1,0,1\n", row, "part 3 is not rigid");
  says("*LOAD_RIGID_BODY\n7,1,1\n", row, "part 7 is not defined");
  says("*INITIAL_VELOCITY_RIGID_BODY\n3,1.0\n", row, "part 3 is not rigid");
  says("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,9,0,1\n0,0,0,1,2\n", row, "beside the centre");
  says("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,3,1\n", row, "motion of kind 3");
}

TEST(Rigid, PartWithoutElementsHasNoMass) {
  const Built b = build_text(three() + "*PART\nempty\n4,1,1\n");
  EXPECT_TRUE(b.says(Severity::error, lines(three()) + 3, "rigid body 4 has no elements and so no mass"))
      << b.text();
}

TEST(Rigid, StatedInertiaIsReadInItsAxes) {
  const std::string part = "*PART\none\n1,1,1\n";
  std::string text = three();
  const auto at = text.find(part);
  const auto with = [&](const std::string& card) {
    std::string changed = text;
    changed.replace(at, part.size(), "*PART_INERTIA\none\n1,1,1\n" + card);
    return build_text(changed);
  };
  const Built b = with("0.5,0.5,0.5,3.0,1\n1,0,0,2,0,2.5\n1,2,3,4,5,6\n0,1,0,-1,0,0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const RigidInertia& s = *b.model.parts[0].inertia;
  EXPECT_EQ(s.mass, 3.0);
  EXPECT_EQ(s.tensor.xx, 2.0);  // local x is global y
  EXPECT_EQ(s.tensor.yy, 1.0);
  EXPECT_TRUE(b.model.rigid_bodies[0].has_velocity);
  EXPECT_EQ(b.model.rigid_bodies[0].spin.z, 6.0);
  const int first = lines(text.substr(0, at)) + 4;
  EXPECT_TRUE(
      with("0,0,0,3.0\n1,2,0,2,0,2.5\n0\n").says(Severity::error, first + 1, "not positive definite"));
  EXPECT_TRUE(with("0,0,0,0.0\n1,0,0,2,0,2.5\n0\n").says(Severity::error, first, "mass of a rigid body"));
}

TEST(Rigid, ShellsAreRigidOrHeldOrRefused) {
  const std::string shells =
      "*SECTION_SHELL\n7,2\n0.1\n*PART\nplate\n5,7,2\n*ELEMENT_SHELL\n1,5,21,22,23,24\n";
  const int row = lines(three()) + 8;
  EXPECT_TRUE(build_text(three() + shells).says(Severity::error, row, "its shells deform"));
  const Built held =
      build_text(three() + shells + "*SET_NODE\n4\n21,22,23,24\n*BOUNDARY_SPC_SET\n4,0,1,1,1,1,1,1\n");
  ASSERT_FALSE(held.failed()) << held.text();
  EXPECT_TRUE(held.model.rigid_bodies.size() == 2u && held.model.mesh.shells.at(0).count() == 1u);
  EXPECT_TRUE(
      build_text(three() + "*SECTION_SHELL\n7,2\n0.0\n*PART\nplate\n5,7,1\n*ELEMENT_SHELL\n1,5,1,2,3,4\n")
          .says(Severity::error, lines(three()) + 2, "no thickness"));
}

TEST(Rigid, EverythingComesBackFromItsOwnDeck) {
  const std::string axes = "*DEFINE_COORDINATE_VECTOR\n5,0,1,0,-1,0,0\n*DEFINE_VECTOR\n3,0,0,0,1,1,0\n";
  expect_round_trip(
      three("-1,5,110111\n5\n") + axes +
      "*SET_NODE\n4\n25,26\n*SET_NODE\n6\n21,22\n*CONSTRAINED_RIGID_BODIES\n1,2\n"
      "*CONSTRAINED_EXTRA_NODES_NODE\n1,31,1\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_SPC_TITLE\nlid\n9,5,4\n-1,5,100010\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n8,0,6\n0,0,0,3.0\n1,0.1,0,2,0,2.5\n0.5\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID_ID\n         3turn\n1,5,2,1,2.0,0,0.5,0.25\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL\n1,-4,0,1,1.0,3\n"
      "*INITIAL_VELOCITY_RIGID_BODY\n1,1,2,3,4,5,6\n"
      "*LOAD_RIGID_BODY\n1,2,1,3.0\n9,7,1,0.5,5\n1,8,1,1.0,0,21,22,23\n*DATABASE_RBDOUT\n0.1\n");
}

}  // namespace
}  // namespace cleave::model
