#pragma once
/// Principal values of a symmetric tensor, without branches.

#include "model/material/kernel.hpp"

namespace cleave::model {

/// Eigenvalues, first the largest.
template <class Real>
struct Principal {
  Real first, second, third;
};

/// With J2 = s:s/2 and J3 = det s of the deviator s, the values are mean + 2 sqrt(J2/3) c, where c solves
/// 4 c^3 - 3 c = t, t = (3 sqrt(3) / 2) J3 / J2^1.5 in [-1, 1]. The root that stands alone (the largest for
/// t > 0, the least for t < 0) is well conditioned: four Newton steps from 1 give it to roundoff. The other
/// two follow from a quadratic; where they coincide their distance carries the square root of the roundoff.
template <class Real>
Principal<Real> principal_values(const base::Sym3<Real>& a) {
  const Real one(1.0), mean = trace(a) * Real(1.0 / 3.0);
  const auto s = a - base::spherical(mean);
  const Real j2 = Real(0.5) * dot(s, s);
  const Real j3 = s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.zx) +
                  s.zx * (s.xy * s.yz - s.yy * s.zx);
  const Real radius = sqrt(j2 * Real(1.0 / 3.0));
  const Real t = min(abs(j3) * Real(0.5) / max(radius * radius * radius, Real(1e-300)), one);

  Real c = one - (one - t) * Real(0.134);  // chord between the ends: t = 0 at cos 30 degrees
  for (int i = 0; i < 4; ++i) {
    const Real c2 = c * c;
    c = c - (c * (Real(4.0) * c2 - Real(3.0)) - t) / (Real(12.0) * c2 - Real(3.0));
  }
  const Real root = sqrt(max(Real(3.0) * (one - c * c), Real(0.0)));
  const Real alone = Real(2.0) * c * radius, near = (root - c) * radius, far = -(root + c) * radius;

  const auto up = j3 >= Real(0.0);  // alone > near > far; mirrored for J3 < 0
  return {mean + select(up, alone, -far), mean + select(up, near, -near), mean + select(up, far, -alone)};
}

}  // namespace cleave::model
