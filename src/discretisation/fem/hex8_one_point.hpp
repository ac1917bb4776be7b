#pragma once
/// Eight-node hexahedron with one point, uniform gradient and hourglass control: the element description.
/// Source: Flanagan & Belytschko, IJNME 17 (1981) 679-706.

#include "discretisation/fem/hourglass.hpp"
#include "model/mesh.hpp"

namespace cleave::discretisation::fem {

template <class Hourglass>
struct HexOnePoint {
  static constexpr int node_count = 8, point_count = 1;
  static constexpr model::Shape shape = model::Shape::hex8;
  static constexpr int gradient_size = 18;  ///< reference gradient, kept only for laws that need F

  Hourglass hourglass;
  bool needs_F = false;

  /// Own record: hourglass forces, then the reference gradient b_a/V.
  int own_size() const { return Hourglass::own_size + (needs_F ? gradient_size : 0); }

  template <class Real>
  struct Carried {
    HexModes<Real> shape;        ///< at t_n+1
    HexGradient<Real> gradient;  ///< at t_n+1
    Vec3<Real> dq[4];            ///< hourglass displacement of the step [length]
  };

  template <class Real>
  void reference(const Vec3<Real>* x, Real* volume, Record<Real> own) const {
    const auto gradient = hex_gradient(hex_modes(x));
    volume[0] = gradient.volume;
    const Real inverse = Real(1.0) / gradient.volume, zero(0.0);
    for (int i = 0; i < Hourglass::own_size; ++i) own.set(i, zero);
    if (!needs_F) return;
    for (int i = 0; i < 3; ++i) {
      set_vector(own, Hourglass::own_size + 3 * i, inverse * gradient.a[i]);
      set_vector(own, Hourglass::own_size + 9 + 3 * i, inverse * gradient.h[i]);
    }
  }

  /// An eighth to each node.
  template <class Give>
  void spread_mass(double mass, const Give& give) const {
    for (int a = 0; a < node_count; ++a) give(a, mass / node_count);
  }

  template <class Real>
  void strain(const ElementInput<Real>& in, Record<Real> own, ElementMotion<Real, 1>& motion,
              Carried<Real>& carried) const {
    const Real dt(in.dt), half(0.5);
    carried.shape = hex_modes(in.x);
    carried.gradient = hex_gradient(carried.shape);

    // Displacement increment and mid-step geometry: both linear in the nodes, so modes suffice.
    HexModes<Real> step = hex_modes(in.v), middle;
    for (int i = 0; i < 3; ++i) {
      step.a[i] = dt * step.a[i];
      middle.a[i] = carried.shape.a[i] - half * step.a[i];
    }
    for (int i = 0; i < 4; ++i) {
      step.h[i] = dt * step.h[i];
      middle.h[i] = carried.shape.h[i] - half * step.h[i];
    }
    const auto b = hex_gradient(middle);
    const Real inverse = Real(1.0) / b.volume;
    Mat3<Real>& g = motion.point[0].gradient;
    g = hex_outer(step, b);
    for (auto& line : g.m)
      for (Real& entry : line) entry = inverse * entry;

    for (int k = 0; k < 4; ++k) carried.dq[k] = step.h[k] - apply(g, middle.h[k]);

    motion.volume = carried.gradient.volume;
    motion.least = min(carried.gradient.volume, b.volume);
    motion.point[0].volume_ratio = carried.gradient.volume / in.reference_volume[0];
    motion.length = Real(0.25) * carried.gradient.volume / sqrt(hex_largest_face(carried.shape));
    if (in.needs_F) {
      HexGradient<Real> start;
      for (int i = 0; i < 3; ++i) {
        start.a[i] = get_vector(own, Hourglass::own_size + 3 * i);
        start.h[i] = get_vector(own, Hourglass::own_size + 9 + 3 * i);
      }
      motion.point[0].F = hex_outer(carried.shape, start);
    }
  }

  template <class Real>
  void turn(const StepRotation<Real>* rotation, Record<Real> own, Carried<Real>& carried) const {
    hourglass.turn(rotation[0], own, carried.dq);
  }

  /// f_a = stress b_a + sum of Q gamma_a; the part of gamma along b is a (non-symmetric) stress.
  template <class Real>
  void force(const ElementAnswer<Real, 1>& e, Record<Real> own, Carried<Real>& carried, Vec3<Real>* force,
             Real& hourglass_work) const {
    Vec3<Real> q[4];
    hourglass.resist(e, carried.shape, carried.gradient, own, carried.dq, q, hourglass_work);
    const auto& s = e.stress[0];
    Mat3<Real> p = {{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}}};
    const Real inverse = Real(1.0) / carried.gradient.volume;
    for (int k = 0; k < 4; ++k) {
      const Vec3<Real> h = inverse * carried.shape.h[k];
      const Real* line[3] = {&q[k].x, &q[k].y, &q[k].z};
      for (int i = 0; i < 3; ++i) {
        p.m[i][0] = p.m[i][0] - *line[i] * h.x;
        p.m[i][1] = p.m[i][1] - *line[i] * h.y;
        p.m[i][2] = p.m[i][2] - *line[i] * h.z;
      }
    }
    HexModes<Real> f;
    for (int i = 0; i < 3; ++i) {
      f.a[i] = apply(p, carried.gradient.a[i]);
      f.h[i] = apply(p, carried.gradient.h[i]) + q[i];
    }
    f.h[3] = q[3];
    hex_spread(f, force);
  }
};

}  // namespace cleave::discretisation::fem
