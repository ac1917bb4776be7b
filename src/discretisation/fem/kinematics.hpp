#pragma once
/// Strain and rotation of a step from the gradient of its displacement increment.
///
/// The gradient G = d(du)/dx is taken in the geometry half way through the step. For a rigid rotation of any
/// angle below half a turn, du = (R - I) x0 and x_mid = (R + I) x0 / 2, so G = 2 (R - I)(R + I)^-1 is skew:
/// the strain is zero and its Cayley transform is R itself. Source: Hughes & Winget, IJNME 15 (1980)
/// 1862-1867.

#include "base/tensor.hpp"

namespace cleave::discretisation::fem {

using base::Mat3;
using base::Sym3;
using base::Vec3;
// For Lanes the argument's namespace is searched anyway; a plain double has none.
using base::all;
using base::max;
using base::min;
using base::select;
using base::sqrt;

template <class Real>
Sym3<Real> symmetric_part(const Mat3<Real>& g) {
  const Real half(0.5);
  return {g.m[0][0],
          g.m[1][1],
          g.m[2][2],
          half * (g.m[0][1] + g.m[1][0]),
          half * (g.m[1][2] + g.m[2][1]),
          half * (g.m[2][0] + g.m[0][2])};
}

/// Axial vector w of the skew part: skew(G) a = w x a.
template <class Real>
Vec3<Real> spin(const Mat3<Real>& g) {
  const Real half(0.5);
  return {half * (g.m[2][1] - g.m[1][2]), half * (g.m[0][2] - g.m[2][0]), half * (g.m[1][0] - g.m[0][1])};
}

/// Rotation Q = (I - W/2)^-1 (I + W/2) of the spin w, and its square root.
template <class Real>
struct StepRotation {
  Mat3<Real> whole, half;
};

/// I + c (W + s W^2) with W a = w x a.
template <class Real>
Mat3<Real> rotation_polynomial(const Vec3<Real>& w, const Real& c, const Real& s) {
  const Real one(1.0);
  const Real xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z, cs = c * s;
  const Real xy = cs * (w.x * w.y), yz = cs * (w.y * w.z), zx = cs * (w.z * w.x);
  const Real x = c * w.x, y = c * w.y, z = c * w.z;
  return {{{one - cs * (yy + zz), xy - z, zx + y},
           {xy + z, one - cs * (zz + xx), yz - x},
           {zx - y, yz + x, one - cs * (xx + yy)}}};
}

/// With t = tan(angle/2) = |w|/2, the square root turns by half the angle, tan(angle/4) = t/(1+sqrt(1+t^2)).
/// Source: Hughes & Winget 1980, eq. 22.
template <class Real>
StepRotation<Real> step_rotation(const Vec3<Real>& w) {
  const Real one(1.0), half(0.5);
  const Real stretch = one + Real(0.25) * dot(w, w);
  const Real inverse = one / stretch;
  // Half the rotation has spin w k with k = 1/(1+sqrt(1+t^2)); 1 + |w k|^2/4 = 2 sqrt(1+t^2) k.
  const Real root = sqrt(stretch);
  const Real k = one / (one + root);
  const Real half_inverse = half * (one + root) / root;
  const Vec3<Real> small{k * w.x, k * w.y, k * w.z};
  return {rotation_polynomial(w, inverse, half), rotation_polynomial(small, half_inverse, half)};
}

}  // namespace cleave::discretisation::fem
