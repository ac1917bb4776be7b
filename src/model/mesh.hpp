#pragma once
/// Nodes and elements as asked for: ids resolved to indices, nothing else.

#include <cstdint>
#include <string_view>
#include <vector>

namespace cleave::model {

using Id = std::int64_t;
using Index = std::int32_t;  ///< position in an array of the model; -1 for none

enum class Shape : std::uint8_t { hex8, penta6, tet4, tet10 };
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

/// Solid elements of one shape.
///
/// Node order is that of the keyword format: hex8 1-4 bottom counter-clockwise, 5-8 above;
/// penta6 is the wedge with triangles (0,1,2) below and (3,4,5) above, unfolded from N1 N2 N3 N4 N5=N6 N7=N8;
/// tet10 has mid nodes on edges 12 23 31 14 24 34. A hex8 may repeat nodes (pyramids).
struct Elements {
  Shape shape = Shape::hex8;
  std::vector<Id> id;
  std::vector<Index> part;  ///< index into Model::parts
  std::vector<Index> node;  ///< [element][nodes_of(shape)]

  std::size_t count() const { return id.size(); }
};

struct Mesh {
  Nodes nodes;
  std::vector<Elements> solids;  ///< at most one entry per shape
};

/// Four nodes of a face, counter-clockwise seen from outside; triangles repeat the third.
struct Segment {
  Index node[4];
};

}  // namespace cleave::model
