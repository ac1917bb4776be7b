/// *INITIAL_VELOCITY, _GENERATION, _NODE.
///
/// Order of precedence: *INITIAL_VELOCITY cards in reading order, the last one counts; then *_GENERATION in
/// reading order; *INITIAL_VELOCITY_NODE last of all.

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

void set_velocity(Draft& draft, Index node, const Vector& v) {
  double* out = draft.model.initial_velocity.data() + 3 * static_cast<std::size_t>(node);
  out[0] = v.x, out[1] = v.y, out[2] = v.z;
}

/// A velocity in the frame ICID, in global components.
std::optional<Vector> velocity(Draft& draft, const Entry& entry, std::string_view x, std::string_view y,
                               std::string_view z) {
  const Vector local = {entry.real(x, a_velocity), entry.real(y, a_velocity), entry.real(z, a_velocity)};
  const Frame* frame = draft.frame(entry, "ICID");
  if (!frame) return std::nullopt;
  return to_global(*frame, local);
}

/// IRIGID: velocities stated with the inertia of rigid parts (1, 3) or nodal rigid bodies (2, 3) give way.
void take_rigid(Draft& draft, const Entry& entry) {
  const auto code = entry.integer("IRIGID");
  if (code < 0 || code > 3)
    return draft.refuse(entry, "IRIGID", "the way " + std::to_string(code) + " of setting rigid bodies",
                        "0, 1, 2 and 3 are computed");
  draft.rigid.reset_parts = draft.rigid.reset_parts || (code & 1) != 0;
  draft.rigid.reset_nodal = draft.rigid.reset_nodal || (code & 2) != 0;
}

void take_initial(Draft& draft, const Entry& entry) {
  take_rigid(draft, entry);
  draft.refuse_turned(entry, "an initial velocity");
  const auto v = velocity(draft, entry, "VX", "VY", "VZ");
  if (!v) return;
  std::optional<Vector> exempt;
  if (entry.integer("NSIDEX") != 0) {
    exempt = velocity(draft, entry, "VXE", "VYE", "VZE");
    if (!exempt || !draft.node_set(entry, "NSIDEX")) return;
  }
  draft.velocity_layers[0].push_back([&draft, entry, v, exempt] {
    const auto nodes = draft.selected_nodes(entry);
    if (!nodes) return;
    for (const Index i : *nodes) set_velocity(draft, i, *v);
    if (exempt)
      for (const Index i : *draft.node_set(entry, "NSIDEX")) set_velocity(draft, i, *exempt);
  });
}

void take_generation(Draft& draft, const Entry& entry) {
  take_rigid(draft, entry);
  draft.refuse_turned(entry, "an initial velocity");
  std::vector<Index> nodes;
  const Id id = entry.integer("ID");
  const auto type = entry.integer("STYP");
  if (id == 0) {
    nodes = draft.all_nodes();
  } else if (type == 1) {
    const auto* parts = draft.part_set(entry, "ID");
    if (!parts) return;
    nodes = draft.nodes_of_parts(*parts);
  } else if (type == 2) {
    const Index part = draft.part(entry, "ID");
    if (part < 0) return;
    nodes = draft.nodes_of_parts({part});
  } else if (type == 3) {
    const auto* set = draft.node_set(entry, "ID");
    if (!set) return;
    nodes = *set;
  } else {
    return draft.error(entry, "STYP",
                       "found " + std::to_string(type) + ", expected 1 (part set), 2 (part) or 3 (node set)");
  }

  const double omega = entry.real("OMEGA", a_rate);
  const auto v = velocity(draft, entry, "VX", "VY", "VZ");
  const Frame* frame = draft.frame(entry, "ICID");
  if (!v || !frame) return;
  // The rotation axis: a point and a direction, or (NX = -999) the line through nodes NY and NZ.
  Vector centre = entry.point("XC", "YC", "ZC"), axis;
  if (entry.card().real("NX") == -999.0) {
    const Index from = draft.model.mesh.nodes.find(entry.offset(IdKind::node, entry.integer("NY")));
    const Index to = draft.model.mesh.nodes.find(entry.offset(IdKind::node, entry.integer("NZ")));
    if (from < 0 || to < 0)
      return draft.error(entry, "NX", "a node of the rotation axis (NY, NZ) is not defined");
    centre = draft.position(from);
    axis = draft.position(to) - centre;
  } else {
    axis = to_global(*frame, {entry.card().real("NX"), entry.card().real("NY"), entry.card().real("NZ")});
  }
  if (omega != 0.0 && length(axis) == 0.0)
    return draft.error(entry, "NX", "a rotation needs an axis", "give its direction in NX, NY, NZ");
  const Vector spin = omega * unit(axis);
  draft.velocity_layers[1].push_back([&draft, nodes, v, spin, centre] {
    for (const Index i : nodes) set_velocity(draft, i, *v + cross(spin, draft.position(i) - centre));
  });
}

void take_node(Draft& draft, const Entry& entry) {
  draft.refuse_turned(entry, "an initial velocity");
  const Index node = draft.node(entry, "NID");
  const auto v = velocity(draft, entry, "VX", "VY", "VZ");
  if (node < 0 || !v) return;
  draft.velocity_layers[2].push_back([&draft, node, v] { set_velocity(draft, node, *v); });
}

constexpr std::string_view rotations = "VXR VYR VZR VXRE VYRE VZRE IVATN";
constexpr Handler handlers[] = {
    {.keyword = "INITIAL_VELOCITY",
     .honoured = "NSID NSIDEX BOXID ICID VX VY VZ VXE VYE VZE IRIGID",
     .harmless = rotations,
     .take = take_initial},
    {.keyword = "INITIAL_VELOCITY_GENERATION",
     .honoured = "ID STYP OMEGA VX VY VZ ICID XC YC ZC NX NY NZ IRIGID",
     .harmless = rotations,
     .take = take_generation},
    {.keyword = "INITIAL_VELOCITY_NODE",
     .honoured = "NID VX VY VZ ICID",
     .harmless = rotations,
     .take = take_node},
};

}  // namespace

/// Lays the velocities on in their order of precedence.
void finish_velocities(Draft& draft) {
  draft.model.initial_velocity.assign(3 * draft.model.mesh.nodes.count(), 0.0);
  for (auto& layer : draft.velocity_layers)
    for (const auto& lay : layer) lay();
}

extern const Family velocity_cards{handlers};

}  // namespace cleave::model
