#pragma once

namespace cleave::model {

/// Pressure of an equation of state at one volume: linear in the energy, p = cold + thermal * energy.
/// The slopes are derivatives with respect to the relative volume.
template <class Real>
struct PressureLine {
  Real cold, thermal;              ///< [stress], [-]
  Real cold_slope, thermal_slope;  ///< [stress], [-]
};

}  // namespace cleave::model
