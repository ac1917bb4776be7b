#pragma once
/// How two faces lie over each other: the polygon they share, seen along their common normal.

#include "solver/contact/surface.hpp"

namespace cleave::solver {

struct Overlap {
  Vector normal;           ///< unit, from b to a: the mean of the normal of b and the opposite of that of a
  double facing = 0.0;     ///< minus the cosine between the normals: 1 where they look at each other
  double area = 0.0;       ///< of the shared polygon, across the normal [length^2]
  double deep_area = 0.0;  ///< of its part where a is behind b [length^2]
  double volume = 0.0;     ///< between the faces there [length^3]
  double wa[4], wb[4];     ///< shares of the corners in that volume; each sums to 1
};

/// A quadrature point of the shared polygon.
struct SharedPoint {
  double area;          ///< [length^2]
  double gap;           ///< from a to b along the normal, positive where a is behind b [length]
  double wa[4], wb[4];  ///< values of the corner functions
};

/// Integrates the depth of face a behind face b over the polygon both cover, with the bilinear (triangles:
/// linear) functions of both. The integrals are exact for constant depth on parallelograms and triangles, so
/// that a constant pressure between unlike meshes gives each node its consistent share (the patch test; Puso
/// & Laursen 2004, sec. 3, for the segments). Faces that are not plane are clipped as if they were.
/// @param a, b  corners; triangles repeat the third [length]
/// @param whole  if given: the quadrature points of the whole polygon, whatever the depth, and no integrals
/// @return false where they share nothing, do not look at each other, or a is nowhere behind b
bool overlap(const Vector a[4], const Vector b[4], Overlap& out, std::vector<SharedPoint>* whole = nullptr);

}  // namespace cleave::solver
