/// *BOUNDARY_PRESCRIBED_MOTION_NODE and _SET: translations along a global axis or a vector, rotations about a
/// line along a global axis.

#include <algorithm>
#include <cstdlib>

#include "model/keyword/handler.hpp"
#include "model/keyword/over_time.hpp"

namespace cleave::model {
namespace {

bool same(const Vector& a, const Vector& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

void take_motion(Draft& draft, const Entry& entry) {
  PrescribedMotion motion;
  motion.id = entry.own_id();
  motion.title = entry.title();
  const bool by_set = entry.keyword() == "BOUNDARY_PRESCRIBED_MOTION_SET";
  motion.place = entry.place(by_set ? "NSID" : "NID");
  if (by_set) {
    const auto* set = draft.node_set(entry, "NSID");
    if (!set) return;
    motion.nodes = *set;
  } else {
    const Index node = draft.node(entry, "NID");
    if (node < 0) return;
    motion.nodes = {node};
  }

  const auto dof = entry.integer("DOF");
  switch (dof < 0 && dof >= -12 ? -dof : dof) {
    case 1:
      motion.direction = {1, 0, 0};
      break;
    case 2:
      motion.direction = {0, 1, 0};
      break;
    case 3:
      motion.direction = {0, 0, 1};
      break;
    case 4: {
      const Id vid = entry.id(IdKind::definition, "VID");
      const auto at = draft.vectors.find(vid);
      if (at == draft.vectors.end())
        return draft.error(entry, "VID", "vector " + std::to_string(vid) + " is not defined",
                           "add a *DEFINE_VECTOR");
      motion.direction = at->second;
      motion.only_direction = dof > 0;
      break;
    }
    case 5:
    case 6:
    case 7:
    case 8:
      return draft.refuse(entry, "DOF",
                          "a rotation (DOF " + std::to_string(dof) + "): nodes of solids have none",
                          "prescribe the translations that the rotation makes");
    case 9:
    case 10:
    case 11: {
      // Offsets in the plane across the axis, in cyclic order: y z, z x, x y.
      const double first = entry.real("OFFSET1", a_length), second = entry.real("OFFSET2", a_length);
      const int axis = static_cast<int>(dof < 0 ? -dof : dof) - 9;
      motion.rotation = true;
      motion.radial_free = dof < 0;
      motion.direction = axis == 0 ? Vector{1, 0, 0} : axis == 1 ? Vector{0, 1, 0} : Vector{0, 0, 1};
      motion.centre = axis == 0   ? Vector{0, first, second}
                      : axis == 1 ? Vector{second, 0, first}
                                  : Vector{first, second, 0};
      draft.refuse_turned(entry, "a rotation about a global axis");
      break;
    }
    case 12:
      return draft.refuse(entry, "DOF", "motion along the normals of segments (DOF 12)",
                          "prescribe translations (DOF 1, 2, 3 or 4)");
    default:
      return draft.error(entry, "DOF",
                         "found " + std::to_string(dof) +
                             ", expected 1, 2, 3 (x, y, z), 4, -4 (along VID) or 9, 10, 11 (about x, y, z)");
  }
  if (dof < 0 && dof != -4 && !motion.rotation)
    return draft.error(entry, "DOF", "found " + std::to_string(dof) + ", expected 1, 2 or 3",
                       "only 4, 9, 10 and 11 may be negative here");
  if (entry.integer("LRB") != 0)
    return draft.refuse(entry, "LRB", "motion relative to a rigid body",
                        "prescribe the motion in global axes");

  const auto vad = entry.integer("VAD");
  if (vad == 3) {
    motion.kind = PrescribedMotion::Kind::velocity_by_displacement;
    if (motion.rotation)
      return draft.refuse(entry, "VAD", "speed of rotation over angle (VAD 3)",
                          "give it over time (0), or the angle over time (2)");
  } else if (vad == 4) {
    return draft.refuse(entry, "VAD", "relative displacement (VAD 4) is one of rigid bodies",
                        "give the displacement (2) over time");
  } else if (!kind_over_time(vad, motion.kind)) {
    return draft.error(
        entry, "VAD", "found " + std::to_string(vad) + ", expected 0 to 4",
        "velocity (0), acceleration (1) or displacement (2) over time, velocity over displacement (3)");
  }
  if (!read_over_time(draft, entry, motion)) return;

  // Rows that differ only in their node are one motion.
  auto& all = draft.model.motions;
  if (!by_set && !draft.first_of_block && motion.id == 0 && motion.title.empty() && !all.empty()) {
    PrescribedMotion& last = all.back();
    if (last.id == 0 && last.title.empty() && last.kind == motion.kind &&
        same(last.direction, motion.direction) && last.only_direction == motion.only_direction &&
        last.rotation == motion.rotation && same(last.centre, motion.centre) &&
        last.radial_free == motion.radial_free && last.curve == motion.curve && last.scale == motion.scale &&
        last.birth == motion.birth && last.death == motion.death) {
      last.nodes.push_back(motion.nodes[0]);
      return;
    }
  }
  all.push_back(std::move(motion));
}

constexpr std::string_view fields = "ID HEADING NID NSID DOF VAD LCID SF VID DEATH BIRTH OFFSET1 OFFSET2 LRB";
constexpr std::string_view remark = "VAD 4, LRB, NODE1 and NODE2 are those of rigid bodies";
constexpr Handler handlers[] = {
    {.keyword = "BOUNDARY_PRESCRIBED_MOTION_NODE", .honoured = fields, .take = take_motion, .remark = remark},
    {.keyword = "BOUNDARY_PRESCRIBED_MOTION", .honoured = fields, .take = take_motion, .remark = remark},
    {.keyword = "BOUNDARY_PRESCRIBED_MOTION_SET", .honoured = fields, .take = take_motion, .remark = remark},
};

}  // namespace
extern const Family motion_cards{handlers};

}  // namespace cleave::model
