/// Twenty traps of real decks, as far as they concern reading.
#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Trap, T01EmptyPartTitle) {
  Reading r("*PART\n\n         1         2         3\n*PART\n$ remark\n \n         4         5         6\n");
  EXPECT_EQ(r.card("PART").integer("MID"), 3);
  EXPECT_EQ(r.card("PART", 1).integer("PID"), 4);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Trap, T02TitlesThatLookLikeData) {
  for (const std::string title :
       {"1, 2, 3", "         1       2.0", "&undefined <1+>", "a.b $ \"c\"", "'quoted', & more", "100%"}) {
    Reading r("*PART\n" + title + "\n         1         2         3\n*SECTION_SOLID_TITLE\n" + title +
              "\n         1         2\n");
    EXPECT_EQ(r.card("PART").integer("SECID"), 2) << title;
    EXPECT_EQ(r.card("SECTION_SOLID").text("TITLE"), title.substr(title.find_first_not_of(' ')));
    EXPECT_EQ(r.card("SECTION_SOLID").integer("ELFORM"), 2);
    EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
  }
}

TEST(Trap, T03BlankThickness) {
  Reading r("*SECTION_SHELL\n         1         2\n\n         2         2\n       1.5\n");
  const auto cards = r.cards("SECTION_SHELL");
  ASSERT_EQ(cards.size(), 2u);
  EXPECT_FALSE(cards[0].given("T1"));
  EXPECT_EQ(cards[0].row_count("T1"), 1u);
  EXPECT_EQ(cards[1].real("T1"), 1.5);
}

TEST(Trap, T04CurveLinesLeftOut) {
  const std::string head =
      "*MAT_024\n         1      8e-9     2.1e5       0.3     250.0\n                            12\n";
  Reading without(head);
  EXPECT_EQ(without.card("MAT_PIECEWISE_LINEAR_PLASTICITY").integer("LCSS"), 12);
  EXPECT_EQ(without.card("MAT_PIECEWISE_LINEAR_PLASTICITY").row_count("EPS1"), 0u);
  EXPECT_EQ(without.errors() + without.warnings(), 0u) << without.rendered();
  Reading zero(head + "       0.0       0.0\n       0.0       0.0\n");
  EXPECT_TRUE(zero.card("MAT_PIECEWISE_LINEAR_PLASTICITY").given("ES2"));
  EXPECT_EQ(zero.card("MAT_PIECEWISE_LINEAR_PLASTICITY").real("ES2"), 0.0);
}

TEST(Trap, T05ErosionCutShort) {
  Reading r("*MAT_ADD_EROSION\n         1\n       0.0       0.0       0.0       0.2\n");
  EXPECT_EQ(r.card("MAT_ADD_EROSION").real("MXEPS"), 0.2);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
  Reading first("*MAT_ADD_EROSION\n         1                           0.1\n");
  EXPECT_EQ(first.cards("MAT_ADD_EROSION").size(), 1u);
  EXPECT_EQ(first.errors(), 0u);
}

TEST(Trap, T06BlankFormulationAndMaterial) {
  Reading r("*SECTION_SOLID\n         1\n*PART\nx\n         1         1         0\n");
  EXPECT_FALSE(r.card("SECTION_SOLID").given("ELFORM"));
  EXPECT_TRUE(r.card("PART").given("MID"));
  EXPECT_EQ(r.card("PART").integer("MID"), 0);
}

TEST(Trap, T07SeveralMotions) {
  Reading r(
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n         1        -4         2         5       1.0         3\n       "
      "  2         3         2         5\n");
  const auto cards = r.cards("BOUNDARY_PRESCRIBED_MOTION_SET");
  ASSERT_EQ(cards.size(), 2u);
  EXPECT_EQ(cards[0].integer("DOF"), -4);
  EXPECT_EQ(cards[1].real("DEATH"), 1e28) << "the documented default";
}

