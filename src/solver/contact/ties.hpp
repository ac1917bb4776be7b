#pragma once
/// Which nodes a tied contact joins to which points of faces.

#include "solver/contact/surface.hpp"

namespace cleave::solver {

struct Tie {
  Index node;
  Index corner[4];
  double weight[4];  ///< of the closest point, summing to 1
  double offset[3];  ///< from that point to the node at the start [length]
};

/// Nodes of side A within 5 % of the shorter diagonal of a face of side B (or the distance the card gives),
/// each with its closest point; nodes of side B and nodes tied before are left out. A warning counts those
/// too far away; that none is near is an error.
std::vector<Tie> find_ties(const discretisation::World& world, const model::Contact& contact,
                           deck::Diagnostics& diagnostics);

}  // namespace cleave::solver
