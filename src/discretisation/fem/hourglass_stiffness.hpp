#pragma once
/// Hourglass control by stiffness: the force grows with the hourglass displacement, not with its rate.

#include "discretisation/fem/hourglass.hpp"

namespace cleave::discretisation::fem {

/// The four force vectors of a stiffness form, in its own record.
template <class Real>
void get_forces(Record<Real> own, Vec3<Real> (&q)[4]) {
  for (int k = 0; k < 4; ++k) q[k] = get_vector(own, 3 * k);
}
template <class Real>
void set_forces(Record<Real> own, const Vec3<Real> (&q)[4]) {
  for (int k = 0; k < 4; ++k) set_vector(own, 3 * k, q[k]);
}

/// Types 4, 5: Q grows by k dq with k = QM (lambda + 2 mu) (b_a . b_a) / (24 V), the force vectors turn with
/// the body. QM = 1 gives hourglass modes the highest frequency of the element's other modes.
/// Source: Flanagan & Belytschko, IJNME 17 (1981) 679-706, artificial stiffness, with the longitudinal
/// modulus.
struct StiffnessHourglass {
  static constexpr int own_size = 12;
  double coefficient;  ///< QM [-]

  template <class Real>
  void turn(const StepRotation<Real>& rotation, Record<Real> own, Vec3<Real> (&dq)[4]) const {
    Vec3<Real> q[4];
    get_forces(own, q);
    for (int k = 0; k < 4; ++k) {
      q[k] = apply(rotation.whole, q[k]);
      dq[k] = apply(rotation.half, dq[k]);
    }
    set_forces(own, q);
  }

  template <class Real>
  void resist(const ElementAnswer<Real, 1>& e, const HexModes<Real>&, const HexGradient<Real>& b,
              Record<Real> own, const Vec3<Real> (&dq)[4], Vec3<Real> (&q)[4], Real& work) const {
    // Sum over nodes of b_a . b_a is eight times that over the patterns.
    Real squares(0.0);
    for (int i = 0; i < 3; ++i) squares = squares + dot(b.a[i], b.a[i]) + dot(b.h[i], b.h[i]);
    const Real stiffness = Real(coefficient / 3.0) * e.modulus * squares / b.volume;
    get_forces(own, q);
    work = Real(0.0);
    for (int k = 0; k < 4; ++k) {
      const Vec3<Real> growth = stiffness * dq[k];
      work = work + dot(q[k] + Real(0.5) * growth, dq[k]);
      q[k] = q[k] + growth;
    }
    set_forces(own, q);
  }
};

/// Type 6: the stiffness of an assumed strain field that bends like a plate in every plane and locks neither
/// in shear nor in volume (ASQBI), scaled by QM; in axes that turn with the element.
/// Source: Belytschko & Bindeman, CMAME 105 (1993) 225-260.
struct AssumedStrainHourglass {
  static constexpr int own_size = 12;
  double coefficient;  ///< QM [-]; 1 is the elastic stiffness itself

  template <class Real>
  void turn(const StepRotation<Real>& rotation, Record<Real>, Vec3<Real> (&dq)[4]) const {
    for (Vec3<Real>& d : dq) d = apply(rotation.half, d);
  }

  template <class Real>
  void resist(const ElementAnswer<Real, 1>& e, const HexModes<Real>& x, const HexGradient<Real>&,
              Record<Real> own, const Vec3<Real> (&dq)[4], Vec3<Real> (&q)[4], Real& work) const {
    const Real one(1.0), half(0.5), third(1.0 / 3.0);
    // Axes: the first along the first edge direction, the second in the plane of the first two.
    const Vec3<Real> r = x.a[1] - (dot(x.a[0], x.a[1]) / dot(x.a[0], x.a[0])) * x.a[0];
    Vec3<Real> axis[3];
    axis[0] = (one / sqrt(dot(x.a[0], x.a[0]))) * x.a[0];
    axis[1] = (one / sqrt(dot(r, r))) * r;
    axis[2] = cross(axis[0], axis[1]);

    // Integrals of the gradients of the patterns: H_ii = l_j l_k / (3 l_i), H_ij = l_k / 3.
    Real l[3], hh[3], h[3];
    for (int i = 0; i < 3; ++i) l[i] = dot(x.a[i], axis[i]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      hh[i] = third * l[j] * l[k] / l[i];
      h[i] = third * l[i];  // H_jk
    }
    // dq and Q carry a factor 8 each over the modal amplitudes of the paper.
    const Real mu = Real(coefficient / 64.0) * e.shear;
    const Real nu = half * (e.modulus - Real(2.0) * e.shear) / (e.modulus - e.shear);
    const Real plate = Real(2.0) * mu / (one - nu), bar = Real(2.0) * mu * (one + nu) * third;

    Real d[3][4], local[3][4];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k) d[i][k] = dot(axis[i], dq[k]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      local[i][i] = mu * ((hh[j] + hh[k]) * d[i][i] + h[k] * d[j][j] + h[j] * d[k][k]);
      local[i][j] = plate * (hh[i] * d[i][j] + nu * h[k] * d[j][i]);
      local[i][k] = plate * (hh[i] * d[i][k] + nu * h[j] * d[k][i]);
      local[i][3] = bar * hh[i] * d[i][3];
    }

    // Growth in the element's axes, where the record keeps the forces.
    Vec3<Real> stored[4];
    get_forces(own, stored);
    work = Real(0.0);
    for (int k = 0; k < 4; ++k) {
      const Vec3<Real> growth{local[0][k], local[1][k], local[2][k]}, along{d[0][k], d[1][k], d[2][k]};
      work = work + dot(stored[k] + half * growth, along);
      stored[k] = stored[k] + growth;
      q[k] = stored[k].x * axis[0] + stored[k].y * axis[1] + stored[k].z * axis[2];
    }
    set_forces(own, stored);
  }
};

}  // namespace cleave::discretisation::fem
