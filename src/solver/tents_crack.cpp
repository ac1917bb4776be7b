#include "solver/tents_crack.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::solver {

using namespace discretisation::spacetime;

template <int D>
CrackSides<D>::CrackSides(const model::Model& model, const Body<D>& body) {
  if (model.precracks.empty()) return;
  for (const model::Index node : model.requests.history_nodes) {
    std::vector<Vertex> sides;
    for (Vertex v = 0; v < body.mesh.vertex_count(); ++v)
      if (body.node_of_vertex[static_cast<std::size_t>(v)] == node) sides.push_back(v);
    for (std::size_t k = 1; k < sides.size(); ++k) {
      CrackOpening at{.node = node, .side = static_cast<int>(k) + 1};
      double square = 0.0;
      for (const BoundaryFace<D>& face : body.mesh.boundary()) {
        if (face.crack < 0 ||
            std::find(face.vertex.begin(), face.vertex.end(), sides[k]) == face.vertex.end())
          continue;
        for (std::size_t i = 0; i < D; ++i)
          at.normal[i] -= face.area * face.normal[i];  // outward: to the first
      }
      for (const double component : at.normal) square += component * component;
      for (double& component : at.normal) component /= square > 0.0 ? std::sqrt(square) : 1.0;
      pair_.push_back({sides[0], sides[k]});
      openings_.push_back(at);
    }
  }
}

template <int D>
void CrackSides<D>::fill(const Instant<D>& instant) {
  for (std::size_t k = 0; k < pair_.size(); ++k) {
    CrackOpening& at = openings_[k];
    const Vector<D> first = instant.at_vertex(pair_[k].first).state.u;
    const Vector<D> other = instant.at_vertex(pair_[k].other).state.u;
    Vector<D> jump;
    at.opening = 0.0;
    for (std::size_t i = 0; i < D; ++i) jump[i] = other[i] - first[i];
    for (std::size_t i = 0; i < D; ++i) at.opening += jump[i] * at.normal[i];
    if constexpr (D == 2) at.sliding = jump[1] * at.normal[0] - jump[0] * at.normal[1];
    if constexpr (D == 3) {
      double square = 0.0;
      for (std::size_t i = 0; i < D; ++i) {
        const double along = jump[i] - at.opening * at.normal[i];
        square += along * along;
      }
      at.sliding = std::sqrt(square);
    }
  }
}

template class CrackSides<1>;
template class CrackSides<2>;
template class CrackSides<3>;

}  // namespace cleave::solver
