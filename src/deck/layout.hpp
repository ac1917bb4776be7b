#pragma once
/// The card table: every keyword known, its lines and fields. Generated from data/cards.json.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::deck {

struct FieldLayout {
  std::string_view name;
  int offset = 0, width = 0;  ///< columns, from 0, in the standard format
  char type = 'F';            ///< I, F or A
  bool has_default = false;
  double default_value = 0.0;     ///< for I and F
  std::string_view default_text;  ///< for A
  std::string_view meaning;
};

/// Does the table know this keyword (number form, synonyms and options allowed)? Canonical name, or empty.
std::string_view canonical_keyword(std::string_view written);
/// Does the reader itself use up this keyword (*KEYWORD, *INCLUDE, *PARAMETER, *TITLE, ...)?
bool steers_reading(std::string_view canonical);
/// The known keywords, sorted.
std::span<const std::string_view> known_keywords();
/// Nearest known keyword by edit distance, or empty when nothing is near.
std::string_view nearest_keyword(std::string_view written);
/// All fields of a keyword in card order.
std::vector<FieldLayout> fields_of(std::string_view canonical);
/// The layout in words: lines, columns, types, defaults, meanings, options. For `cleave explain`.
std::string describe(std::string_view canonical);

}  // namespace cleave::deck
