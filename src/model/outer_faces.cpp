#include "model/outer_faces.hpp"

#include <algorithm>
#include <array>

#include "model/solid_shape.hpp"

namespace cleave::model {
namespace {

struct Face {
  std::array<Index, 4> key;  ///< corners ascending; a triangle has -1 first
  Segment segment;
  std::size_t order;
};

}  // namespace

std::vector<Segment> outer_faces(const Mesh& mesh, std::span<const Index> parts) {
  std::vector<Face> faces;
  for (const Elements& group : mesh.solids) {
    const int n = nodes_of(group.shape);
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (!parts.empty() && std::find(parts.begin(), parts.end(), group.part[e]) == parts.end()) continue;
      for (const auto& local : faces_of(group.shape)) {
        // Repeated nodes make triangles of quadrilaterals, or nothing.
        std::array<Index, 4> corner;
        int count = 0;
        for (const int a : local) {
          const Index node = group.node[e * n + a];
          if (std::find(corner.begin(), corner.begin() + count, node) == corner.begin() + count)
            corner[count++] = node;
        }
        if (count < 3) continue;
        Face face{.key = corner, .segment = {}, .order = faces.size()};
        if (count == 3) face.key[3] = -1, corner[3] = corner[2];
        std::copy(corner.begin(), corner.end(), face.segment.node);
        std::sort(face.key.begin(), face.key.end());
        faces.push_back(face);
      }
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.order < b.order; });
  std::vector<Face> outer;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t j = i + 1;
    while (j < faces.size() && faces[j].key == faces[i].key) ++j;
    if (j == i + 1) outer.push_back(faces[i]);
    i = j;
  }
  std::sort(outer.begin(), outer.end(), [](const Face& a, const Face& b) { return a.order < b.order; });
  std::vector<Segment> segments;
  segments.reserve(outer.size());
  for (const Face& face : outer) segments.push_back(face.segment);
  return segments;
}

}  // namespace cleave::model