TEST(Trap, T08InitialVelocityWithExemptNodes) {
  Reading r(
      "*INITIAL_VELOCITY\n         0         7\n       0.0       0.0   -1000.0\n       1.0       2.0       "
      "3.0\n         4\n       5.0\n");
  const auto cards = r.cards("INITIAL_VELOCITY");
  ASSERT_EQ(cards.size(), 2u);
  EXPECT_EQ(cards[0].real("VZ"), -1000.0);
  EXPECT_EQ(cards[0].real("VYE"), 2.0);
  EXPECT_EQ(cards[1].real("VX"), 5.0);
  EXPECT_EQ(cards[1].row_count("VXE"), 0u);
}

TEST(Trap, T09TriangularSegments) {
  Reading r(
      "*LOAD_SEGMENT\n         1       1.0       0.0        11        12        13        13\n         1     "
      "  1.0       0.0        11        12        13\n"
      "*SET_SEGMENT\n         1\n        11        12        13         0\n        11        12        13    "
      "    13\n");
  EXPECT_EQ(r.cards("LOAD_SEGMENT").size(), 2u);
  EXPECT_EQ(r.cards("LOAD_SEGMENT")[1].integer("N4"), 0);
  EXPECT_EQ(r.card("SET_SEGMENT").row_count("N1"), 2u);
  EXPECT_EQ(r.card("SET_SEGMENT").integer("N4", 1), 13);
}

TEST(Trap, T10TriangularShells) {
  Reading r(
      "*ELEMENT_SHELL\n       1       1      11      12      13      13       0       0       0       0\n    "
      "   2       1      11      12      13\n");
  std::vector<std::int64_t> last;
  r.deck.rows(r.block("ELEMENT_SHELL"), r.diagnostics, [&](const Row& s) { last.push_back(s.integer(5)); });
  EXPECT_EQ(last, (std::vector<std::int64_t>{13, 0}));
}

TEST(Trap, T11T12ContactsOfTheWholeModel) {
  Reading r(
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n       0.1\n       0.0       "
      "0.0\n");
  const Card c = r.card("CONTACT_AUTOMATIC_SINGLE_SURFACE");
  EXPECT_TRUE(c.given("SURFA"));
  EXPECT_EQ(c.integer("SURFATYP"), 5);
  EXPECT_TRUE(c.given("SFSA")) << "zero is given; it means 1, which is for the contact to know";
}

TEST(Trap, T13CurvesWithRemarksAndBlanks) {
  Reading r(
      "*DEFINE_CURVE\n         1         0       0.0       2.0\n                 0.0                 1.0\n$ "
      "remark\n\n                 1.0                 2.0\n\n");
  const Card c = r.card("DEFINE_CURVE");
  EXPECT_EQ(c.row_count("A1"), 2u);
  EXPECT_EQ(c.real("SFA"), 0.0);
  EXPECT_EQ(c.real("SFO"), 2.0);
  EXPECT_EQ(c.place("O1", 1).line, 6);
}

TEST(Trap, T14TimestepWithOneValue) {
  Reading r("*CONTROL_TIMESTEP\n,.8\n*CONTROL_TIMESTEP\n         0         0         0         0    -1e-6\n");
  EXPECT_FALSE(r.card("CONTROL_TIMESTEP").given("DTINIT"));
  EXPECT_EQ(r.card("CONTROL_TIMESTEP").real("TSSFAC"), 0.8);
  EXPECT_EQ(r.card("CONTROL_TIMESTEP", 1).real("DT2MS"), -1e-6);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Trap, T15HourglassIds) {
  Reading r(
      "*HOURGLASS\n         7         5      0.05\n         8         4\n*CONTROL_HOURGLASS\n         6      "
      " 0.1\n");
  EXPECT_EQ(r.cards("HOURGLASS").size(), 2u);
  EXPECT_EQ(r.cards("HOURGLASS")[0].real("QM"), 0.05);
  EXPECT_EQ(r.card("CONTROL_HOURGLASS").integer("IHQ"), 6);
}

