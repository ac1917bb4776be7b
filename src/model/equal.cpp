#include "model/equal.hpp"

#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "model/elasticity.hpp"
#include "model/material/law.hpp"

namespace cleave::model {
namespace {

// One overload of same() per kind of member; each compares everything the struct holds.

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
bool same(const T& a, const T& b) {
  return a == b;
}
bool same(const std::string& a, const std::string& b) {
  return a == b;
}
bool same(const Vector& a, const Vector& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
bool close(const Vector& a, const Vector& b) {
  return std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + std::fabs(a.z - b.z) <= 1e-12;
}
template <class T, std::size_t n>
bool same(const T (&a)[n], const T (&b)[n]) {
  return std::equal(a, a + n, b, [](const T& x, const T& y) { return same(x, y); });
}
template <class A, class B>
bool same(const std::pair<A, B>& a, const std::pair<A, B>& b) {
  return a.first == b.first && a.second == b.second;
}
bool same(const Segment& a, const Segment& b) {
  return same(a.node, b.node);
}
bool same(const Frame& a, const Frame& b) {
  return same(a.axis, b.axis) && same(a.origin, b.origin);
}
bool same(const MaterialCard::Value& a, const MaterialCard::Value& b) {
  return a.name == b.name && a.text == b.text && a.number == b.number;
}
bool same(const Termination::NodeBound& a, const Termination::NodeBound& b) {
  return a.node == b.node && a.stop == b.stop && a.maximum == b.maximum && a.minimum == b.minimum;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const T& x, const T& y) { return same(x, y); });
}
bool same(const std::vector<bool>& a, const std::vector<bool>& b) {
  return a == b;
}
template <class M>
bool same(const Set<M>& a, const Set<M>& b) {
  return a.id == b.id && a.title == b.title && same(a.members, b.members);
}
bool same(const Curve& a, const Curve& b) {
  return a.id == b.id && a.title == b.title && same(a.x, b.x) && same(a.y, b.y);
}
bool same(const Table& a, const Table& b) {
  return a.id == b.id && a.title == b.title && same(a.value, b.value) && same(a.curve, b.curve);
}
bool same(const Elements& a, const Elements& b) {
  return a.shape == b.shape && same(a.id, b.id) && same(a.part, b.part) && same(a.node, b.node);
}
bool same(const Hourglass& a, const Hourglass& b) {
  return a.type == b.type && a.coefficient == b.coefficient && a.quadratic_bulk == b.quadratic_bulk &&
         a.linear_bulk == b.linear_bulk;
}
bool same(const Section& a, const Section& b) {
  return a.id == b.id && a.title == b.title && a.family == b.family && a.form == b.form &&
         same(a.numbers, b.numbers);
}
bool same(const MaterialCard& a, const MaterialCard& b) {
  return a.id == b.id && a.keyword == b.keyword && a.title == b.title && same(a.values, b.values);
}
bool same(const Elasticity& a, const Elasticity& b) {
  return a.isotropic == b.isotropic && a.young == b.young && a.poisson == b.poisson &&
         same(a.modulus, b.modulus) && a.poisson_ba == b.poisson_ba && a.poisson_ca == b.poisson_ca &&
         a.poisson_cb == b.poisson_cb && a.shear_ab == b.shear_ab && a.shear_bc == b.shear_bc &&
         a.shear_ca == b.shear_ca && a.axes == b.axes && same(a.frame, b.frame) &&
         same(a.reference, b.reference) && a.angle == b.angle;
}
bool same_elastic(const Elasticity* a, const Elasticity* b) {
  return a && b ? same(*a, *b) : a == b;
}
bool same_law(const Law* a, const Law* b) {
  if (!a || !b) return a == b;
  return typeid(*a) == typeid(*b) && a->state_size() == b->state_size() &&
         a->longitudinal_modulus() == b->longitudinal_modulus() && a->shear_modulus() == b->shear_modulus();
}
bool same(const Part& a, const Part& b) {
  return a.id == b.id && a.title == b.title && same(a.section, b.section) && a.material_id == b.material_id &&
         a.state_id == b.state_id && a.material_keyword == b.material_keyword &&
         same_law(a.law.get(), b.law.get()) && same_elastic(a.elastic.get(), b.elastic.get()) &&
         a.density == b.density && same(a.hourglass, b.hourglass) && a.mass_damping == b.mass_damping &&
         a.mass_damping_curve == b.mass_damping_curve && same(a.mass_damping_factor, b.mass_damping_factor) &&
         a.stiffness_damping == b.stiffness_damping && (a.rigid != nullptr) == (b.rigid != nullptr) &&
         (a.inertia != nullptr) == (b.inertia != nullptr);
}
bool same(const FixedNodes& a, const FixedNodes& b) {
  return a.id == b.id && a.title == b.title && same(a.nodes, b.nodes) && a.directions == b.directions &&
         a.local == b.local && same(a.frame, b.frame) && a.birth == b.birth && a.death == b.death;
}
bool same(const PrescribedMotion& a, const PrescribedMotion& b) {
  return a.id == b.id && a.title == b.title && same(a.nodes, b.nodes) && a.kind == b.kind &&
         same(a.direction, b.direction) && a.only_direction == b.only_direction && a.rotation == b.rotation &&
         same(a.centre, b.centre) && a.radial_free == b.radial_free && a.curve == b.curve &&
         a.scale == b.scale && a.birth == b.birth && a.death == b.death;
}
bool same(const NodeLoad& a, const NodeLoad& b) {
  return same(a.nodes, b.nodes) && same(a.direction, b.direction) && a.follower == b.follower &&
         same(a.follow, b.follow) && a.curve == b.curve && a.scale == b.scale;
}
bool same(const SegmentLoad& a, const SegmentLoad& b) {
  return same(a.segments, b.segments) && a.quadratic == b.quadratic && a.curve == b.curve &&
         a.scale == b.scale && a.arrival == b.arrival;
}
bool same(const BodyLoad& a, const BodyLoad& b) {
  return same(a.direction, b.direction) && a.rotation == b.rotation && same(a.centre, b.centre) &&
         a.curve == b.curve && a.scale == b.scale && same(a.nodes, b.nodes) && a.angular == b.angular &&
         a.generalized == b.generalized;
}
bool same(const RigidWall& a, const RigidWall& b) {
  return a.id == b.id && a.title == b.title && same(a.nodes, b.nodes) && same(a.origin, b.origin) &&
         close(a.normal, b.normal) && a.finite == b.finite && close(a.edge_l, b.edge_l) &&
         close(a.edge_m, b.edge_m) && a.length_l == b.length_l && a.length_m == b.length_m &&
         a.shape == b.shape && a.geometric == b.geometric && a.length_n == b.length_n &&
         a.radius == b.radius && a.interior == b.interior && a.penalty == b.penalty &&
         a.friction == b.friction && a.velocity_limit == b.velocity_limit && a.orthotropic == b.orthotropic &&
         same(a.static_friction, b.static_friction) && same(a.dynamic_friction, b.dynamic_friction) &&
         same(a.friction_decay, b.friction_decay) && close(a.friction_axis, b.friction_axis) &&
         same(a.friction_node, b.friction_node) && a.mass == b.mass && a.speed == b.speed &&
         a.motion == b.motion && a.motion_is_displacement == b.motion_is_displacement &&
         close(a.motion_direction, b.motion_direction) && a.birth == b.birth && a.death == b.death &&
         a.soft_cycles == b.soft_cycles;
}
bool same(const base::Sym3<double>& a, const base::Sym3<double>& b) {
  return a.xx == b.xx && a.yy == b.yy && a.zz == b.zz && a.xy == b.xy && a.yz == b.yz && a.zx == b.zx;
}
bool same(const RigidInertia& a, const RigidInertia& b) {
  return same(a.centre, b.centre) && a.node == b.node && a.mass == b.mass && same(a.tensor, b.tensor) &&
         same(a.velocity, b.velocity) && same(a.spin, b.spin);
}
bool same(const RigidHold& a, const RigidHold& b) {
  return a.directions == b.directions && a.local == b.local && same(a.frame, b.frame);
}
bool same(const RigidBody& a, const RigidBody& b) {
  return a.id == b.id && a.title == b.title && a.parts == b.parts && a.nodes == b.nodes &&
         a.extra == b.extra && a.added == b.added && same(a.hold, b.hold) && a.has_axes == b.has_axes &&
         same(a.axes, b.axes) && a.has_velocity == b.has_velocity && same(a.velocity, b.velocity) &&
         same(a.spin, b.spin) &&
         (a.inertia && b.inertia ? same(*a.inertia, *b.inertia) : a.inertia == b.inertia);
}
bool same(const RigidMotion& a, const RigidMotion& b) {
  return a.id == b.id && a.title == b.title && a.body == b.body && a.rotation == b.rotation &&
         a.local == b.local && same(a.direction, b.direction) && a.only_direction == b.only_direction &&
         a.kind == b.kind && a.curve == b.curve && a.scale == b.scale && a.birth == b.birth &&
         a.death == b.death;
}
bool same(const RigidLoad& a, const RigidLoad& b) {
  return a.id == b.id && a.title == b.title && a.body == b.body && a.moment == b.moment &&
         same(a.direction, b.direction) && a.follower == b.follower && same(a.follow, b.follow) &&
         a.curve == b.curve && a.scale == b.scale;
}
bool same(const ContactSide& a, const ContactSide& b) {
  return a.type == b.type && a.id == b.id && a.parts == b.parts && same(a.segments, b.segments) &&
         a.nodes == b.nodes;
}
bool same(const Contact& a, const Contact& b) {
  return a.keyword == b.keyword && a.id == b.id && a.named == b.named && a.title == b.title &&
         a.search == b.search && a.automatic == b.automatic && a.eroding == b.eroding && a.tied == b.tied &&
         a.offset == b.offset && a.joins == b.joins && a.tie_distance == b.tie_distance && same(a.a, b.a) &&
         same(a.b, b.b) && a.static_friction == b.static_friction &&
         a.dynamic_friction == b.dynamic_friction && a.friction_decay == b.friction_decay &&
         a.viscous_limit == b.viscous_limit && a.part_friction == b.part_friction && a.damping == b.damping &&
         a.birth == b.birth && a.death == b.death && a.scale_a == b.scale_a && a.scale_b == b.scale_b &&
         a.soft == b.soft && a.soft_scale == b.soft_scale && a.solid_thickness == b.solid_thickness &&
         a.solid_modulus == b.solid_modulus && a.extension == b.extension && a.ignore == b.ignore &&
         a.release == b.release;
}
bool same(const ContactControl& a, const ContactControl& b) {
  return a.stiffness == b.stiffness && a.penalty == b.penalty && a.orient == b.orient &&
         a.ignore == b.ignore && a.shell_thickness == b.shell_thickness;
}
bool same(const AbsorbingFaces& a, const AbsorbingFaces& b) {
  return same(a.segments, b.segments) && a.dilatational == b.dilatational && a.shear == b.shear;
}
bool same(const Precrack& a, const Precrack& b) {
  return a.part == b.part && same(a.points, b.points);
}
bool same(const IncidentWave& a, const IncidentWave& b) {
  return same(a.segments, b.segments) && a.kind == b.kind && same(a.direction, b.direction) &&
         same(a.polarisation, b.polarisation) && same(a.reference, b.reference) && a.curve == b.curve &&
         a.scale == b.scale && a.arrival == b.arrival;
}
bool same(const InitialStress& a, const InitialStress& b) {
  return a.shell == b.shell && a.element == b.element && same(a.stress, b.stress);
}
bool same(const PointMass& a, const PointMass& b) {
  return a.id == b.id && a.node == b.node && a.mass == b.mass;
}
bool same(const GlobalDamping& a, const GlobalDamping& b) {
  return a.curve == b.curve && a.value == b.value && same(a.factor, b.factor);
}
bool same(const Interval& a, const Interval& b) {
  return a.every == b.every && a.curve == b.curve;
}

bool same(const TimeStepControl& a, const TimeStepControl& b) {
  return a.first == b.first && a.safety == b.safety && a.mass_scaling == b.mass_scaling &&
         a.mass_scaling_curve == b.mass_scaling_curve && a.mass_scaling_fraction == b.mass_scaling_fraction &&
         a.mass_scaling_first_only == b.mass_scaling_first_only && a.limit_curve == b.limit_curve &&
         a.erode == b.erode;
}
bool same(const Termination& a, const Termination& b) {
  return a.time == b.time && a.cycles == b.cycles && a.step_fraction == b.step_fraction &&
         a.energy_change == b.energy_change && a.mass_change == b.mass_change &&
         a.no_solution_check == b.no_solution_check && same(a.nodes, b.nodes);
}
bool same(const SpacetimeControl& a, const SpacetimeControl& b) {
  return a.space == b.space && a.degree == b.degree && a.chi == b.chi && a.progress == b.progress &&
         a.eps == b.eps && a.height_factor == b.height_factor && a.height_cap == b.height_cap &&
         a.smoothing == b.smoothing && a.threads == b.threads && a.verify == b.verify &&
         a.subdivision == b.subdivision && a.repeat == b.repeat;
}
bool same(const BulkViscosity& a, const BulkViscosity& b) {
  return a.quadratic == b.quadratic && a.linear == b.linear && a.type == b.type;
}
bool same(const EnergyControl& a, const EnergyControl& b) {
  return a.hourglass == b.hourglass && a.wall == b.wall && a.sliding == b.sliding && a.damping == b.damping;
}

template <class T>
std::string in_list(std::string_view name, const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size())
    return std::string(name) + ": " + std::to_string(a.size()) + " against " + std::to_string(b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i], b[i])) return std::string(name) + "[" + std::to_string(i) + "]";
  return {};
}

}  // namespace

