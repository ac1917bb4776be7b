#pragma once
/// The model made computable: blocks, and the state they start from.

#include <memory>
#include <vector>

#include "discretisation/block.hpp"
#include "discretisation/rigid/body.hpp"

namespace cleave::discretisation {

struct World {
  const model::Model* model = nullptr;
  std::vector<std::unique_ptr<const Block>> blocks;
  std::vector<RigidBody> bodies;    ///< one per Model::rigid_bodies
  std::vector<Index> body_of_node;  ///< [node], -1 for none; empty without bodies
  double rigid_step = 1.0e30;       ///< that the rigid elements would have if they deformed [time]
  std::size_t node_count() const { return model->mesh.nodes.count(); }
};

/// Blocks for every part of the model. Parts whose section no formulation honours are errors.
World build(const model::Model& model, deck::Diagnostics& diagnostics);

/// Initial state: positions, initial velocities, masses (elements and point masses), block states.
StepStatus initialise(const World& world, State& state);

}  // namespace cleave::discretisation
