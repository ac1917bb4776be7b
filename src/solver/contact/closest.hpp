#pragma once
/// The point of a face that is closest to a given point.

#include "solver/contact/surface.hpp"

namespace cleave::solver {

struct Closest {
  Vector point;      ///< of the face
  double weight[4];  ///< of the corners in it, summing to 1
  Vector normal;     ///< of the flat piece it lies on, times twice its area
  int edge = -1;     ///< on the edge from this corner to the next; -1 inside or on a corner
  int corner = -1;   ///< on this corner
  bool inside() const { return edge < 0 && corner < 0; }
};

/// Quadrilaterals are four triangles that meet in the mean of the corners, so that neighbours join without a
/// gap however warped they are. Source: Ericson, Real-Time Collision Detection (2005), sec. 5.1.5.
Closest closest_point(const Face& face, const Vector corner[4], const Vector& p);

}  // namespace cleave::solver
