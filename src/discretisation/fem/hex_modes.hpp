#pragma once
/// The eight-node hexahedron in its own modes: three linear, four hourglass.
///
/// x(xi, eta, zeta) = c + (a0 xi + a1 eta + a2 zeta + h0 eta zeta + h1 zeta xi + h2 xi eta + h3 xi eta
/// zeta)/8. In these the exact volume and its gradient, which is the uniform-gradient operator of Flanagan &
/// Belytschko (IJNME 17 (1981) 679-706), need a few cross products: the volume does not depend on h3, and
///   V = ([a0,a1,a2] + ([a0,h2,h1] + [h2,a1,h0] + [h1,h0,a2])/3) / 64.
/// The sum over nodes of anything times a nodal sign pattern is one pass of additions (a Walsh transform).

#include "discretisation/fem/kinematics.hpp"

namespace cleave::discretisation::fem {

/// Components along the sign patterns, without the factor 1/8; the mean is left out.
template <class Real>
struct HexModes {
  Vec3<Real> a[3], h[4];
};

/// One component: sums of eight nodal values with the signs of the seven patterns.
template <class Real>
struct HexSums {
  Real a0, a1, a2, h0, h1, h2, h3;
};

template <class Real>
HexSums<Real> hex_sums(const Real& n0, const Real& n1, const Real& n2, const Real& n3, const Real& n4,
                       const Real& n5, const Real& n6, const Real& n7) {
  // Along xi, then eta, then zeta; s sum, d difference, b bottom, t top.
  const Real s01 = n1 + n0, d01 = n1 - n0, s32 = n2 + n3, d32 = n2 - n3;
  const Real s45 = n5 + n4, d45 = n5 - n4, s76 = n6 + n7, d76 = n6 - n7;
  const Real ss_b = s32 + s01, sd_b = s32 - s01, ds_b = d32 + d01, dd_b = d32 - d01;
  const Real ss_t = s76 + s45, sd_t = s76 - s45, ds_t = d76 + d45, dd_t = d76 - d45;
  return {ds_t + ds_b, sd_t + sd_b, ss_t - ss_b, sd_t - sd_b, ds_t - ds_b, dd_t + dd_b, dd_t - dd_b};
}

template <class Real>
HexModes<Real> hex_modes(const Vec3<Real>* n) {
  const auto x = hex_sums(n[0].x, n[1].x, n[2].x, n[3].x, n[4].x, n[5].x, n[6].x, n[7].x);
  const auto y = hex_sums(n[0].y, n[1].y, n[2].y, n[3].y, n[4].y, n[5].y, n[6].y, n[7].y);
  const auto z = hex_sums(n[0].z, n[1].z, n[2].z, n[3].z, n[4].z, n[5].z, n[6].z, n[7].z);
  return {{{x.a0, y.a0, z.a0}, {x.a1, y.a1, z.a1}, {x.a2, y.a2, z.a2}},
          {{x.h0, y.h0, z.h0}, {x.h1, y.h1, z.h1}, {x.h2, y.h2, z.h2}, {x.h3, y.h3, z.h3}}};
}

/// The transpose: nodal values from components along the patterns.
template <class Real>
void hex_spread(const HexSums<Real>& m, Real (&n)[8]) {
  // The mean is zero; the first level joins the patterns that differ in zeta.
  const Real ds_b = m.a0 - m.h1, ds_t = m.a0 + m.h1;
  const Real sd_b = m.a1 - m.h0, sd_t = m.a1 + m.h0;
  const Real dd_b = m.h2 - m.h3, dd_t = m.h2 + m.h3;
  // Then eta, then xi.
  const Real s01 = -m.a2 - sd_b, s32 = sd_b - m.a2, d01 = ds_b - dd_b, d32 = ds_b + dd_b;
  const Real s45 = m.a2 - sd_t, s76 = m.a2 + sd_t, d45 = ds_t - dd_t, d76 = ds_t + dd_t;
  n[0] = s01 - d01;
  n[1] = s01 + d01;
  n[2] = s32 + d32;
  n[3] = s32 - d32;
  n[4] = s45 - d45;
  n[5] = s45 + d45;
  n[6] = s76 + d76;
  n[7] = s76 - d76;
}

template <class Real>
void hex_spread(const HexModes<Real>& m, Vec3<Real>* n) {
  Real x[8], y[8], z[8];
  hex_spread({m.a[0].x, m.a[1].x, m.a[2].x, m.h[0].x, m.h[1].x, m.h[2].x, m.h[3].x}, x);
  hex_spread({m.a[0].y, m.a[1].y, m.a[2].y, m.h[0].y, m.h[1].y, m.h[2].y, m.h[3].y}, y);
  hex_spread({m.a[0].z, m.a[1].z, m.a[2].z, m.h[0].z, m.h[1].z, m.h[2].z, m.h[3].z}, z);
  for (int a = 0; a < 8; ++a) n[a] = {x[a], y[a], z[a]};
}

/// Volume gradient b_a = dV/dx_a of all nodes, as components along the patterns: b_a = sum of sign * a, h.
/// It has no part along h3.
template <class Real>
struct HexGradient {
  Vec3<Real> a[3], h[3];
  Real volume;
};

template <class Real>
HexGradient<Real> hex_gradient(const HexModes<Real>& m) {
  const Real third(1.0 / 3.0), scale(1.0 / 64.0);
  const auto& a = m.a;
  const auto& h = m.h;
  HexGradient<Real> g;
  g.a[0] = scale * (cross(a[1], a[2]) + third * cross(h[2], h[1]));
  g.a[1] = scale * (cross(a[2], a[0]) + third * cross(h[0], h[2]));
  g.a[2] = scale * (cross(a[0], a[1]) + third * cross(h[1], h[0]));
  const Real part = scale * third;
  g.h[0] = part * (cross(h[2], a[1]) + cross(a[2], h[1]));
  g.h[1] = part * (cross(a[0], h[2]) + cross(h[0], a[2]));
  g.h[2] = part * (cross(h[1], a[0]) + cross(a[1], h[0]));
  g.volume = dot(a[0], g.a[0]) + dot(a[1], scale * third * cross(h[0], h[2])) +
             dot(a[2], scale * third * cross(h[1], h[0]));
  return g;
}

/// Sum over nodes of u_a (x) b_a: the volume integral of the gradient of u.
template <class Real>
Mat3<Real> hex_outer(const HexModes<Real>& u, const HexGradient<Real>& b) {
  const auto line = [&](const Real& u0, const Real& u1, const Real& u2, const Real& w0, const Real& w1,
                        const Real& w2, Real(&out)[3]) {
    const Vec3<Real> r = u0 * b.a[0] + u1 * b.a[1] + u2 * b.a[2] + w0 * b.h[0] + w1 * b.h[1] + w2 * b.h[2];
    out[0] = r.x;
    out[1] = r.y;
    out[2] = r.z;
  };
  Mat3<Real> g;
  line(u.a[0].x, u.a[1].x, u.a[2].x, u.h[0].x, u.h[1].x, u.h[2].x, g.m[0]);
  line(u.a[0].y, u.a[1].y, u.a[2].y, u.h[0].y, u.h[1].y, u.h[2].y, g.m[1]);
  line(u.a[0].z, u.a[1].z, u.a[2].z, u.h[0].z, u.h[1].z, u.h[2].z, g.m[2]);
  return g;
}

/// Square of a quarter of the largest face area: |t1 x t2|^2 of the tangents in the middle of a face, which
/// equals the area of the (possibly warped) face between its diagonals.
template <class Real>
Real hex_largest_face(const HexModes<Real>& m) {
  const Real scale(1.0 / 64.0);
  const auto face = [&](const Vec3<Real>& s, const Vec3<Real>& t) {
    const Vec3<Real> n = cross(s, t);
    return dot(n, n);
  };
  const auto pair = [&](const Vec3<Real>& s, const Vec3<Real>& sh, const Vec3<Real>& t,
                        const Vec3<Real>& th) { return max(face(s + sh, t + th), face(s - sh, t - th)); };
  const Real largest = max(pair(m.a[1], m.h[2], m.a[2], m.h[1]),
                           max(pair(m.a[0], m.h[2], m.a[2], m.h[0]), pair(m.a[0], m.h[1], m.a[1], m.h[0])));
  return scale * scale * largest;
}

}  // namespace cleave::discretisation::fem
