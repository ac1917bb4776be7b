#include "solver/tents_elements.hpp"

#include <cmath>
#include <map>

#include "model/elasticity.hpp"

namespace cleave::solver {

using namespace discretisation::spacetime;

template <int D>
ElementProbes<D>::ElementProbes(const model::Model& model, const Body<D>& body) {
  const auto& wanted = D == 1   ? model.requests.history_beams
                       : D == 2 ? model.requests.history_shells
                                : model.requests.history_solids;
  if (wanted.empty()) return;
  std::map<discretisation::Id, std::vector<Simplex>> simplices;
  for (const discretisation::Id element : wanted) simplices[element];
  for (Simplex s = 0; s < body.mesh.simplex_count(); ++s)
    if (const auto at = simplices.find(body.element_of_simplex[static_cast<std::size_t>(s)]);
        at != simplices.end())
      at->second.push_back(s);
  for (const discretisation::Id element : wanted) {
    Probe probe{.element = element, .part = -1, .pieces = {}};
    double volume = 0.0;
    for (const Simplex s : simplices[element]) {
      std::array<Point<D>, D + 1> corner;
      Point<D> middle{};
      for (std::size_t c = 0; c <= D; ++c) {
        corner[c] = body.mesh.position()[static_cast<std::size_t>(body.mesh.simplex(s)[c])];
        for (std::size_t k = 0; k < D; ++k) middle[k] += corner[c][k] / (D + 1);
      }
      probe.part = body.mesh.material(s);
      probe.pieces.push_back({s, middle, std::fabs(signed_volume<D>(corner))});
      volume += probe.pieces.back().share;
    }
    if (probe.pieces.empty()) continue;
    for (Piece& piece : probe.pieces) piece.share /= volume;
    if (D == 1) {
      const model::Part& part = model.parts[static_cast<std::size_t>(probe.part)];
      if (part.section.form == 2 && part.elastic)
        probe.lateral = part.elastic->poisson / (1.0 - part.elastic->poisson);
    }
    probes_.push_back(std::move(probe));
  }
}

template <int D>
std::vector<ElementStress> ElementProbes<D>::at(const Instant<D>& instant) const {
  static constexpr int component[3][6] = {{0}, {0, 1, 3}, {0, 1, 2, 3, 4, 5}};
  std::vector<ElementStress> all;
  for (const Probe& probe : probes_) {
    ElementStress out{.element = probe.element, .part = probe.part};
    for (const Piece& piece : probe.pieces) {
      const PlaceState<D> place = instant.at(piece.simplex, piece.middle);
      for (std::size_t c = 0; c < place.stress.size(); ++c)
        out.stress[component[D - 1][c]] += piece.share * place.stress[c];
      if (D == 2) out.stress[2] += piece.share * place.across;
    }
    if (D == 1) out.stress[1] = out.stress[2] = probe.lateral * out.stress[0];
    all.push_back(out);
  }
  return all;
}

template class ElementProbes<1>;
template class ElementProbes<2>;
template class ElementProbes<3>;

}  // namespace cleave::solver
