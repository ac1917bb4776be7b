#pragma once
/// Builds models from deck text for the tests of this folder.

#include <string>

#include "deck/deck.hpp"
#include "model/model.hpp"

namespace cleave::model {

struct Built {
  deck::Diagnostics diagnostics;
  Account account;
  Model model;

  bool failed() const { return diagnostics.failed(); }
  /// All messages as one text, for failed assertions and for looking up a phrase.
  std::string text() const {
    std::string all;
    for (const auto& d : diagnostics.all())
      all += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.keyword + " " +
             d.field + ": " + d.message + " | " + d.hint + "\n";
    return all;
  }
  /// Is there a message of this severity at this line whose text holds the phrase?
  bool says(deck::Severity severity, int line, std::string_view phrase) const {
    for (const auto& d : diagnostics.all())
      if (d.severity == severity && d.place.line == line && d.message.find(phrase) != std::string::npos)
        return true;
    return false;
  }
};

inline Built build_text(const std::string& text, BuildOptions options = {}) {
  Built built;
  const deck::Deck deck = deck::Deck::read_text(text, "test.k", {}, built.diagnostics);
  built.model = build(deck, options, built.diagnostics, built.account);
  return built;
}

/// One elastic unit cube, nodes 1-8, part 1, end time 1; ends without *END so that text can follow.
inline const std::string cube =
    "*KEYWORD\n"
    "*CONTROL_TERMINATION\n1.0\n"
    "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
    "*SECTION_SOLID\n1,1\n"
    "*PART\ncube\n1,1,1\n"
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
    "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";
/// Line number of the first line after `cube`.
inline const int after_cube = 22;

}  // namespace cleave::model
