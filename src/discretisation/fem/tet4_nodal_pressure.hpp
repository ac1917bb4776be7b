#pragma once
/// Tetrahedron with four nodes whose volume change is averaged at nodes.
///
/// With V and v the reference and current volumes of the elements around node a, J_a = sum v / sum V, and an
/// element has the mean J of its four nodes instead of its own v / V. A block of tetrahedra then has one
/// volume constraint per node, not per element (five to six times as many), and does not lock.
///
/// Energy sum V W(J) gives the forces: delta J = mean over nodes of (sum delta v) / (sum V), so an element
/// feels, on its own dv/dx, the mean over its nodes of (sum V p) / (sum V).
/// Sources: Bonet & Burton, Commun. Numer. Meth. Engng 14 (1998) 437-449; Bonet, Marriott & Hassan, ibid. 17
/// (2001) 551-561; the mean of J at the nodes as Joldes, Wittek & Miller, ibid. 25 (2009) 827-836.

#include "discretisation/fem/tetrahedron.hpp"

namespace cleave::discretisation::fem {

struct Tet4NodalPressure {
  using Own = Isoparametric<Tet4, false>;
  static constexpr int node_count = 4, point_count = 1;
  static constexpr model::Shape shape = model::Shape::tet4;
  static constexpr bool averages_at_nodes = true;

  Own tet;

  template <class Real>
  struct Carried {
    Own::Carried<Real> tet;
    Real share;        ///< averaged volume over own volume at t_n+1 [-]
    Real mean_stress;  ///< a third of the trace, with viscosity and damping [stress]
  };

  int own_size() const { return tet.own_size(); }
  template <class Real>
  void reference(const Vec3<Real>* x, Real* volume, Record<Real> own) const {
    tet.reference(x, volume, own);
  }
  template <class Give>
  void spread_mass(double mass, const Give& give) const {
    tet.spread_mass(mass, give);
  }

  /// The increment of volume is that of the middle of the step, d = sum of v_mid tr G: exact to the same
  /// order as the other strains, and for a uniform gradient the strain is its trace.
  template <class Real>
  void volumes(const Vec3<Real>* x, const Vec3<Real>* v, double dt, Real* out) const {
    const auto& table = Tet4::rule.gradient[0];
    const Real weight(Tet4::rule.weight[0]), half(0.5), step_dt(dt);
    const auto now = jacobian(x, table);
    out[0] = weight * determinant(now, cofactor(now));
    Mat3<Real> step = jacobian(v, table), middle;
    for (int i = 0; i < 9; ++i) {
      Real& entry = step.m[i / 3][i % 3];
      entry = step_dt * entry;
      middle.m[i / 3][i % 3] = now.m[i / 3][i % 3] - half * entry;
    }
    const auto c = cofactor(middle);
    out[1] = weight * determinant(middle, c);
    Real growth(0.0);
    for (int i = 0; i < 9; ++i) growth = growth + c.m[i / 3][i % 3] * step.m[i / 3][i % 3];
    out[2] = weight * growth;
  }

  template <class Real>
  void strain(const ElementInput<Real>& in, Record<Real> own, ElementMotion<Real, 1>& motion,
              Carried<Real>& carried) const {
    tet.strain(in, own, motion, carried.tet);
    carried.share = Real(1.0);
    if (!in.means) return;
    auto& point = motion.point[0];
    auto& g = point.gradient;
    const Real more =
        Real(1.0 / 3.0) * (in.means->growth / in.means->middle - (g.m[0][0] + g.m[1][1] + g.m[2][2]));
    for (int i = 0; i < 3; ++i) g.m[i][i] = g.m[i][i] + more;
    carried.share = in.means->ratio / point.volume_ratio;
    point.volume_ratio = in.means->ratio;
    if (!in.needs_F) return;
    const Real scale = cbrt(carried.share);
    for (int i = 0; i < 9; ++i) point.F.m[i / 3][i % 3] = scale * point.F.m[i / 3][i % 3];
  }

  template <class Real>
  void turn(const StepRotation<Real>*, Record<Real>, Carried<Real>&) const {}

  /// Forces of the deviator. Its energy is counted per averaged volume, so that is what it acts on.
  template <class Real>
  void force(const ElementAnswer<Real, 1>& e, Record<Real> own, Carried<Real>& carried, Vec3<Real>* force,
             Real& hourglass_work) const {
    carried.mean_stress = Real(1.0 / 3.0) * trace(e.stress[0]);
    ElementAnswer<Real, 1> shape_change = e;
    shape_change.stress[0] = carried.share * (e.stress[0] - base::spherical(carried.mean_stress));
    tet.force(shape_change, own, carried.tet, force, hourglass_work);
  }

  template <class Real>
  void pressure_force(const Vec3<Real>* x, const Real& mean_stress, Vec3<Real>* force) const {
    const auto c = cofactor(jacobian(x, Tet4::rule.gradient[0]));
    const Real p = Real(Tet4::rule.weight[0]) * mean_stress;
    for (int a = 1; a < 4; ++a) force[a] = {p * c.m[0][a - 1], p * c.m[1][a - 1], p * c.m[2][a - 1]};
    force[0] = Real(-1.0) * (force[1] + force[2] + force[3]);
  }
};

}  // namespace cleave::discretisation::fem
