#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Card, EveryRowIsADataSet) {
  Reading r(
      "*PART\nfirst, with comma\n         1         1         1\n$ between\n\n         2         1         "
      "1\n"
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         1         2         5\n         1         9       "
      "  2         5\n"
      "       1.0       2.0         7\n         1         3         2         5\n"
      "*CONSTRAINED_RIGID_BODIES\n1,2\n3,4\n5,6\n*DATABASE_HISTORY_NODE\n1,2,3\n4\n");
  const auto parts = r.cards("PART");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].text("HEADING"), "first, with comma");
  EXPECT_EQ(parts[1].text("HEADING"), "");
  EXPECT_EQ(parts[1].integer("PID"), 2);
  EXPECT_EQ(parts[1].place().line, 5);
  const auto motions = r.cards("BOUNDARY_PRESCRIBED_MOTION_SET");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_FALSE(motions[0].given("OFFSET1"));
  EXPECT_EQ(motions[1].real("OFFSET2"), 2.0);
  EXPECT_EQ(motions[1].integer("LRB"), 7);
  EXPECT_EQ(motions[2].integer("DOF"), 3);
  EXPECT_EQ(motions[2].real("SF"), 1.0) << "blank is the default";
  EXPECT_EQ(r.cards("CONSTRAINED_RIGID_BODIES").size(), 3u);
  EXPECT_EQ(r.cards("DATABASE_HISTORY_NODE").size(), 2u);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Card, IdLinesStandInFrontOfEachEntry) {
  Reading r(
      "*BOUNDARY_SPC_NODE_ID\n         1left, 5 mm\n        11         0         1\n         2right\n        "
      "12         0         1\n");
  const auto cards = r.cards("BOUNDARY_SPC_NODE");
  ASSERT_EQ(cards.size(), 2u);
  EXPECT_EQ(cards[0].text("HEADING"), "left, 5 mm");
  EXPECT_EQ(cards[1].integer("ID"), 2);
  EXPECT_EQ(cards[1].integer("NID"), 12);
}

TEST(Card, OptionLinesHaveTheirOwnOrder) {
  Reading r(
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_ID\n         7the contact\n         1       300\n&              "
      "    1       2.5\n"
      "         3         0         2\n       0.2       0.1\n\n         2\n\n         5         1\n");
  const Card c = r.card("CONTACT_AUTOMATIC_SINGLE_SURFACE");
  EXPECT_EQ(c.integer("CID"), 7);
  EXPECT_EQ(c.text("HEADING"), "the contact");
  EXPECT_EQ(c.integer("BCKT"), 300);
  EXPECT_EQ(c.integer("CHKSEGS"), 1);
  EXPECT_EQ(c.real("PENSF"), 2.5);
  EXPECT_EQ(c.integer("SURFA"), 3);
  EXPECT_EQ(c.integer("SSID"), 3) << "old and new names are the same column";
  EXPECT_EQ(c.real("FS"), 0.2);
  EXPECT_EQ(c.integer("SOFT"), 2) << "optional card A";
  EXPECT_EQ(c.row_count("PENMAX"), 1u) << "card B is blank: all defaults";
  EXPECT_EQ(c.integer("IGAP"), 5) << "card C";
  EXPECT_EQ(c.integer("IGNORE"), 1);
  EXPECT_EQ(c.integer("MPP_IGNORE"), 1);
  EXPECT_EQ(c.row_count("Q2TRI"), 0u) << "card D is not there";
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Card, ConditionalLines) {
  Reading none("*SECTION_SOLID\n         1         1\n         2         2\n");
  EXPECT_EQ(none.cards("SECTION_SOLID").size(), 2u);
  Reading user(
      "*SECTION_SOLID\n         1       101\n         2         0         0         0         3\n       0.1  "
      "     0.2       0.3       1.0\n"
      "       0.4       0.5       0.6       2.0\n       7.0       8.0       9.0\n         2         1\n");
  const auto cards = user.cards("SECTION_SOLID");
  ASSERT_EQ(cards.size(), 2u) << user.rendered();
  EXPECT_EQ(cards[0].row_count("XI"), 2u);
  EXPECT_EQ(cards[0].real("WGT", 1), 2.0);
  EXPECT_EQ(cards[0].reals("PI").size(), 3u);
  EXPECT_EQ(cards[0].reals("PI")[2], 9.0);
  EXPECT_EQ(cards[1].integer("SECID"), 2);
  Reading damping(
      "*DAMPING_PART_MASS\n         1         2       1.0         1\n        .1        .2\n         2        "
      " 2\n");
  ASSERT_EQ(damping.cards("DAMPING_PART_MASS").size(), 2u);
  EXPECT_EQ(damping.cards("DAMPING_PART_MASS")[0].real("STY"), 0.2);
}

