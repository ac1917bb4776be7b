#include "discretisation/spacetime/tent.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::discretisation::spacetime {
namespace {

template <int D>
double space_length(const Event<D>& normal) {
  double sum = 0.0;
  for (std::size_t k = 0; k < D; ++k) sum += normal[k] * normal[k];
  return std::sqrt(sum);
}

}  // namespace

template <int D>
void build_patch(const SpaceMesh<D>& mesh, const Front<D>& front, const Pole<D>& pole, Patch<D>& patch) {
  constexpr auto N = static_cast<std::size_t>(D + 1);
  const auto star = mesh.star(pole.vertex);
  patch.pole = pole.vertex;
  patch.foot = pole.foot;
  patch.top = pole.top;
  patch.shape = pole.shape;
  patch.elements.resize(star.size());
  patch.facets.resize(star.size() * (D + 2));

  for (std::size_t e = 0; e < star.size(); ++e) {
    const Simplex s = star[e];
    std::array<std::pair<Vertex, int>, D> others;  // vertex and its local number in the simplex
    for (int i = 0, to = 0; i <= D; ++i)
      if (const Vertex v = mesh.simplex(s)[static_cast<std::size_t>(i)]; v != pole.vertex)
        others[static_cast<std::size_t>(to++)] = {v, i};
    std::sort(others.begin(), others.end());

    PatchElement<D>& element = patch.elements[e];
    element.simplex = s;
    element.material = mesh.material(s);
    element.corner[0] = pole.foot;
    for (std::size_t i = 0; i < D; ++i) element.corner[i + 1] = front.event(others[i].first);
    element.corner[D + 1] = pole.top;
    element.volume = std::abs(signed_volume<N>(element.corner));

    const auto facet = [&](std::size_t number, std::size_t opposite) -> Facet<D>& {
      Facet<D>& f = patch.facets[e * (D + 2) + number];
      f = {};
      f.element = static_cast<std::int32_t>(e);
      for (std::size_t i = 0, to = 0; i < D + 2; ++i)
        if (i != opposite) f.corner[to++] = element.corner[i];
      f.normal = area_vector<N>(f.corner, element.corner[opposite]);
      return f;
    };
    facet(0, D + 1).kind = FacetKind::inflow;
    facet(1, 0).kind = FacetKind::outflow;
    for (std::size_t i = 0; i < D; ++i) {
      Facet<D>& f = facet(2 + i, 1 + i);
      const Simplex across = mesh.across(s, others[i].second);
      if (across < 0) {
        f.kind = FacetKind::boundary;
        f.boundary = mesh.boundary_face(s, others[i].second);
        continue;
      }
      f.kind = FacetKind::interior;
      f.neighbour =
          static_cast<std::int32_t>(std::lower_bound(star.begin(), star.end(), across) - star.begin());
      const auto other = static_cast<std::size_t>(f.neighbour);
      if (other > e) continue;
      // The other side was listed before: give both the same bits.
      for (std::size_t j = 0; j < D; ++j) {
        const std::size_t at = other * (D + 2) + 2 + j;
        Facet<D>& twin = patch.facets[at];
        if (twin.kind != FacetKind::interior || twin.neighbour != static_cast<std::int32_t>(e)) continue;
        f.twin = static_cast<std::int32_t>(at);
        twin.twin = static_cast<std::int32_t>(e * (D + 2) + 2 + i);
        for (std::size_t k = 0; k <= D; ++k) f.normal[k] = -twin.normal[k];
      }
    }
  }
}

template <int D>
std::string fault_of(const SpaceMesh<D>& mesh, const Patch<D>& patch) {
  for (std::size_t e = 0; e < patch.elements.size(); ++e) {
    const PatchElement<D>& element = patch.elements[e];
    const std::string name = "tent over element " + std::to_string(mesh.simplex_id(element.simplex));
    const double speed = mesh.speed(element.simplex).fastest;
    if (!(element.volume > 0.0)) return name + " has no volume";
    Event<D> sum{}, size{};
    for (std::size_t i = 0; i < D + 2; ++i) {
      const Facet<D>& f = patch.facets[e * (D + 2) + i];
      for (std::size_t k = 0; k <= D; ++k) {
        sum[k] += f.normal[k];
        size[k] += std::abs(f.normal[k]);
      }
      // A facet of slope 1 / c has |N_x| c = |N_t|.
      const double across = space_length<D>(f.normal) * speed, up = f.normal[D];
      if (f.kind == FacetKind::inflow && !(-up > 0.0 && across <= -up * (1.0 + 1e-9)))
        return name + " stands on a front steeper than its waves";
      if (f.kind == FacetKind::outflow && !(up > 0.0 && across <= up * (1.0 + 1e-9)))
        return name + " ends in a front steeper than its waves";
      if (f.kind == FacetKind::boundary && !(std::abs(up) <= 1e-9 * across))
        return name + " leans out of the boundary";
      if (f.kind == FacetKind::interior) {
        if (f.twin < 0) return name + " has an interior facet without another side";
        const Facet<D>& twin = patch.facets[static_cast<std::size_t>(f.twin)];
        if (twin.element != f.neighbour || twin.neighbour != f.element || twin.corner != f.corner)
          return name + " shares a facet with the wrong element";
        for (std::size_t k = 0; k <= D; ++k)
          if (twin.normal[k] != -f.normal[k]) return name + " shares a facet whose normals differ";
      }
    }
    for (std::size_t k = 0; k <= D; ++k)
      if (!(std::abs(sum[k]) <= 1e-12 * size[k])) return name + " is not closed by its facets";
  }
  return {};
}

#define CLEAVE_TENT(D)                                                                           \
  template void build_patch<D>(const SpaceMesh<D>&, const Front<D>&, const Pole<D>&, Patch<D>&); \
  template std::string fault_of<D>(const SpaceMesh<D>&, const Patch<D>&);
CLEAVE_TENT(1)
CLEAVE_TENT(2)
CLEAVE_TENT(3)
#undef CLEAVE_TENT

}  // namespace cleave::discretisation::spacetime
