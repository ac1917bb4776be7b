#pragma once
/// Histories of prescribed motions and loads, as functions of time.

#include <memory>

#include "model/model.hpp"

namespace cleave::discretisation::spacetime {

/// A curve of the model with factor and delay. It keeps a copy of the curve, so it may outlive the model.
class History {
 public:
  enum class Kind {
    value,    ///< of a load or a velocity: zero outside the curve
    rate,     ///< of a displacement: the slope, zero outside the curve
    integral  ///< of an acceleration: from time 0 on
  };
  History(const model::Curve& curve, double scale, double delay, Kind kind)
      : curve_(std::make_shared<const model::Curve>(curve)), scale_(scale), delay_(delay), kind_(kind) {
    if (kind == Kind::integral) start_ = curve_->integral(0.0);
  }

  double operator()(double time) const {
    if (time < delay_) return 0.0;
    const double at = time - delay_;
    if (kind_ == Kind::rate) return scale_ * curve_->slope(at);
    if (kind_ == Kind::integral) return scale_ * (curve_->integral(at) - start_);
    return scale_ * curve_->value_or_zero(at);
  }

 private:
  std::shared_ptr<const model::Curve> curve_;
  double scale_, delay_, start_ = 0.0;
  Kind kind_;
};

}  // namespace cleave::discretisation::spacetime
