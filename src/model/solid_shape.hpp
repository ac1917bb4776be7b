#pragma once
/// Which solid the eight or ten nodes of an *ELEMENT_SOLID row make, and its faces.

#include <array>
#include <span>

#include "model/mesh.hpp"

namespace cleave::model {

struct Classified {
  bool ok = false;
  Shape shape = Shape::hex8;
  int node_count = 0;
  std::array<Id, 10> node{};
};

/// Classifies a row by its repeated nodes and unfolds wedges and tetrahedra into their own order.
///
/// `node` holds ten ids, 0 where the column is blank. Ten distinct nodes are a quadratic tetrahedron; N4 =
/// ... = N8 or N5..N8 blank a tetrahedron; two opposite edges of one face collapsed a wedge (N5 = N6, N7 = N8
/// is the documented form, the others are turned copies); four equal nodes of a face a pyramid, kept as hex8.
/// Fails (ok = false) for fewer nodes, and for repeats that no edge or face of a hexahedron joins.
Classified classify(std::span<const Id, 10> node);

/// Faces of a shape as local node numbers, counter-clockwise seen from outside; triangles repeat the third.
/// Mid nodes of tet10 are left out.
std::span<const std::array<int, 4>> faces_of(Shape shape);

}  // namespace cleave::model
