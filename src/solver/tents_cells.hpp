#pragma once
/// Field cells of a spacetime solution at one instant.

#include "discretisation/spacetime/observe.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

/// Each simplex of the undeformed space mesh in `subdivision`^D equal parts, with points of its own: fields
/// are polynomials in an element and jump between elements. Fields: displacement, velocity, stress (in the
/// order of discretisation/spacetime/elastic.hpp), strain_energy_density; von_mises beyond one dimension,
/// with the stress across the plane; in the plane max_shear_stress (half the difference of the principal
/// stresses in it) and stress_across.
/// @param subdivision  at least 1
template <int D>
CellFields cells_at(const model::Model& model, const discretisation::spacetime::Body<D>& body,
                    const discretisation::spacetime::Instant<D>& instant, int subdivision);

}  // namespace cleave::solver
