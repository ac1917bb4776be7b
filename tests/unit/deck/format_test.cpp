#include "reading.hpp"

namespace cleave::deck {
namespace {

const std::string elastic = "         1  7.83E-6     207.0       0.3\n";

void expect_elastic(const std::string& text) {
  Reading r(text);
  const Card card = r.card("MAT_ELASTIC");
  EXPECT_EQ(card.integer("MID"), 1) << text;
  EXPECT_EQ(card.real("RO"), 7.83e-6) << text;
  EXPECT_EQ(card.real("E"), 207.0) << text;
  EXPECT_EQ(card.real("PR"), 0.3) << text;
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Format, FixedColumns) {
  expect_elastic("*MAT_ELASTIC\n" + elastic);
}

TEST(Format, AdjustmentIsFree) {
  expect_elastic("*MAT_ELASTIC\n1         7.83E-6      207.0   .3        \n");
}

TEST(Format, CommasLineByLine) {
  expect_elastic("*MAT_ELASTIC\n1,7.83E-6,207.,.3\n");
  expect_elastic("*MAT_ELASTIC\n 1 , 7.83E-6 , 207. , .3 ,\n");
  Reading r("*BOUNDARY_SPC_SET\n1,,1\n         2         0         0         1\n3,,,,1\n");
  const auto cards = r.cards("BOUNDARY_SPC_SET");
  ASSERT_EQ(cards.size(), 3u);
  EXPECT_EQ(cards[0].integer("DOFX"), 1);
  EXPECT_FALSE(cards[0].given("CID"));
  EXPECT_EQ(cards[1].integer("DOFY"), 1);
  EXPECT_EQ(cards[2].integer("DOFZ"), 1);
}

TEST(Format, TouchingNumbers) {
  Reading r("*NODE\n     12353.535533905932723.5355339059327             0.0\n");
  r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) {
    EXPECT_EQ(n.integer(0), 123);
    EXPECT_EQ(n.real(1), 53.5355339059327);
    EXPECT_EQ(n.real(2), 23.5355339059327);
  });
  Reading v("*DEFINE_VECTOR\n         1-6.0000000 6.0000000-6.0000000  2500.000-2.000e+05         7\n");
  const Card card = v.card("DEFINE_VECTOR");
  EXPECT_EQ(card.real("XT"), -6.0);
  EXPECT_EQ(card.real("ZT"), -6.0);
  EXPECT_EQ(card.real("XH"), 2500.0);
  EXPECT_EQ(card.real("YH"), -2e5);
  EXPECT_EQ(v.errors(), 0u) << v.rendered();
  Reading g("*SET_NODE_GENERAL\n         2ALL       ALL\nALL\n");
  EXPECT_EQ(g.card("SET_NODE_GENERAL").integer("SID"), 2);
}

TEST(Format, LongColumns) {
  const std::string wide =
      "                   1             7.83E-6               207.0                 0.3\n";
  expect_elastic("*KEYWORD LONG=Y\n*MAT_ELASTIC\n" + wide);
  expect_elastic("*KEYWORD long=k\n*MAT_ELASTIC\n" + wide);
  expect_elastic("*MAT_ELASTIC+\n" + wide);
  expect_elastic("*MAT_ELASTIC +\n" + wide);
  expect_elastic("*KEYWORD LONG=S\n*MAT_ELASTIC\n" + elastic);
  expect_elastic("*KEYWORD LONG=Y\n*MAT_ELASTIC-\n" + elastic);
  expect_elastic("*KEYWORD LONG=Y\n*MAT_ELASTIC\n1,7.83E-6,207.,.3\n");
  Reading r(
      "*KEYWORD LONG=Y\n*NODE\n                  12                 1.5                 2.5                 "
      "3.5\n");
  r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) {
    EXPECT_EQ(n.integer(0), 12);
    EXPECT_EQ(n.real(3), 3.5);
  });
  const std::string title(150, 't');
  Reading t("*KEYWORD LONG=Y\n*MAT_ELASTIC_TITLE\n" + title + "\n" + wide);
  EXPECT_EQ(t.card("MAT_ELASTIC").text("TITLE"), title);
  Reading h("*KEYWORD LONG=Y\n*BOUNDARY_SPC_SET_ID\n                   4a heading\n                   7\n");
  EXPECT_EQ(h.card("BOUNDARY_SPC_SET").text("HEADING"), "a heading");
  EXPECT_EQ(h.card("BOUNDARY_SPC_SET").integer("NSID"), 7);
}

TEST(Format, TenColumns) {
  const std::string node = "1234567890             1.5             2.5             3.5\n";
  for (const char* head : {"*KEYWORD I10=Y\n*NODE\n", "*NODE %\n", "*NODE%\n"}) {
    Reading r(head + node);
    r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) {
      EXPECT_EQ(n.integer(0), 1234567890);
      EXPECT_EQ(n.real(1), 1.5);
      EXPECT_EQ(n.real(3), 3.5);
    });
    EXPECT_EQ(r.errors(), 0u);
  }
  Reading s("*ELEMENT_SHELL%\n1234567890         2        11        12        13        14\n");
  s.deck.rows(s.block("ELEMENT_SHELL"), s.diagnostics, [](const Row& e) { EXPECT_EQ(e.integer(5), 14); });
}

