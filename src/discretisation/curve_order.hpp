#pragma once
/// An order of elements in which neighbours in the list are neighbours in space.

#include <cstdint>
#include <vector>

#include "model/mesh.hpp"

namespace cleave::discretisation {

/// Position on a Hilbert curve of 2^20 cells per axis through the unit cube.
/// Source: Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004) 381-387.
/// @param x  [3], each in 0 .. 2^20 - 1
std::uint64_t hilbert_index(const std::uint32_t x[3]);

/// Permutation of elements along a Hilbert curve through their centroids; ties keep the given order.
/// @param node      [element][nodes_per_element]
/// @param position  [node][3] [length]
std::vector<model::Index> curve_order(const std::vector<model::Index>& node, int nodes_per_element,
                                      const std::vector<double>& position);

}  // namespace cleave::discretisation
