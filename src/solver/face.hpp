#pragma once
/// Integrals over the faces that loads and absorbing boundaries act on.

#include <array>
#include <span>

#include "base/tensor.hpp"
#include "model/mesh.hpp"

namespace cleave::solver {

inline bool is_triangle(const model::Segment& face) {
  return face.node[3] == face.node[2];
}

/// Integral of N_a n dA for each corner a, N_a bilinear (exact, in closed form) or linear on triangles.
/// The corners of a parallelogram get the same bits (docs/decisions/0007-pressure-on-faces.md).
/// Corners of the same node (the third and fourth of a triangle) do not share: the fourth gets nothing.
/// @param position [node][3] [length]
/// @return area vectors, outward where the corners run counter-clockwise seen from outside [length^2]
std::array<base::Vec3<double>, 4> face_vectors(const model::Segment& face, std::span<const double> position);

/// The same for a face with six nodes (three corners, then the nodes amid the edges 12, 23, 31), N_a
/// quadratic. The integrand has degree four, for which the rule of six points is exact. Source: Dunavant
/// 1985, degree 4.
std::array<base::Vec3<double>, 6> face_vectors(const std::array<model::Index, 6>& face,
                                               std::span<const double> position);

}  // namespace cleave::solver
