#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Parameter, EverySpellingOfADefinition) {
  const std::string definitions =
      "*PARAMETER\nR tend           2.0\nRendtim, 1\nrterm, 0.2, istaTES, 80\nr E          12.3\nR    valid  "
      "10.0\nRscale        3.5\ncpaR1, foo\n";
  const auto value = [&](const std::string& name) {
    Reading r(definitions + "*CONTROL_CPU\n&" + name + "\n");
    const double v = r.card("CONTROL_CPU").real("CPUTIM");
    EXPECT_EQ(r.errors(), 0u) << r.rendered();
    return v;
  };
  EXPECT_EQ(value("TEND"), 2.0);
  EXPECT_EQ(value("endtim"), 1.0);
  EXPECT_EQ(value("term"), 0.2);
  EXPECT_EQ(value("states"), 80.0);
  EXPECT_EQ(value("e"), 12.3);
  EXPECT_EQ(value("VALID"), 10.0);
  EXPECT_EQ(value("scale"), 3.5);
}

TEST(Parameter, FourPairsInFixedColumns) {
  Reading r(
      "*PARAMETER\nRa               1.5Rb               2.5Ic                 3Rd               "
      "4.5\n*MAT_ELASTIC\n&c,&a,&b,-&d\n");
  const Card card = r.card("MAT_ELASTIC");
  EXPECT_EQ(card.integer("MID"), 3);
  EXPECT_EQ(card.real("RO"), 1.5);
  EXPECT_EQ(card.real("E"), 2.5);
  EXPECT_EQ(card.real("PR"), -4.5);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Parameter, ValuesAreSubstitutedNotTexts) {
  Reading r("*PARAMETER\nRdensity, 7.8500001234567890\n*MAT_ELASTIC\n         1&density        1.\n");
  EXPECT_EQ(r.card("MAT_ELASTIC").real("RO"), 7.8500001234567890);
}

TEST(Parameter, WholeRealsServeAsIds) {
  Reading r(
      "*PARAMETER\nRssid         1234.0\nRbad          1234.5\n*SECTION_SOLID\n     &ssid         "
      "1\n*SECTION_SOLID\n      &bad         1\n");
  EXPECT_EQ(r.card("SECTION_SOLID").integer("SECID"), 1234);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
  r.card("SECTION_SOLID", 1);
  EXPECT_TRUE(r.says("SECID found '&bad', expected a parameter with a whole value")) << r.rendered();
}

TEST(Parameter, TextParameters) {
  Reading r("*PARAMETER\nCsolver, MECH\n*SET_NODE_LIST\n1,,,,,&solver\n1\n*MAT_ELASTIC\n1,&solver\n");
  EXPECT_EQ(r.card("SET_NODE_LIST").text("SOLVER"), "MECH");
  r.read_all();
  EXPECT_TRUE(r.says("parameter 'solver' is text, a number was expected")) << r.rendered();
}

TEST(Parameter, ExpressionsOverSeveralLines) {
  Reading r(
      "*PARAMETER\nrterm, 0.2, istaTES, 80\n*parameter_expression\nrPlot, tErm/(States-30)\nR long    "
      "(1.0+2.0\n          +3.0) * 2\nIhalf     7.9/2\n"
      "*MAT_ELASTIC\n&half,&plot,&LONG\n");
  const Card card = r.card("MAT_ELASTIC");
  EXPECT_EQ(card.integer("MID"), 3);
  EXPECT_DOUBLE_EQ(card.real("RO"), 0.2 / 50.0);
  EXPECT_EQ(card.real("E"), 12.0);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Parameter, UndefinedNamesSayWhere) {
  Reading r("*PARAMETER\nRheight, 2.\n*MAT_ELASTIC\n         1   &heigth\n");
  r.read_all();
  ASSERT_EQ(r.errors(), 1u);
  EXPECT_EQ(r.diagnostics.all()[0].place.line, 4);
  EXPECT_EQ(r.diagnostics.all()[0].place.column, 11);
  EXPECT_EQ(r.diagnostics.all()[0].field, "RO");
  EXPECT_TRUE(r.says("did you mean &height?")) << r.rendered();
  Reading later("*MAT_ELASTIC\n         1        &x\n*PARAMETER\nRx, 2.\n");
  later.read_all();
  EXPECT_TRUE(later.says("it is defined in test.k:4, but behind this line")) << later.rendered();
}

