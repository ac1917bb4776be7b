#pragma once
/// The scalar equation of radial return where it has no closed form:
///   q = stiffness x + flow_stress(x),  x > 0 the increment of effective plastic strain,
/// q the trial stress beyond which the point flows. Newton's method in u = ln x: there the smooth hardening
/// and rate laws used here are convex, so that iterates started above the root fall monotonically to it; a
/// bracket catches curves that are not. A lane that has converged rests, so that its result does not depend
/// on the others.

#include <algorithm>
#include <cmath>

#include "model/material/plasticity.hpp"

namespace cleave::model {

/// What the rate of flow does to a static flow stress h: factor h + addition; slopes are d/du.
template <class Real>
struct RateTerm {
  Real factor, factor_slope, addition, addition_slope;
};

/// No rate law besides the hardening, which may itself depend on the increment's rate.
struct NoRate {
  template <class Real>
  RateTerm<Real> term(const Real&) const {
    return {Real(1.0), Real(0.0), Real(0.0), Real(0.0)};
  }
  template <class Real>
  Real bound(const Real&, const Real&) const {
    return Real(1e300);
  }
};

/// Cowper and Symonds: a factor 1 + (x / (C dt))^(1/P), or, with a stress S, the addition S (x / (C
/// dt))^(1/P).
class CowperSymondsFlow {
 public:
  CowperSymondsFlow(const CowperSymonds& law, double dt, double stress = 0.0)
      : log_reference_(std::log(std::max(law.reference * dt, 1e-250))),
        exponent_(law.exponent),
        stress_(stress) {}

  template <class Real>
  RateTerm<Real> term(const Real& u) const {
    const Real over = exp((u - Real(log_reference_)) * Real(1.0 / exponent_));
    const Real slope = over * Real(1.0 / exponent_);
    if (stress_ > 0.0) return {Real(1.0), Real(0.0), Real(stress_) * over, Real(stress_) * slope};
    return {Real(1.0) + over, slope, Real(0.0), Real(0.0)};
  }
  /// ln x at which the rate alone takes the static stress `start` up to q.
  template <class Real>
  Real bound(const Real& q, const Real& start) const {
    const Real over = stress_ > 0.0 ? (q - start) * Real(1.0 / stress_) : q / positive(start) - Real(1.0);
    return Real(log_reference_) + Real(exponent_) * log(positive(over));
  }

 private:
  double log_reference_, exponent_, stress_;
};

/// Static flow stress that is linear in the increment: radius + slope x.
template <class Real>
struct LinearHardening {
  Real radius;         ///< at the begin of the step [stress]
  double slope_value;  ///< [stress]

  Real start() const { return radius; }
  Real value(const Real& x) const { return radius + Real(slope_value) * x; }
  Real slope(const Real&) const { return Real(slope_value); }
  /// An increment at which the flow stress reaches q, or more.
  Real bound(const Real&) const { return Real(1e300); }
};

/// Newton's method has arrived when a step changes its unknown by less than this part: the next one would
/// change it by the square.
inline constexpr double last_change = 1e-8;

/// Increment of effective plastic strain; 0 where q is not beyond the static flow stress. Relative accuracy
/// near roundoff; smooth laws take 3 to 8 iterations, kinks of a curve may throw an iterate back to the
/// bracket.
template <class Real, class Hardening, class RateLaw>
Real viscoplastic_flow(const Real& q, double stiffness, const Hardening& hardening, const RateLaw& rate) {
  constexpr int most_iterations = 40;
  const Real start = hardening.start(), excess = q - start;
  const auto flows = excess > Real(0.0);
  if (!any(flows)) return Real(0.0);

  // Three increments of which each alone would take up the excess: the root lies below the least.
  Real u = log(positive(min(excess * Real(1.0 / stiffness), hardening.bound(q))));
  u = min(u, rate.bound(q, start));
  Real high = u, low = u - Real(60.0);
  auto moving = flows;
  for (int i = 0; i < most_iterations && any(moving); ++i) {
    const Real x = exp(u), h = hardening.value(x);
    const auto r = rate.term(u);
    const Real residual = q - Real(stiffness) * x - h * r.factor - r.addition;
    const Real slope =
        (Real(stiffness) + hardening.slope(x) * r.factor) * x + h * r.factor_slope + r.addition_slope;
    const auto above = residual <= Real(0.0);
    high = select(above, u, high);
    low = select(above, low, u);
    Real next = u + residual / positive(slope);
    const Real margin(1e-9);
    const auto outside = (next < low - margin) | (next > high + margin);
    next = select(outside, Real(0.5) * (low + high), next);
    const auto moved = abs(next - u) > Real(last_change);
    u = select(moving, next, u);
    moving = moving & moved;
  }
  return select(flows, exp(u), Real(0.0));
}

}  // namespace cleave::model
