#pragma once
/// The words in which a space mesh is refused: the user's numbers and a place.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "discretisation/spacetime/mesh.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
class Words {
 public:
  explicit Words(const SpaceMeshInput<D>& input) : input_(input) {}

  std::int64_t element_id(std::size_t s) const {
    return s < input_.simplex_id.size() ? input_.simplex_id[s] : static_cast<std::int64_t>(s) + 1;
  }
  std::int64_t vertex_id(std::size_t v) const {
    return v < input_.vertex_id.size() ? input_.vertex_id[v] : static_cast<std::int64_t>(v) + 1;
  }
  std::string element(std::size_t s) const { return std::to_string(element_id(s)); }
  std::string vertex(std::size_t v) const { return std::to_string(vertex_id(v)); }

  /// " at (x, y)".
  std::string at(const Point<D>& x) const {
    std::string text = " at (";
    for (std::size_t k = 0; k < D; ++k) {
      char number[32];
      std::snprintf(number, sizeof number, "%s%.6g", k ? ", " : "", x[k]);
      text += number;
    }
    return text + ")";
  }

  MeshFault fault(std::string what, std::string cause, const std::vector<std::size_t>& elements,
                  const std::vector<std::size_t>& vertices) const {
    MeshFault fault{
        .ok = false, .what = std::move(what), .likely_cause = std::move(cause), .element = {}, .vertex = {}};
    for (const std::size_t s : elements) fault.element.push_back(element_id(s));
    for (const std::size_t v : vertices) fault.vertex.push_back(vertex_id(v));
    std::sort(fault.element.begin(), fault.element.end());
    std::sort(fault.vertex.begin(), fault.vertex.end());
    return fault;
  }

 private:
  const SpaceMeshInput<D>& input_;
};

}  // namespace cleave::discretisation::spacetime
