#pragma once
/// Coulomb friction between the impulses of a node that a rigid wall stops.

#include <span>

#include "model/load.hpp"

namespace cleave::solver {

/// The part of the sliding velocity that friction takes away: against it, at most the coefficient times the
/// normal change of velocity. With coefficients along two directions the limit is an ellipse and the impulse
/// the point of it nearest to the one that would hold the node, which is the impulse that takes most energy;
/// each coefficient falls from its static to its dynamic value with the speed of sliding.
/// The same holds for forces: of the spring that would hold the node, and the normal one.
/// @param sliding   relative to the wall, in its plane [length/time, or force]
/// @param speed     of sliding [length/time]
/// @param gain      normal change of velocity, not below zero [as sliding]
/// @param normal    of the wall, unit
/// @param position  [node][3], for a direction given by nodes [length]
/// Source: Wriggers 2006, Computational Contact Mechanics, sec. 4.2 (Coulomb's law as a maximum of
/// dissipation).
model::Vector friction_change(const model::RigidWall& wall, const model::Vector& sliding, double speed,
                              double gain, const model::Vector& normal, std::span<const double> position);

}  // namespace cleave::solver
