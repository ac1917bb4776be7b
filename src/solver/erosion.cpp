#include "solver/erosion.hpp"

#include <memory>

namespace cleave::solver {

using discretisation::State;

Erosion::Erosion(const discretisation::World& world, const State& state)
    : world_(world), elements_of_(world.node_count(), 0) {
  for (std::size_t b = 0; b < world.blocks.size(); ++b) {
    const auto nodes = world.blocks[b]->connectivity();
    const std::size_t count = world.blocks[b]->element_ids().size();
    const std::size_t width = count ? nodes.size() / count : 0;
    const auto alive = std::make_unique<bool[]>(count);
    world.blocks[b]->alive(state.blocks[b], {alive.get(), count});
    for (std::size_t e = 0; e < count; ++e) {
      if (!alive[e]) continue;
      active_ += 1.0;
      for (const auto node : nodes.subspan(width * e, width)) ++elements_of_[static_cast<std::size_t>(node)];
    }
  }
  for (const discretisation::RigidBody& body : world.bodies)  // its nodes stay whatever they lose
    for (const auto node : body.node) ++elements_of_[static_cast<std::size_t>(node)];
  if (world.model->point_masses.empty()) return;
  point_mass_.resize(world.node_count());
  for (const auto& point : world.model->point_masses)
    point_mass_[static_cast<std::size_t>(point.node)] += point.mass;
}

void Erosion::find_elements() {
  for (std::size_t b = 0; b < world_.blocks.size(); ++b) {
    if (world_.blocks[b]->formulation() == "rigid") continue;  // shells may have the numbers of solids
    const auto ids = world_.blocks[b]->element_ids();
    for (std::size_t e = 0; e < ids.size(); ++e) element_.emplace(ids[e], Where{b, e});
  }
}

bool Erosion::remove(std::span<const model::Id> eroded, State& state) {
  if (eroded.empty()) return false;
  if (element_.empty()) find_elements();
  bool changed = false;
  for (const model::Id id : eroded) {
    const Where where = element_.at(id);
    const discretisation::Block& block = *world_.blocks[where.block];
    const std::size_t width = block.connectivity().size() / block.element_ids().size();
    active_ -= 1.0;
    for (const auto index : block.connectivity().subspan(width * where.element, width)) {
      const auto node = static_cast<std::size_t>(index);
      if (--elements_of_[node] > 0) continue;
      const double kept = point_mass_.empty() ? 0.0 : point_mass_[node];
      double* v = &state.velocity[3 * node];
      const double energy = 0.5 * (state.mass[node] - kept) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      state.energy.eroded_kinetic += energy;
      state.parts[static_cast<std::size_t>(block.part())].eroded_kinetic += energy;
      state.mass[node] = kept;
      if (kept == 0.0) v[0] = v[1] = v[2] = 0.0;
      changed = true;
    }
  }
  return changed;
}

}  // namespace cleave::solver
