#pragma once
/// Helpers of the deck tests: decks from text, with their diagnostics.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace cleave::deck {

struct Reading {
  Diagnostics diagnostics;
  Deck deck;

  explicit Reading(std::string_view text) : deck(Deck::read_text(text, "test.k", {}, diagnostics)) {}

  const Block& block(std::string_view keyword, std::size_t nth = 0) const {
    for (const Block& b : deck.blocks()) {
      if (b.keyword == keyword && nth-- == 0) return b;
    }
    ADD_FAILURE() << "no block " << keyword;
    return deck.blocks().front();
  }
  std::vector<Card> cards(std::string_view keyword, std::size_t nth = 0) {
    return deck.cards(block(keyword, nth), diagnostics);
  }
  Card card(std::string_view keyword, std::size_t nth = 0) { return cards(keyword, nth).at(0); }
  /// Reads every card and row, so that all that is wrong is reported.
  void read_all() {
    for (const Block& b : deck.blocks()) {
      if (b.known && !b.consumed) deck.cards(b, diagnostics);
    }
  }
  std::size_t errors() const { return diagnostics.count(Severity::error); }
  std::size_t warnings() const { return diagnostics.count(Severity::warning); }
  /// Is there a diagnostic that holds all these words in its message, hint, keyword or field?
  bool says(const std::string& words) const {
    for (const Diagnostic& d : diagnostics.all()) {
      if ((d.keyword + " " + d.field + " " + d.message + " " + d.hint).find(words) != std::string::npos)
        return true;
    }
    return false;
  }
  std::string rendered() const { return diagnostics.render(deck.sources(), false); }
};

}  // namespace cleave::deck
