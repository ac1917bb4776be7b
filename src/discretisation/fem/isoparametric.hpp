#pragma once
/// Solid elements with shape functions on a reference shape and a quadrature rule: one description for all.
///
/// A topology `T` states
///   static constexpr int node_count, point_count; static constexpr model::Shape shape;
///   static constexpr Quadrature<node_count, point_count> rule;
///   static constexpr std::array<double, node_count> mass_share;      fractions of the element's mass, sum 1
///   template <class Real> static Real length(const Vec3<Real>* x, const Real& volume);
///       for the stable step and the bulk viscosity: c times the step never exceeds it [length]
/// With mean dilatation the volume change of all points is that of the element, so a nearly incompressible
/// material has one constraint per element and does not lock. Source: Hughes, IJNME 15 (1980) 1413-1418.

#include <array>

#include "discretisation/fem/solid_element.hpp"
#include "model/mesh.hpp"

namespace cleave::discretisation::fem {

using base::cbrt;

/// Gradients of the shape functions in reference coordinates, and weights, at the points.
template <int Nodes, int Points>
struct Quadrature {
  double gradient[Points][Nodes][3];
  double weight[Points];
};

/// Jacobian dx/dxi of a point: sum of x_a (x) dN_a/dxi. Entries that are zero in the table cost nothing.
template <class Real, int Nodes>
Mat3<Real> jacobian(const Vec3<Real>* x, const double (&gradient)[Nodes][3]) {
  Mat3<Real> j;
  for (int k = 0; k < 3; ++k) {
    Vec3<Real> column{Real(0.0), Real(0.0), Real(0.0)};
    for (int a = 0; a < Nodes; ++a)
      if (gradient[a][k] != 0.0) column = column + Real(gradient[a][k]) * x[a];
    j.m[0][k] = column.x;
    j.m[1][k] = column.y;
    j.m[2][k] = column.z;
  }
  return j;
}

/// Cofactors c with c^T j = det(j) I, so that det(j) dN/dx = c dN/dxi.
template <class Real>
Mat3<Real> cofactor(const Mat3<Real>& j) {
  Mat3<Real> c;
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k) {
      const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      c.m[r][k] = j.m[r1][k1] * j.m[r2][k2] - j.m[r1][k2] * j.m[r2][k1];
    }
  return c;
}

/// Determinant from the Jacobian and its cofactors.
template <class Real>
Real determinant(const Mat3<Real>& j, const Mat3<Real>& c) {
  return j.m[0][0] * c.m[0][0] + j.m[0][1] * c.m[0][1] + j.m[0][2] * c.m[0][2];
}

template <class Topology, bool MeanDilatation>
struct Isoparametric {
  static constexpr int node_count = Topology::node_count, point_count = Topology::point_count;
  static constexpr model::Shape shape = Topology::shape;
  static constexpr bool mean_dilatation = MeanDilatation;

  bool needs_F = false;

  /// Own record, only for laws that need F: inverse Jacobian of the reference configuration, nine a point.
  int own_size() const { return needs_F ? 9 * point_count : 0; }

  template <class Real>
  struct Carried {
    Mat3<Real> weighted[point_count];  ///< weight * cofactor of the Jacobian at t_n+1 [length^2]
    Real volume[point_count];          ///< weight * det at t_n+1 [length^3]
  };

  template <class Real>
  void reference(const Vec3<Real>* x, Real* volume, Record<Real> own) const {
    for (int p = 0; p < point_count; ++p) {
      const auto j = jacobian(x, Topology::rule.gradient[p]);
      const auto c = cofactor(j);
      const Real det = determinant(j, c);
      volume[p] = Real(Topology::rule.weight[p]) * det;
      if (!needs_F) continue;
      for (int i = 0; i < 9; ++i) own.set(9 * p + i, c.m[i % 3][i / 3] / det);
    }
  }

  template <class Give>
  void spread_mass(double mass, const Give& give) const {
    for (int a = 0; a < node_count; ++a) give(a, mass * Topology::mass_share[static_cast<std::size_t>(a)]);
  }

