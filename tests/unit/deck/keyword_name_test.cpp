#include "deck/keyword_name.hpp"

#include <algorithm>

#include "deck/layout.hpp"
#include "reading.hpp"

namespace cleave::deck {
namespace {

std::string named(const std::string& written) {
  const KeywordMatch match = match_keyword(normal_name(written));
  if (match.keyword == nullptr) return "";
  std::string text = match.keyword->name;
  std::vector<std::string> options = match.options;
  std::sort(options.begin(), options.end());
  for (const std::string& option : options) text += " " + option;
  return text;
}

TEST(KeywordName, NumbersAndSynonyms) {
  EXPECT_EQ(named("*MAT_024"), "MAT_PIECEWISE_LINEAR_PLASTICITY");
  EXPECT_EQ(named("*mat_24_title"), "MAT_PIECEWISE_LINEAR_PLASTICITY TITLE");
  EXPECT_EQ(named("*MAT_3"), "MAT_PLASTIC_KINEMATIC");
  EXPECT_EQ(named("*EOS_001"), "EOS_LINEAR_POLYNOMIAL");
  EXPECT_EQ(named("*EOS_4"), "EOS_GRUNEISEN");
  EXPECT_EQ(named("*SET_NODE"), "SET_NODE_LIST");
  EXPECT_EQ(named("*SET_PART_TITLE"), "SET_PART_LIST TITLE");
  EXPECT_EQ(named("*SET_SHELL"), "SET_SHELL_LIST");
  EXPECT_EQ(named("*DEFINE_COORDINATE_NODE"), "DEFINE_COORDINATE_NODES");
  EXPECT_EQ(named("*MAT_MOONEY_RIVLIN_RUBBER"), "MAT_MOONEY-RIVLIN_RUBBER");
  EXPECT_EQ(named("*MAT_BLATZ-KO_RUBBER"), "MAT_BLATZ-KO_RUBBER");
  EXPECT_EQ(named("*CONTROL_ADAPTIVITY"), "CONTROL_ADAPTIVE");
  EXPECT_EQ(named("*CONTROL_REMESH"), "CONTROL_REMESHING");
  EXPECT_EQ(named("*CONTROL_THERMAL"), "CONTROL_THERMAL_SOLVER");
  EXPECT_EQ(named("*BOUNDARY_PRESCRIBED_MOTION"), "BOUNDARY_PRESCRIBED_MOTION_NODE");
  EXPECT_EQ(named("*MAT_3-PARAMETER_BARLAT_TITLE"), "MAT_3-PARAMETER_BARLAT TITLE");
}

TEST(KeywordName, OptionsInAnyOrderAndInTheMiddle) {
  EXPECT_EQ(named("*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_ID_BEAM_OFFSET_MPP"),
            "CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET ID MPP");
  EXPECT_EQ(named("*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID"),
            "CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET ID");
  EXPECT_EQ(named("*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_ID"), "CONTACT_AUTOMATIC_SINGLE_SURFACE ID MPP");
  EXPECT_EQ(named("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_TITLE"),
            "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE THERMAL TITLE");
  EXPECT_EQ(named("*BOUNDARY_PRESCRIBED_MOTION_SET_ID"), "BOUNDARY_PRESCRIBED_MOTION_SET ID");
  EXPECT_EQ(named("*RIGIDWALL_PLANAR_MOVING_FORCES_ID"), "RIGIDWALL_PLANAR_MOVING_FORCES ID");
  EXPECT_EQ(named("*RIGIDWALL_PLANAR_FINITE_MOVING"), "RIGIDWALL_PLANAR_FINITE_MOVING");
}

TEST(KeywordName, LongestMatchWins) {
  EXPECT_EQ(named("*DATABASE_HISTORY_NODE_ID"), "DATABASE_HISTORY_NODE_ID");
  EXPECT_EQ(named("*LOAD_SEGMENT_ID"), "LOAD_SEGMENT_ID");
  EXPECT_EQ(named("*SECTION_SOLID_EFG"), "SECTION_SOLID_EFG");
  EXPECT_EQ(named("*PARAMETER_EXPRESSION"), "PARAMETER_EXPRESSION");
}

TEST(KeywordName, EveryNameOfTheTableIsItself) {
  for (const std::string_view name : known_keywords()) EXPECT_EQ(canonical_keyword(name), name);
}

TEST(KeywordName, UnknownNamesGetTheNearest) {
  EXPECT_EQ(named("*MAT_FOO"), "");
  EXPECT_EQ(named("*ELEMENT_BEAM_SCALAR"), "");
  EXPECT_EQ(named("*ID_MAT_ELASTIC"), "");
  EXPECT_EQ(named("*MAT_ELASTIC_TITLE_TITLE"), "");
  EXPECT_EQ(named(""), "");
  EXPECT_EQ(named("*" + std::string(100000, 'A')), "");
  EXPECT_EQ(named("*CONTACT" + std::string(190, '_')), "");
  EXPECT_EQ(nearest_keyword("*MAT_ELASTICC"), "MAT_ELASTIC");
  EXPECT_EQ(nearest_keyword("*CONTROL_TERMINATON"), "CONTROL_TERMINATION");
  EXPECT_EQ(nearest_keyword("*SECTION_SOLD"), "SECTION_SOLID");
  EXPECT_EQ(nearest_keyword("*XYZZY"), "");
}

TEST(KeywordName, UnknownKeywordIsSkippedWithItsLines) {
  Reading r(
      "*KEYWORD\n*MAT_ELASTICC\n         1       1.0\n garbage , , <\n*MAT_ELASTIC\n         2       "
      "1.0\n*END\n");
  EXPECT_FALSE(r.deck.blocks()[1].known);
  EXPECT_EQ(r.deck.blocks()[1].written, "*MAT_ELASTICC");
  r.read_all();
  EXPECT_EQ(r.errors(), 0u);
  EXPECT_EQ(r.warnings(), 1u);
  EXPECT_TRUE(r.says("did you mean *MAT_ELASTIC?")) << r.rendered();
  EXPECT_EQ(r.card("MAT_ELASTIC").integer("MID"), 2);
}

}  // namespace
}  // namespace cleave::deck
