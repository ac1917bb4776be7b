#pragma once
/// The scalar equation of radial return where it has no closed form:
///   q = stiffness x + flow_stress(x),  x > 0 the increment of effective plastic strain,
/// q the trial stress beyond which the point flows. Newton's method in u = ln x: there every hardening and
/// rate law used here is convex, so that iterates started above the root fall monotonically to it; a bracket
/// catches curves that are not. The number of iterations is fixed: no lane waits for another.

#include <algorithm>
#include <cmath>

#include "model/material/plasticity.hpp"

namespace cleave::model {

/// Static flow stress that is linear in the increment: radius + slope x. `slope` may vary from point to
/// point.
template <class Real, class Slope = double>
struct LinearHardening {
  Real radius;  ///< at the begin of the step [stress]
  Slope slope_value;

  Real start() const { return radius; }
  Real value(const Real& x) const { return radius + Real(slope_value) * x; }
  Real slope(const Real&) const { return Real(slope_value); }
  /// An increment at which the flow stress reaches q, or more.
  Real bound(const Real&) const { return Real(1e300); }
};

/// 1 + (x / (C dt))^(1/P), a factor on the static flow stress.
class CowperSymondsFlow {
 public:
  CowperSymondsFlow(const CowperSymonds& law, double dt)
      : log_reference_(std::log(std::max(law.reference * dt, 1e-250))), exponent_(law.exponent) {}

  template <class Real>
  Real overstress(const Real& u) const {
    return exp((u - Real(log_reference_)) * Real(1.0 / exponent_));
  }
  template <class Real>
  Real factor(const Real& u) const {
    return Real(1.0) + overstress(u);
  }
  /// d factor / du.
  template <class Real>
  Real slope(const Real& u) const {
    return overstress(u) * Real(1.0 / exponent_);
  }
  /// ln x at which the factor alone takes up the ratio q / static stress.
  template <class Real>
  Real bound(const Real& ratio) const {
    return Real(log_reference_) + Real(exponent_) * log(positive(ratio - Real(1.0)));
  }

 private:
  double log_reference_, exponent_;
};

/// Increment of effective plastic strain for a flow stress hardening(x) * rate(x); 0 where q is not beyond
/// the static one. Relative accuracy near roundoff.
template <class Real, class Hardening, class RateLaw>
Real viscoplastic_flow(const Real& q, double stiffness, const Hardening& hardening, const RateLaw& rate) {
  constexpr int iteration_count = 10;
  const Real start = hardening.start(), excess = q - start;
  const auto flows = excess > Real(0.0);
  if (!any(flows)) return Real(0.0);

  // Three increments of which each alone would take up the excess: the root lies below the least.
  Real u = log(positive(min(excess * Real(1.0 / stiffness), hardening.bound(q))));
  u = min(u, rate.bound(q / positive(start)));
  Real high = u, low = u - Real(60.0);
  for (int i = 0; i < iteration_count; ++i) {
    const Real x = exp(u), h = hardening.value(x), r = rate.factor(u);
    const Real residual = q - Real(stiffness) * x - h * r;
    const Real slope = -((Real(stiffness) + hardening.slope(x) * r) * x + h * rate.slope(u));
    const auto above = residual <= Real(0.0);
    high = select(above, u, high);
    low = select(above, low, u);
    const Real next = u - residual / min(slope, Real(-1e-300));
    const Real margin(1e-9);
    const auto outside = (next < low - margin) | (next > high + margin);
    u = select(outside, Real(0.5) * (low + high), next);
  }
  return select(flows, exp(u), Real(0.0));
}

}  // namespace cleave::model
