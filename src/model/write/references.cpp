#include "model/write/references.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::model {

const Set<Index>* set_of(const std::vector<Set<Index>>& sets, const std::vector<Index>& members) {
  for (const auto& set : sets)
    if (set.members == members) return &set;
  return nullptr;
}

const Set<Segment>* set_of(const std::vector<Set<Segment>>& sets, const std::vector<Segment>& members) {
  const auto same = [](const Segment& a, const Segment& b) { return std::equal(a.node, a.node + 4, b.node); };
  for (const auto& set : sets)
    if (std::equal(set.members.begin(), set.members.end(), members.begin(), members.end(), same)) return &set;
  return nullptr;
}

std::vector<Index> flagged(const std::vector<bool>& flags) {
  std::vector<Index> positions;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) positions.push_back(static_cast<Index>(i));
  return positions;
}

void name_node_lists(Model& model) {
  Id next = 1;
  for (const auto& set : model.node_sets) next = std::max(next, set.id + 1);
  const auto ensure = [&](const std::vector<Index>& nodes, std::string title) {
    if (!set_of(model.node_sets, nodes)) model.node_sets.push_back({next++, std::move(title), nodes});
  };
  for (std::size_t i = 0; i < model.walls.size(); ++i)
    if (model.walls[i].nodes.size() != model.mesh.nodes.count())
      ensure(model.walls[i].nodes, "nodes of rigid wall " + std::to_string(i + 1));
  for (const RigidBody& body : model.rigid_bodies)
    if (body.parts.empty()) ensure(body.extra, "nodes of rigid body " + std::to_string(body.id));
  for (const BodyLoad& load : model.body_loads)
    if (load.generalized) ensure(flagged(load.nodes), "nodes of a body load");
  for (const FixedNodes& fixed : model.fixed)
    if ((fixed.id != 0 || !fixed.title.empty()) && fixed.nodes.size() != 1)
      ensure(fixed.nodes, "nodes of constraint " + std::to_string(fixed.id));

  // Faces that a box has chosen.
  Id next_segments = 1;
  for (const auto& set : model.segment_sets) next_segments = std::max(next_segments, set.id + 1);
  for (Contact& contact : model.contacts)
    for (ContactSide* side : {&contact.a, &contact.b}) {
      if (side->type != 0 || side->id != 0 || side->segments.empty()) continue;
      const auto* known = set_of(model.segment_sets, side->segments);
      if (!known) {
        model.segment_sets.push_back(
            {next_segments++, "faces of contact " + std::to_string(contact.id), side->segments});
        known = &model.segment_sets.back();
      }
      side->id = known->id;
    }
}

int axis_of(const Vector& d) {
  if (d.x == 1 && d.y == 0 && d.z == 0) return 1;
  if (d.x == 0 && d.y == 1 && d.z == 0) return 2;
  if (d.x == 0 && d.y == 0 && d.z == 1) return 3;
  return 0;
}

Id References::frame(const Frame& frame) {
  const Vector &x = frame.axis[0], &y = frame.axis[1];
  out_.keyword("DEFINE_COORDINATE_VECTOR");
  out_.line({++frames_, x.x, x.y, x.z, y.x, y.y, y.z});
  return frames_;
}

Id References::frame_along(const Vector& d) {
  Frame made;
  const Vector other = std::fabs(d.x) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  make_frame(d, other, made);
  return frame(made);
}

Id References::vector(const Vector& d) {
  out_.keyword("DEFINE_VECTOR");
  out_.line({++vectors_, 0.0, 0.0, 0.0, d.x, d.y, d.z});
  return vectors_;
}

}  // namespace cleave::model
