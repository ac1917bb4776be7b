#include "deck/diagnostic.hpp"

#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Diagnostic, LooksLikeACompilers) {
  Reading r("*KEYWORD\n*MAT_ELASTIC\n$ steel\n         1  7.83E-6     2o7.0       0.3\n");
  r.read_all();
  EXPECT_EQ(r.rendered(),
            "test.k:4:21: error: *MAT_ELASTIC E: found '2o7.0', expected a real number\n"
            "      | $--------+---------+---------+---------+\n"
            "    4 |          1  7.83E-6     2o7.0       0.3\n"
            "      |                     ^~~~~~~~~~\n"
            "1 error, 0 warnings, 0 notes\n");
}

TEST(Diagnostic, ColoursOnDemand) {
  Reading r("*MAT_ELASTIC\nx\n");
  r.read_all();
  EXPECT_NE(r.diagnostics.render(r.deck.sources(), true).find("\033[1;31merror\033[0m"), std::string::npos);
  EXPECT_EQ(r.rendered().find('\033'), std::string::npos);
}

TEST(Diagnostic, SortedByReadingOrder) {
  Reading r("*MAT_ELASTIC\nx1\n*MAT_ELASTIC\nx2\n*MAT_ELASTIC\nx3\n");
  r.cards("MAT_ELASTIC", 2);
  r.cards("MAT_ELASTIC", 0);
  r.cards("MAT_ELASTIC", 1);
  const std::string text = r.rendered();
  EXPECT_LT(text.find("'x1'"), text.find("'x2'"));
  EXPECT_LT(text.find("'x2'"), text.find("'x3'"));
}

TEST(Diagnostic, SaysEveryMistakeOnceAndCapsRepeats) {
  std::string text = "*BOUNDARY_SPC_SET\n";
  for (int i = 0; i < 50; ++i) text += "x" + std::to_string(i) + ",,1\n";
  Reading r(text);
  r.read_all();
  r.read_all();
  EXPECT_EQ(r.errors(), 50u);
  const std::string shown = r.rendered();
  EXPECT_NE(shown.find("'x4'"), std::string::npos);
  EXPECT_EQ(shown.find("'x5'"), std::string::npos);
  EXPECT_NE(shown.find("... and 45 more of this kind"), std::string::npos) << shown;
  EXPECT_NE(shown.find("50 errors, 0 warnings"), std::string::npos);
}

TEST(Diagnostic, CountsWhatItDoesNotKeep) {
  Diagnostics d;
  for (int i = 0; i < 30000; ++i) d.error({0, i, 1, 1}, "NODE", "X", "bad " + std::to_string(i));
  EXPECT_EQ(d.count(Severity::error), 30000u);
  EXPECT_LE(d.all().size(), 20000u);
  EXPECT_TRUE(d.failed());
}

TEST(Diagnostic, OddBytesAndLongLinesAreShown) {
  Reading r("*MAT_ELASTIC\n1,\xE4\x01\xC3\xA4," + std::string(5000, '9') + "e,\n");
  r.read_all();
  const std::string text = r.rendered();
  EXPECT_NE(text.find("    2 | 1,??\xC3\xA4,999"), std::string::npos) << text;
  EXPECT_NE(text.find(" ...\n"), std::string::npos);
  EXPECT_LT(text.size(), 4000u);
}

TEST(Diagnostic, PlacesOutsideTheTextAreHarmless) {
  Reading r("*KEYWORD\n");
  r.diagnostics.error({0, 99, 5, 7}, "PART", "", "far away");
  r.diagnostics.error({7, 1, 1, 1}, "", "", "no such file");
  r.diagnostics.note({}, "", "", "nowhere", "a hint");
  const std::string text = r.rendered();
  EXPECT_NE(text.find("test.k:99:5: error: *PART: far away"), std::string::npos) << text;
  EXPECT_NE(text.find("note: nowhere\n        hint: a hint"), std::string::npos) << text;
}

}  // namespace
}  // namespace cleave::deck
