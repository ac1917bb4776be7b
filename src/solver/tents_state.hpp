#pragma once
/// Fills the State, and what else a Frame shows, from the spacetime solution at one instant.

#include "discretisation/spacetime/observe.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

/// Nodal values are those of at_vertex(); a node on a crack shows its first side, the vertex of the mesh
/// with the lowest number. Energies, masses and momenta are integrals over the cut.
template <int D>
class StateFiller {
 public:
  using Body = discretisation::spacetime::Body<D>;
  using Vertex = discretisation::spacetime::Vertex;

  StateFiller(const model::Model& model, const Body& body,
              const discretisation::spacetime::Outside<D>& outside);

  /// Nodal masses and what does not change: once for a new state.
  void start(discretisation::State& state) const;
  /// What was exchanged before the instant that a resumed state was filled at.
  void resume(const discretisation::spacetime::Exchange<D>& exchanged) { exchanged_ = exchanged; }
  /// Position, velocity and acceleration of nodes.
  /// @param every  else of those alone that histories show or that may end the run
  void fill_nodes(discretisation::State& state, const discretisation::spacetime::Instant<D>& instant,
                  bool every);
  /// @param resumed  the state was filled at this instant before it was saved: keeps its energies, which need
  ///                 elements that are no longer there
  void fill_energies(discretisation::State& state, const discretisation::spacetime::Instant<D>& instant,
                     bool resumed);
  /// Forces of the boundary on the nodes of its held faces; others stay zero.
  void fill_reactions(const discretisation::spacetime::Instant<D>& instant);

  std::span<const double> acceleration() const { return acceleration_; }  ///< [node][3] [length/time^2]
  std::span<const double> reaction() const { return reaction_; }          ///< [node][3] [force]
  std::span<const PartMotion> motion() const { return motion_; }          ///< [part]
  const std::array<double, 3>& momentum() const { return momentum_; }     ///< of all parts
  const discretisation::spacetime::Exchange<D>& exchanged() const { return exchanged_; }
  /// Of the spacetime solved up to the instant, relative.
  double volume_error(double time) const;

 private:
  const model::Model& model_;
  const Body& body_;
  const discretisation::spacetime::Outside<D>& outside_;
  std::vector<Vertex> vertex_;   ///< [shown] vertices whose values their nodes show, ascending
  std::vector<Vertex> watched_;  ///< those of nodes that are filled at every instant
  std::vector<char> held_;       ///< [boundary face] all its nodes are held in some direction
  std::vector<double> acceleration_, reaction_;
  std::vector<PartMotion> motion_;
  std::array<double, 3> momentum_{};
  discretisation::spacetime::Exchange<D> exchanged_;
};

}  // namespace cleave::solver
