/// Mass, volume, quality and likely units of a model; checks that follow a build.

#include "model/report.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "deck_text.hpp"
#include "model/solid_geometry.hpp"

namespace cleave::model {
namespace {

TEST(Geometry, VolumesOfKnownSolids) {
  const std::array<Corner, 8> brick{
      {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 4}, {2, 0, 4}, {2, 3, 4}, {0, 3, 4}}};
  EXPECT_NEAR(volume(Shape::hex8, brick), 24.0, 1e-13);
  EXPECT_NEAR(centre_volume(Shape::hex8, brick), 24.0, 1e-13);
  EXPECT_NEAR(aspect_ratio(Shape::hex8, brick), 2.0, 1e-15);
  EXPECT_NEAR(jacobian_ratio(Shape::hex8, brick), 1.0, 1e-15);
  // A frustum with square faces of 2 and 1, height 3: (h / 3) (A + B + sqrt(A B)).
  const std::array<Corner, 8> frustum{{{-1, -1, 0},
                                       {1, -1, 0},
                                       {1, 1, 0},
                                       {-1, 1, 0},
                                       {-.5, -.5, 3},
                                       {.5, -.5, 3},
                                       {.5, .5, 3},
                                       {-.5, .5, 3}}};
  EXPECT_NEAR(volume(Shape::hex8, frustum), 4.0 + 1.0 + 2.0, 1e-13);
  // The same with its top collapsed to a point: a pyramid.
  std::array<Corner, 8> pyramid = frustum;
  for (int a = 4; a < 8; ++a) pyramid[a] = {0, 0, 3};
  EXPECT_NEAR(volume(Shape::hex8, pyramid), 4.0, 1e-13);
  const std::array<Corner, 6> wedge{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {0, 1, 3}}};
  EXPECT_NEAR(volume(Shape::penta6, wedge), 2.0 + 0.5 + 1.0, 1e-13);
  const std::array<Corner, 4> tet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR(volume(Shape::tet4, tet), 1.0 / 6.0, 1e-16);
}

TEST(Report, AddsUpMassVolumeAndBox) {
  const Built b = build_text(cube + "*ELEMENT_MASS\n1,1,1e-9\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const ModelReport r = report(b.model);
  EXPECT_NEAR(r.volume, 1.0, 1e-14);
  EXPECT_NEAR(r.mass, 8.85e-9, 1e-22);
  EXPECT_EQ(r.high[2], 1.0);
  EXPECT_EQ(r.elements, 1u);
  EXPECT_EQ(r.units, "tonne mm s");
  // 1 / sqrt(282692 / 7.85e-9)
  EXPECT_NEAR(r.least_time_step, 1.6664e-7, 1e-11);
}

TEST(Report, GuessesTheUnitSystems) {
  EXPECT_EQ(guess_units(7830, 2.07e11), "kg m s");
  EXPECT_EQ(guess_units(2700, 7e10), "kg m s");
  EXPECT_EQ(guess_units(7.83e-6, 207), "kg mm ms");
  EXPECT_EQ(guess_units(8.93e-9, 1.17e5), "tonne mm s");
  EXPECT_EQ(guess_units(8.96, 1.2), "g cm us");
  EXPECT_EQ(guess_units(7.33e-4, 3e7), "lbf-s2/in in s");
  EXPECT_EQ(guess_units(1.0, 1.0), "");
}

TEST(Check, WarnsOfWhatIsProbablyNotMeant) {
  const Built lonely = build_text(cube + "*NODE\n77,9,9,9\n");
  EXPECT_NE(lonely.text().find("1 nodes belong to no element: 77"), std::string::npos) << lonely.text();
  const std::string curve = "*DEFINE_CURVE\n3\n0,0\n0.5,1\n";
  EXPECT_NE(build_text(cube + curve + "*LOAD_NODE_POINT\n1,1,3\n").text().find("curve 3 ends at 0.5"),
            std::string::npos);
  EXPECT_NE(build_text(cube + curve + "*NODE\n77,9,9,9\n*LOAD_NODE_POINT\n77,1,3\n")
                .text()
                .find("without mass: 77"),
            std::string::npos);
  const Built mixed = build_text(cube + "*MAT_ELASTIC\n2,2700,7e10,0.3\n*PART\n\n2,1,2\n");
  EXPECT_NE(mixed.text().find("different units"), std::string::npos) << mixed.text();
}

TEST(Report, SpacetimePartsHaveHeights) {
  const std::string head =
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1,2.0,2.5,0.25\n*PART\n\n1,1,1\n"
      "*NODE\n1,0,0,0\n2,3,0,0\n3,3,4,0\n4,0,4,0\n5,7,0,0\n6,0,0,6\n";
  // A rectangle of 3 by 4, whose diagonals are 5 long, and a triangle of 4 by 4; thickness one half.
  Built b = build_text(head + "*SECTION_SHELL_SDG\n1,13,0,0,0.5\n*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,3,3\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ModelReport r = report(b.model);
  EXPECT_EQ(r.parts[0].elements, 2u);
  EXPECT_NEAR(r.parts[0].volume, 0.5 * (12.0 + 8.0), 1e-13);
  EXPECT_NEAR(r.mass, 2.0 * 10.0, 1e-13);
  EXPECT_NEAR(r.parts[0].least_height, 2.4, 1e-14);
  EXPECT_EQ(r.parts[0].least_height_element, 1);
  EXPECT_NEAR(r.least_time_step, 2.4 / std::sqrt(1.5), 1e-13);
  b = build_text(head + "*SECTION_BEAM_SDG\n1,1,0,0,0.5\n*ELEMENT_BEAM\n1,1,1,2\n2,1,2,5\n");
  ASSERT_FALSE(b.failed()) << b.text();
  r = report(b.model);
  EXPECT_NEAR(r.volume, 3.5, 1e-13);
  EXPECT_EQ(r.parts[0].least_height, 3.0);
  b = build_text(head + "*SECTION_SOLID_SDG\n1,\n*ELEMENT_SOLID\n1,1,1,2,4,6,6,6,6,6\n");
  ASSERT_FALSE(b.failed()) << b.text();
  r = report(b.model);
  EXPECT_NEAR(r.volume, 12.0, 1e-13);
  // Height over the largest face, through (3, 0, 0), (0, 4, 0), (0, 0, 6): 1 / |(1/3, 1/4, 1/6)|.
  EXPECT_NEAR(r.parts[0].least_height, 12.0 / std::sqrt(29.0), 1e-13);
}

}  // namespace
}  // namespace cleave::model
