#pragma once
/// Hourglass control of the one-point hexahedron, in the modes of hex_modes.hpp.
///
/// The generalised hourglass displacement of pattern alpha is dq = sum over nodes of gamma_alpha du, with
/// gamma = Gamma - (h_alpha . b)/V orthogonal to every linear field, whatever the shape of the element. A
/// form answers with the force Q that belongs to it. Source: Flanagan & Belytschko, IJNME 17 (1981) 679-706.

#include "discretisation/fem/hex_modes.hpp"
#include "discretisation/fem/solid_element.hpp"

namespace cleave::discretisation::fem {

/// Types 1, 2, 3: resistance to the rate of hourglass modes, Q = a dq/dt with a = QM rho V^(2/3) c / 4.
/// Sources: Flanagan & Belytschko 1981; Goudreau & Hallquist, CMAME 33 (1982) 725-757.
struct ViscousHourglass {
  static constexpr int own_size = 0;
  double coefficient;  ///< QM [-]

  template <class Real>
  void turn(const StepRotation<Real>&, Record<Real>, Vec3<Real> (&)[4]) const {}

  template <class Real>
  void resist(const ElementAnswer<Real, 1>& e, const HexModes<Real>&, const HexGradient<Real>&, Record<Real>,
              const Vec3<Real> (&dq)[4], Vec3<Real> (&q)[4], Real& work) const {
    const double per_time = e.dt > 0.0 ? 1.0 / e.dt : 0.0;
    const Real a = Real(0.25 * coefficient * per_time) * e.size * e.size * sqrt(e.density * e.modulus);
    work = Real(0.0);
    for (int k = 0; k < 4; ++k) {
      q[k] = a * dq[k];
      work = work + dot(q[k], dq[k]);
    }
  }
};

}  // namespace cleave::discretisation::fem