  template <class Real>
  void strain(const ElementInput<Real>& in, Record<Real> own, ElementMotion<Real, point_count>& motion,
              Carried<Real>& carried) const {
    const Real dt(in.dt), half(0.5);
    Mat3<Real> now[point_count];
    Real middle_volume[point_count], total(0.0), middle_total(0.0), growth(0.0);
    for (int p = 0; p < point_count; ++p) {
      const auto& table = Topology::rule.gradient[p];
      const Real weight(Topology::rule.weight[p]);
      now[p] = jacobian(in.x, table);
      Mat3<Real> c = cofactor(now[p]);
      carried.volume[p] = weight * determinant(now[p], c);
      for (int i = 0; i < 9; ++i) carried.weighted[p].m[i / 3][i % 3] = weight * c.m[i / 3][i % 3];
      total = p == 0 ? carried.volume[p] : total + carried.volume[p];

      // Gradient of the displacement increment in the geometry of the middle of the step.
      Mat3<Real> step = jacobian(in.v, table), middle;
      for (int i = 0; i < 9; ++i) {
        Real& entry = step.m[i / 3][i % 3];
        entry = dt * entry;
        middle.m[i / 3][i % 3] = now[p].m[i / 3][i % 3] - half * entry;
      }
      c = cofactor(middle);
      const Real det = determinant(middle, c), inverse = Real(1.0) / det;
      Mat3<Real>& g = motion.point[p].gradient;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          g.m[i][k] =
              inverse * (step.m[i][0] * c.m[k][0] + step.m[i][1] * c.m[k][1] + step.m[i][2] * c.m[k][2]);
      middle_volume[p] = weight * det;
      middle_total = p == 0 ? middle_volume[p] : middle_total + middle_volume[p];
      growth = growth + middle_volume[p] * (g.m[0][0] + g.m[1][1] + g.m[2][2]);
      const Real smaller = min(carried.volume[p], middle_volume[p]);
      motion.least = p == 0 ? smaller : min(motion.least, smaller);
    }
    motion.volume = total;
    motion.length = Topology::length(in.x, total);

    Real reference_total = in.reference_volume[0];
    for (int p = 1; p < point_count; ++p) reference_total = reference_total + in.reference_volume[p];
    const Real mean_ratio = total / reference_total, mean_growth = growth / middle_total, third(1.0 / 3.0);
    for (int p = 0; p < point_count; ++p) {
      auto& point = motion.point[p];
      const Real ratio = carried.volume[p] / in.reference_volume[p];
      point.volume_ratio = MeanDilatation ? mean_ratio : ratio;
      Real scale(1.0);
      if constexpr (MeanDilatation) {
        Mat3<Real>& g = point.gradient;
        const Real more = third * (mean_growth - (g.m[0][0] + g.m[1][1] + g.m[2][2]));
        for (int i = 0; i < 3; ++i) g.m[i][i] = g.m[i][i] + more;
        if (in.needs_F) scale = cbrt(mean_ratio / ratio);
      }
      if (!in.needs_F) continue;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          point.F.m[i][k] =
              scale * (now[p].m[i][0] * own.get(9 * p + k) + now[p].m[i][1] * own.get(9 * p + 3 + k) +
                       now[p].m[i][2] * own.get(9 * p + 6 + k));
    }
  }

  template <class Real>
  void turn(const StepRotation<Real>*, Record<Real>, Carried<Real>&) const {}

  /// f_a = sum over points of volume * stress grad N_a; with mean dilatation every point has the mean
  /// pressure.
  template <class Real>
  void force(const ElementAnswer<Real, point_count>& e, Record<Real>, Carried<Real>& carried,
             Vec3<Real>* force, Real& hourglass_work) const {
    hourglass_work = Real(0.0);
    const Real third(1.0 / 3.0);
    Real pressure(0.0);  // mean of the mean stresses
    if constexpr (MeanDilatation) {
      for (int p = 0; p < point_count; ++p) pressure = pressure + carried.volume[p] * trace(e.stress[p]);
      pressure = third * pressure / e.volume;
    }
    for (int a = 0; a < node_count; ++a) force[a] = {Real(0.0), Real(0.0), Real(0.0)};
    for (int p = 0; p < point_count; ++p) {
      Sym3<Real> s = e.stress[p];
      if constexpr (MeanDilatation) s = s + base::spherical(pressure - third * trace(s));
      // stress * cofactor once per point, then one small product per node
      const Mat3<Real>& c = carried.weighted[p];
      Vec3<Real> column[3];
      for (int k = 0; k < 3; ++k)
        column[k] = {s.xx * c.m[0][k] + s.xy * c.m[1][k] + s.zx * c.m[2][k],
                     s.xy * c.m[0][k] + s.yy * c.m[1][k] + s.yz * c.m[2][k],
                     s.zx * c.m[0][k] + s.yz * c.m[1][k] + s.zz * c.m[2][k]};
      for (int a = 0; a < node_count; ++a)
        for (int k = 0; k < 3; ++k)
          if (Topology::rule.gradient[p][a][k] != 0.0)
            force[a] = force[a] + Real(Topology::rule.gradient[p][a][k]) * column[k];
    }
  }
};

}  // namespace cleave::discretisation::fem
