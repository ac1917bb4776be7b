/// Ties to faces of rigid bodies: the nodes become the body's own.

#include <algorithm>
#include <set>

#include "solver/contact/ties.hpp"
#include "solver/interaction.hpp"

namespace cleave::solver {
namespace {

/// The body of all corners that carry a tie; -1 if there is none, or several.
Index body_of_face(const std::vector<Index>& body, const Tie& tie) {
  Index found = -2;
  for (int k = 0; k < 4; ++k) {
    if (tie.weight[k] == 0.0) continue;
    const Index own = body[static_cast<std::size_t>(tie.corner[k])];
    if (found != -2 && own != found) return -1;
    found = own;
  }
  return std::max(found, Index{-1});
}

/// Nodes that something else than a body holds or moves.
std::set<Index> held_nodes(const model::Model& model) {
  std::set<Index> held;
  for (const auto& fixed : model.fixed)
    if (fixed.directions != 0) held.insert(fixed.nodes.begin(), fixed.nodes.end());
  for (const auto& motion : model.motions) held.insert(motion.nodes.begin(), motion.nodes.end());
  return held;
}

void insert(std::vector<Index>& list, const std::vector<Index>& more) {
  list.insert(list.end(), more.begin(), more.end());
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

bool joined(const discretisation::World& world, const Tie& tie) {
  const Index body = world.body_of_node.empty() ? -1 : body_of_face(world.body_of_node, tie);
  return body >= 0 && world.body_of_node[static_cast<std::size_t>(tie.node)] == body;
}

void join_ties(model::Model& model, deck::Diagnostics& diagnostics) {
  if (model.rigid_bodies.empty()) return;
  const auto name = [&](Index node) {
    return "node " + std::to_string(model.mesh.nodes.id[static_cast<std::size_t>(node)]);
  };
  for (const model::Contact& contact : model.contacts) {
    if (!contact.joins) continue;
    std::vector<Index> body = model::body_of_nodes(model.rigid_bodies, model.mesh.nodes.count());
    const std::set<Index> held = held_nodes(model);
    discretisation::World world;  // the surfaces ask it for no more than the mesh
    world.model = &model;
    deck::Diagnostics said_later;
    std::vector<std::vector<Index>> fresh(model.rigid_bodies.size());
    const auto refuse = [&](const std::string& what, const std::string& hint) {
      diagnostics.error(contact.place, contact.keyword, "",
                        "tied contact " + std::to_string(contact.id) + ": " + what, hint);
    };
    bool failed = false;
    for (const Tie& tie : find_ties(world, contact, said_later)) {
      const Index to = body_of_face(body, tie), own = body[static_cast<std::size_t>(tie.node)];
      if (to < 0 || own == to || failed) continue;
      failed = true;
      if (own >= 0)
        refuse(name(tie.node) + " (and perhaps more) belongs to one rigid body and is tied to another",
               "merge the bodies by *CONSTRAINED_RIGID_BODIES, or tie them by springs: _OFFSET");
      else if (held.count(tie.node) > 0)
        refuse(name(tie.node) + " (and perhaps more) is held or moved by itself and tied to a rigid body",
               "hold or move the body, or leave the node out of the tie");
      else if (contact.birth > 0.0 || contact.death < model.control.end.time)
        refuse("a tie to a rigid body that begins or ends within the run is not computed",
               "tie by springs: *CONTACT_TIED_NODES_TO_SURFACE_OFFSET");
      else
        failed = false;
      fresh[static_cast<std::size_t>(to)].push_back(tie.node);
    }
    for (std::size_t b = 0; b < fresh.size() && !failed; ++b) {
      if (fresh[b].empty()) continue;
      insert(model.rigid_bodies[b].nodes, fresh[b]);
      insert(model.rigid_bodies[b].extra, fresh[b]);
      const std::set<Index> given(fresh[b].begin(), fresh[b].end());
      for (model::RigidWall& wall : model.walls)
        if (wall.penalty == 0.0) std::erase_if(wall.nodes, [&](Index node) { return given.count(node) > 0; });
      diagnostics.note(contact.place, contact.keyword, "",
                       std::to_string(fresh[b].size()) + " nodes of tied contact " +
                           std::to_string(contact.id) + " lie on faces of rigid body " +
                           std::to_string(model.rigid_bodies[b].id) + " and move with it");
    }
  }
}

}  // namespace cleave::solver
