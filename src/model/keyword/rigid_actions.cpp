/// What drives rigid bodies, and what must not act on their nodes.

#include <algorithm>

#include "model/keyword/over_time.hpp"
#include "model/keyword/rigid_cards.hpp"
#include "model/keyword/row_place.hpp"

namespace cleave::model {
namespace {

Vector axis_of(std::int64_t k) {
  return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
}

/// Index of the body that a PID names; -1 with an error.
Index body_of(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::part, "PID");
  const Index part = draft.model.part_of(id);
  const auto& bodies = draft.model.rigid_bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (part >= 0 ? std::find(bodies[b].parts.begin(), bodies[b].parts.end(), part) != bodies[b].parts.end()
                  : bodies[b].parts.empty() && bodies[b].id == id)
      return static_cast<Index>(b);
  if (part < 0)
    draft.error(entry, "PID", "part " + std::to_string(id) + " is not defined",
                "name a part of *MAT_RIGID or a *CONSTRAINED_NODAL_RIGID_BODY");
  else if (draft.model.parts[static_cast<std::size_t>(part)].law)
    draft.error(entry, "PID", "part " + std::to_string(id) + " is not rigid", "give it *MAT_RIGID");
  return -1;
}

bool take_direction(Draft& draft, const Entry& entry, RigidMotion& motion) {
  const auto dof = entry.integer("DOF");
  const auto size = std::abs(dof);
  motion.rotation = size >= 5;
  motion.only_direction = dof > 0;
  if ((dof >= 1 && dof <= 3) || (dof >= 5 && dof <= 7)) {
    const auto k = (dof - 1) % 4;
    const RigidBody& body = draft.model.rigid_bodies[static_cast<std::size_t>(motion.body)];
    motion.direction = motion.local && body.has_axes ? body.axes.axis[k] : axis_of(k);
    return true;
  }
  if (size == 4 || size == 8) {
    const Id id = entry.id(IdKind::definition, "VID");
    const auto at = draft.vectors.find(id);
    if (at == draft.vectors.end())
      draft.error(entry, "VID", "vector " + std::to_string(id) + " is not defined", "add a *DEFINE_VECTOR");
    else
      motion.direction = at->second;
    return at != draft.vectors.end();
  }
  if (size >= 9 && size <= 11)
    draft.refuse(entry, "DOF", "motion about an axis beside the centre (DOF " + std::to_string(dof) + ")",
                 "prescribe the motion of the centre and the rotation");
  else
    draft.error(entry, "DOF",
                "found " + std::to_string(dof) + ", expected 1 to 3, 5 to 7, or 4 and 8 along VID");
  return false;
}

void take_motion(Draft& draft, const Entry& entry) {
  RigidMotion motion;
  motion.id = entry.own_id();
  motion.title = entry.title();
  motion.place = entry.place("PID");
  motion.local = entry.keyword().ends_with("_LOCAL");
  motion.body = body_of(draft, entry);
  if (motion.body < 0 || !take_direction(draft, entry, motion)) return;
  const auto vad = entry.integer("VAD");
  if (!kind_over_time(vad, motion.kind))
    return draft.refuse(entry, "VAD", "motion of kind " + std::to_string(vad),
                        "give velocity (0), acceleration (1) or displacement (2) over time");
  if (!read_over_time(draft, entry, motion)) return;
  draft.model.rigid_motions.push_back(std::move(motion));
}

void take_load(Draft& draft, const Entry& entry) {
  RigidLoad load;
  load.id = entry.own_id();
  load.title = entry.title();
  load.place = entry.place("PID");
  load.body = body_of(draft, entry);
  const auto dof = entry.integer("DOF");
  load.moment = dof >= 5;
  if (dof == 4 || dof == 8) {
    load.follower = true;
    load.follow[0] = draft.node(entry, "M1");
    load.follow[1] = draft.node(entry, "M2");
    load.follow[2] = draft.node(entry, "M3");
    if (*std::min_element(load.follow, load.follow + 3) < 0) return;
  } else if ((dof >= 1 && dof <= 3) || (dof >= 5 && dof <= 7)) {
    const Frame* frame = draft.frame(entry, "CID");
    if (!frame) return;
    load.direction = frame->axis[(dof - 1) % 4];
  } else {
    return draft.error(entry, "DOF",
                       "found " + std::to_string(dof) + ", expected 1 to 3 (force), 5 to 7 (moment), 4 or 8");
  }
  load.curve = draft.curve(entry, "LCID");
  load.scale = entry.real_or("SF", pure, 1.0);
  if (load.body >= 0 && load.curve >= 0) draft.model.rigid_loads.push_back(std::move(load));
}

void take_velocity(Draft& draft, const Entry& entry) {
  const Index body = body_of(draft, entry);
  const Frame* frame = draft.frame(entry, "ICID");
  if (body < 0 || !frame) return;
  draft.refuse_turned(entry, "an initial velocity");
  RigidBody& to = draft.model.rigid_bodies[static_cast<std::size_t>(body)];
  to.has_velocity = true;
  to.velocity = to_global(
      *frame, {entry.real("VX", a_velocity), entry.real("VY", a_velocity), entry.real("VZ", a_velocity)});
  to.spin =
      to_global(*frame, {entry.real("VXR", a_rate), entry.real("VYR", a_rate), entry.real("VZR", a_rate)});
}

/// Nodes of rigid bodies have one master: supports and motions of single nodes are errors.
class Masters {
 public:
  explicit Masters(Draft& draft)
      : draft_(draft), body_(body_of_nodes(draft.model.rigid_bodies, draft.model.mesh.nodes.count())) {
    fixed_.resize(body_.size());
    for (const FixedNodes& fixed : draft.model.fixed)
      if (fixed.birth <= 0.0 && fixed.death >= forever && (!fixed.local || (fixed.directions & 7u) == 7u))
        for (const Index node : fixed.nodes) fixed_[static_cast<std::size_t>(node)] |= fixed.directions;
    for (const RigidBody& body : draft.model.rigid_bodies) held_.push_back(body.hold.directions == 63u);
  }

