#pragma once
/// Volume and shape measures of solids in the reference configuration.

#include <span>

#include "base/tensor.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

using Corner = base::Vec3<double>;

/// Volume by 2x2x2 Gauss points (hex8, exact for straight edges), 2x3 (penta6), closed form (tetrahedra;
/// tet10 by its corners). Negative when the element is inside out. [length^3]
/// Area of tri3 and plane quad4 [length^2], length of line2 [length]; never negative.
double volume(Shape shape, std::span<const Corner> node);

/// Jacobian determinant at the centre times the parent volume: cheap, equal to the volume of a
/// parallelepiped.
double centre_volume(Shape shape, std::span<const Corner> node);

/// Smallest over largest corner Jacobian, 1 for a parallelepiped, negative for a folded corner. Corners at
/// repeated nodes are left out.
double jacobian_ratio(Shape shape, std::span<const Corner> node);

/// Length of the shortest edge of more than zero length. [length]
double shortest_edge(Shape shape, std::span<const Corner> node);

/// Longest edge over shortest, edges of zero length left out.
double aspect_ratio(Shape shape, std::span<const Corner> node);

}  // namespace cleave::model
