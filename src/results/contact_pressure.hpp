#pragma once
/// Pressure of contact on the nodes of its surfaces.

#include <vector>

#include "solver/solver.hpp"

namespace cleave::results {

/// Contact force of each node along the area of the faces around it, per area; positive pushes into the body
/// [node] [stress]. Faces are those of the sides of the contacts at the start, where they are now; 0
/// elsewhere.
std::vector<double> contact_pressure(const solver::Frame& frame);

}  // namespace cleave::results
