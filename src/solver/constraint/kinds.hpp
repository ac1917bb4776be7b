#pragma once
/// The constraints there are; each in the file of its name.

#include <memory>
#include <vector>

#include "solver/action.hpp"

namespace cleave::solver {

using ConstraintList = std::vector<std::unique_ptr<Constraint>>;

void add_dashpots(const discretisation::World& world, ConstraintList& list, deck::Diagnostics& diagnostics);
void add_tied_nodes(const discretisation::World& world, ConstraintList& list, deck::Diagnostics& diagnostics);
void add_rigid_walls(const discretisation::World& world, ConstraintList& list,
                     deck::Diagnostics& diagnostics);
std::unique_ptr<Constraint> make_geometric_wall(const model::Model& model, std::size_t number,
                                                deck::Diagnostics& diagnostics);
void add_rigid_bodies(const discretisation::World& world, ConstraintList& list,
                      deck::Diagnostics& diagnostics);
void add_held_nodes(const model::Model& model, ConstraintList& list, deck::Diagnostics& diagnostics);

}  // namespace cleave::solver
