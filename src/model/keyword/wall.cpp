/// *RIGIDWALL_PLANAR with _ORTHO, _FINITE, _MOVING and _FORCES; *RIGIDWALL_GEOMETRIC with _MOTION, _INTERIOR.

#include <algorithm>
#include <cmath>

#include "model/keyword/handler.hpp"
#include "model/keyword/over_time.hpp"

namespace cleave::model {
namespace {

using Shape = RigidWall::Shape;

/// What the cards of every wall begin with: name, nodes, normal, times. The nodes stay empty where none can
/// meet the wall.
bool read_common(Draft& draft, const Entry& entry, RigidWall& wall) {
  wall.id = entry.own_id();
  wall.title = entry.title();
  wall.keyword = entry.keyword();
  wall.place = entry.place();
  auto nodes = draft.selected_nodes(entry);
  if (!nodes) return false;
  wall.nodes = std::move(*nodes);

  // The normal runs from its tail (a point of the wall) to its head.
  wall.origin = entry.point("XT", "YT", "ZT");
  const Vector normal = entry.point("XH", "YH", "ZH") - wall.origin;
  const bool needs_normal = wall.shape != Shape::sphere;
  if (length(normal) == 0.0 && needs_normal) {
    const bool cylinder = wall.shape == Shape::cylinder;
    draft.error(entry, "XH",
                cylinder ? "head and tail of the axis are the same point"
                         : "head and tail of the normal are the same point",
                cylinder ? "XT YT ZT is the middle of an end, XH YH ZH a point of the axis beyond it"
                         : "XT YT ZT is a point of the wall, XH YH ZH the head of its outward normal");
    return false;
  }
  wall.normal = length(normal) == 0.0 ? Vector{0, 0, 1} : unit(normal);

  wall.friction = entry.real("FRIC", pure);
  wall.birth = entry.real("BIRTH", a_time);
  wall.death = death_time(entry, "DEATH");
  return true;
}

/// The edge l runs from the tail towards XHEV; m completes the right-handed set n, l, m.
bool read_edges(Draft& draft, const Entry& entry, RigidWall& wall) {
  Frame frame;
  if (!make_frame(wall.normal, entry.point("XHEV", "YHEV", "ZHEV") - wall.origin, frame)) {
    draft.error(entry, "XHEV", "the edge of the wall runs along its normal, or has no length");
    return false;
  }
  wall.edge_l = frame.axis[1];
  wall.edge_m = frame.axis[2];
  wall.length_l = entry.real("LENL", a_length);
  wall.length_m = entry.real("LENM", a_length);
  return true;
}

/// Friction coefficients along two directions of the wall (_ORTHO).
bool read_directions(Draft& draft, const Entry& entry, RigidWall& wall) {
  wall.orthotropic = true;
  constexpr std::string_view names[2][3] = {{"SFRICA", "DFRICA", "DECAYA"}, {"SFRICB", "DFRICB", "DECAYB"}};
  for (int k = 0; k < 2; ++k) {
    wall.static_friction[k] = entry.real(names[k][0], pure);
    wall.dynamic_friction[k] = entry.real(names[k][1], pure);
    wall.friction_decay[k] = entry.real(names[k][2], {0, -1, 1});
    for (const std::string_view name : names[k])
      if (entry.card().real(name) < 0.0) {
        draft.error(entry, name,
                    "found " + std::to_string(entry.card().real(name)) + ", expected 0 or above");
        return false;
      }
  }
  const bool by_nodes = entry.integer("NODE1") != 0 || entry.integer("NODE2") != 0;
  if (by_nodes) {
    wall.friction_node[0] = draft.node(entry, "NODE1");
    wall.friction_node[1] = draft.node(entry, "NODE2");
    if (wall.friction_node[0] < 0 || wall.friction_node[1] < 0) return false;
    wall.friction_axis = draft.position(wall.friction_node[1]) - draft.position(wall.friction_node[0]);
  } else {
    wall.friction_axis =
        entry.motion().direction({entry.card().real("D1"), entry.card().real("D2"), entry.card().real("D3")});
  }
  const std::string_view where = by_nodes ? "NODE1" : "D1";
  const double size = length(wall.friction_axis);
  if (size > 0.0) wall.friction_axis = unit(wall.friction_axis);
  if (length(base::cross(wall.friction_axis, wall.normal)) < 1e-6) {
    draft.error(entry, where, "the first direction of friction runs along the normal, or has no length",
                "give two nodes NODE1 and NODE2, or a vector D1 D2 D3, along the wall");
    return false;
  }
  if (wall.friction > 0.0 && wall.friction < 1.0)
    draft.warning(entry, "FRIC", "not used with _ORTHO, which has coefficients of its own");
  return true;
}

void check_friction(Draft& draft, const Entry& entry, const RigidWall& wall) {
  const bool welds = !wall.geometric && (wall.friction == 2.0 || wall.friction == 3.0);
  if (!welds && (wall.friction < 0.0 || wall.friction > 1.0))
    draft.error(
        entry, "FRIC",
        "found " + std::to_string(wall.friction) +
            (wall.geometric ? ", expected 0 to 1" : ", expected 0 to 1, or 2 or 3"),
        wall.geometric ? "1 lets no node slide" : "2 welds nodes that hit and lets them slide, 3 holds them");
}

void take_planar(Draft& draft, const Entry& entry) {
  RigidWall wall;
  if (!read_common(draft, entry, wall)) return;
  // OFFSET keeps only nodes near the wall.
  if (const double offset = entry.real("OFFSET", a_length); offset > 0.0)
    std::erase_if(wall.nodes,
                  [&](Index i) { return dot(draft.position(i) - wall.origin, wall.normal) > offset; });
  if (wall.nodes.empty()) draft.warning(entry, "NSID", "no node can meet this wall");

  check_friction(draft, entry, wall);
  const bool welds = wall.friction == 2.0 || wall.friction == 3.0;
  wall.velocity_limit = entry.real("WVEL", a_velocity);
  if (wall.velocity_limit != 0.0 && !welds)
    draft.warning(entry, "WVEL", "used with FRIC 2 and 3 only: nodes that hit faster are welded");
  if (entry.has("SFRICA") && !read_directions(draft, entry, wall)) return;

  if (entry.has("LENL")) {
    wall.finite = true;
    if (!read_edges(draft, entry, wall)) return;
    if (!(wall.length_l > 0.0 && wall.length_m > 0.0))
      return draft.error(entry, "LENL", "a finite wall needs both lengths above 0");
  }
  if (entry.has("MASS")) {
    wall.mass = entry.real("MASS", a_mass);
    wall.speed = entry.real("V0", a_velocity);
    if (!(wall.mass > 0.0)) return draft.error(entry, "MASS", "a moving wall needs a mass above 0");
  }
  if (entry.has("SOFT")) wall.soft_cycles = static_cast<int>(entry.integer("SOFT"));
  wall.penalty = draft.wall_penalty;
  draft.model.walls.push_back(std::move(wall));
}

/// _MOTION: the wall is moved along a direction as a curve tells, which begins at its birth.
bool read_motion(Draft& draft, const Entry& entry, RigidWall& wall) {
  if (entry.integer("LCID") == 0) {
    draft.error(entry, "LCID", "the motion of the wall has no curve",
                "give a *DEFINE_CURVE of velocity (OPT 0) or displacement (OPT 1) over time");
    return false;
  }
  wall.motion = draft.curve(entry, "LCID");
  if (wall.motion < 0) return false;
  const auto option = entry.integer("OPT");
  if (option != 0 && option != 1) {
    draft.error(entry, "OPT",
                "found " + std::to_string(option) + ", expected 0 (velocity) or 1 (displacement)");
    return false;
  }
  wall.motion_is_displacement = option == 1;
  const Vector along =
      entry.motion().direction({entry.card().real("VX"), entry.card().real("VY"), entry.card().real("VZ")});
  if (length(along) == 0.0) {
    draft.error(entry, "VX", "the direction of the motion has no length", "give its cosines VX VY VZ");
    return false;
  }
  if (std::abs(length(along) - 1.0) > 1e-3)
    draft.warning(entry, "VX",
                  "the direction of the motion has length " + std::to_string(length(along)) +
                      ", taken as 1: the curve alone says how far or how fast",
                  "give direction cosines");
  wall.motion_direction = unit(along);
  return true;
}

void take_geometric(Draft& draft, const Entry& entry) {
  RigidWall wall;
  wall.geometric = true;
  wall.shape = entry.has("RADCYL")   ? Shape::cylinder
               : entry.has("RADSPH") ? Shape::sphere
               : entry.has("LENP")   ? Shape::prism
                                     : Shape::plane;
  if (!read_common(draft, entry, wall)) return;
  if (wall.nodes.empty()) draft.warning(entry, "NSID", "no node can meet this wall");
  check_friction(draft, entry, wall);

  const auto not_negative = [&](std::string_view field, double value) {
    if (value >= 0.0) return true;
    draft.error(entry, field, "found " + std::to_string(value) + ", expected a length, or 0 for without end");
    return false;
  };
  if (wall.shape == Shape::cylinder || wall.shape == Shape::sphere) {
    const std::string_view field = wall.shape == Shape::cylinder ? "RADCYL" : "RADSPH";
    wall.radius = entry.real(field, a_length);
    wall.interior = entry.card().option("INTERIOR");
    if (!(wall.radius > 0.0))
      return draft.error(entry, field,
                         "found " + std::to_string(wall.radius) + ", expected a radius above 0");
    if (wall.shape == Shape::cylinder) wall.length_n = entry.real("LENCYL", a_length);
    if (!not_negative("LENCYL", wall.length_n)) return;
  } else {
    // An edge is needed only where something ends along it.
    const bool ends = entry.card().real("LENL") != 0.0 || entry.card().real("LENM") != 0.0;
    Frame frame;
    if (ends ? !read_edges(draft, entry, wall) : false) return;
    if (!ends && make_frame(wall.normal, entry.point("XHEV", "YHEV", "ZHEV") - wall.origin, frame)) {
      wall.edge_l = frame.axis[1];
      wall.edge_m = frame.axis[2];
    }
    if (wall.shape == Shape::prism) wall.length_n = entry.real("LENP", a_length);
    if (!not_negative("LENL", wall.length_l) || !not_negative("LENM", wall.length_m) ||
        !not_negative("LENP", wall.length_n))
      return;
    wall.finite = wall.shape == Shape::plane && ends;
  }
  if (entry.card().option("MOTION") && !read_motion(draft, entry, wall)) return;
  draft.model.walls.push_back(std::move(wall));
}

constexpr std::string_view planar =
    "ID TITLE NSID NSIDEX BOXID OFFSET BIRTH DEATH XT YT ZT XH YH ZH FRIC WVEL SFRICA SFRICB DFRICA DFRICB "
    "DECAYA DECAYB NODE1 NODE2 D1 D2 D3 XHEV YHEV ZHEV LENL LENM MASS V0 SOFT";
constexpr std::string_view planar_unused = "RWKSF SSID N1 N2 N3 N4";
constexpr std::string_view geometric =
    "ID TITLE NSID NSIDEX BOXID BIRTH DEATH XT YT ZT XH YH ZH FRIC XHEV YHEV ZHEV LENL LENM LENP RADCYL "
    "LENCYL RADSPH LCID OPT VX VY VZ";
constexpr std::string_view geometric_unused = "NSEGS VL HEIGHT PID RO E PR";
constexpr std::string_view in_one_piece =
    "forces are those on the whole wall; sections (NSEGS) and the part that shows it (_DISPLAY) are not "
    "written";
constexpr Handler handlers[] = {
    {"RIGIDWALL_PLANAR", Phase::action, planar, planar_unused, take_planar},
    {"RIGIDWALL_PLANAR_*", Phase::action, planar, planar_unused, take_planar},
    {.keyword = "RIGIDWALL_GEOMETRIC_*",
     .honoured = geometric,
     .harmless = geometric_unused,
     .take = take_geometric,
     .remark = in_one_piece},
};

}  // namespace
extern const Family wall_cards{handlers};

}  // namespace cleave::model
