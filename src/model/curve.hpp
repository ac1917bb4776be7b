#pragma once
/// Curves and tables of the deck (*DEFINE_CURVE, *DEFINE_TABLE), scaled and offset already.

#include <string>
#include <vector>

#include "deck/diagnostic.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

class Curve {
 public:
  Id id = 0;
  std::string title;
  deck::Place place;         ///< in the deck, for messages
  std::vector<double> x, y;  ///< x ascending; equal neighbours are a jump

  /// Linear interpolation; outside the range the end value is kept.
  double value(double at) const;
  /// Linear interpolation; outside the range zero, as loads of the format expect after their last point.
  double value_or_zero(double at) const;
  /// Slope of the segment that holds `at`; 0 outside the range.
  double slope(double at) const;
  /// Integral from the first point to `at`.
  double integral(double at) const;
};

/// A family of curves over one more variable (strain rate, temperature).
struct Table {
  Id id = 0;
  std::string title;
  std::vector<double> value;  ///< ascending
  std::vector<Index> curve;   ///< index into Model::curves, same length
};

}  // namespace cleave::model
