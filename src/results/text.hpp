#pragma once
/// Numbers as text: shortest round-trip form for machines, fixed columns for the established layouts.

#include <cstdint>
#include <string>
#include <string_view>

namespace cleave::results {

/// Appends the shortest text that reads back to the same double ("0.1", "1e-07", "nan", "inf").
void append_shortest(std::string& out, double value);

/// Appends like printf. ASCII histories only; numbers that machines read go through append_shortest.
[[gnu::format(printf, 2, 3)]] void append_format(std::string& out, const char* format, ...);

/// A value for a fixed column: magnitudes below 1e-99 become 0, so that the exponent keeps two digits and
/// neighbouring columns do not touch.
double column(double value);

/// "1h 02m", "3m 05s", "4.2 s".
std::string duration(double seconds);

/// "5184", "1.25 million": counts and rates for people.
std::string count_text(double value);

/// Today as MM/DD/YYYY, as the headers of the established layouts have it.
std::string today();

}  // namespace cleave::results
