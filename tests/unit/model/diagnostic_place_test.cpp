/// What is wrong with a deck is said once, and where.

#include <gtest/gtest.h>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

/// `cube` with one of its lines replaced.
Built cube_with(const std::string& line, const std::string& instead, BuildOptions options = {}) {
  std::string text = cube;
  text.replace(text.find(line), line.size(), instead);
  return build_text(text + "*END\n", options);
}

TEST(Diagnostics, BadNumberIsReportedOnce) {
  // In a material, a control card, and a row of the mesh: no error may follow from the value it did not have.
  for (const auto& [line, instead, at] :
       {std::tuple("1,7.85e-9,2.1e5,0.3", "1,7.85e-9,2.1x5,0.3", 5),
        std::tuple("1,7.85e-9,2.1e5,0.3", "1,seven,2.1e5,0.3", 5), std::tuple("1.0\n", "soon\n", 3),
        std::tuple("1,1,1,2,3,4,5,6,7,8", "1,1,1,2,3,4,5,6,7,8.5", 21)}) {
    const Built r = cube_with(line, instead);
    EXPECT_EQ(r.diagnostics.count(Severity::error), 1u) << r.text();
    EXPECT_TRUE(r.says(Severity::error, at, "found ")) << r.text();
  }
  // A blank field still says that it is needed.
  EXPECT_TRUE(cube_with("1,7.85e-9,2.1e5,0.3", "1,7.85e-9,,0.3").says(Severity::error, 5, "is needed"));
}

TEST(Diagnostics, InsideOutElementHasAPlace) {
  const Built r = cube_with("1,1,1,2,3,4,5,6,7,8", "1,1,5,6,7,8,1,2,3,4");
  ASSERT_EQ(r.diagnostics.count(Severity::error), 1u) << r.text();
  EXPECT_TRUE(r.says(Severity::error, 21, "element 1 has volume 0 or less")) << r.text();
  EXPECT_EQ(r.diagnostics.all().front().place.column, 1);
}

TEST(Diagnostics, MissingEndTimeHasAPlaceAndCanWait) {
  const std::string card = "*CONTROL_TERMINATION\n1.0\n";
  const Built r = cube_with(card, "");
  ASSERT_EQ(r.diagnostics.count(Severity::error), 1u) << r.text();
  EXPECT_TRUE(r.says(Severity::error, 1, "no end time")) << r.text();
  EXPECT_FALSE(cube_with(card, "", {.needs_end_time = false}).failed());
  const Built given = cube_with(card, "", {.end_time = 2.5});
  EXPECT_FALSE(given.failed()) << given.text();
  EXPECT_EQ(given.model.control.end.time, 2.5);
}

TEST(Diagnostics, AbsurdMaterialsAreDoubted) {
  EXPECT_TRUE(cube_with("7.85e-9", "1e-99").says(Severity::warning, 5, "found 1e-99"));
  EXPECT_TRUE(cube_with("2.1e5", "1e-40").says(Severity::warning, 5, "waves travel at"));
  EXPECT_EQ(cube_with("7.85e-9", "7.85e-27").diagnostics.count(Severity::warning), 0u);  // tonne, nanometre
  EXPECT_EQ(cube_with("7.85e-9", "7.85e-9").diagnostics.count(Severity::warning), 0u);
}

TEST(Diagnostics, DeletionByStepIsNotUsedWithMassScaling) {
  const Built r = build_text(cube + "*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,-1e-6,0,1\n*END\n");
  EXPECT_TRUE(r.says(Severity::warning, after_cube + 1, "not used with mass scaling")) << r.text();
  const Built alone = build_text(cube + "*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,0.0,0,1\n*END\n");
  EXPECT_EQ(alone.diagnostics.count(Severity::warning), 0u) << alone.text();
}

TEST(Diagnostics, CurveThatEndsTooSoonHasAPlace) {
  const Built r =
      build_text(cube + "*DEFINE_CURVE\n7\n0.0,0.0\n0.5,1.0\n*LOAD_NODE_POINT\n7,3,7,1.0\n*END\n");
  EXPECT_TRUE(r.says(Severity::warning, after_cube + 1, "ends at 0.5")) << r.text();
}

}  // namespace
}  // namespace cleave::model
