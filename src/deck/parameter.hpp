#pragma once
/// *PARAMETER and its forms: definitions, scopes and the values that stand behind &name.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "deck/deck.hpp"
#include "deck/expression.hpp"

namespace cleave::deck {

struct Parameter {
  std::string name;         ///< as written
  char type = 'R';          ///< R, I or C
  Number number;            ///< of R and I
  std::string text;         ///< of C
  std::uint32_t epoch = 0;  ///< definitions made before this one
  Place place;
};

/// All parameters of a deck. Definitions are numbered in reading order; a block sees those made before it.
class Parameters {
 public:
  /// What a second definition of a name does: the DFLAG of *PARAMETER_DUPLICATION, 0 for our own rule.
  enum class Duplicate { later_with_warning, first_with_warning, error, later, first };
  Duplicate duplicate = Duplicate::later_with_warning;

  /// Adds a definition; `local_file` is -1 for a global one. Reports second definitions.
  void define(Parameter parameter, int local_file, Diagnostics& diagnostics);
  /// The value of a name for a block in `file`: the nearest enclosing local one, else the global one.
  const Parameter* find(std::string_view name, int file, std::uint32_t epoch, const Sources& sources) const;
  /// The definition whose name is nearest to an unknown one; the same name if it is only not known there.
  const Parameter* nearest(std::string_view name) const;
  std::uint32_t epoch() const { return static_cast<std::uint32_t>(all_.size()); }

 private:
  std::deque<Parameter> all_;
  /// Key: lower-case name, '\n', number of the file for local ones. Values in order of their epochs.
  std::unordered_map<std::string, std::vector<const Parameter*>> by_name_;
  static std::string key(std::string_view name, int file);
};

/// Where a value is read: enough to resolve names and to say where a mistake is.
struct ValueContext {
  const Parameters* parameters = nullptr;
  const Sources* sources = nullptr;
  Diagnostics* diagnostics = nullptr;
  std::string_view keyword;
  int file = -1;
  std::uint32_t epoch = 0;
};

/// Does the field hold &name, -&name or <expression> in place of a value?
inline bool is_reference(std::string_view text) {
  return !text.empty() && (text[0] == '&' || text[0] == '<' ||
                           (text.size() > 1 && (text[0] == '-' || text[0] == '+') && text[1] == '&'));
}

/// Values of a trimmed, non-empty field. False: a mistake was reported and `value` is unchanged.
bool read_value(std::string_view text, const ValueContext& context, std::string_view field, Place place,
                double& value);
bool read_value(std::string_view text, const ValueContext& context, std::string_view field, Place place,
                std::int64_t& value);
/// Value of an expression in `<...>`, its kind kept.
bool read_expression(std::string_view text, const ValueContext& context, std::string_view field, Place place,
                     Number& value);
/// Text of a character parameter; a number is given back as written in the deck.
/// nullptr: a mistake was reported.
const std::string* read_text_reference(std::string_view text, const ValueContext& context,
                                       std::string_view field, Place place);

}  // namespace cleave::deck
