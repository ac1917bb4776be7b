/// *RIGIDWALL_PLANAR with _FINITE, _MOVING and _FORCES.

#include <algorithm>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

void take_wall(Draft& draft, const Entry& entry) {
  RigidWall wall;
  wall.id = entry.own_id();
  wall.title = entry.title();
  auto nodes = draft.selected_nodes(entry);
  if (!nodes) return;

  // The normal runs from its tail (a point of the wall) to its head.
  wall.origin = entry.point("XT", "YT", "ZT");
  const Vector normal = entry.point("XH", "YH", "ZH") - wall.origin;
  if (length(normal) == 0.0)
    return draft.error(entry, "XH", "head and tail of the normal are the same point",
                       "XT YT ZT is a point of the wall, XH YH ZH the head of its outward normal");
  wall.normal = unit(normal);

  // OFFSET keeps only nodes near the wall.
  if (const double offset = entry.real("OFFSET", a_length); offset > 0.0)
    std::erase_if(*nodes,
                  [&](Index i) { return dot(draft.position(i) - wall.origin, wall.normal) > offset; });
  wall.nodes = std::move(*nodes);
  if (wall.nodes.empty()) draft.warning(entry, "NSID", "no node can meet this wall");

  wall.friction = entry.real("FRIC", pure);
  const bool welds = wall.friction == 2.0 || wall.friction == 3.0;
  if (!welds && (wall.friction < 0.0 || wall.friction > 1.0))
    draft.error(entry, "FRIC", "found " + std::to_string(wall.friction) + ", expected 0 to 1, or 2 or 3",
                "2 welds nodes that hit and lets them slide, 3 holds them");
  wall.velocity_limit = entry.real("WVEL", a_velocity);
  if (wall.velocity_limit != 0.0 && !welds)
    draft.warning(entry, "WVEL", "used with FRIC 2 and 3 only: nodes that hit faster are welded");
  wall.birth = entry.real("BIRTH", a_time);
  wall.death = entry.real("DEATH", a_time);
  if (wall.death == 0.0 || entry.card().real("DEATH") >= 1e20) wall.death = forever;

  if (entry.has("LENL")) {
    wall.finite = true;
    // The edge l runs from the tail towards XHEV; m completes the right-handed set n, l, m.
    Frame frame;
    if (!make_frame(wall.normal, entry.point("XHEV", "YHEV", "ZHEV") - wall.origin, frame))
      return draft.error(entry, "XHEV", "the edge of the wall runs along its normal, or has no length");
    wall.edge_l = frame.axis[1];
    wall.edge_m = frame.axis[2];
    wall.length_l = entry.real("LENL", a_length);
    wall.length_m = entry.real("LENM", a_length);
    if (!(wall.length_l > 0.0 && wall.length_m > 0.0))
      return draft.error(entry, "LENL", "a finite wall needs both lengths above 0");
  }
  if (entry.has("MASS")) {
    wall.mass = entry.real("MASS", a_mass);
    wall.speed = entry.real("V0", a_velocity);
    if (!(wall.mass > 0.0)) return draft.error(entry, "MASS", "a moving wall needs a mass above 0");
  }
  if (entry.has("SOFT")) wall.soft_cycles = static_cast<int>(entry.integer("SOFT"));
  wall.place = entry.place();
  draft.model.walls.push_back(std::move(wall));
}

constexpr std::string_view fields =
    "ID TITLE NSID NSIDEX BOXID OFFSET BIRTH DEATH XT YT ZT XH YH ZH FRIC WVEL XHEV YHEV ZHEV LENL LENM MASS "
    "V0 "
    "SOFT";
constexpr std::string_view unused = "RWKSF SSID N1 N2 N3 N4";
constexpr Handler handlers[] = {
    {"RIGIDWALL_PLANAR", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_FINITE", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_MOVING", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_FORCES", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_FINITE_MOVING", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_FINITE_FORCES", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_MOVING_FORCES", Phase::action, fields, unused, take_wall},
    {"RIGIDWALL_PLANAR_FINITE_MOVING_FORCES", Phase::action, fields, unused, take_wall},
};

}  // namespace
extern const Family wall_cards{handlers};

}  // namespace cleave::model
