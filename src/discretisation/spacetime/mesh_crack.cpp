#include <algorithm>
#include <map>
#include <string>

#include "discretisation/spacetime/mesh.hpp"
#include "discretisation/spacetime/mesh_words.hpp"

namespace cleave::discretisation::spacetime {
namespace {

constexpr double tolerance = 1e-6;  ///< of the crack's size: coordinates come from cards with few digits

/// Faces that belong to two simplices and have all corners among the marked vertices.
template <int D>
std::vector<std::array<Vertex, D>> inner_faces(const SpaceMeshInput<D>& in, const std::vector<char>& marked) {
  std::map<std::array<Vertex, D>, int> count;
  for (const auto& simplex : in.simplex)
    for (std::size_t opposite = 0; opposite <= D; ++opposite) {
      std::array<Vertex, D> face;
      bool all = true;
      for (std::size_t i = 0; i < D; ++i) {
        face[i] = simplex[i + (i >= opposite ? 1 : 0)];
        all = all && marked[static_cast<std::size_t>(face[i])];
      }
      if (!all) continue;
      std::sort(face.begin(), face.end());
      ++count[face];
    }
  std::vector<std::array<Vertex, D>> faces;
  for (const auto& [face, times] : count)
    if (times == 2) faces.push_back(face);
  return faces;
}

}  // namespace

MeshFault add_crack(SpaceMeshInput<2>& input, std::span<const Point<2>> polyline) {
  const Words<2> words(input);
  if (polyline.size() < 2) return words.fault("a crack needs two points or more", "", {}, {});
  for (std::size_t p = 0; p + 1 < polyline.size(); ++p) {
    const Point<2>&a = polyline[p], &b = polyline[p + 1], e = difference(b, a);
    const double length = norm(e);
    const std::string name = "crack segment " + std::to_string(p + 1) + " from" + words.at(a).substr(3) +
                             " to" + words.at(b).substr(3);
    if (!(length > 0.0)) return words.fault(name + " has no length", "", {}, {});
    std::vector<char> marked(input.vertex.size(), 0);
    for (std::size_t v = 0; v < marked.size(); ++v)
      marked[v] = distance_to_segment<2>(input.vertex[v], a, b) <= tolerance * length;
    // Along the segment the edges must follow each other without a gap.
    const auto along = [&](Vertex v) {
      return dot(difference(input.vertex[static_cast<std::size_t>(v)], a), e) / (length * length);
    };
    std::vector<std::array<double, 2>> pieces;
    const auto faces = inner_faces<2>(input, marked);
    for (const auto& face : faces) {
      const double s = along(face[0]), t = along(face[1]);
      pieces.push_back({std::min(s, t), std::max(s, t)});
    }
    std::sort(pieces.begin(), pieces.end());
    double reached = 0.0;
    for (const auto& piece : pieces) {
      if (piece[0] > reached + 2.0 * tolerance) break;
      reached = std::max(reached, piece[1]);
    }
    if (reached < 1.0 - 2.0 * tolerance) {
      const Point<2> gap{a[0] + reached * e[0], a[1] + reached * e[1]};
      return words.fault(name + " leaves the edges inside the mesh" + words.at(gap),
                         "a crack must follow edges between elements and end at vertices", {}, {});
    }
    for (const auto& face : faces)
      if (std::find(input.crack.begin(), input.crack.end(), face) == input.crack.end())
        input.crack.push_back(face);
  }
  return {};
}

MeshFault add_crack(SpaceMeshInput<3>& input, std::span<const Point<3>> polygon) {
  const Words<3> words(input);
  if (polygon.size() < 3) return words.fault("a crack surface needs three corners or more", "", {}, {});
  Point<3> area{};
  double size = 0.0;
  for (std::size_t p = 1; p + 1 < polygon.size(); ++p) {
    const auto e = difference(polygon[p], polygon[0]), f = difference(polygon[p + 1], polygon[0]);
    for (std::size_t k = 0; k < 3; ++k)
      area[k] += 0.5 * (e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3]);
    size = std::max({size, norm(e), norm(f)});
  }
  const double whole = norm(area);
  const std::string name = "the crack surface with its first corner" + words.at(polygon[0]);
  if (!(whole > tolerance * size * size)) return words.fault(name + " has no area", "", {}, {});
  for (double& component : area) component /= whole;

  for (const Point<3>& corner : polygon)
    if (std::abs(dot(difference(corner, polygon[0]), area)) > tolerance * size)
      return words.fault(name + " is not plane", "give a surface as several plane ones", {}, {});
  std::vector<char> marked(input.vertex.size(), 0);
  for (std::size_t v = 0; v < marked.size(); ++v) {
    const Point<3>& x = input.vertex[v];
    bool inside = std::abs(dot(difference(x, polygon[0]), area)) <= tolerance * size;
    for (std::size_t p = 0; p < polygon.size() && inside; ++p) {
      const auto e = difference(polygon[(p + 1) % polygon.size()], polygon[p]),
                 to = difference(x, polygon[p]);
      const Point<3> turn{e[1] * to[2] - e[2] * to[1], e[2] * to[0] - e[0] * to[2],
                          e[0] * to[1] - e[1] * to[0]};
      inside = dot(turn, area) >= -tolerance * size * norm(e);
    }
    marked[v] = inside;
  }
  const auto faces = inner_faces<3>(input, marked);
  double covered = 0.0;
  for (const auto& face : faces) {
    const auto x = [&](std::size_t i) { return input.vertex[static_cast<std::size_t>(face[i])]; };
    const auto e = difference(x(1), x(0)), f = difference(x(2), x(0));
    covered += 0.5 * std::sqrt(std::max(0.0, dot(e, e) * dot(f, f) - dot(e, f) * dot(e, f)));
  }
  if (std::abs(covered - whole) > 10.0 * tolerance * size * size)
    return words.fault(name + " is covered by faces inside the mesh over " +
                           std::to_string(100.0 * covered / whole) + " per cent of its area",
                       "a crack must follow faces between elements, and its rim edges; it must be convex", {},
                       {});
  for (const auto& face : faces)
    if (std::find(input.crack.begin(), input.crack.end(), face) == input.crack.end())
      input.crack.push_back(face);
  return {};
}

}  // namespace cleave::discretisation::spacetime
