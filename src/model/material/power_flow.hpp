#pragma once
/// Radial return with hardening by a power of the plastic strain: Johnson-Cook, Ludwik, Hollomon, Swift.

#include "model/material/flow.hpp"

namespace cleave::model {

/// Static flow stress a + b e^n, e = plastic strain plus a constant [stress].
struct PowerHardening {
  double a = 0.0, b = 0.0, n = 1.0;

  /// The same curve with an exponent that is safe to invert: b e^0 is a constant.
  static PowerHardening from(double a, double b, double n) {
    if (b == 0.0) return {.a = a};
    if (n == 0.0) return {.a = a + b};
    return {.a = a, .b = b, .n = n};
  }
};

/// Increment x >= 0 of plastic strain with q = stiffness x + factor (a + b (e + x)^n).
/// @param e strain at the begin of the step, as in the hardening law; @param factor of rate and temperature.
/// Newton's method, in e^n for n < 1 and in e for n > 1: concave in either, so iterates started above the
/// root fall to it; a lane that has converged rests. Accurate to a few roundoffs of q / stiffness for 0.05 <
/// n < 20.
template <class Real>
Real power_flow(const Real& q, double stiffness, const Real& factor, const Real& e, const PowerHardening& h) {
  constexpr int most_iterations = 12;
  const Real n(h.n), inverse(1.0 / h.n);
  const Real excess = q - factor * (Real(h.a) + Real(h.b) * pow(e, n));
  const auto flows = excess > Real(0.0);
  if (!any(flows)) return Real(0.0);

  // z = e^n or e; two bounds from above: all of the excess elastic, or all of it hardening.
  const bool root = h.n < 1.0;
  const Real reach = e + max(excess, Real(0.0)) * Real(1.0 / stiffness);
  const Real power_bound = (q / positive(factor) - Real(h.a)) * Real(1.0 / std::max(h.b, 1e-300));
  Real z = root ? min(pow(reach, n), power_bound) : min(reach, pow(positive(power_bound), inverse));
  z = positive(z);
  const Real hardening = factor * Real(h.b);
  auto moving = flows;
  for (int i = 0; i < most_iterations && any(moving); ++i) {
    const Real other = pow(z, root ? inverse : n), over_z = Real(1.0) / z;
    const Real strain = root ? other : z, power = root ? z : other;
    const Real residual = q - Real(stiffness) * (strain - e) - factor * Real(h.a) - hardening * power;
    const Real slope = root ? Real(stiffness) * inverse * strain * over_z + hardening
                            : Real(stiffness) + hardening * n * power * over_z;
    const Real next = positive(z + residual / slope);
    const auto moved = abs(next - z) > Real(last_change) * z;
    z = select(moving, next, z);
    moving = moving & moved;
  }
  const Real power = root ? z : pow(z, n);
  const Real flow = (q - factor * Real(h.a) - hardening * power) * Real(1.0 / stiffness);
  return select(flows, max(flow, Real(0.0)), Real(0.0));
}

/// The same curve as the hardening of viscoplastic_flow, times `factor`.
template <class Real>
struct PowerFlowStress {
  PowerHardening law;
  Real factor, strain;  ///< strain at the begin of the step
  double cap = 1e300;   ///< largest static stress

  Real start() const { return value(Real(0.0)); }
  Real value(const Real& x) const {
    return factor * min(Real(law.a) + Real(law.b) * pow(strain + x, Real(law.n)), Real(cap));
  }
  Real slope(const Real& x) const {
    const Real e = positive(strain + x), power = Real(law.b) * pow(e, Real(law.n));
    return select(Real(law.a) + power < Real(cap), factor * Real(law.n) * power / e, Real(0.0));
  }
  Real bound(const Real& q) const {
    const Real power = (q / positive(factor) - Real(law.a)) * Real(1.0 / std::max(law.b, 1e-300));
    const Real reached = pow(positive(power), Real(1.0 / law.n)) - strain;
    return select(Real(law.a) + power < Real(cap), positive(reached), Real(1e300));
  }
};

/// 1 + C ln(rate / reference), 1 below the reference rate: Johnson and Cook's rate term.
struct JohnsonCookRate {
  double constant = 0.0, reference = 1.0;  ///< C [-], EPSO [1/time]

  template <class Real>
  Real factor(const Real& rate) const {
    return Real(1.0) + Real(constant) * log(max(rate * Real(1.0 / reference), Real(1.0)));
  }
};

/// The same as a rate law of viscoplastic_flow.
class JohnsonCookFlow {
 public:
  JohnsonCookFlow(const JohnsonCookRate& law, double dt)
      : log_reference_(std::log(std::max(law.reference * dt, 1e-250))), constant_(law.constant) {}

  template <class Real>
  RateTerm<Real> term(const Real& u) const {
    const Real over = u - Real(log_reference_);
    return {Real(1.0) + Real(constant_) * max(over, Real(0.0)),
            select(over > Real(0.0), Real(constant_), Real(0.0)), Real(0.0), Real(0.0)};
  }
  template <class Real>
  Real bound(const Real& q, const Real& start) const {
    const Real over = q / positive(start) - Real(1.0);
    return Real(log_reference_) + over * Real(1.0 / std::max(constant_, 1e-12));
  }

 private:
  double log_reference_, constant_;
};

}  // namespace cleave::model