  void check() {
    for (const FixedNodes& fixed : draft_.model.fixed)
      if (fixed.directions != 0)
        refuse(fixed.nodes, fixed.place, "BOUNDARY_SPC", "is held by itself",
               "hold the body: CMO, CON1 and CON2 of *MAT_RIGID, or *CONSTRAINED_NODAL_RIGID_BODY_SPC");
    for (const PrescribedMotion& motion : draft_.model.motions)
      refuse(motion.nodes, motion.place, "BOUNDARY_PRESCRIBED_MOTION", "is moved by itself",
             "move the body: *BOUNDARY_PRESCRIBED_MOTION_RIGID");
    for (RigidWall& wall : draft_.model.walls) leave_out(wall);
    for (const Contact& contact : draft_.model.contacts) check_sides(contact);
    for (const AbsorbingFaces& faces : draft_.model.absorbing)
      for (const Segment& face : faces.segments)
        if (refuse({face.node[0], face.node[1], face.node[2], face.node[3]}, faces.place,
                   "BOUNDARY_NON_REFLECTING", "lies on an absorbing face",
                   "no wave comes out of a rigid body"))
          break;
  }

 private:
  /// Can no node of a side ever be moved by a force?
  bool immovable(const ContactSide& side) const {
    return std::all_of(side.nodes.begin(), side.nodes.end(), [&](Index node) {
      const Index body = body_[static_cast<std::size_t>(node)];
      return body >= 0 ? held_[static_cast<std::size_t>(body)] != 0
                       : (fixed_[static_cast<std::size_t>(node)] & 7u) == 7u;
    });
  }

  void check_sides(const Contact& contact) {
    const bool single = contact.search == Contact::Search::single;
    if (contact.a.nodes.empty() || !immovable(contact.a) || (!single && !immovable(contact.b))) return;
    draft_.diagnostics.error(contact.place, contact.keyword, "",
                             "both sides of contact " + std::to_string(contact.id) +
                                 " are rigid without mass: no force can move them",
                             "at least one side must deform, or be a rigid body that is free to move");
  }

  /// A rigid wall stops single nodes; those of rigid bodies pass it, as in the established programs, unless
  /// RWPNAL gives them springs, which planar walls have.
  void leave_out(RigidWall& wall) {
    if (wall.penalty != 0.0) return;
    const auto rigid = [&](Index node) { return body_[static_cast<std::size_t>(node)] >= 0; };
    if (std::none_of(wall.nodes.begin(), wall.nodes.end(), rigid)) return;
    std::erase_if(wall.nodes, rigid);
    draft_.diagnostics.warning(
        wall.place, wall.keyword, "",
        "nodes of rigid bodies pass rigid walls: they are left out of wall " + std::to_string(wall.id),
        wall.geometric ? "mesh the wall as a rigid part that is held, and give a contact"
                       : "RWPNAL 1 of *CONTROL_CONTACT lets the wall push them");
  }

  bool refuse(const std::vector<Index>& nodes, deck::Place place, std::string keyword, std::string_view what,
              std::string hint) {
    for (const Index node : nodes) {
      const Index body = body_[static_cast<std::size_t>(node)];
      if (body < 0) continue;
      if (place.file < 0) {  // a code of *NODE
        const Id id = draft_.model.mesh.nodes.id[static_cast<std::size_t>(node)];
        place = row_places(draft_.deck, "NODE", IdKind::node, {id})[id];
        keyword = "NODE";
      }
      draft_.diagnostics.error(
          place, std::move(keyword), "",
          "node " + std::to_string(draft_.model.mesh.nodes.id[static_cast<std::size_t>(node)]) +
              " (and perhaps more) belongs to rigid body " +
              std::to_string(draft_.model.rigid_bodies[static_cast<std::size_t>(body)].id) + " and " +
              std::string(what),
          std::move(hint));
      return true;
    }
    return false;
  }

  Draft& draft_;
  std::vector<Index> body_;
  std::vector<unsigned> fixed_;  // [node] directions held from beginning to end
  std::vector<char> held_;       // [body] in all directions
};

}  // namespace

void finish_rigid_actions(Draft& draft) {
  for (const Entry& entry : draft.rigid.motions) take_motion(draft, entry);
  for (const Entry& entry : draft.rigid.loads) take_load(draft, entry);
  for (const Entry& entry : draft.rigid.velocities) take_velocity(draft, entry);
  const bool surfaces = !draft.model.contacts.empty() && !draft.model.mesh.shells.empty();
  if (!draft.model.rigid_bodies.empty() || surfaces) Masters(draft).check();
}

}  // namespace cleave::model