std::string first_difference(const Model& a, const Model& b) {
#define CLEAVE_COMPARE(member) \
  if (!same(a.member, b.member)) return #member;
#define CLEAVE_COMPARE_LIST(member) \
  if (std::string d = in_list(#member, a.member, b.member); !d.empty()) return d;
  CLEAVE_COMPARE(title)
  CLEAVE_COMPARE_LIST(mesh.nodes.id)
  CLEAVE_COMPARE_LIST(mesh.nodes.position)
  CLEAVE_COMPARE_LIST(mesh.solids)
  CLEAVE_COMPARE_LIST(mesh.shells)
  CLEAVE_COMPARE_LIST(mesh.beams)
  CLEAVE_COMPARE_LIST(parts)
  CLEAVE_COMPARE_LIST(materials)
  CLEAVE_COMPARE_LIST(curves)
  CLEAVE_COMPARE_LIST(tables)
  CLEAVE_COMPARE_LIST(node_sets)
  CLEAVE_COMPARE_LIST(part_sets)
  CLEAVE_COMPARE_LIST(solid_sets)
  CLEAVE_COMPARE_LIST(shell_sets)
  CLEAVE_COMPARE_LIST(beam_sets)
  CLEAVE_COMPARE_LIST(segment_sets)
  CLEAVE_COMPARE_LIST(fixed)
  CLEAVE_COMPARE_LIST(motions)
  CLEAVE_COMPARE_LIST(node_loads)
  CLEAVE_COMPARE_LIST(segment_loads)
  CLEAVE_COMPARE_LIST(body_loads)
  CLEAVE_COMPARE_LIST(walls)
  CLEAVE_COMPARE_LIST(contacts)
  CLEAVE_COMPARE_LIST(rigid_bodies)
  CLEAVE_COMPARE_LIST(rigid_motions)
  CLEAVE_COMPARE_LIST(rigid_loads)
  CLEAVE_COMPARE_LIST(absorbing)
  CLEAVE_COMPARE_LIST(precracks)
  CLEAVE_COMPARE_LIST(incident_waves)
  CLEAVE_COMPARE_LIST(initial_stress)
  CLEAVE_COMPARE_LIST(point_masses)
  CLEAVE_COMPARE_LIST(global_damping)
  CLEAVE_COMPARE_LIST(initial_velocity)
  CLEAVE_COMPARE(control.step)
  CLEAVE_COMPARE(control.end)
  CLEAVE_COMPARE(control.viscosity)
  CLEAVE_COMPARE(control.energy)
  CLEAVE_COMPARE(control.hourglass)
  CLEAVE_COMPARE(control.invariant_node_numbering)
  CLEAVE_COMPARE(control.contact)
  CLEAVE_COMPARE(control.solid_sort)
  CLEAVE_COMPARE(control.spacetime)
  CLEAVE_COMPARE(requests.title)
  CLEAVE_COMPARE(requests.field)
  CLEAVE_COMPARE(requests.glstat)
  CLEAVE_COMPARE(requests.matsum)
  CLEAVE_COMPARE(requests.nodout)
  CLEAVE_COMPARE(requests.elout)
  CLEAVE_COMPARE(requests.rwforc)
  CLEAVE_COMPARE(requests.spcforc)
  CLEAVE_COMPARE(requests.rcforc)
  CLEAVE_COMPARE(requests.sleout)
  CLEAVE_COMPARE(requests.ncforc)
  CLEAVE_COMPARE(requests.rbdout)
  CLEAVE_COMPARE(requests.restart_cycles)
  CLEAVE_COMPARE(requests.running_restart_cycles)
  CLEAVE_COMPARE_LIST(requests.history_nodes)
  CLEAVE_COMPARE_LIST(requests.history_node_titles)
  CLEAVE_COMPARE_LIST(requests.history_solids)
  CLEAVE_COMPARE_LIST(requests.history_shells)
  CLEAVE_COMPARE_LIST(requests.history_beams)
#undef CLEAVE_COMPARE_LIST
#undef CLEAVE_COMPARE
  return {};
}

}  // namespace cleave::model
