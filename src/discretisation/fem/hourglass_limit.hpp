#pragma once
/// How much viscous hourglass control the time step bears.

#include "discretisation/formulation.hpp"

namespace cleave::discretisation::fem {

/// The largest stable coefficient, and the element that sets it.
struct ViscousLimit {
  double coefficient = 0.0;  ///< QM [-]
  Id element = 0;
};

/// Largest QM of hourglass types 1 to 3 for which no hourglass mode of an element grows, when the step is
/// TSSFAC times the smallest L/c of the part: QM = V^(1/3) / (lambda TSSFAC min L), lambda the largest
/// eigenvalue of gamma_k . gamma_l, 8 for a parallelepiped. By the eigenvalue inequality of elements it
/// holds for the mesh, and a mesh of equal bricks attains it. Theory: docs/formulations/hourglass.md.
/// @param elements  hexahedra of one part, at least one, none of zero volume
ViscousLimit viscous_hourglass_limit(const PartElements& elements);

/// Says so where the part asks for more than that.
void warn_of_unstable_hourglass(const PartElements& elements, deck::Diagnostics& diagnostics);

}  // namespace cleave::discretisation::fem
