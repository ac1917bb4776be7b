#pragma once
/// What an incident plane wave brings to a silent face.

#include "discretisation/spacetime/body_motion.hpp"
#include "discretisation/spacetime/target.hpp"

namespace cleave::discretisation::spacetime {

/// The characteristic s + Z v that a plane wave brings to a face, for make_silent(). Exact in the exterior
/// whatever the angle between wave and face.
/// @param stress   in the wave at its reference point, over time [stress]
/// @param material behind the face, isotropic; the exterior is of the same
/// @param normal   of the face, outward
template <int D>
VectorField<D> incident_characteristic(const model::IncidentWave& wave, History stress,
                                       const Elastic<D>& material, const Vector<D>& normal);

}  // namespace cleave::discretisation::spacetime
