#include "reading.hpp"

namespace cleave::deck {
namespace {

struct Solid {
  std::vector<std::int64_t> values;
  int fields;
};

std::vector<Solid> solids(Reading& r) {
  std::vector<Solid> list;
  r.deck.rows(r.block("ELEMENT_SOLID"), r.diagnostics, [&](const Row& row) {
    Solid s{{}, row.field_count()};
    for (int i = 0; i < s.fields; ++i) s.values.push_back(row.integer(i));
    list.push_back(s);
  });
  return list;
}

TEST(Row, SolidsMixBothFormsAndCommas) {
  Reading r(
      "*ELEMENT_SOLID\n"
      "       1       7      11      12      13      14      15      16      17      18\n"
      "       2       7\n      11      12      13      14      15      16      17      18      19      20\n"
      "$ remark\n3,7\n11,12,13,14,15,16,17,18,,\n"
      "4,7,11,12,13,14\n\n"
      "       5       7   remark\n12345678123456781234567812345678      13      14      15      16\n");
  const auto list = solids(r);
  ASSERT_EQ(list.size(), 5u) << r.rendered();
  EXPECT_EQ(list[0].values, (std::vector<std::int64_t>{1, 7, 11, 12, 13, 14, 15, 16, 17, 18}));
  EXPECT_EQ(list[1].values, (std::vector<std::int64_t>{2, 7, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20}));
  EXPECT_EQ(list[2].fields, 10);
  EXPECT_EQ(list[3].values, (std::vector<std::int64_t>{4, 7, 11, 12, 13, 14}));
  EXPECT_EQ(list[4].values[5], 12345678);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Row, CardsOfSolidsAgreeWithRows) {
  Reading r("*ELEMENT_SOLID\n1,7,1,2,3,4,5,6,7,8\n2,7\n1,2,3,4,5,6,7,8,9,10\n");
  const auto cards = r.cards("ELEMENT_SOLID");
  ASSERT_EQ(cards.size(), 2u) << r.rendered();
  EXPECT_EQ(cards[0].integer("EID"), 1);
  EXPECT_EQ(cards[0].integer("N8"), 8);
  EXPECT_EQ(cards[1].integer("EID"), 2);
  EXPECT_EQ(cards[1].integer("N10"), 10);
}

TEST(Row, ShortNodesAndTheirCodes) {
  Reading r(
      "*NODE\n       1             1.5             2.5             3.5\n       2             1.5             "
      "2.5             3.5       7       4\n"
      "3,1.5\n\n   \n");
  std::size_t count = 0;
  r.deck.rows(r.block("NODE"), r.diagnostics, [&](const Row& n) {
    if (count++ == 0) {
      EXPECT_EQ(n.field_count(), 4);
      EXPECT_FALSE(n.given(4));
      EXPECT_EQ(n.place(1).column, 9);
      EXPECT_EQ(n.place().line, 2);
    } else if (count == 2) {
      EXPECT_EQ(n.integer(4), 7);
      EXPECT_EQ(n.integer(5), 4);
    } else {
      EXPECT_EQ(n.real(2), 0.0);
      EXPECT_FALSE(n.given(3));
    }
  });
  EXPECT_EQ(count, 3u);
  EXPECT_GE(r.deck.line_count(r.block("NODE")), 3u);
}

TEST(Row, MassesAndShells) {
  Reading r(
      "*ELEMENT_MASS\n       1      11             2.5\n*ELEMENT_SHELL\n       1       7      11      12     "
      " 13      13\n");
  r.deck.rows(r.block("ELEMENT_MASS"), r.diagnostics, [](const Row& m) { EXPECT_EQ(m.real(2), 2.5); });
  r.deck.rows(r.block("ELEMENT_SHELL"), r.diagnostics, [](const Row& s) { EXPECT_EQ(s.integer(5), 13); });
}

TEST(Row, MistakesAreReportedOnceWithTheirField) {
  Reading r("*NODE\n       1            oops             2.5\n*ELEMENT_SOLID\n       1       7\n");
  r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) {
    EXPECT_EQ(n.real(1), 0.0);
    EXPECT_EQ(n.real(1), 0.0);
  });
  EXPECT_EQ(r.errors(), 1u);
  EXPECT_TRUE(r.says("NODE X found 'oops', expected a real number"));
  solids(r);
  EXPECT_TRUE(r.says("the element has no line with its nodes")) << r.rendered();
}

TEST(Row, KnowsItsTransform) {
  Reading r("*NODE\n1,0.,0.,0.\n");
  r.deck.rows(r.block("NODE"), r.diagnostics, [](const Row& n) { EXPECT_EQ(n.transform, 0); });
}

}  // namespace
}  // namespace cleave::deck
