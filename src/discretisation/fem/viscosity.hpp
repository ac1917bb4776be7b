#pragma once
/// Bulk viscosity, stiffness damping, and what they do to the stable step.

#include "discretisation/fem/kinematics.hpp"

namespace cleave::discretisation::fem {

/// Shock viscosity of a part: quadratic and linear coefficients [-].
struct BulkCoefficients {
  double quadratic = 1.5, linear = 0.06;
};

/// q = rho L (Q1 L d^2 + Q2 c |d|) in compression (d = trace of D < 0), else 0. [stress]
/// Sources: von Neumann & Richtmyer 1950; Landshoff 1955.
template <class Real>
Real bulk_viscosity(const BulkCoefficients& q, const Real& density, const Real& length,
                    const Real& sound_speed, const Real& rate) {
  const Real compression = max(-rate, Real(0.0));
  return density * length * compression *
         (Real(q.quadratic) * length * compression + Real(q.linear) * sound_speed);
}

/// L / (Q + sqrt(Q^2 + c^2)) with Q = Q2 c + Q1 L |d| in compression, else 0. [time]
template <class Real>
Real stable_step(const BulkCoefficients& q, const Real& length, const Real& sound_speed, const Real& rate) {
  const Real zero(0.0);
  const Real compression = max(-rate, zero);
  const Real both =
      select(rate < zero, Real(q.linear) * sound_speed + Real(q.quadratic) * length * compression, zero);
  return length / (both + sqrt(both * both + sound_speed * sound_speed));
}

/// Stiffness-proportional damping of a part. COEF > 0: fraction of critical damping at the highest frequency
/// of each element; COEF < 0: the Rayleigh coefficient itself [time].
struct StiffnessDamping {
  double coefficient = 0.0;
  bool active() const { return coefficient != 0.0; }

  /// Rayleigh coefficient beta [time] of an element of the undamped stable step 2/omega.
  template <class Real>
  Real beta(const Real& undamped_step) const {
    return coefficient > 0.0 ? Real(coefficient) * undamped_step : Real(-coefficient);
  }
  /// Central differences with lagged velocities: step sqrt(1 + xi^2) - xi of the undamped, xi = beta/step.
  template <class Real>
  static Real reduction(const Real& beta, const Real& undamped_step) {
    const Real xi = beta / undamped_step;
    return sqrt(Real(1.0) + xi * xi) - xi;
  }
};

/// beta C : D of an isotropic material. [stress]
template <class Real>
base::Sym3<Real> viscous_stress(const Real& beta, const Real& longitudinal, const Real& shear,
                                const base::Sym3<Real>& rate) {
  const Real two(2.0);
  return beta * (two * shear * rate + base::spherical((longitudinal - two * shear) * trace(rate)));
}

}  // namespace cleave::discretisation::fem