TEST(Trap, T16DatabasesAndUnusedLines) {
  Reading r(
      "*DATABASE_GLSTAT\n       0.0\n*DATABASE_BINARY_D3PLOT\n     0.001\n         0\n         1\n         "
      "2\n");
  EXPECT_TRUE(r.card("DATABASE_GLSTAT").given("DT"));
  EXPECT_EQ(r.card("DATABASE_BINARY_D3PLOT").real("DT"), 1e-3);
  EXPECT_EQ(r.errors(), 0u);
  EXPECT_TRUE(r.says("from here on 2 lines are not read")) << r.rendered();
}

TEST(Trap, T17NodesBeforeKeywordAndAgain) {
  Reading r(
      "*NODE\n       1             0.0             0.0             1.0\n*KEYWORD\n*NODE\n       1            "
      " 0.0             0.0             1.0\n");
  std::size_t count = 0;
  for (std::size_t i = 0; i < 2; ++i)
    r.deck.rows(r.block("NODE", i), r.diagnostics, [&](const Row&) { ++count; });
  EXPECT_EQ(count, 2u) << "whether they agree is for the model to say";
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Trap, T18SetsKeepTheirKinds) {
  Reading r(
      "*SET_NODE_LIST\n1\n1,2\n*SET_PART_LIST\n1\n3\n*SET_SHELL_LIST\n1\n4\n*SET_SOLID\n1\n5,6,7\n*SET_"
      "SEGMENT\n1\n1,2,3,4\n");
  EXPECT_EQ(r.card("SET_NODE_LIST").integers("NODES").size(), 2u);
  EXPECT_EQ(r.card("SET_PART_LIST").integers("PARTS")[0], 3);
  EXPECT_EQ(r.card("SET_SHELL_LIST").integers("SHELLS")[0], 4);
  EXPECT_EQ(r.card("SET_SOLID").integers("SOLIDS").size(), 3u);
  EXPECT_EQ(r.card("SET_SEGMENT").integer("N4"), 4);
}

TEST(Trap, T19RigidwallLinesDependOnTheSuffix) {
  const std::string base =
      "         1\n       0.0       0.0       0.0       0.0       0.0       1.0       0.3\n";
  Reading r("*RIGIDWALL_PLANAR\n" + base + base + "*RIGIDWALL_PLANAR_FINITE_MOVING\n" + base +
            "       1.0       0.0       0.0      10.0      20.0\n     500.0      "
            "-3.0\n*RIGIDWALL_PLANAR_MOVING_ID\n         7the wall\n" +
            base + "     500.0      -3.0\n");
  EXPECT_EQ(r.cards("RIGIDWALL_PLANAR").size(), 2u);
  EXPECT_EQ(r.card("RIGIDWALL_PLANAR").real("ZH"), 1.0);
  EXPECT_EQ(r.card("RIGIDWALL_PLANAR_FINITE_MOVING").real("LENM"), 20.0);
  EXPECT_EQ(r.card("RIGIDWALL_PLANAR_FINITE_MOVING").real("V0"), -3.0);
  EXPECT_EQ(r.card("RIGIDWALL_PLANAR_MOVING").real("MASS"), 500.0);
  EXPECT_EQ(r.card("RIGIDWALL_PLANAR_MOVING").integer("ID"), 7);
  EXPECT_EQ(r.errors() + r.warnings(), 0u) << r.rendered();
}

TEST(Trap, T20BlankIsNotZero) {
  Reading r(
      "*MAT_ELASTIC_PERI\n         1      8e-9     2.1e5\n*MAT_ELASTIC_PERI\n         1      8e-9     2.1e5  "
      "     0.0\n");
  EXPECT_FALSE(r.card("MAT_ELASTIC_PERI").given("GT"));
  EXPECT_TRUE(r.card("MAT_ELASTIC_PERI", 1).given("GT"));
}

}  // namespace
}  // namespace cleave::deck
