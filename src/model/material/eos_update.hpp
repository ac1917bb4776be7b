#pragma once
/// How a law with an equation of state moves pressure and energy over a step.
///
/// Energy per reference volume obeys de = w - (p + q) dJ, w the work of the deviator, p the mean of the
/// pressures before and after. Pressure is linear in e, so both follow from one linear equation.
/// Source: Wilkins, Calculation of elastic-plastic flow, Methods Comput. Phys. 3 (1964), sec. IV.

#include "model/material/eos.hpp"
#include "model/material/kernel.hpp"

namespace cleave::model {

struct EosConstants {
  double initial_volume = 1.0, initial_energy = 0.0;  ///< V0 [-], E0 [energy/volume]
  double bulk_modulus = 0.0;                          ///< in the initial state [stress]

  static EosConstants from(const PressureLaw& law) {
    return {law.initial_volume, law.initial_energy, law.bulk_modulus()};
  }

  /// Work of the mean deviator over the step [energy/reference volume].
  template <class P>
  auto work(const P& p, const base::Sym3<typename P::Scalar>& before,
            const base::Sym3<typename P::Scalar>& after) const {
    using Real = typename P::Scalar;
    return Real(0.25) * dot(before + after, p.strain_increment) * (p.volume_ratio + p.volume_ratio_before);
  }

  /// Pressure at the end of the step.
  template <class P>
  auto pressure(const P& p, const typename P::Scalar& work, const typename P::Scalar& before) const {
    using Real = typename P::Scalar;
    const Real swelling = p.volume_ratio - p.volume_ratio_before, half(0.5), start(initial_volume);
    const Real known = p.energy + work - (half * before + p.bulk_viscosity) * swelling;
    return (p.pressure.cold + p.pressure.thermal * (Real(initial_energy) + start * known)) /
           (Real(1.0) + half * start * p.pressure.thermal * swelling);
  }

  /// Energy at the end of the step.
  template <class P>
  auto energy(const P& p, const typename P::Scalar& work, const typename P::Scalar& before,
              const typename P::Scalar& after) const {
    using Real = typename P::Scalar;
    const Real mean = Real(0.5) * (before + after) + p.bulk_viscosity;
    return p.energy + work - mean * (p.volume_ratio - p.volume_ratio_before);
  }

  /// Isentropic bulk modulus -v dp/dv; not below 1 % of its initial value, where the sound speed would be
  /// lost.
  template <class P>
  auto bulk(const P& p, const typename P::Scalar& pressure, const typename P::Scalar& energy) const {
    using Real = typename P::Scalar;
    const Real e = Real(initial_energy) + Real(initial_volume) * energy;
    const Real slope = p.pressure.cold_slope + p.pressure.thermal_slope * e - p.pressure.thermal * pressure;
    return max(-(Real(initial_volume) * p.volume_ratio * slope), Real(0.01 * bulk_modulus));
  }
};

}  // namespace cleave::model
