#pragma once
/// Which stars of a space mesh are alike: the same simplices in the same order, but for rounding of their
/// coordinates.

#include <vector>

#include "discretisation/spacetime/mesh.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
class StarShapes {
 public:
  StarShapes() = default;
  explicit StarShapes(const SpaceMesh<D>& mesh);

  /// The shape of a star; the corners are those of the lowest vertex that has it. Null on a mesh that does
  /// not repeat itself.
  const StarShape<D>* of(Vertex v) const {
    const std::int32_t s = !repeating_ ? -1 : shape_of_[static_cast<std::size_t>(v)];
    return s < 0 ? nullptr : &shapes_[static_cast<std::size_t>(s)];
  }
  /// Are all simplices of few shapes?
  bool repeating() const { return repeating_; }
  /// And of different sizes?
  bool graded() const { return graded_; }

 private:
  std::vector<StarShape<D>> shapes_;
  std::vector<std::int32_t> shape_of_;  ///< [vertex]
  bool repeating_ = false, graded_ = false;
};

}  // namespace cleave::discretisation::spacetime
