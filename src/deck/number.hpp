#pragma once
/// Numbers as Fortran writes them, and trimming of the fields they stand in.

#include <cstdint>
#include <string_view>

namespace cleave::deck {

enum class NumberState { good, malformed, out_of_range, not_whole };

/// Reads `1.`, `.5E-2`, `7.85000-6`, `1.0D-3`, `-3`: no blanks inside, every character used, correctly
/// rounded. `value` is set only if the state is good. Underflow gives 0.
NumberState parse_real(std::string_view text, double& value);

/// Reads an integer, or a real that is whole (`1.`, `0.0`, `2.0E3`).
NumberState parse_integer(std::string_view text, std::int64_t& value);

/// `text` without leading and trailing blanks and tabs.
inline std::string_view trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace cleave::deck
