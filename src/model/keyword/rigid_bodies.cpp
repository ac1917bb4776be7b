/// Rigid bodies from what the deck says of them: parts, merged parts, extra nodes, nodal rigid bodies.

#include <algorithm>

#include "model/keyword/rigid_cards.hpp"
#include "model/keyword/row_place.hpp"

namespace cleave::model {

void finish_rigid_actions(Draft& draft);

namespace {

void sort_unique(std::vector<Index>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Bodies {
 public:
  explicit Bodies(Draft& draft) : draft_(draft), model_(draft.model), lead_(model_.parts.size(), -1) {}

  void make() {
    for (Index p = 0; p < static_cast<Index>(lead_.size()); ++p)
      if (part(p).rigid) lead_[static_cast<std::size_t>(p)] = p;
    for (const auto& [p, entry] : draft_.rigid.inertia)
      if (part(p).law && !part(p).rigid)
        draft_.error(entry, "PID",
                     name(p) + " is not rigid, so its mass and inertia are those of its elements",
                     "give it *MAT_RIGID, or take *PART");
    for (const Entry& entry : draft_.rigid.merges) merge(entry);
    for (Index p = 0; p < static_cast<Index>(lead_.size()); ++p)
      if (lead_[static_cast<std::size_t>(p)] == p) add_body(p);
    for (const Entry& entry : draft_.rigid.extra) add_extra(entry);
    for (const Entry& entry : draft_.rigid.nodal) add_nodal(entry);
    collect_nodes();
  }

 private:
  const Part& part(Index p) const { return model_.parts[static_cast<std::size_t>(p)]; }
  std::string name(Index p) const { return "part " + std::to_string(part(p).id); }
  Index lead_of(Index p) const { return lead_[static_cast<std::size_t>(p)]; }

  /// The part of a field, if it is rigid; -1 with an error.
  Index rigid_part(const Entry& entry, std::string_view field) {
    const Index p = draft_.part(entry, field);
    if (p < 0 || lead_of(p) >= 0) return p;
    if (part(p).law)  // else it has been said what is wrong with its material
      draft_.error(entry, field, name(p) + " is not rigid", "give it *MAT_RIGID");
    return -1;
  }

  void merge(const Entry& entry) {
    const Index lead = rigid_part(entry, "PIDL"), other = rigid_part(entry, "PIDC");
    if (lead < 0 || other < 0) return;
    const Index to = lead_of(lead), from = lead_of(other);
    if (to == from)
      return draft_.warning(entry, "PIDC", name(lead) + " and " + name(other) + " are one body already");
    for (Index& one : lead_)
      if (one == from) one = to;
  }

  void add_body(Index lead) {
    const Part& first = part(lead);
    RigidBody body;
    body.id = first.id;
    body.title = first.title;
    body.place = first.place;
    body.hold = first.rigid->hold;
    body.has_axes = first.rigid->has_axes;
    body.axes = first.rigid->axes;
    body.parts.push_back(lead);
    for (Index p = 0; p < static_cast<Index>(lead_.size()); ++p)
      if (p != lead && lead_of(p) == lead) body.parts.push_back(p);
    if (first.inertia && !draft_.rigid.reset_parts) {
      body.has_velocity = true;
      body.velocity = first.inertia->velocity;
      body.spin = first.inertia->spin;
    }
    model_.rigid_bodies.push_back(std::move(body));
  }

  RigidBody* body_of(Index p) {
    for (RigidBody& body : model_.rigid_bodies)
      if (std::find(body.parts.begin(), body.parts.end(), p) != body.parts.end()) return &body;
    return nullptr;
  }

  void add_extra(const Entry& entry) {
    const bool by_set = entry.keyword() == "CONSTRAINED_EXTRA_NODES_SET";
    const Index p = rigid_part(entry, "PID");
    if (p < 0) return;
    RigidBody& body = *body_of(p);
    std::vector<Index> nodes;
    if (by_set) {
      const auto* set = draft_.node_set(entry, "NSID");
      if (!set) return;
      nodes = *set;
      if (nodes.empty()) return draft_.error(entry, "NSID", "the set of extra nodes is empty");
    } else if (const Index node = draft_.node(entry, "NID"); node >= 0) {
      nodes = {node};
    }
    const auto flag = entry.integer("IFLAG");
    if (flag != 0 && flag != 1)
      draft_.error(entry, "IFLAG", "found " + std::to_string(flag) + ", expected 0 or 1");
    for (const Index node : nodes) {
      places_.insert_or_assign(node, entry.place(by_set ? "NSID" : "NID"));
      body.extra.push_back(node);
      if (flag == 1) body.added.push_back(node);
    }
  }

  void add_nodal(const Entry& entry) {
    RigidBody body;
    const auto* set = draft_.node_set(entry, "NSID");
    body.id = entry.id(IdKind::part, "PID");
    if (body.id == 0) body.id = entry.id(IdKind::set, "NSID");
    body.title = entry.title();
    body.place = entry.place("NSID");
    if (!set || !read_nodal(entry, body)) return;
    if (set->empty()) return draft_.error(entry, "NSID", "the set of this nodal rigid body is empty");
    if (model_.part_of(body.id) >= 0 || find(body.id))
      return draft_.error(entry, "PID",
                          "the number " + std::to_string(body.id) + " is a part or a body already",
                          "give each rigid body its own number");
    body.extra = *set;
    for (const Index node : *set) places_.insert_or_assign(node, body.place);
    model_.rigid_bodies.push_back(std::move(body));
  }

  bool read_nodal(const Entry& entry, RigidBody& body) {
    if (entry.has("CMO") && !read_hold(draft_, entry, body.hold)) return false;
    if (entry.integer("CID") != 0) {
      const Frame* frame = draft_.frame(entry, "CID");
      if (!frame) return false;
      body.has_axes = true;
      body.axes = *frame;
      body.axes.origin = {0, 0, 0};
    }
    if (!entry.has("TM")) return true;
    const auto stated = read_inertia(draft_, entry);
    if (!stated) return false;
    body.inertia = stated;
    if (draft_.rigid.reset_nodal) return true;
    body.has_velocity = true;
    body.velocity = stated->velocity;
    body.spin = stated->spin;
    return true;
  }

  bool find(Id id) const {
    return std::any_of(model_.rigid_bodies.begin(), model_.rigid_bodies.end(),
                       [&](const RigidBody& body) { return body.id == id; });
  }

  /// Every node of each body; one that two bodies claim is an error.
  void collect_nodes() {
    std::vector<Index> owner(model_.mesh.nodes.count(), -1);
    for (std::size_t b = 0; b < model_.rigid_bodies.size(); ++b) {
      RigidBody& body = model_.rigid_bodies[b];
      sort_unique(body.extra);
      sort_unique(body.added);
      if (!body.parts.empty()) body.nodes = draft_.nodes_of_parts(body.parts);
      body.nodes.insert(body.nodes.end(), body.extra.begin(), body.extra.end());
      for (const Index p : body.parts)
        if (part(p).inertia && part(p).inertia->node >= 0) body.nodes.push_back(part(p).inertia->node);
      if (body.inertia && body.inertia->node >= 0) body.nodes.push_back(body.inertia->node);
      sort_unique(body.nodes);
      if (body.nodes.empty())
        draft_.diagnostics.error(body.place, "PART", "PID",
                                 "rigid body " + std::to_string(body.id) + " has no elements and so no mass",
                                 "give its part elements, or remove it");
      for (const Index node : body.nodes) claim(node, static_cast<Index>(b), owner);
    }
    if (const auto rest = complaints_.rest(); !rest.empty())
      draft_.diagnostics.error({}, "MAT_RIGID", "", rest + " nodes with such mistakes");
  }

  void claim(Index node, Index body, std::vector<Index>& owner) {
    Index& now = owner[static_cast<std::size_t>(node)];
    if (now < 0) now = body;
    if (now == body || !complaints_.take()) return;
    const RigidBody &one = model_.rigid_bodies[static_cast<std::size_t>(now)],
                    &other = model_.rigid_bodies[static_cast<std::size_t>(body)];
    const auto at = places_.find(node);
    draft_.diagnostics.error(at != places_.end() ? at->second : other.place, "MAT_RIGID", "",
                             "node " + std::to_string(model_.mesh.nodes.id[static_cast<std::size_t>(node)]) +
                                 " belongs to two rigid bodies, " + std::to_string(one.id) + " and " +
                                 std::to_string(other.id),
                             "merge them by *CONSTRAINED_RIGID_BODIES, or give them nodes of their own");
  }

  Draft& draft_;
  Model& model_;
  std::vector<Index> lead_;              // [part] the lead of its body, -1 if it is not rigid
  std::map<Index, deck::Place> places_;  // where a node was given to a body by a card
  Capped complaints_;
};

/// Directions in which each node is held from beginning to end: bits 0..5; global axes, or all of one frame.
std::vector<unsigned> always_held(const Model& model) {
  std::vector<unsigned> held(model.mesh.nodes.count(), 0);
  for (const FixedNodes& fixed : model.fixed) {
    const bool whole = fixed.directions == 63u;
    if (fixed.birth > 0.0 || fixed.death < forever || (fixed.local && !whole)) continue;
    for (const Index node : fixed.nodes) held[static_cast<std::size_t>(node)] |= fixed.directions;
  }
  return held;
}

/// Takes the shells of some parts out of the mesh.
void remove_shells(Mesh& mesh, const std::vector<Id>& of_part) {
  for (Elements& group : mesh.shells) {
    const auto n = static_cast<std::size_t>(nodes_of(group.shape));
    Elements kept{.shape = group.shape, .id = {}, .part = {}, .node = {}};
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (of_part[static_cast<std::size_t>(group.part[e])] > 0) continue;
      kept.id.push_back(group.id[e]);
      kept.part.push_back(group.part[e]);
      kept.node.insert(kept.node.end(), &group.node[n * e], &group.node[n * e] + n);
    }
    group = std::move(kept);
  }
}

/// Shells of *SECTION_SHELL must be rigid, or held at every node; others are refused, and taken out of the
/// mesh where that is allowed.
void check_shells(Draft& draft) {
  Model& model = draft.model;
  std::vector<Id> free(model.parts.size(), 0);  // [part] lowest number of a shell that deforms
  std::vector<char> met(model.parts.size(), 0);
  std::vector<unsigned> held;
  for (const Elements& group : model.mesh.shells)
    for (std::size_t e = 0; e < group.count(); ++e) {
      const auto p = static_cast<std::size_t>(group.part[e]);
      if (spacetime_dimension(model.parts[p].section) != 0 || model.parts[p].rigid) continue;
      if (held.empty()) held = always_held(model);
      met[p] = 1;
      const auto n = static_cast<std::size_t>(nodes_of(group.shape));
      for (std::size_t a = 0; a < n && (free[p] == 0 || group.id[e] < free[p]); ++a)
        if (held[static_cast<std::size_t>(group.node[n * e + a])] != 63u) free[p] = group.id[e];
    }
  bool any = false;
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const Part& part = model.parts[p];
    any = any || free[p] > 0;
    if (free[p] > 0)
      draft.refuse(
          row_places(draft.deck, "ELEMENT_SHELL", IdKind::element, {free[p]})[free[p]], "ELEMENT_SHELL",
          "PID",
          "not computed here: part " + std::to_string(part.id) + " has *SECTION_SHELL, and its shells deform",
          "give the part *MAT_RIGID, hold all its nodes in all six directions, or mesh it with solids");
    else if (met[p])
      draft.diagnostics.note(part.place, "PART", "PID",
                             "every node of the shells of part " + std::to_string(part.id) +
                                 " is held: it is a surface that does not deform");
    const bool shell = met[p] || (part.rigid && part.section.family == "SHELL");
    if (shell && !(part.section.number("T1", 0.0) > 0.0))
      draft.diagnostics.error(
          part.section.place, "SECTION_SHELL", "T1",
          "shells of part " + std::to_string(part.id) + " have no thickness, and so no mass");
  }
  if (any) remove_shells(model.mesh, free);
}

}  // namespace

void finish_rigid(Draft& draft) {
  check_shells(draft);
  Bodies(draft).make();
  finish_rigid_actions(draft);
}

}  // namespace cleave::model
