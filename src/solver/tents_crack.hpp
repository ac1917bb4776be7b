#pragma once
/// How far cracks are open at the nodes of a history.

#include "discretisation/spacetime/observe.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

template <int D>
class CrackSides {
 public:
  /// The sides of a node are the vertices that its crack was opened into, ascending. The normal of a side is
  /// the mean of its crack faces by area.
  CrackSides(const model::Model& model, const discretisation::spacetime::Body<D>& body);

  void fill(const discretisation::spacetime::Instant<D>& instant);
  std::span<const CrackOpening> openings() const { return openings_; }

 private:
  using Vertex = discretisation::spacetime::Vertex;
  struct Pair {
    Vertex first, other;
  };
  std::vector<Pair> pair_;  ///< [opening]
  std::vector<CrackOpening> openings_;
};

}  // namespace cleave::solver
