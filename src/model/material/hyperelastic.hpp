#pragma once
/// Kinematics shared by the rubber laws.

#include "model/material/kernel.hpp"

namespace cleave::model {

/// b = F F^T.
template <class Real>
base::Sym3<Real> left_cauchy_green(const base::Mat3<Real>& F) {
  const auto entry = [&](int i, int j) {
    return F.m[i][0] * F.m[j][0] + F.m[i][1] * F.m[j][1] + F.m[i][2] * F.m[j][2];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

/// a a.
template <class Real>
base::Sym3<Real> square(const base::Sym3<Real>& a) {
  return {a.xx * a.xx + a.xy * a.xy + a.zx * a.zx, a.xy * a.xy + a.yy * a.yy + a.yz * a.yz,
          a.zx * a.zx + a.yz * a.yz + a.zz * a.zz, a.xx * a.xy + a.xy * a.yy + a.zx * a.yz,
          a.xy * a.zx + a.yy * a.yz + a.yz * a.zz, a.xx * a.zx + a.xy * a.yz + a.zx * a.zz};
}

/// A number not below the largest principal value; equal to it when the two others coincide.
template <class Real>
Real greatest_bound(const base::Sym3<Real>& a) {
  const auto s = deviator(a);
  return trace(a) * Real(1.0 / 3.0) + sqrt(Real(2.0 / 3.0) * dot(s, s));
}

}  // namespace cleave::model