TEST(Format, LineEndsAndMarks) {
  expect_elastic("*MAT_ELASTIC\r\n" + elastic.substr(0, elastic.size() - 1) + "\r\n");
  expect_elastic("*MAT_ELASTIC\r$ remark\r" + elastic.substr(0, elastic.size() - 1) + "\r*END");
  expect_elastic("*KEYWORD\r*MAT_ELASTIC\n" + elastic.substr(0, elastic.size() - 1) + "\r\n*END");
  expect_elastic("\xEF\xBB\xBF*KEYWORD\n*MAT_ELASTIC\n" + elastic);
  expect_elastic("*MAT_ELASTIC\n" + elastic.substr(0, elastic.size() - 1));
  expect_elastic("*keyword\n*Mat_Elastic\n" + elastic);
  expect_elastic("*MAT_ELASTIC      carte de mat\n$ one\n$ two\n" + elastic + "$ three\n");
}

TEST(Format, BytesOfTitlesStay) {
  const std::string title = "St\xE4hl \xE6\x9C\x80 & <x>, $ \"q\"";
  Reading r("*TITLE\n" + title + "\n*MAT_ELASTIC_TITLE\n" + title + "\n" + elastic);
  EXPECT_EQ(r.deck.title(), title);
  EXPECT_EQ(r.card("MAT_ELASTIC").text("TITLE"), title);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Format, TabsAreBlanksAndAWarning) {
  Reading r("*NODE\n       1\t1.5\t\t2.5\n*MAT_ELASTIC\n1\t  7.83E-6     207.0       0.3\n");
  std::vector<double> seen;
  r.deck.rows(r.block("NODE"), r.diagnostics, [&](const Row& n) { seen = {n.real(1), n.real(2)}; });
  EXPECT_EQ(seen, (std::vector<double>{1.5, 2.5})) << "tabs go to columns 16, 24 and 32";
  EXPECT_EQ(r.card("MAT_ELASTIC").real("RO"), 7.83e-6);
  EXPECT_TRUE(r.says("the line has tabs"));
}

TEST(Format, TextBehindTheColumnsIsARemark) {
  Reading r(
      "*DEFINE_CURVE\n         1\n                 0.0                 5.0   time, then force\n              "
      "   1.0                 6.0\n");
  EXPECT_EQ(r.card("DEFINE_CURVE").real("O1", 0), 5.0);
  EXPECT_EQ(r.card("DEFINE_CURVE").real("O1", 1), 6.0);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Format, LongCommaRowsHoldMoreValues) {
  Reading r("*SET_NODE_LIST\n1\n1,2,3,4,5,6,7,8,9,10,11\n12,13\n*DEFINE_CURVE\n1\n0,0,1,10,2,20\n3,30\n");
  EXPECT_EQ(r.card("SET_NODE_LIST").integers("NODES").size(), 13u);
  const Card curve = r.card("DEFINE_CURVE");
  ASSERT_EQ(curve.row_count("A1"), 4u);
  EXPECT_EQ(curve.real("O1", 2), 20.0);
  EXPECT_EQ(curve.real("A1", 3), 3.0);
}

TEST(Format, ShiftedColumnsAreReadAtBlanksWithAWarning) {
  Reading r(
      "*BOUNDARY_SPC_NODE\n       1       0       1       1       1       0       0       "
      "0\n*CONTROL_TERMINATION\n     1.0E-3\n");
  const Card card = r.card("BOUNDARY_SPC_NODE");
  EXPECT_EQ(card.integer("NID"), 1);
  EXPECT_EQ(card.integer("DOFZ"), 1);
  EXPECT_EQ(card.integer("DOFRZ"), 0);
  EXPECT_EQ(r.card("CONTROL_TERMINATION").real("ENDTIM"), 1e-3);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
  EXPECT_EQ(r.warnings(), 2u);
  // A number that its column would cut in two is the worst: it would be read as another number.
  Reading small("*CONTROL_TERMINATION\n     1.00E-13\n*DEFINE_VECTOR\n         1     123.456       2.0\n");
  EXPECT_EQ(small.card("CONTROL_TERMINATION").real("ENDTIM"), 1e-13);
  EXPECT_EQ(small.card("DEFINE_VECTOR").real("XT"), 123.456);
  EXPECT_EQ(small.card("DEFINE_VECTOR").real("YT"), 2.0);
  EXPECT_EQ(small.warnings(), 2u) << small.rendered();
  // Not if a value is missing somewhere: which one could not be told.
  Reading gap("*BOUNDARY_SPC_NODE\n       1               1       1       1\n");
  gap.read_all();
  EXPECT_GT(gap.errors(), 0u);
}

}  // namespace
}  // namespace cleave::deck
