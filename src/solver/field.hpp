#pragma once
/// Reading nodal fields [node][3] as vectors.

#include <cmath>
#include <span>

#include "base/tensor.hpp"
#include "model/mesh.hpp"

namespace cleave::solver {

inline base::Vec3<double> vector_at(std::span<const double> field, model::Index node) {
  const double* v = &field[3 * static_cast<std::size_t>(node)];
  return {v[0], v[1], v[2]};
}

/// Unit normal of the plane of three nodes (right-hand rule); zero when they are in line.
/// @param position  [node][3] [length]
inline base::Vec3<double> normal_of(std::span<const double> position, const model::Index (&node)[3]) {
  const base::Vec3<double> first = vector_at(position, node[0]);
  const base::Vec3<double> normal =
      base::cross(vector_at(position, node[1]) - first, vector_at(position, node[2]) - first);
  const double length = std::sqrt(base::dot(normal, normal));
  return length > 0.0 ? (1.0 / length) * normal : base::Vec3<double>{0, 0, 0};
}

}  // namespace cleave::solver
