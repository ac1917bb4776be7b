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
std::unique_ptr<Gauge> make_node_finder(const NodeSides& sides, const model::Contact& contact, double factor,
                                        int rule);
/// Faces against faces; a and b may be one surface.
std::unique_ptr<Finder> make_segment_finder(std::shared_ptr<Surface> a, std::shared_ptr<Surface> b,
                                            const model::Contact& contact, double factor, int rule);

/// Springs between faces that lie on each other at the start, for tied contacts with an offset.
std::unique_ptr<Interaction> make_tied_faces(const discretisation::World& world, std::size_t number,
                                             deck::Diagnostics& diagnostics);

/// Moves nodes that penetrate at the start out of the other side, and says which and how far.
/// @param finders  of nodes against faces
void move_out(model::Model& model, const model::Contact& contact,
              const std::vector<std::unique_ptr<Gauge>>& finders, deck::Diagnostics& diagnostics);

/// Says which nodes penetrate at the start and how deep; refuses those more than an element below the
/// surface.
/// @param finders  of nodes against faces
void report_initial(const model::Model& model, const model::Contact& contact,
                    const std::vector<std::unique_ptr<Gauge>>& finders, deck::Diagnostics& diagnostics);

/// What turns touches into forces and remembers them.
/// @param gauges       nodes of both sides, for output
/// @param force_scale  what a force of this contact may well be [force]
/// @param stiffest     largest stiffness of its faces [force/length]
std::unique_ptr<Interaction> make_interface(const model::Model& model, std::size_t number,
                                            std::vector<std::unique_ptr<Finder>> finders,
                                            std::vector<std::unique_ptr<Gauge>> gauges, double force_scale,
                                            double stiffest);

}  // namespace cleave::solver
