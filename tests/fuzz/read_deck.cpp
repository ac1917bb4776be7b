/// Any bytes as a deck: every card, every row, every message. Nothing may crash, hang or grow without bound.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "deck/deck.hpp"

namespace {

using namespace cleave::deck;

/// Rows can be streamed from keywords that hold one line an entity.
bool has_rows(const Block& block) {
  constexpr const char* bulk[] = {"NODE", "ELEMENT_SOLID", "ELEMENT_SHELL", "ELEMENT_MASS", "ELEMENT_SPH"};
  return block.known && block.options.empty() &&
         std::find(std::begin(bulk), std::end(bulk), block.keyword) != std::end(bulk);
}

/// Asks a card everything a model asks it.
std::size_t read(const Card& card) {
  std::size_t sum = card.given_fields().size();
  for (const std::string& field : card.given_fields()) {
    for (std::size_t row = 0; row < std::min<std::size_t>(card.row_count(field), 3); ++row) {
      sum += static_cast<std::size_t>(card.integer(field, row)) + card.text(field, row).size();
      sum += card.real(field, row) > 0.0 ? 1 : 0;
      sum += static_cast<std::size_t>(card.place(field, row).line);
    }
    sum += card.integers(field).size() + card.reals(field).size();
  }
  return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Diagnostics diagnostics;
  ReadOptions options;
  options.follow_includes = false;  // other files are not part of the input
  const Deck deck = Deck::read_text(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.k",
                                    options, diagnostics);
  std::size_t sum = deck.title().size();
  for (const Block& block : deck.blocks()) {
    for (const Card& card : deck.cards(block, diagnostics)) sum += read(card);
    if (!has_rows(block)) continue;
    deck.rows(block, diagnostics, [&](const Row& row) {
      for (int f = 0; f <= row.field_count(); ++f) {
        sum +=
            static_cast<std::size_t>(row.integer(f)) + (row.real(f) > 0.0 ? 1 : 0) + (row.given(f) ? 1 : 0);
        sum += static_cast<std::size_t>(row.place(f).column);
      }
    });
  }
  // Every message points into its line or to columns that a line may have.
  for (const Diagnostic& d : diagnostics.all()) {
    const std::size_t reach = 8 * deck.sources().line(d.place.file, d.place.line).size() + 400;
    if (d.place.column < 0 || d.place.width < 0 || static_cast<std::size_t>(d.place.column) > reach)
      __builtin_trap();
  }
  const std::string text = diagnostics.render(deck.sources(), (sum & 1) != 0);
  return text.size() > (std::size_t{1} << 40) ? 1 : 0;
}
