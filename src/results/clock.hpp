#pragma once
/// When the next output of one kind is due.

#include <vector>

#include "model/curve.hpp"
#include "model/request.hpp"

namespace cleave::results {

/// Instants of one kind of output: multiples of an interval, or steps of an interval that a curve gives over
/// time. What is due is written at the first cycle that reaches the instant; instants between two cycles are
/// written once.
class Clock {
 public:
  Clock() = default;  ///< never due
  Clock(const model::Interval& interval, const std::vector<model::Curve>& curves);

  bool due(double time) const;
  /// Moves to the first instant after `time`.
  void advance(double time);

  double next() const { return next_; }
  void set_next(double next) { next_ = next; }  ///< after a restart

 private:
  double interval_at(double time) const;

  double every_ = 0.0;
  const model::Curve* curve_ = nullptr;
  double next_ = 0.0;
};

}  // namespace cleave::results
