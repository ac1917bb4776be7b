#include "model/curve.hpp"

#include <algorithm>

namespace cleave::model {
namespace {

/// The last point i with x[i] <= at, for x[0] <= at < x.back(); at a jump the later point counts.
std::size_t segment_of(const std::vector<double>& x, double at) {
  return static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()) - 1;
}

}  // namespace

double Curve::value(double at) const {
  if (x.empty()) return 0.0;
  if (at < x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const std::size_t i = segment_of(x, at);
  return y[i] + (y[i + 1] - y[i]) * ((at - x[i]) / (x[i + 1] - x[i]));
}

double Curve::value_or_zero(double at) const {
  if (x.empty() || at < x.front() || at > x.back()) return 0.0;
  return value(at);
}

double Curve::slope(double at) const {
  if (x.empty() || at < x.front() || at >= x.back()) return 0.0;
  const std::size_t i = segment_of(x, at);
  return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

double Curve::integral(double at) const {
  if (x.empty()) return 0.0;
  // Outside the range the curve keeps its end values, as value() does.
  if (at <= x.front()) return (at - x.front()) * y.front();
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < x.size() && x[i] < at; ++i) {
    const double end = std::min(at, x[i + 1]), width = end - x[i];
    if (width <= 0.0) continue;  // a jump
    const double y_end = y[i] + (y[i + 1] - y[i]) * (width / (x[i + 1] - x[i]));
    sum += 0.5 * (y[i] + y_end) * width;
  }
  if (at > x.back()) sum += (at - x.back()) * y.back();
  return sum;
}

}  // namespace cleave::model
