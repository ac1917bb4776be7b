#pragma once
/// Small vectors and tensors over a scalar type `Real` (double, Lanes or a dual number).
/// Symmetric tensors are stored xx yy zz xy yz zx, as in the files users read.

#include <array>

#include "base/lanes.hpp"

namespace cleave::base {

template <class Real>
struct Vec3 {
  Real x, y, z;

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const Real& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A general second-order tensor, m[row][column].
template <class Real>
struct Mat3 {
  Real m[3][3];

  static Mat3 identity() {
    Mat3 r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r.m[i][j] = Real(i == j ? 1.0 : 0.0);
    return r;
  }
  friend Mat3 operator*(const Mat3& a, const Mat3& b) {
    Mat3 r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        r.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
    return r;
  }
  friend Mat3 operator+(const Mat3& a, const Mat3& b) {
    Mat3 r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r.m[i][j] = a.m[i][j] + b.m[i][j];
    return r;
  }
};

template <class Real>
Mat3<Real> transpose(const Mat3<Real>& a) {
  Mat3<Real> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r.m[i][j] = a.m[j][i];
  return r;
}
template <class Real>
Real determinant(const Mat3<Real>& a) {
  return a.m[0][0] * (a.m[1][1] * a.m[2][2] - a.m[1][2] * a.m[2][1]) -
         a.m[0][1] * (a.m[1][0] * a.m[2][2] - a.m[1][2] * a.m[2][0]) +
         a.m[0][2] * (a.m[1][0] * a.m[2][1] - a.m[1][1] * a.m[2][0]);
}
/// Inverse; the caller guarantees a determinant away from zero.
template <class Real>
Mat3<Real> inverse(const Mat3<Real>& a, const Real& det) {
  const Real s = Real(1.0) / det;
  Mat3<Real> r;
  r.m[0][0] = s * (a.m[1][1] * a.m[2][2] - a.m[1][2] * a.m[2][1]);
  r.m[0][1] = s * (a.m[0][2] * a.m[2][1] - a.m[0][1] * a.m[2][2]);
  r.m[0][2] = s * (a.m[0][1] * a.m[1][2] - a.m[0][2] * a.m[1][1]);
  r.m[1][0] = s * (a.m[1][2] * a.m[2][0] - a.m[1][0] * a.m[2][2]);
  r.m[1][1] = s * (a.m[0][0] * a.m[2][2] - a.m[0][2] * a.m[2][0]);
  r.m[1][2] = s * (a.m[0][2] * a.m[1][0] - a.m[0][0] * a.m[1][2]);
  r.m[2][0] = s * (a.m[1][0] * a.m[2][1] - a.m[1][1] * a.m[2][0]);
  r.m[2][1] = s * (a.m[0][1] * a.m[2][0] - a.m[0][0] * a.m[2][1]);
  r.m[2][2] = s * (a.m[0][0] * a.m[1][1] - a.m[0][1] * a.m[1][0]);
  return r;
}

/// A symmetric second-order tensor; shear components are tensor (not engineering) components.
template <class Real>
struct Sym3 {
  Real xx, yy, zz, xy, yz, zx;

  friend Sym3 operator+(const Sym3& a, const Sym3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
  }
  friend Sym3 operator-(const Sym3& a, const Sym3& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
  }
  friend Sym3 operator*(const Real& s, const Sym3& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
  }
};

template <class Real>
Real trace(const Sym3<Real>& a) {
  return a.xx + a.yy + a.zz;
}
template <class Real>
Sym3<Real> spherical(const Real& s) {
  return {s, s, s, Real(0.0), Real(0.0), Real(0.0)};
}
template <class Real>
Sym3<Real> deviator(const Sym3<Real>& a) {
  return a - spherical(trace(a) * Real(1.0 / 3.0));
}
/// Full contraction a : b.
template <class Real>
Real dot(const Sym3<Real>& a, const Sym3<Real>& b) {
  const Real two(2.0);
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + two * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
/// von Mises stress of a deviator or of any stress.
template <class Real>
Real von_mises(const Sym3<Real>& a) {
  const auto s = deviator(a);
  return sqrt(Real(1.5) * dot(s, s));
}
/// Q a Q^T.
template <class Real>
Sym3<Real> rotate(const Mat3<Real>& q, const Sym3<Real>& a) {
  const Real s[3][3] = {{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}};
  Real t[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = q.m[i][0] * s[0][j] + q.m[i][1] * s[1][j] + q.m[i][2] * s[2][j];
  const auto entry = [&](int i, int j) {
    return t[i][0] * q.m[j][0] + t[i][1] * q.m[j][1] + t[i][2] * q.m[j][2];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

}  // namespace cleave::base
