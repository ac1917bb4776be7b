#pragma once
/// Which nodes a tied contact joins to which points of faces.

#include "solver/contact/surface.hpp"

namespace cleave::solver {

struct Tie {
  Index node;
  Index corner[4];
  double weight[4];   ///< of the closest point, summing to 1
  double offset[3];   ///< from that point to the node at the start [length]
  std::int32_t face;  ///< of the surface of side B
};

/// Nodes of side A near a face of side B, each with its closest point: within the distance the card gives,
/// else 5 % of the shorter diagonal, or half an element for ties with an offset; nodes of side B are left
/// out. A note counts those too far away; that none is near is an error.
std::vector<Tie> find_ties(const discretisation::World& world, const model::Contact& contact,
                           deck::Diagnostics& diagnostics);

/// Does the node belong to the rigid body whose face it is tied to? Then that moves it.
bool joined(const discretisation::World& world, const Tie& tie);

}  // namespace cleave::solver
