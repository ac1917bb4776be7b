#pragma once
/// Nodes and elements as asked for: ids resolved to indices, nothing else.

#include <cstdint>
#include <string_view>
#include <vector>

namespace cleave::model {

using Id = std::int64_t;
using Index = std::int32_t;  ///< position in an array of the model; -1 for none

enum class Shape : std::uint8_t { hex8, penta6, tet4, tet10, tri3, quad4, line2 };
constexpr int nodes_of(Shape shape) {
  switch (shape) {
    case Shape::hex8:
      return 8;
    case Shape::penta6:
      return 6;
    case Shape::tet4:
      return 4;
    case Shape::tet10:
      return 10;
    case Shape::tri3:
      return 3;
    case Shape::quad4:
      return 4;
    case Shape::line2:
      return 2;
  }
  return 0;
}
std::string_view name_of(Shape shape);

struct Nodes {
  std::vector<Id> id;            ///< ascending; the index of a node is its rank
  std::vector<double> position;  ///< [node][3], reference configuration [length]

  std::vector<Index> dense;  ///< id - id.front() to index, -1 in gaps; empty unless index() found it worth it

  std::size_t count() const { return id.size(); }
  Index find(Id wanted) const;  ///< -1 when there is no such node
  void index();                 ///< prepares find() for speed; call after `id` has changed
};

/// Elements of one shape.
///
/// Node order is that of the keyword format: hex8 1-4 bottom counter-clockwise, 5-8 above;
/// penta6 is the wedge with triangles (0,1,2) below and (3,4,5) above, unfolded from N1 N2 N3 N4 N5=N6 N7=N8;
/// tet10 has mid nodes on edges 12 23 31 14 24 34. A hex8 may repeat nodes (pyramids). Shells are tri3 and
/// quad4, beams line2.
struct Elements {
  Shape shape = Shape::hex8;
  std::vector<Id> id;
  std::vector<Index> part;  ///< index into Model::parts
  std::vector<Index> node;  ///< [element][nodes_of(shape)]

  std::size_t count() const { return id.size(); }
};

/// Kinds of elements; each has numbers of its own.
enum class ElementKind : std::uint8_t { solid, shell, beam };
constexpr std::string_view name_of(ElementKind kind) {
  return kind == ElementKind::solid ? "solid" : kind == ElementKind::shell ? "shell" : "beam";
}

struct Mesh {
  Nodes nodes;
  std::vector<Elements> solids, shells, beams;  ///< at most one entry per shape

  const std::vector<Elements>& elements(ElementKind kind) const {
    return kind == ElementKind::solid ? solids : kind == ElementKind::shell ? shells : beams;
  }
};

/// Four nodes of a face, counter-clockwise seen from outside; triangles repeat the third. In the plane an
/// edge, which repeats its second node twice and has the body on its left; on a line one node four times.
struct Segment {
  Index node[4];
};

/// Corners of a segment: 4 or 3 of a face, 2 of an edge, 1 of a point.
constexpr int corner_count(const Segment& s) {
  if (s.node[3] != s.node[2]) return 4;
  if (s.node[2] != s.node[1]) return 3;
  return s.node[1] != s.node[0] ? 2 : 1;
}

}  // namespace cleave::model