TEST(Card, CountedSeriesKeepTheirPositions) {
  Reading r(
      "*SECTION_SHELL\n         1         2       1.0        10         0         0         1\n       1.0\n  "
      "      45                  30\n"
      "                10\n         2         2\n       2.0\n");
  const auto cards = r.cards("SECTION_SHELL");
  ASSERT_EQ(cards.size(), 2u) << r.rendered();
  const auto angles = cards[0].reals("ANGLE");
  ASSERT_EQ(angles.size(), 10u);
  EXPECT_EQ(angles[0], 45.0);
  EXPECT_EQ(angles[1], 0.0);
  EXPECT_EQ(angles[2], 30.0);
  EXPECT_EQ(angles[9], 10.0);
  EXPECT_EQ(cards[1].real("T1"), 2.0);
}

TEST(Card, GroupsOfLines) {
  Reading r(
      "*DEFINE_TRANSFORMATION\n         1\nTRANSL           1.0       2.0       "
      "3.0\nMATRIX\n1,0,0,0,0,1,0,0\n0,0,1,0,0,0,0,1\nSCALE,2,2,2\n");
  const Card t = r.card("DEFINE_TRANSFORMATION");
  ASSERT_EQ(t.row_count("OPTION"), 3u) << r.rendered();
  EXPECT_EQ(t.text("OPTION", 2), "SCALE");
  EXPECT_EQ(t.real("A1", 0), 1.0);
  EXPECT_EQ(t.real("A3", 2), 2.0);
  EXPECT_EQ(t.row_count("M11"), 1u);
  EXPECT_EQ(t.real("M33"), 1.0);

  Reading s(
      "*INITIAL_STRESS_SHELL\n         7         1         2         3\n       -1.        1.        2.\n     "
      "  11.       12.       13.\n"
      "        1.        3.        4.\n       21.       22.       23.\n         8         1         1\n      "
      "  0.        5.\n");
  const auto cards = s.cards("INITIAL_STRESS_SHELL");
  ASSERT_EQ(cards.size(), 2u) << s.rendered();
  EXPECT_EQ(cards[0].row_count("T"), 2u);
  EXPECT_EQ(cards[0].real("SIGYY", 1), 4.0);
  EXPECT_EQ(cards[0].reals("HISV").size(), 6u);
  EXPECT_EQ(cards[0].reals("HISV")[4], 22.0);
  EXPECT_EQ(cards[1].real("SIGXX"), 5.0);
}

TEST(Card, BlankAndZeroAreToldApart) {
  Reading r("*RIGIDWALL_PLANAR\n1,,,0.0,0.0,,0.0\n\n");
  const Card c = r.card("RIGIDWALL_PLANAR");
  EXPECT_TRUE(c.given("BIRTH"));
  EXPECT_FALSE(c.given("DEATH"));
  EXPECT_EQ(c.real("DEATH"), 1e20);
  EXPECT_TRUE(c.given("RWKSF"));
  EXPECT_EQ(c.real("RWKSF"), 0.0);
  EXPECT_EQ(c.row_count("XT"), 1u) << "an empty line is a card full of defaults";
  EXPECT_EQ(c.given_fields(), (std::vector<std::string>{"NSID", "OFFSET", "BIRTH", "RWKSF"}));
}

