#pragma once
/// What the von Mises laws share: elastic trial, strain rate, radial return.

#include "model/material/kernel.hpp"

namespace cleave::model {

/// Isotropic elastic moduli [stress].
struct Moduli {
  double bulk = 0.0, shear = 0.0;

  static Moduli from(double young, double poisson) {
    return {.bulk = young / (3.0 * (1.0 - 2.0 * poisson)), .shear = young / (2.0 * (1.0 + poisson))};
  }
  double longitudinal() const { return bulk + 4.0 / 3.0 * shear; }
};

/// Mean stress and deviator as if the step were elastic [stress].
template <class Real>
struct Trial {
  Real mean;
  base::Sym3<Real> deviator;
};

template <class P>
Trial<typename P::Scalar> elastic_trial(const P& p, const Moduli& m) {
  using Real = typename P::Scalar;
  const Real third(1.0 / 3.0);
  const Real volume_strain = trace(p.strain_increment), mean_before = trace(p.stress) * third;
  const auto shifted = p.stress + Real(2.0 * m.shear) * p.strain_increment;
  const Real shift = mean_before + Real(2.0 * m.shear / 3.0) * volume_strain;
  return {mean_before + Real(m.bulk) * volume_strain, shifted - base::spherical(shift)};
}

/// sqrt(3/2 s:s) of a deviator.
template <class Real>
Real effective(const base::Sym3<Real>& deviator) {
  return sqrt(Real(1.5) * dot(deviator, deviator));
}

/// A divisor that never is zero.
template <class Real>
Real positive(const Real& a) {
  return max(a, Real(1e-300));
}

inline double inverse_step(double dt) {
  return dt > 0.0 ? 1.0 / dt : 0.0;
}

/// Effective rate of the deviatoric strain, sqrt(2/3 e:e) / dt; 0 for a step of no length [1/time].
template <class P>
typename P::Scalar effective_rate(const P& p) {
  using Real = typename P::Scalar;
  const auto e = deviator(p.strain_increment);
  return sqrt(Real(2.0 / 3.0) * dot(e, e)) * Real(inverse_step(p.dt));
}

/// 1 where `reached`, else 0.
template <class Real, class Mask>
Real flag(const Mask& reached) {
  return select(reached, Real(1.0), Real(0.0));
}

/// Does the element's own step, length / sqrt(modulus / density), fall below the least one allowed? Asks for
/// modulus to be set already. @param density in the reference state [mass/length^3]
template <class P>
auto step_below(const P& p, double density, double least_step) {
  using Real = typename P::Scalar;
  // L^2 rho < t^2 modulus, with rho = density / J: no root, no division.
  return p.length * p.length * Real(density) < p.volume_ratio * p.modulus * Real(least_step * least_step);
}

/// Cowper and Symonds' rate law, C and P of the cards; C = 0 switches it off.
struct CowperSymonds {
  double reference = 0.0, exponent = 1.0;  ///< [1/time], [-]

  bool active() const { return reference > 0.0 && exponent > 0.0; }
  /// (rate / C)^(1/P).
  template <class Real>
  Real overstress(const Real& rate) const {
    return pow(rate * Real(1.0 / reference), Real(1.0 / exponent));
  }
};

}  // namespace cleave::model
