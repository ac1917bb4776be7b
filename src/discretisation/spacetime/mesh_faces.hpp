#pragma once
/// Faces of simplices as lists of vertices.

#include <algorithm>

#include "discretisation/spacetime/patch.hpp"

namespace cleave::discretisation::spacetime {

/// The face opposite a local corner, in local order.
template <int D>
std::array<Vertex, D> face_of(const std::array<Vertex, D + 1>& simplex, int opposite) {
  std::array<Vertex, D> face;
  for (int i = 0, to = 0; i <= D; ++i)
    if (i != opposite) face[static_cast<std::size_t>(to++)] = simplex[static_cast<std::size_t>(i)];
  return face;
}

template <std::size_t N>
std::array<Vertex, N> sorted(std::array<Vertex, N> face) {
  std::sort(face.begin(), face.end());
  return face;
}

}  // namespace cleave::discretisation::spacetime