TEST(Card, SurplusLinesAreReported) {
  Reading r(
      "*MAT_BLATZ-KO_RUBBER\n         1      1e-9       1.0\n         2      1e-9       1.0\n\n  "
      "\n*DEFINE_CURVE\n1\n0,0\n1,1\n");
  r.read_all();
  EXPECT_EQ(r.warnings(), 1u) << r.rendered();
  EXPECT_TRUE(r.says("this line is not read: the keyword has no more cards"));
}

TEST(Card, MissingLinesTakeTheirDefaultsWithAWarning) {
  Reading r("*MAT_JOHNSON_COOK\n         1      8e-9      1e4\n*CONTROL_TIMESTEP\n,.8\n*CONTROL_ENERGY\n");
  const Card c = r.card("MAT_JOHNSON_COOK");
  EXPECT_EQ(c.row_count("A"), 0u);
  EXPECT_FALSE(c.given("A"));
  EXPECT_TRUE(r.says("3 lines are missing, from the one that begins with A")) << r.rendered();
  EXPECT_EQ(r.card("CONTROL_TIMESTEP").real("TSSFAC"), 0.8);
  EXPECT_EQ(r.card("CONTROL_ENERGY").integer("HGEN"), 1);
  EXPECT_EQ(r.warnings(), 2u) << "optional lines may be missing: " << r.rendered();
}

TEST(Card, BlankLinesBehindTheLastSetAreWhiteSpace) {
  Reading r("*BOUNDARY_SPC_SET\n1,,1\n2,,1\n\n   \n$\n\n*PART\ntitle\n1,1,1\n       \n\n");
  EXPECT_EQ(r.cards("BOUNDARY_SPC_SET").size(), 2u);
  EXPECT_EQ(r.cards("PART").size(), 1u);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Card, TextKeywords) {
  Reading r(
      "*TITLE\n  the title, with & and <  \n*COMMENT\nany text, *\n$ no remark\n  & < "
      "undefined\n*DEFINE_CURVE_FUNCTION\n1\nsin(2.*time)\n +1.\n*END\nafter\n*MAT_ELASTIC\n");
  EXPECT_EQ(r.deck.title(), "the title, with & and <");
  const Card function = r.card("DEFINE_CURVE_FUNCTION");
  ASSERT_EQ(function.row_count("FUNCTION"), 2u);
  EXPECT_EQ(function.text("FUNCTION", 0), "sin(2.*time)");
  EXPECT_EQ(r.deck.blocks().size(), 4u);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Card, PlacesPointAtFields) {
  Reading r("*MAT_ELASTIC\n         1       2.0\n*MAT_ELASTIC\n1, 2.5 ,3\n");
  const Place fixed = r.card("MAT_ELASTIC").place("RO");
  EXPECT_EQ(fixed.line, 2);
  EXPECT_EQ(fixed.column, 11);
  EXPECT_EQ(fixed.width, 10);
  const Place comma = r.card("MAT_ELASTIC", 1).place("RO");
  EXPECT_EQ(comma.line, 4);
  EXPECT_EQ(comma.column, 4);
  EXPECT_EQ(comma.width, 3);
  EXPECT_EQ(r.card("MAT_ELASTIC").place("EFUNC").line, 1) << "a line that is not there: the keyword";
}

TEST(Card, LinesInFrontOfTheFirstKeywordAreReported) {
  Reading r("\n$ fine\n  \nstray\nmore\n*KEYWORD\n");
  EXPECT_EQ(r.warnings(), 1u);
  EXPECT_TRUE(r.says("2 lines stand in front of the first keyword")) << r.rendered();
}

}  // namespace
}  // namespace cleave::deck
