#pragma once
/// A tent: the spacetime simplices between the old and the new front around one pole. What the front and the
/// pitcher hand to the patch solver; what comes back is committed to the front whole or not at all.
///
/// D is the space dimension, 1, 2 or 3. A spacetime point has D + 1 coordinates, time last.
/// Notation and equations: docs/spacetime.md and the papers named there.

#include <array>
#include <cstdint>
#include <vector>

namespace cleave::discretisation::spacetime {

using Vertex = std::int32_t;   ///< number of a vertex of the space mesh
using Simplex = std::int32_t;  ///< number of a simplex of the space mesh (a cell of the front)

/// x_1 .. x_D, t. [length], [time]
template <int D>
using Event = std::array<double, D + 1>;

enum class FacetKind : std::uint8_t {
  inflow,    ///< on the old front: data come from the older element of the same simplex
  outflow,   ///< on the new front
  interior,  ///< contains the pole, shared by two elements of the patch
  boundary   ///< contains the pole, on the boundary of the body (or on a crack face)
};

/// A facet of a patch element.
///
/// `normal` is the area vector of the facet in spacetime, N_k of the specification: outward from `element`,
/// its length is the measure of the facet, so that the integral of f n_t - g_j n_j is the weighted mean of f
/// N_t - g_j N_j (weights sum to one). [length^(D-1) time] in space, [length^D] in time
template <int D>
struct Facet {
  FacetKind kind = FacetKind::inflow;
  std::int32_t element = -1;    ///< in the patch
  std::int32_t neighbour = -1;  ///< interior: the element on the other side; else -1
  std::int32_t boundary = -1;   ///< boundary: index of the boundary face of the mesh; else -1
  std::int32_t twin = -1;       ///< interior: the same facet in Patch::facets as seen by `neighbour`; else -1
  std::array<Event<D>, D + 1> corner;  ///< with the pole: foot, the others by ascending vertex, top
  Event<D> normal;
};

/// One spacetime simplex of a patch.
template <int D>
struct PatchElement {
  Simplex simplex = -1;                ///< of the front, below and above it
  std::array<Event<D>, D + 2> corner;  ///< foot of the pole, the D others, top of the pole
  double volume = 0.0;                 ///< [length^D time]
  std::int32_t material = 0;           ///< index of the part
};

/// The star of a vertex that many others of the mesh look like, as seen from the vertex.
template <int D>
struct StarShape {
  /// Corners of each simplex other than the vertex, relative to it; order as in PatchElement. [length]
  std::vector<std::array<std::array<double, D>, D>> corner;
};

template <int D>
struct Patch {
  Vertex pole = -1;
  Event<D> foot, top;                     ///< of the pole
  std::vector<PatchElement<D>> elements;  ///< in ascending simplex number
  /// D + 2 per element: inflow, outflow, then the D that contain the pole (facet 2 + i is opposite corner 1 +
  /// i). An interior facet is listed by both its elements: same corners in the same order, exactly opposite
  /// normals.
  std::vector<Facet<D>> facets;
  /// Under a vertical pole whose star is one of many: equal tents may share what is worked out for one of
  /// them. Else null.
  const StarShape<D>* shape = nullptr;
};

}  // namespace cleave::discretisation::spacetime
