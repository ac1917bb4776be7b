#pragma once
/// Evaluates the postfix conditions and counts of the card table.

#include <functional>
#include <string_view>

#include "deck/layout_table.hpp"

namespace cleave::deck {

/// What a condition can ask: the reader answers from the lines read, the writer from the values set.
class ConditionValues {
 public:
  virtual ~ConditionValues() = default;
  virtual double number(std::size_t field) const = 0;  ///< latest value or default
  virtual std::string_view text(std::size_t field) const = 0;
  virtual std::size_t rows(std::size_t field) const = 0;
  virtual std::size_t next_line_values() const = 0;
  virtual bool next_line_starts(std::string_view word) const = 0;
};

double evaluate(const table::Op* code, std::size_t count, const ConditionValues& values);

/// Is the line there? An empty condition holds.
inline bool holds(const table::Item& item, const ConditionValues& values) {
  return item.when_count == 0 || evaluate(table::code(item.when_first), item.when_count, values) != 0.0;
}

/// How often a line or group is there, or how many values a series has; never negative.
std::size_t repeats(const table::Item& item, const ConditionValues& values);

}  // namespace cleave::deck
