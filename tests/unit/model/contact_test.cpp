/// What *CONTACT_ and *PART_CONTACT make of boxes, friction of parts and thicknesses of solids.

#include <gtest/gtest.h>

#include <algorithm>

#include "round_trip.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

/// The cube of deck_text.hpp (part 1) under another of two elements side by side (part 2), 0.1 apart.
const std::string two =
    cube +
    "*PART_CONTACT\nupper\n2,1,1\n0.4,0.2,3.0,7.0\n"
    "*NODE\n11,0,0,1.1\n12,1,0,1.1\n13,1,1,1.1\n14,0,1,1.1\n15,0,0,2\n16,1,0,2\n17,1,1,2\n18,0,1,2\n"
    "19,2,0,1.1\n20,2,1,1.1\n21,2,0,2\n22,2,1,2\n"
    "*ELEMENT_SOLID\n2,2,11,12,13,14,15,16,17,18\n3,2,12,19,20,13,16,21,22,17\n"
    "*DEFINE_BOX\n5,-0.5,1.5,-9,9,1.05,1.5\n";
int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}
std::string contact(const std::string& keyword, const std::string& sides, const std::string& rest = "\n\n") {
  return two + "*CONTACT_" + keyword + "\n" + sides + "\n" + rest;
}

// Of the ten outer faces of part 2 only the lower one of its first element lies in the box.
TEST(Contact, ABoxLimitsTheFacesOfParts) {
  const std::string text = contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3,5");
  const Built built = build_text(text);
  ASSERT_FALSE(built.failed()) << built.text();
  const ContactSide& side = built.model.contacts.at(0).a;
  ASSERT_EQ(side.segments.size(), 1u);
  EXPECT_EQ(side.nodes, (std::vector<Index>{8, 9, 10, 11}));
  EXPECT_TRUE(side.parts.empty());
  EXPECT_EQ(built.model.contacts[0].b.segments.size(), 6u);
  expect_round_trip(text);
  expect_round_trip(contact("TIED_SURFACE_TO_SURFACE_OFFSET", "1,2,3,3,0,5"));
}

TEST(Contact, BoxesThatCannotBeAreRefused) {
  const int line = lines_of(two) + 2;
  EXPECT_TRUE(build_text(contact("SURFACE_TO_SURFACE", "2,1,3,3,9")).says(Severity::error, line, "box 9"));
  EXPECT_TRUE(build_text(contact("SURFACE_TO_SURFACE", "1,2,3,3,5"))
                  .says(Severity::error, line, "no face of side A lies in the box"));
  EXPECT_TRUE(build_text(contact("ERODING_SURFACE_TO_SURFACE", "2,1,3,3,5", "\n\n\n"))
                  .says(Severity::error, line, "elements are deleted"));
  EXPECT_TRUE(build_text(two + "*SET_NODE\n1\n1,2\n*CONTACT_NODES_TO_SURFACE\n1,2,4,3,5\n\n\n")
                  .says(Severity::error, line + 3, "limits the faces of parts"));
}

TEST(Contact, FrictionOfPartsIsTaken) {
  const std::string text = contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "-1.0\n\n");
  const Built built = build_text(text);
  ASSERT_FALSE(built.failed()) << built.text();
  const std::vector<PartFriction> expected{{}, {0.4, 0.2, 3.0, 7.0}};
  EXPECT_EQ(built.model.contacts.at(0).part_friction, expected);
  expect_round_trip(text);
  EXPECT_TRUE(build_text(contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "-2.0\n\n")).failed());
  EXPECT_TRUE(build_text(contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", "-1.0\n,,,,,,2.0\n")).failed());
}

TEST(Contact, SolidsMayHaveAThicknessAndAStiffness) {
  const std::string rest = "\n\n0\n,,,,,,0.1,5e4\n";
  const std::string text = contact("AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", rest);
  const Built built = build_text(text);
  ASSERT_FALSE(built.failed()) << built.text();
  EXPECT_EQ(built.model.contacts.at(0).solid_thickness, 0.1);
  EXPECT_EQ(built.model.contacts.at(0).solid_modulus, 5e4);
  expect_round_trip(text);
  EXPECT_TRUE(build_text(contact("SURFACE_TO_SURFACE", "2,1,3,3", rest)).failed());
}

TEST(Contact, RwpnalGoesToPlanarWalls) {
  const std::string text = cube + "*CONTROL_CONTACT\n0.1,-0.5\n\n*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0\n";
  const Built built = build_text(text);
  ASSERT_FALSE(built.failed()) << built.text();
  EXPECT_EQ(built.model.walls.at(0).penalty, -0.5);
  expect_round_trip(text);
}

}  // namespace
}  // namespace cleave::model
