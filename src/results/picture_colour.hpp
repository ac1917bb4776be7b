#pragma once
/// Numbers to colours, and the round numbers beside a colour bar.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cleave::results {

struct Colour {
  float red = 0, green = 0, blue = 0;  ///< 0 to 1, sRGB
};

/// The table behind colour_at, evenly spaced: the page shows the same colours.
std::span<const std::uint32_t> colour_table();

/// Colour of t in [0, 1], clamped; grey when t is not a number.
///
/// viridis: perceived lightness grows evenly, also in grey print and for the colour-blind.
/// Source: S. van der Walt and N. Smith, "A better default colormap for matplotlib" (SciPy 2015), table in
/// the public domain (CC0); here every eighth entry, linear between, off by at most 2/255.
Colour colour_at(double t);

/// What the colours or an axis stretch over.
struct Range {
  double low = 0.0, high = 1.0;

  double part(double value) const { return (value - low) / (high - low); }
};

/// Least and greatest of the finite values; widened when they are equal, 0 to 1 when there is none.
Range range_of(std::span<const float> values);

/// Round numbers (1, 2, 2.5 or 5 times a power of ten) inside a range, about `wanted` of them, ascending.
std::vector<double> round_ticks(const Range& range, int wanted);

/// A number as a reader expects it: four significant digits, a power of ten only when it is shorter.
std::string number_text(double value);

}  // namespace cleave::results
