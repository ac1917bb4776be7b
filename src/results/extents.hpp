#pragma once
/// Size and shape of parts: what a Taylor test is read off from.

#include <span>
#include <vector>

#include "discretisation/world.hpp"

namespace cleave::results {

/// Box around the nodes of a part's living elements, and how wide the part is about each axis [length].
struct Extent {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  double diameter[3] = {0, 0, 0};  ///< twice the largest distance from the part's axis along x, y, z
  std::size_t elements = 0;        ///< living
  double length(int axis) const { return high[axis] - low[axis]; }
};

/// The axes of a part: lines through the middle of its box, or in the planes of symmetry that bound it.
struct PartAxes {
  double centre[3] = {0, 0, 0};  ///< reference configuration [length]
  bool symmetry[3] = {false, false,
                      false};  ///< all nodes on one bounding plane across the axis are held in it
};

/// Axes of each part, from the reference configuration and the fixed nodes [part].
std::vector<PartAxes> part_axes(const discretisation::World& world);

/// Extents in a given configuration [part].
/// @param position  [node][3]
/// @param state     null: every element counts
std::vector<Extent> extents(const discretisation::World& world, std::span<const double> position,
                            const discretisation::State* state, std::span<const PartAxes> axes);

}  // namespace cleave::results
