#pragma once
/// The ways to find touches; each in the file of its name.

#include <memory>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Nodes that look at faces.
struct NodeSides {
  std::vector<Index> nodes;           ///< empty: all of the surface `of_nodes`
  std::shared_ptr<Surface> of_nodes;  ///< the faces around the nodes
  std::shared_ptr<Surface> faces;
  bool reverse = false;  ///< the nodes are of side B of the card
  bool single = false;   ///< both are one surface
};

/// @param factor  SLSFAC [-]
/// @param rule    PENOPT: 1 the softer side, 2 side B, 3 side A
std::unique_ptr<Finder> make_node_finder(const NodeSides& sides, const model::Contact& contact, double factor,
                                         int rule);
/// Faces against faces; a and b may be one surface.
std::unique_ptr<Finder> make_segment_finder(std::shared_ptr<Surface> a, std::shared_ptr<Surface> b,
                                            const model::Contact& contact, double factor, int rule);

}  // namespace cleave::solver
