/// *DEFINE_CURVE and *DEFINE_TABLE: scaling rules, order, values between and beyond the points.

#include <gtest/gtest.h>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

TEST(Curve, ScalesAfterTheOffsetAndReadsZeroFactorsAsOne) {
  const Built b =
      build_text(cube + "*DEFINE_CURVE\n1,0,2,3,0.5,1\n0,0\n1,10\n*DEFINE_CURVE\n2,0,0,0\n0,0\n1,10\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.curves[0].x, (std::vector<double>{1.0, 3.0}));   // 2 (A + 0.5)
  EXPECT_EQ(b.model.curves[0].y, (std::vector<double>{3.0, 33.0}));  // 3 (O + 1)
  EXPECT_EQ(b.model.curves[1].y, (std::vector<double>{0.0, 10.0}));
}

TEST(Curve, DescendingAbscissaeAreAnErrorAtTheirLine) {
  const Built b = build_text(cube + "*DEFINE_CURVE\n1\n0,0\n2,1\n1,2\n");
  EXPECT_TRUE(b.says(deck::Severity::error, after_cube + 4, "ascend")) << b.text();
}

TEST(Curve, NumbersAreSharedWithTables) {
  const Built b = build_text(cube + "*DEFINE_CURVE\n1\n0,0\n*DEFINE_TABLE_2D\n1\n0,1\n");
  EXPECT_TRUE(b.says(deck::Severity::error, after_cube + 4, "defined before")) << b.text();
}

TEST(Curve, InterpolatesHoldsAndIntegrates) {
  Curve c;
  c.x = {1.0, 2.0, 2.0, 4.0};
  c.y = {0.0, 2.0, 5.0, 1.0};
  EXPECT_EQ(c.value(0.0), 0.0);
  EXPECT_EQ(c.value(1.5), 1.0);
  EXPECT_EQ(c.value(2.0), 5.0);  // after the jump
  EXPECT_EQ(c.value(3.0), 3.0);
  EXPECT_EQ(c.value(9.0), 1.0);
  EXPECT_EQ(c.value_or_zero(0.5), 0.0);
  EXPECT_EQ(c.value_or_zero(4.0), 1.0);
  EXPECT_EQ(c.value_or_zero(4.1), 0.0);
  EXPECT_EQ(c.slope(1.5), 2.0);
  EXPECT_EQ(c.slope(3.0), -2.0);
  EXPECT_EQ(c.slope(5.0), 0.0);
  EXPECT_EQ(c.integral(1.0), 0.0);
  EXPECT_EQ(c.integral(2.0), 1.0);
  EXPECT_EQ(c.integral(3.0), 1.0 + 4.0);
  EXPECT_EQ(c.integral(5.0), 1.0 + 6.0 + 1.0);
}

TEST(Table, TakesTheCurvesThatFollow) {
  const Built b =
      build_text(cube + "*DEFINE_TABLE\n5\n0\n10\n*DEFINE_CURVE\n8\n0,1\n*DEFINE_CURVE\n3\n0,2\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.tables.size(), 1u);
  EXPECT_EQ(b.model.tables[0].value, (std::vector<double>{0, 10}));
  EXPECT_EQ(b.model.curves[b.model.tables[0].curve[0]].id, 8);
  EXPECT_EQ(b.model.curves[b.model.tables[0].curve[1]].id, 3);
  const Built short_of = build_text(cube + "*DEFINE_TABLE\n5\n0\n10\n*DEFINE_CURVE\n8\n0,1\n");
  EXPECT_NE(short_of.text().find("2 values, but 1"), std::string::npos) << short_of.text();
}

TEST(Table, TwoDimensionalNamesItsCurves) {
  const Built b = build_text(cube + "*DEFINE_TABLE_2D\n5,2\n1,8\n2,8\n*DEFINE_CURVE\n8\n0,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.tables[0].value, (std::vector<double>{2, 4}));
  EXPECT_EQ(b.model.tables[0].curve, (std::vector<Index>{0, 0}));
  EXPECT_NE(build_text(cube + "*DEFINE_TABLE_2D\n5\n1,9\n").text().find("curve 9 of the table"),
            std::string::npos);
}

}  // namespace
}  // namespace cleave::model
