#pragma once
/// What a solid element says to its block. All functions are templates on Real: eight lanes, or one double.
///
/// An element description `E` has
///   static constexpr int node_count, point_count;
///   static constexpr model::Shape shape;
///   template <class Real> struct Carried;        what the strain pass leaves for the force pass, all Real
///   int own_size() const;                        reference data and history of its own per element
///   void reference(const Vec3<Real>* x, Real* volume, Record<Real> own) const;
///       reference volume of each point [length^3]; fills its own record
///   void spread_mass(double mass, give(node, share)) const;
///   void strain(const ElementInput<Real>&, Record<Real> own, ElementMotion<Real, P>&, Carried<Real>&) const;
///   void turn(const StepRotation<Real>*, Record<Real> own, Carried<Real>&) const;
///       the rotations of the step are known now: turn vectors and tensors of the own record
///   void force(const ElementAnswer<Real, P>&, Record<Real> own, Carried<Real>&, Vec3<Real>* force,
///              Real& hourglass_work) const;
///       internal nodal forces [force], and the work done against hourglass modes in the step [energy]
/// See hex8_one_point.cpp for the shortest one.
///
/// A description with `static constexpr bool averages_at_nodes = true` takes its volume change and gives its
/// mean stress by way of averages at the nodes (node_average.hpp); it has besides
///   void volumes(const Vec3<Real>* x, const Vec3<Real>* v, double dt, Real* out) const;
///       volume at t_n+1, at mid-step, and its growth in the step [length^3]
///   void pressure_force(const Vec3<Real>* x, const Real& mean_stress, Vec3<Real>* force) const;
///       what force() leaves out
/// and its Carried has a member mean_stress.

#include "base/tensor.hpp"
#include "discretisation/fem/kinematics.hpp"

namespace cleave::discretisation::fem {

using base::lane_count;
using base::Lanes;

/// One element's (or eight elements') stretch of an array [component][lane].
template <class Real>
struct Record;

template <>
struct Record<Lanes> {
  double* at;
  Lanes get(int component) const { return Lanes::load(at + component * lane_count); }
  void set(int component, Lanes value) const { value.store(at + component * lane_count); }
  Record from(int component) const { return {at + component * lane_count}; }
};

/// The scalar twin: `at` points at the lane of the element.
template <>
struct Record<double> {
  double* at;
  double get(int component) const { return at[component * lane_count]; }
  void set(int component, double value) const { at[component * lane_count] = value; }
  Record from(int component) const { return {at + component * lane_count}; }
};

template <class Real>
Sym3<Real> get_tensor(Record<Real> r, int first) {
  return {r.get(first),     r.get(first + 1), r.get(first + 2),
          r.get(first + 3), r.get(first + 4), r.get(first + 5)};
}
template <class Real>
void set_tensor(Record<Real> r, int first, const Sym3<Real>& t) {
  r.set(first, t.xx);
  r.set(first + 1, t.yy);
  r.set(first + 2, t.zz);
  r.set(first + 3, t.xy);
  r.set(first + 4, t.yz);
  r.set(first + 5, t.zx);
}
template <class Real>
Vec3<Real> get_vector(Record<Real> r, int first) {
  return {r.get(first), r.get(first + 1), r.get(first + 2)};
}
template <class Real>
void set_vector(Record<Real> r, int first, const Vec3<Real>& v) {
  r.set(first, v.x);
  r.set(first + 1, v.y);
  r.set(first + 2, v.z);
}
template <class Real>
Vec3<Real> apply(const Mat3<Real>& q, const Vec3<Real>& v) {
  return {q.m[0][0] * v.x + q.m[0][1] * v.y + q.m[0][2] * v.z,
          q.m[1][0] * v.x + q.m[1][1] * v.y + q.m[1][2] * v.z,
          q.m[2][0] * v.x + q.m[2][1] * v.y + q.m[2][2] * v.z};
}

/// Description of an element that takes averages at its nodes.
template <class Element>
concept AveragesAtNodes = requires {
  requires Element::averages_at_nodes;
};

/// Means over the nodes of an element of the averages there.
template <class Real>
struct NodeMeans {
  Real ratio;   ///< volume at t_n+1 over reference volume [-]
  Real middle;  ///< volume at mid-step over reference volume [-]
  Real growth;  ///< growth of the volume in the step over reference volume [-]
};

/// Nodal values of a step.
template <class Real>
struct ElementInput {
  const Vec3<Real>* x;           ///< at t_n+1 [length]
  const Vec3<Real>* v;           ///< at t_n+1/2 [length/time]
  const Real* reference_volume;  ///< [point] [length^3]
  double dt;
  bool needs_F;
  const NodeMeans<Real>* means = nullptr;  ///< only for elements that average, and only in a step
};

/// How the points of an element moved.
template <class Real, int Points>
struct ElementMotion {
  struct Point {
    Mat3<Real> gradient;  ///< of the displacement increment, in the mid-step geometry [-]
    Real volume_ratio;    ///< at t_n+1 [-]
    Mat3<Real> F;         ///< if asked for [-]
  } point[Points];
  Real volume;  ///< of the element at t_n+1 [length^3]
  Real least;   ///< smallest volume or Jacobian met, here and at mid-step: not positive means inverted
  Real length;  ///< for the stable step and the bulk viscosity [length]
};

/// What is known when forces are computed.
template <class Real, int Points>
struct ElementAnswer {
  Sym3<Real> stress[Points];  ///< Cauchy, with viscosity and damping, at t_n+1 [stress]
  Real volume;                ///< at t_n+1 [length^3]
  Real size;                  ///< cube root of the volume [length]
  Real density;               ///< at t_n+1 [mass/length^3]
  Real modulus, shear;        ///< longitudinal and shear modulus, mean of the points [stress]
  double dt;
};

}  // namespace cleave::discretisation::fem
