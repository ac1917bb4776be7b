#pragma once
/// Outer faces of solid meshes: what pictures and pages show.

#include <cstdint>
#include <span>
#include <vector>

#include "model/mesh.hpp"

namespace cleave::results {

/// Solid elements of one shape, as any block or result file holds them.
struct SolidCells {
  model::Shape shape = model::Shape::hex8;
  std::span<const model::Index> node;     ///< [element][nodes_of(shape)], order of the keyword format
  std::span<const std::uint8_t> alive{};  ///< [element] 0: deleted; empty: all are there
};

/// Faces that belong to one active element only, sorted by block, element and face.
///
/// A face has three or four corners; a triangle repeats its third. A face of a tet10 gives four triangles
/// between its corners and its mid nodes.
struct Surface {
  std::vector<model::Index> node;   ///< [face][4], counter-clockwise seen from outside
  std::vector<std::uint8_t> edges;  ///< [face] bit k: the side from corner k to the next is an element's edge
  std::vector<std::uint32_t> block;    ///< [face] index into the list of cells
  std::vector<std::uint32_t> element;  ///< [face] index within the block

  std::size_t count() const { return element.size(); }
};

/// Finds the outer faces of living elements (model::outer_faces knows neither deletion nor blocks). Cost:
/// sorting by the smallest node, O(n log n) at worst, linear in practice.
/// @param node_count  nodes of the model; every node index is below it
/// Elements may repeat nodes (pyramids, wedges written as hexahedra): faces that collapse are left out.
/// Shells show themselves, once. Neighbours that do not share all corners of a face (four nodes against
/// three) both show theirs.
Surface outer_faces(std::span<const SolidCells> cells, std::size_t node_count);

/// Turns faces whose normal points into their element, so that inverted numbering does no harm to shading.
/// @param position  [node][3] [length]
void orient_outwards(Surface& surface, std::span<const SolidCells> cells, std::span<const double> position);

/// Unit normals per corner, averaged over the faces around the node that lie within the crease angle of
/// the corner's own face, weighted by area; so a cylinder looks round and its rim stays sharp.
/// @param position  [node][3] [length]
/// @return          [face][4][3]
std::vector<float> corner_normals(const Surface& surface, std::span<const double> position,
                                  double crease_degrees = 35.0);

/// A value per corner: the mean over the surface's faces around the node, each with its element's value.
/// @param face_value  [face]
/// @return            [face][4]
std::vector<float> corner_averages(const Surface& surface, std::span<const float> face_value,
                                   std::size_t node_count);

}  // namespace cleave::results
