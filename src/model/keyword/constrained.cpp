/// *CONSTRAINED_GLOBAL, *CONSTRAINED_LOCAL, *BOUNDARY_SPC_SYMMETRY_PLANE: nodes of a plane held.

#include <cmath>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

/// Nodes within `tolerance` of the plane through `point` with unit normal `normal`, out of `among`.
std::vector<Index> nodes_on_plane(const Draft& draft, const Vector& point, const Vector& normal,
                                  double tolerance, const std::vector<Index>& among) {
  std::vector<Index> nodes;
  for (const Index i : among)
    if (std::fabs(dot(draft.position(i) - point, normal)) <= tolerance) nodes.push_back(i);
  return nodes;
}

void add(Draft& draft, const Entry& entry, FixedNodes fixed, double tolerance) {
  if (fixed.nodes.empty())
    draft.warning(entry, "X", "no node lies within " + std::to_string(tolerance) + " of the plane");
  else
    draft.model.fixed.push_back(std::move(fixed));
}

void take_plane(Draft& draft, const Entry& entry) {
  const bool local = entry.keyword() == "CONSTRAINED_LOCAL";
  const auto direction = entry.integer("DIR");
  const auto tc = entry.integer("TC"), rc = entry.integer("RC");
  if (tc < 0 || tc > 7) return draft.error(entry, "TC", "found " + std::to_string(tc) + ", expected 0 to 7");
  if (rc < 0 || rc > 7) return draft.error(entry, "RC", "found " + std::to_string(rc) + ", expected 0 to 7");
  if (direction < 1 || direction > 3)
    return draft.error(
        entry, "DIR", "found " + std::to_string(direction) + ", expected 1, 2 or 3: the normal of the plane");
  draft.refuse_turned(entry, "a plane of constraints");

  FixedNodes fixed;
  fixed.place = entry.place("X");
  const Frame global;
  const Frame* frame = &global;
  Vector point = {entry.real("X", a_length), entry.real("Y", a_length), entry.real("Z", a_length)};
  if (local) {
    fixed.id = entry.own_id();
    fixed.title = entry.title();
    frame = draft.frame(entry, "CID");
    if (!frame) return;
    point = frame->origin + to_global(*frame, point);
    fixed.local = entry.integer("CID") != 0;
    if (fixed.local)
      for (int k = 0; k < 3; ++k) fixed.frame.axis[k] = frame->axis[k];
  }
  fixed.directions = direction_bits(tc) | direction_bits(rc) << 3;
  const double tolerance = entry.real_or("TOL", a_length, draft.plane_tolerance());
  fixed.nodes = nodes_on_plane(draft, point, frame->axis[direction - 1], tolerance, draft.all_nodes());
  add(draft, entry, std::move(fixed), tolerance);
}

/// Nodes of a part on a plane may not leave it, nor turn out of it.
void take_symmetry(Draft& draft, const Entry& entry) {
  FixedNodes fixed;
  fixed.place = entry.place("X");
  fixed.id = entry.integer("IDSP");
  std::vector<Index> among = draft.all_nodes();
  if (entry.integer("PID") != 0) {
    const Index part = draft.part(entry, "PID");
    if (part < 0) return;
    among = draft.nodes_of_parts({part});
  }
  const Vector written = {entry.card().real("VX"), entry.card().real("VY"), entry.card().real("VZ")};
  if (length(written) == 0.0) return draft.error(entry, "VX", "the normal of the plane has no length");
  const Vector normal = unit(entry.motion().direction(written));
  // Any two axes in the plane will do: take the global axis least along the normal.
  const Vector globals[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double along[] = {std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (along[k] < along[least]) least = k;
  make_frame(normal, globals[least], fixed.frame);
  fixed.local = true;
  fixed.directions = 1u | 1u << 4 | 1u << 5;
  const double tolerance = entry.real_or("TOL", a_length, draft.plane_tolerance());
  fixed.nodes = nodes_on_plane(draft, entry.point("X", "Y", "Z"), normal, tolerance, among);
  add(draft, entry, std::move(fixed), tolerance);
}

constexpr Handler handlers[] = {
    {.keyword = "CONSTRAINED_GLOBAL", .honoured = "TC RC DIR X Y Z TOL", .take = take_plane},
    {.keyword = "CONSTRAINED_LOCAL", .honoured = "ID HEADING TC RC DIR X Y Z CID TOL", .take = take_plane},
    {.keyword = "BOUNDARY_SPC_SYMMETRY_PLANE",
     .honoured = "IDSP PID X Y Z VX VY VZ TOL",
     .take = take_symmetry},
};

}  // namespace
extern const Family constrained_cards{handlers};

}  // namespace cleave::model
