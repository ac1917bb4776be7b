#include "results/surface.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/assert.hpp"
#include "model/solid_shape.hpp"

namespace cleave::results {
namespace {

using model::Index;
using model::Shape;

/// Mid nodes of a ten-node tetrahedron on the sides of its faces, from each corner of model::faces_of to the
/// next.
constexpr int mid_nodes[4][3] = {{6, 5, 4}, {4, 8, 7}, {5, 9, 8}, {6, 7, 9}};

/// One face of one element: its distinct corners in order round the face.
struct Face {
  std::array<Index, 4> corner{-1, -1, -1, -1};
  int count = 0;

  /// Corners ascending: equal for the two elements that share the face.
  std::array<Index, 4> key() const {
    auto sorted = corner;
    for (int k = 1; k < count; ++k)
      for (int at = k; at > 0 && sorted[at - 1] > sorted[at]; --at) std::swap(sorted[at - 1], sorted[at]);
    return sorted;
  }
};

Face face_of(const SolidCells& cells, std::size_t element, int face) {
  const Index* node = &cells.node[element * model::nodes_of(cells.shape)];
  Face result;
  for (const int corner : model::faces_of(cells.shape)[static_cast<std::size_t>(face)]) {
    const Index n = node[corner];
    if (std::find(result.corner.begin(), result.corner.begin() + result.count, n) ==
        result.corner.begin() + result.count)
      result.corner[result.count++] = n;
  }
  return result;
}

/// A candidate: which face of which element, with the key it is compared by.
struct Candidate {
  std::array<Index, 4> key;
  std::uint32_t block, element;
  std::uint32_t face;
};

bool is_alive(const SolidCells& cells, std::size_t element) {
  return cells.alive.empty() || cells.alive[element] != 0;
}

/// Calls visit(block, element, face number, face) for every face with at least three distinct corners.
template <class Visit>
void for_each_face(std::span<const SolidCells> cells, const Visit& visit) {
  for (std::uint32_t b = 0; b < cells.size(); ++b) {
    const std::size_t count = cells[b].node.size() / model::nodes_of(cells[b].shape);
    const int face_count = static_cast<int>(model::faces_of(cells[b].shape).size());
    for (std::uint32_t e = 0; e < count; ++e) {
      if (!is_alive(cells[b], e)) continue;
      for (int f = 0; f < face_count; ++f) {
        const Face face = face_of(cells[b], e, f);
        if (face.count >= 3) visit(b, e, f, face);
      }
    }
  }
}

void append(Surface& surface, const Candidate& from, std::array<Index, 4> node, std::uint8_t edges) {
  surface.node.insert(surface.node.end(), node.begin(), node.end());
  surface.edges.push_back(edges);
  surface.block.push_back(from.block);
  surface.element.push_back(from.element);
}

/// Appends an outer face as the one polygon it is, or as four triangles where it has mid nodes.
void append_face(Surface& surface, std::span<const SolidCells> cells, const Candidate& from) {
  const SolidCells& block = cells[from.block];
  const Face face = face_of(block, from.element, static_cast<int>(from.face));
  const auto& c = face.corner;
  if (block.shape == Shape::tet10 && face.count == 3) {
    const Index* node = &block.node[static_cast<std::size_t>(from.element) * 10];
    const auto& mid = mid_nodes[from.face];
    const Index m[3] = {node[mid[0]], node[mid[1]], node[mid[2]]};
    append(surface, from, {c[0], m[0], m[2], m[2]}, 0b101);
    append(surface, from, {m[0], c[1], m[1], m[1]}, 0b011);
    append(surface, from, {m[2], m[1], c[2], c[2]}, 0b110);
    append(surface, from, {m[0], m[1], m[2], m[2]}, 0);
  } else if (face.count == 3) {
    append(surface, from, {c[0], c[1], c[2], c[2]}, 0b111);
  } else {
    append(surface, from, c, 0b1111);
  }
}

/// Shells are all surface.
void append_shells(Surface& surface, const SolidCells& block, std::uint32_t number) {
  if (block.shape != Shape::tri3 && block.shape != Shape::quad4) return;
  const auto per = static_cast<std::size_t>(model::nodes_of(block.shape));
  for (std::size_t e = 0; per * e < block.node.size(); ++e) {
    if (!is_alive(block, e)) continue;
    const Index* node = &block.node[per * e];
    append(surface, {{}, number, static_cast<std::uint32_t>(e), 0},
           {node[0], node[1], node[2], node[per - 1]}, per == 4 ? 0b1111 : 0b111);
  }
}

}  // namespace

Surface outer_faces(std::span<const SolidCells> cells, std::size_t node_count) {
  // Faces that are equal have the same smallest node: count, then place them into that node's bucket.
  std::vector<std::size_t> begin(node_count + 1, 0);
  for_each_face(cells, [&](std::uint32_t, std::uint32_t, int, const Face& face) {
    const Index smallest = *std::min_element(face.corner.begin(), face.corner.begin() + face.count);
    CLEAVE_ASSERT(smallest >= 0 && static_cast<std::size_t>(smallest) < node_count, "node out of range");
    ++begin[static_cast<std::size_t>(smallest) + 1];
  });
  for (std::size_t n = 0; n < node_count; ++n) begin[n + 1] += begin[n];
  std::vector<Candidate> candidates(begin[node_count]);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_face(cells, [&](std::uint32_t b, std::uint32_t e, int f, const Face& face) {
    const auto key = face.key();
    candidates[next[static_cast<std::size_t>(key[0])]++] = {key, b, e, static_cast<std::uint32_t>(f)};
  });

  // Within a bucket equal keys become neighbours; a key that occurs once is an outer face.
  std::vector<Candidate> outer;
  for (std::size_t n = 0; n < node_count; ++n) {
    const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(begin[n]);
    const auto last = candidates.begin() + static_cast<std::ptrdiff_t>(begin[n + 1]);
    std::sort(first, last, [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
    for (auto at = first; at != last;) {
      auto end = at + 1;
      while (end != last && end->key == at->key) ++end;
      if (end - at == 1) outer.push_back(*at);
      at = end;
    }
  }
  std::sort(outer.begin(), outer.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.block, a.element, a.face) < std::tie(b.block, b.element, b.face);
  });

  Surface surface;
  for (const Candidate& face : outer) append_face(surface, cells, face);
  for (std::uint32_t b = 0; b < cells.size(); ++b) append_shells(surface, cells[b], b);
  return surface;
}

}  // namespace cleave::results
