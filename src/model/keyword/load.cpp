/// *LOAD_NODE_POINT and _SET, *LOAD_SEGMENT and _SET, *LOAD_BODY_* but _GENERALIZED.

#include <algorithm>
#include <array>

#include "model/keyword/handler.hpp"
#include "model/keyword/selection.hpp"

namespace cleave::model {
namespace {

bool same(const Vector& a, const Vector& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

void take_node_load(Draft& draft, const Entry& entry) {
  NodeLoad load;
  const bool by_set = entry.keyword() == "LOAD_NODE_SET";
  load.place = entry.place(by_set ? "NSID" : "NID");
  if (by_set) {
    const auto* set = draft.node_set(entry, "NSID");
    if (!set) return;
    load.nodes = *set;
  } else {
    const Index node = draft.node(entry, "NID");
    if (node < 0) return;
    load.nodes = {node};
  }
  const auto dof = entry.integer("DOF");
  if (dof >= 1 && dof <= 3) {
    const Frame* frame = draft.frame(entry, "CID");
    if (!frame) return;
    load.direction = frame->axis[dof - 1];
  } else if (dof == 4) {
    load.follower = true;
    load.follow[0] = draft.node(entry, "M1");
    load.follow[1] = draft.node(entry, "M2");
    load.follow[2] = draft.node(entry, "M3");
    if (*std::min_element(load.follow, load.follow + 3) < 0) return;
  } else if (dof >= 5 && dof <= 8) {
    return draft.refuse(entry, "DOF",
                        "a moment (DOF " + std::to_string(dof) + "): nodes of solids do not turn",
                        "apply a pair of forces");
  } else {
    return draft.error(entry, "DOF",
                       "found " + std::to_string(dof) + ", expected 1, 2, 3 (x, y, z) or 4 (follower)");
  }
  load.curve = draft.curve(entry, "LCID");
  if (load.curve < 0) return;
  load.scale = entry.real_or("SF", pure, 1.0);

  // Rows that differ only in their node are one load.
  auto& all = draft.model.node_loads;
  if (!by_set && !draft.first_of_block && !all.empty()) {
    NodeLoad& last = all.back();
    if (last.follower == load.follower && same(last.direction, load.direction) && last.curve == load.curve &&
        last.scale == load.scale && std::equal(last.follow, last.follow + 3, load.follow)) {
      last.nodes.push_back(load.nodes[0]);
      return;
    }
  }
  all.push_back(std::move(load));
}

/// A curve number below 0 (-1, -2) stands for built-in blast functions.
bool pressure_curve(Draft& draft, const Entry& entry, SegmentLoad& load) {
  if (entry.integer("LCID") < 0) {
    draft.refuse(entry, "LCID", "a built-in pressure history", "give the pressure as a *DEFINE_CURVE");
    return false;
  }
  load.curve = draft.curve(entry, "LCID");
  load.scale = entry.real_or("SF", pure, 1.0);
  load.arrival = entry.real("AT", a_time);
  load.place = entry.place("LCID");
  return load.curve >= 0;
}

/// N5 to N8: the face of a ten-node tetrahedron, whose mid nodes may stand in any order; the mesh knows
/// theirs.
bool read_mid_nodes(Draft& draft, const Entry& entry, const Segment& corners, std::array<Index, 6>& face) {
  if (corners.node[3] != corners.node[2]) {
    draft.refuse(entry, "N5", "pressure on a face with eight nodes: there are no elements with such faces",
                 "give the corner nodes N1 to N4 alone");
    return false;
  }
  std::vector<Index> given;
  for (const std::string_view field : {"N5", "N6", "N7", "N8"}) {
    if (entry.integer(field) == 0) continue;
    const Index node = draft.node(entry, field);
    if (node < 0) return false;
    if (node != corners.node[2]) given.push_back(node);  // an edge without length may repeat its corner
  }
  std::copy(corners.node, corners.node + 3, face.begin());
  for (int k = 0; k < 3; ++k) face[3 + k] = draft.mid_node(corners.node[k], corners.node[(k + 1) % 3]);
  if (given.size() == 3 && std::is_permutation(given.begin(), given.end(), face.begin() + 3)) return true;
  draft.error(entry, "N5", "these are not the nodes amid the edges of a face of a ten-node tetrahedron",
              "give three corners, N4 = N3, and the three nodes amid the edges between them");
  return false;
}

void take_segment_load(Draft& draft, const Entry& entry) {
  SegmentLoad load;
  Segment segment;
  if (!pressure_curve(draft, entry, load) || !read_segment(draft, entry, 0, segment)) return;
  if (entry.integer("N5") != 0) {
    load.quadratic.resize(1);
    if (!read_mid_nodes(draft, entry, segment, load.quadratic[0])) return;
  } else {
    load.segments = {segment};
  }
  auto& all = draft.model.segment_loads;
  if (!draft.first_of_block && !all.empty()) {
    SegmentLoad& last = all.back();
    if (last.curve == load.curve && last.scale == load.scale && last.arrival == load.arrival) {
      last.segments.insert(last.segments.end(), load.segments.begin(), load.segments.end());
      last.quadratic.insert(last.quadratic.end(), load.quadratic.begin(), load.quadratic.end());
      return;
    }
  }
  all.push_back(std::move(load));
}

void take_segment_set_load(Draft& draft, const Entry& entry) {
  SegmentLoad load;
  const auto* set = draft.segment_set(entry, "SSID");
  if (!set || !pressure_curve(draft, entry, load)) return;
  load.segments = *set;
  draft.model.segment_loads.push_back(std::move(load));
}

/// The body feels minus the base acceleration of the curve; _R loads spin it about an axis through XC, YC,
/// ZC.
void take_body(Draft& draft, const Entry& entry) {
  BodyLoad load;
  const std::string_view kind =
      std::string_view(entry.keyword()).substr(std::string_view("LOAD_BODY_").size());
  const Frame* frame = draft.frame(entry, "CID");
  load.place = entry.place("LCID");
  load.curve = draft.curve(entry, "LCID");
  if (!frame || load.curve < 0) return;
  if (kind == "VECTOR") {
    load.direction =
        to_global(*frame, {entry.card().real("V1"), entry.card().real("V2"), entry.card().real("V3")});
    if (length(load.direction) == 0.0) return draft.error(entry, "V1", "the direction has no length");
    load.direction = unit(load.direction);
  } else {
    load.direction = frame->axis[kind.back() - 'X'];
    load.rotation = kind.front() == 'R';
  }
  if (load.rotation) load.centre = entry.point("XC", "YC", "ZC");
  load.scale = entry.real_or("SF", pure, 1.0);
  if (entry.integer("LCIDDR") != 0)
    draft.warning(entry, "LCIDDR", "there is no dynamic relaxation phase; this curve is not used");
  draft.model.body_loads.push_back(std::move(load));
}

/// Restricts every body load of the deck to the nodes of a set of parts.
void take_body_parts(Draft& draft, const Entry& entry) {
  const auto* parts = draft.part_set(entry, "PSID");
  if (!parts) return;
  std::vector<bool> flags(draft.model.mesh.nodes.count(), false);
  for (const Index i : draft.nodes_of_parts(*parts)) flags[i] = true;
  draft.after_phase.push_back([&draft, flags = std::move(flags)] {
    for (BodyLoad& load : draft.model.body_loads)
      if (!load.generalized) load.nodes = flags;
  });
}

constexpr std::string_view nodal = "ID HEADING NID NSID DOF LCID SF CID M1 M2 M3";
constexpr std::string_view body = "LCID SF LCIDDR XC YC ZC CID V1 V2 V3";
constexpr Handler handlers[] = {
    {.keyword = "LOAD_NODE_POINT", .honoured = nodal, .take = take_node_load},
    {.keyword = "LOAD_NODE", .honoured = nodal, .take = take_node_load},
    {.keyword = "LOAD_NODE_SET", .honoured = nodal, .take = take_node_load},
    {.keyword = "LOAD_SEGMENT", .honoured = "LCID SF AT N1 N2 N3 N4 N5 N6 N7 N8", .take = take_segment_load},
    {.keyword = "LOAD_SEGMENT_ID",
     .honoured = "ID HEADING LCID SF AT N1 N2 N3 N4 N5 N6 N7 N8",
     .take = take_segment_load},
    {.keyword = "LOAD_SEGMENT_SET", .honoured = "ID HEADING SSID LCID SF AT", .take = take_segment_set_load},
    {.keyword = "LOAD_BODY_X", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_Y", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_Z", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_RX", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_RY", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_RZ", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_VECTOR", .honoured = body, .take = take_body},
    {.keyword = "LOAD_BODY_PARTS", .honoured = "PSID", .take = take_body_parts},
};

}  // namespace
extern const Family load_cards{handlers};

}  // namespace cleave::model
