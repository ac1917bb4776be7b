#pragma once
/// Linear elasticity: the law of *MAT_ELASTIC, and what contact takes the stiffness of a rigid part from.

#include "model/material/tiled_law.hpp"

namespace cleave::model {

/// Isotropic hypoelasticity: objective stress rate = C : D.
/// Source: Belytschko, Liu & Moran, Nonlinear Finite Elements (2000), eq. 5.4.21.
struct Elastic {
  static constexpr int state_size = 0, rotated_tensors = 0, plastic_strain = -1;
  static constexpr bool needs_F = false;
  static constexpr std::array<StateName, 0> state_names{};

  double bulk_modulus, shear_modulus;  ///< [stress]

  bool can_fail() const { return false; }
  double longitudinal() const { return bulk_modulus + 4.0 / 3.0 * shear_modulus; }
  double shear() const { return shear_modulus; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const auto& e = p.strain_increment;
    p.stress = p.stress + Real(2.0 * shear_modulus) * e +
               base::spherical(Real(bulk_modulus - 2.0 / 3.0 * shear_modulus) * trace(e));
    p.modulus = Real(longitudinal());
  }
};

}  // namespace cleave::model
