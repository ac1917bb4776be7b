#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Deck, ReadsAMaterialByFieldName) {
  Reading r(
      "*KEYWORD\n*MAT_003_TITLE\nsteel, mild\n         1  7.83E-6     207.0       0.3       0.2\n*END\n");
  const Card card = r.card("MAT_PLASTIC_KINEMATIC");
  EXPECT_EQ(card.integer("MID"), 1);
  EXPECT_EQ(card.real("RO"), 7.83e-6);
  EXPECT_EQ(card["E"], 207.0);
  EXPECT_EQ(card.text("TITLE"), "steel, mild");
  EXPECT_TRUE(card.option("TITLE"));
  EXPECT_FALSE(card.given("ETAN"));
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Deck, StreamsSolidsInBothForms) {
  Reading r(
      "*ELEMENT_SOLID\n       1       7       1       2       3       4       5       6       7       8\n    "
      "   2       7\n"
      "      11      12      13      14      15      16      17      18      19      "
      "20\n3,7,1,2,3,4,5,6,7,8\n");
  std::vector<std::int64_t> last;
  r.deck.rows(r.block("ELEMENT_SOLID"), r.diagnostics,
              [&](const Row& row) { last.push_back(row.integer(row.field_count() - 1)); });
  EXPECT_EQ(last, (std::vector<std::int64_t>{8, 20, 8}));
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

}  // namespace
}  // namespace cleave::deck
