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

/// Those of the faces that stand alone, in their order.
std::vector<Segment> alone(std::vector<Face> faces) {
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

/// Edges of shells, ends of bars.
std::vector<Segment> outline(const std::vector<Elements>& groups, std::span<const Index> parts) {
  std::vector<Face> sides;
  for (const Elements& group : groups) {
    const std::size_t n = static_cast<std::size_t>(nodes_of(group.shape));
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (!parts.empty() && std::find(parts.begin(), parts.end(), group.part[e]) == parts.end()) continue;
      for (std::size_t a = 0; a < n; ++a) {
        const Index from = group.node[e * n + a], to = n == 2 ? from : group.node[e * n + (a + 1) % n];
        sides.push_back({.key = {-1, -1, std::min(from, to), std::max(from, to)},
                         .segment = {{from, to, to, to}},
                         .order = sides.size()});
      }
    }
  }
  return alone(std::move(sides));
}

}  // namespace

std::vector<Segment> boundary_segments(const Mesh& mesh, std::span<const Index> parts) {
  if (!mesh.solids.empty()) return outer_faces(mesh, parts);
  return outline(mesh.shells.empty() ? mesh.beams : mesh.shells, parts);
}

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
  return alone(std::move(faces));
}

}  // namespace cleave::model
