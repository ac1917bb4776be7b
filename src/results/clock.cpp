#include "results/clock.hpp"

#include <cmath>

#include "model/load.hpp"

namespace cleave::results {
namespace {
/// Time is a sum of steps: an instant is reached when less than this part of the interval is missing, so that
/// a step which divides the interval does not slip by one cycle through rounding.
constexpr double slack = 1.0e-6;
}  // namespace

Clock::Clock(const model::Interval& interval, const std::vector<model::Curve>& curves)
    : every_(interval.every),
      curve_(interval.curve >= 0 ? &curves[static_cast<std::size_t>(interval.curve)] : nullptr) {}

double Clock::interval_at(double time) const {
  const double interval = curve_ ? curve_->value(time) : every_;
  return interval > 0.0 ? interval : model::forever;
}

bool Clock::due(double time) const {
  if (!curve_ && every_ <= 0.0) return false;
  return time >= next_ - slack * interval_at(time);
}

void Clock::advance(double time) {
  const double interval = interval_at(time);
  if (curve_) {
    next_ += interval;
    if (next_ < time) next_ = time;  // the curve asks for more than one output per cycle
    return;
  }
  // A multiple of the interval, not a running sum: no drift, and a restart needs no count.
  const double count = std::floor(time / interval + slack) + 1.0;
  next_ = count * interval;
}

}  // namespace cleave::results
