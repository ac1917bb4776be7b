/// Every card of the sample decks, written and read again, says the same.
#include <cstring>
#include <filesystem>

#include "deck/layout.hpp"
#include "deck/write.hpp"
#include "reading.hpp"

namespace cleave::deck {
namespace {

namespace fs = std::filesystem;

char type_of(const Card& card, const std::string& field) {
  for (const FieldLayout& f : fields_of(card.keyword())) {
    if (f.name == field) return f.type;
  }
  return '?';
}

/// A writer with everything that was given in a card.
CardWriter writer_of(const Card& card, const std::vector<std::string>& options) {
  CardWriter writer(card.keyword(), options);
  for (const std::string& field : card.given_fields()) {
    if (!card.integers(field).empty()) {
      writer.series(field, card.integers(field));
    } else if (!card.reals(field).empty()) {
      writer.series(field, card.reals(field));
    } else {
      for (std::size_t row = 0; row < card.row_count(field); ++row) {
        if (!card.given(field, row)) continue;
        const char type = type_of(card, field);
        if (type == 'I') writer.set(field, card.integer(field, row), row);
        if (type == 'F') writer.set(field, card.real(field, row), row);
        if (type == 'A') writer.set(field, card.text(field, row), row);
      }
    }
  }
  return writer;
}

void expect_same(const Card& a, const Card& b, const std::string& text) {
  ASSERT_EQ(a.given_fields(), b.given_fields()) << text;
  for (const std::string& field : a.given_fields()) {
    ASSERT_EQ(std::vector<std::int64_t>(a.integers(field).begin(), a.integers(field).end()),
              std::vector<std::int64_t>(b.integers(field).begin(), b.integers(field).end()))
        << field << "\n"
        << text;
    ASSERT_EQ(std::vector<double>(a.reals(field).begin(), a.reals(field).end()),
              std::vector<double>(b.reals(field).begin(), b.reals(field).end()))
        << field << "\n"
        << text;
    for (std::size_t row = 0; row < a.row_count(field); ++row) {
      ASSERT_EQ(a.given(field, row), b.given(field, row)) << field << " " << row << "\n" << text;
      const double x = a.real(field, row), y = b.real(field, row);
      ASSERT_EQ(std::memcmp(&x, &y, sizeof x), 0) << field << " " << x << " " << y << "\n" << text;
      ASSERT_EQ(a.integer(field, row), b.integer(field, row)) << field << "\n" << text;
      ASSERT_EQ(a.text(field, row), b.text(field, row)) << field << "\n" << text;
    }
  }
}

TEST(RoundTrip, CardsOfTheSampleDecks) {
  std::size_t count = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(CLEAVE_SOURCE_DIR) / "tests/regression/decks")) {
    const fs::path& path = entry.path();
    if (path.extension() != ".k" && path.extension() != ".dyn" && path.extension() != ".key") continue;
    Diagnostics diagnostics;
    const Deck deck = Deck::read(path, {}, diagnostics);
    for (const Block& block : deck.blocks()) {
      if (!block.known || block.consumed || block.keyword == "NODE" || block.keyword.starts_with("ELEMENT_S"))
        continue;
      const std::vector<Card> cards = deck.cards(block, diagnostics);
      // All data sets under one keyword, as a model writes them.
      std::string text;
      for (std::size_t i = 0; i < cards.size(); ++i)
        writer_of(cards[i], block.options).append_to(text, i == 0);
      Diagnostics again;
      const Deck written = Deck::read_text(text, path.string(), {}, again);
      if (cards.empty()) continue;
      const std::vector<Card> back = written.cards(written.blocks().at(0), again);
      ASSERT_EQ(back.size(), cards.size()) << path << "\n" << text << again.render(written.sources(), false);
      for (std::size_t i = 0; i < cards.size(); ++i) {
        expect_same(cards[i], back[i], path.string() + "\n" + text);
        if (HasFatalFailure()) return;
        ++count;
      }
      EXPECT_EQ(again.count(Severity::error), 0u) << again.render(written.sources(), false);
    }
  }
  EXPECT_GT(count, 400u);
}

}  // namespace
}  // namespace cleave::deck
