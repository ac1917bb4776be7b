#pragma once
/// From a pole to the spacetime simplices around it.

#include <string>

#include "discretisation/spacetime/patch.hpp"
#include "discretisation/spacetime/pitcher.hpp"

namespace cleave::discretisation::spacetime {

/// Fills `patch` with the simplices between the front and the front with the pole's vertex moved to its top:
/// one per simplex of the star. Reuses the memory of `patch`.
template <int D>
void build_patch(const SpaceMesh<D>& mesh, const Front<D>& front, const Pole<D>& pole, Patch<D>& patch);

/// What is wrong with a patch; empty when nothing is. Volumes must be positive, inflow and outflow facets
/// causal for the fastest wave of their material, interior facets shared by exactly two elements with
/// opposite normals, boundary facets vertical, and the normals of each element must add to zero within 1e-12
/// of their sizes.
template <int D>
std::string fault_of(const SpaceMesh<D>& mesh, const Patch<D>& patch);

}  // namespace cleave::discretisation::spacetime
