#pragma once
/// Elements that do not deform: mass and a surface, no force.

#include <memory>

#include "discretisation/formulation.hpp"

namespace cleave::discretisation {

/// A block for solids or shells of a part that is rigid, or whose nodes are all held. Its elements share
/// their mass equally among their nodes, have no stress, and ask for no step.
std::unique_ptr<Block> make_rigid_block(PartElements elements);

/// Thickness of the shells of a section, 0 where it is none of shells [length]
double shell_thickness(const model::Section& section);

}  // namespace cleave::discretisation