TEST(Parameter, LaterDefinitionWinsWithAWarning) {
  Reading r("*PARAMETER\nRx, 1.\n*CONTROL_CPU\n&x\n*PARAMETER\nRX, 2.\n*CONTROL_CPU\n&x\n");
  EXPECT_EQ(r.card("CONTROL_CPU", 0).real("CPUTIM"), 1.0);
  EXPECT_EQ(r.card("CONTROL_CPU", 1).real("CPUTIM"), 2.0);
  EXPECT_EQ(r.warnings(), 1u);
  EXPECT_TRUE(r.says("case does not matter")) << r.rendered();
}

TEST(Parameter, DuplicationRules) {
  const auto value = [](const std::string& flag, std::size_t errors, std::size_t warnings) {
    Reading r("*PARAMETER_DUPLICATION\n" + flag + "\n*PARAMETER\nRx, 1.\nRx, 2.\n*CONTROL_CPU\n&x\n");
    const double v = r.card("CONTROL_CPU").real("CPUTIM");
    EXPECT_EQ(r.errors(), errors) << flag << r.rendered();
    EXPECT_EQ(r.warnings(), warnings) << flag << r.rendered();
    return v;
  };
  EXPECT_EQ(value("         1", 0, 1), 1.0);
  EXPECT_EQ(value("         2", 0, 1), 2.0);
  EXPECT_EQ(value("         3", 1, 0), 1.0);
  EXPECT_EQ(value("         4", 0, 0), 2.0);
  EXPECT_EQ(value("         5", 0, 0), 1.0);
  EXPECT_EQ(value("         9", 1, 1), 2.0);
}

TEST(Parameter, MistakesInDefinitions) {
  Reading r(
      "*PARAMETER\ntend, 1.\nR, 2.\nR a b, 3.\nRx\nRy, abc\n*PARAMETER_EXPRESSION\nRz        1+\nRw        "
      "nope*2\n");
  EXPECT_EQ(r.errors(), 7u) << r.rendered();
  EXPECT_TRUE(r.says("found 'tend', expected R, I or C and the name of a parameter"));
  EXPECT_TRUE(r.says("the parameter has no value"));
  EXPECT_TRUE(r.says("PARAMETER_EXPRESSION z"));
}

TEST(Parameter, PlaceOfAMissingValueIsTheEndOfItsLine) {
  Reading r("*PARAMETER\nRx, 1., Ry\n");
  ASSERT_EQ(r.errors(), 1u);
  EXPECT_EQ(r.diagnostics.all()[0].place.line, 2);
  EXPECT_EQ(r.diagnostics.all()[0].place.column, 11);
}

TEST(Parameter, LongFormat) {
  Reading r(
      "*KEYWORD LONG=Y\n*PARAMETER\nRx                                   2.5Ry                               "
      "    3.5\n*CONTROL_CPU\n                  &y\n");
  EXPECT_EQ(r.card("CONTROL_CPU").real("CPUTIM"), 3.5) << r.rendered();
}

TEST(Parameter, ReferencesInRows) {
  Reading r(
      "*PARAMETER\nRx, 1.25\nIid, 9\n*NODE\n     &id              &x             -&x           <2*x>\n");
  r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) {
    EXPECT_EQ(n.integer(0), 9);
    EXPECT_EQ(n.real(1), 1.25);
    EXPECT_EQ(n.real(2), -1.25);
    EXPECT_EQ(n.real(3), 2.5);
  });
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

}  // namespace
}  // namespace cleave::deck
