#pragma once
/// Arithmetic in decks: `<...>` in a field and *PARAMETER_EXPRESSION, with Fortran's integer rules.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace cleave::deck {

/// An integer or a real; the kind decides how `/` and `**` work.
struct Number {
  bool is_integer = false;
  std::int64_t integer = 0;
  double real = 0.0;

  static Number of(std::int64_t value) { return {true, value, static_cast<double>(value)}; }
  static Number of(double value) { return {false, 0, value}; }
};

struct ExpressionResult {
  Number value;
  std::string error;                ///< empty: good
  std::size_t position = 0;         ///< of the error, bytes from the start
  bool truncated_division = false;  ///< two integers were divided with a remainder
};

/// Value of a name; false: unknown (the message is then set).
using NameLookup = std::function<bool(std::string_view name, Number& value, std::string& error)>;

/// Evaluates + - * / ** ( ) and sin cos tan asin acos atan atan2 sinh cosh tanh sqrt exp log log10 abs min
/// max mod int nint sign float. Names may carry `&`. Two integers divide as in Fortran, and `-a**b` is
/// `-(a**b)`. Fails on unknown names, overflow, division by zero and nesting deeper than 200.
ExpressionResult evaluate(std::string_view text, const NameLookup& lookup);

}  // namespace cleave::deck
