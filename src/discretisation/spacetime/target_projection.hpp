#pragma once
/// Boundary conditions that prescribe the velocity along some directions and the traction along the others.

#include "discretisation/spacetime/target.hpp"

namespace cleave::discretisation::spacetime {

/// `fixed` projects on the directions of prescribed velocity. The star traction is
/// s* = (1 - P) t + P a, with a such that P v* = P v_prescribed and v* obeys the characteristic rule; with P
/// = 0 that is prescribed traction, with P = 1 prescribed velocity s* = s + Z (v_prescribed - v).
template <int D>
void projected_map(const Interface<D>& facet, const Matrix<D>& fixed, StarMap<D>& map);
template <int D>
void projected_load(const Interface<D>& facet, const Matrix<D>& fixed, const Vector<D>& velocity,
                    const Vector<D>& traction, Star<D>& load);

}  // namespace cleave::discretisation::spacetime
