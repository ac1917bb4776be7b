#pragma once
/// Stresses of single elements at an instant.

#include "discretisation/spacetime/observe.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

template <int D>
class ElementProbes {
 public:
  /// Of the elements of *DATABASE_HISTORY_SOLID, _SHELL or _BEAM, by the dimension of the body.
  ElementProbes(const model::Model& model, const discretisation::spacetime::Body<D>& body);

  /// Stress in the middle of each element; of an element in several simplices the mean over their middles, by
  /// volume. Across the plane and across a bar it is what keeps plane or uniaxial strain.
  std::vector<ElementStress> at(const discretisation::spacetime::Instant<D>& instant) const;

 private:
  struct Piece {
    discretisation::spacetime::Simplex simplex;
    discretisation::spacetime::Point<D> middle;
    double share;  ///< of the element's volume
  };
  struct Probe {
    discretisation::Id element;
    model::Index part;
    std::vector<Piece> pieces;
    double lateral = 0.0;  ///< of a bar: stress across it over the stress along it
  };
  std::vector<Probe> probes_;
};

}  // namespace cleave::solver
