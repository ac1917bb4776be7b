#pragma once
/// The generated card table in its regular form (cmake/card_table.py writes it from data/cards.json).

#include <cstdint>
#include <span>
#include <string_view>

namespace cleave::deck::table {

/// Postfix codes of conditions and counts.
enum class Code : std::uint8_t {
  number,     ///< push a constant
  field,      ///< push the latest value of a field of this keyword
  same_text,  ///< push 1 if a text field holds this word
  add,
  subtract,
  multiply,
  divide,
  negate,
  absolute,
  equal,
  differ,
  less,
  less_equal,
  greater,
  greater_equal,
  both,
  either,
  invert,
  choose,       ///< condition, value if true, value otherwise
  line_fields,  ///< push the number of values on the line to come
  line_starts,  ///< push 1 if the line to come begins with this word
  rows          ///< push how often a field was read in this set
};

struct Op {
  Code code;
  double number;
  std::uint16_t argument;  ///< field, counted from the first of the keyword
  const char* word;
};

struct Field {
  const char* name;                 ///< alternatives separated by '/'
  std::uint16_t offset, width;      ///< standard format
  std::uint16_t comma;              ///< position in a comma line; times 20 the column in the long format
  std::uint16_t offset10, width10;  ///< I10 format
  std::uint16_t long_width;
  char type;  ///< I, F or A
  bool has_default;
  double number;
  const char* text;
  const char* meaning;
};

enum class Kind : std::uint8_t { line, series, text, group };

struct Item {
  Kind kind;
  std::uint16_t first_field, field_count;    ///< counted from the first of the keyword
  std::uint16_t when_first, when_count;      ///< condition; no code: always
  std::uint16_t repeat_first, repeat_count;  ///< how often, or how many values; no code: once
  std::uint16_t per_line, width;             ///< of a series
  std::uint16_t children;                    ///< of a group: entries that follow
  bool to_end;                               ///< repeats up to the next keyword
  bool optional;                             ///< may be left out at the end without a word
  bool wrap;                                 ///< a comma line may hold several rows
};

struct Option {
  const char* suffix;  ///< alternatives separated by '|'; empty for a positional trailing line
  const char* letter;  ///< of a positional trailing line, else empty
  bool before;
  std::uint16_t first_item, item_count;
};

struct Keyword {
  const char* name;
  std::uint16_t first_item, item_count, first_option, option_count, first_field, field_count;
  bool repeat_set;
  const char* note;
  const char* slides;
};

struct Alias {
  const char* name;
  std::uint16_t keyword;
};

std::span<const Keyword> keywords();  ///< sorted by name
std::span<const Alias> aliases();     ///< sorted by name
const Op* code(std::uint16_t first);
const Item* item(std::uint16_t index);
const Option* option(std::uint16_t index);
/// Field by its number within the keyword.
const Field& field(const Keyword& keyword, std::size_t index);
/// The keyword of exactly this canonical name; nullptr if there is none.
const Keyword* find(std::string_view canonical);

/// Is `word` one of the alternatives in `list`, separated by `separator`?
bool among(std::string_view list, std::string_view word, char separator);
/// The first alternative of a field name: what messages show.
std::string_view first_name(const char* name);

}  // namespace cleave::deck::table
