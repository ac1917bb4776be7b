#pragma once
/// What a law sees of one material point (or of eight at once, when Real is Lanes).

#include <array>

#include "base/tensor.hpp"
#include "model/material/pressure_line.hpp"

namespace cleave::model {

/// A new input becomes a new member here; existing laws stay as they are.
template <class Real, int StateSize>
struct Point {
  using Scalar = Real;

  // --- given -------------------------------------------------------------------------------------
  double dt = 0.0;                    ///< step just taken [time]
  double time = 0.0;                  ///< at its end [time]
  base::Sym3<Real> strain_increment;  ///< D dt at mid-step, turned into the frame of the end of the step [-]
  base::Mat3<Real> F;                 ///< deformation gradient; set only if the law says needs_F [-]
  Real volume_ratio;                  ///< J at the end of the step [-]
  Real volume_ratio_before;           ///< J at its begin [-]
  Real bulk_viscosity;                ///< q, mean of both ends of the step, positive in compression [stress]
  Real length;                        ///< characteristic length of the element [length]
  PressureLine<Real> pressure;        ///< of the equation of state; set only if the law asks for it

  // --- moved -------------------------------------------------------------------------------------
  base::Sym3<Real> stress;  ///< Cauchy stress, without q; comes in rotated to the current frame [stress]
  std::array<Real, StateSize ? StateSize : 1> state;  ///< history; rotated tensors first
  Real energy;  ///< internal energy per reference volume [energy/volume]

  // --- answered ----------------------------------------------------------------------------------
  Real modulus;  ///< current longitudinal modulus rho c^2, per current volume [stress]
  Real failed;   ///< 1 when the point asks to be deleted, else 0
};

}  // namespace cleave::model
