#include <algorithm>
#include <cmath>
#include <numbers>

#include "discretisation/spacetime/mesh.hpp"
#include "discretisation/spacetime/mesh_boxes.hpp"
#include "discretisation/spacetime/mesh_words.hpp"

/// A mesh covers its body once when no vertex lies in a simplex it is no corner of, no two boundary faces
/// cross, and the simplices around a vertex fill at most the full angle. (Where two sheets of elements
/// overlap, the overlap is bounded by boundary faces of either sheet; those lie inside the other, where a
/// vertex is found, or cross its boundary, or turn about a common vertex.)

namespace cleave::discretisation::spacetime {
namespace {

constexpr double tolerance = 1e-9;  ///< of a simplex's size

template <std::size_t N>
bool has(const std::array<Vertex, N>& face, Vertex v) {
  return std::find(face.begin(), face.end(), v) != face.end();
}

template <int D>
std::array<Point<D>, D + 1> corners(const SpaceMeshInput<D>& in, std::size_t s) {
  std::array<Point<D>, D + 1> corner;
  for (std::size_t i = 0; i <= D; ++i) corner[i] = in.vertex[static_cast<std::size_t>(in.simplex[s][i])];
  return corner;
}

/// Smallest barycentric coordinate of x.
template <int D>
double depth(const std::array<Point<D>, D + 1>& corner, const Point<D>& x) {
  const double whole = signed_volume<static_cast<std::size_t>(D)>(corner);
  double least = 1.0;
  for (std::size_t i = 0; i <= D; ++i) {
    auto part = corner;
    part[i] = x;
    least = std::min(least, signed_volume<static_cast<std::size_t>(D)>(part) / whole);
  }
  return least;
}

template <int D>
MeshFault check_vertices(const SpaceMeshInput<D>& in) {
  const Words<D> words(in);
  std::vector<Box<D>> boxes(in.simplex.size());
  for (std::size_t s = 0; s < boxes.size(); ++s) {
    for (const Point<D>& x : corners<D>(in, s)) boxes[s].add(x);
    boxes[s].grow(tolerance * boxes[s].size());
  }
  const BoxTree<D> tree(std::move(boxes));
  for (std::size_t v = 0; v < in.vertex.size(); ++v) {
    const Point<D>& x = in.vertex[v];
    Box<D> query;
    query.add(x);
    std::size_t in_simplex = in.simplex.size(), on_face = in_simplex, twin = in.vertex.size(),
                twin_simplex = 0;
    tree.visit(query, [&](std::size_t s) {
      if (has(in.simplex[s], static_cast<Vertex>(v))) return;
      const auto corner = corners<D>(in, s);
      const double deep = depth<D>(corner, x);
      if (deep < -tolerance) return;
      for (std::size_t i = 0; i <= D; ++i)
        if (distance(corner[i], x) <= tolerance * distance(corner[i], corner[i == 0 ? 1 : 0])) {
          twin = std::min(twin, static_cast<std::size_t>(in.simplex[s][i]));
          twin_simplex = s;
          return;
        }
      if (deep > tolerance)
        in_simplex = std::min(in_simplex, s);
      else
        on_face = std::min(on_face, s);
    });
    if (in_simplex < in.simplex.size())
      return words.fault(
          "vertex " + words.vertex(v) + " lies inside element " + words.element(in_simplex) + words.at(x),
          "two parts overlap", {in_simplex}, {v});
    if (in.touching_allowed) continue;
    if (on_face < in.simplex.size())
      return words.fault("vertex " + words.vertex(v) + " hangs on a face of element " +
                             words.element(on_face) + words.at(x) + " without being one of its corners",
                         "meshes of different size meet; join them node to node", {on_face}, {v});
    if (twin < in.vertex.size())
      return words.fault("vertices " + words.vertex(v) + " and " + words.vertex(twin) +
                             " lie at the same place" + words.at(x),
                         "parts that are not merged; merge the nodes, or state the seam as a crack",
                         {twin_simplex}, {v, twin});
  }
  return {};
}

/// Do a and b lie on different sides, farther away than rounding puts them? [any measure, and its size]
bool apart(double a, double b, double size) {
  const double least = tolerance * size;
  return (a > least && b < -least) || (a < -least && b > least);
}

/// Do the open segments ab and cd cross?
bool cross(const Point<2>& a, const Point<2>& b, const Point<2>& c, const Point<2>& d) {
  const auto side = [](const Point<2>& p, const Point<2>& q, const Point<2>& r) {
    return signed_volume<2>({p, q, r});
  };
  const double size = std::pow(std::max({distance(a, b), distance(c, d), distance(a, c)}), 2);
  return apart(side(a, b, c), side(a, b, d), size) && apart(side(c, d, a), side(c, d, b), size);
}

/// Does the open segment ab pierce the open triangle?
bool pierces(const Point<3>& a, const Point<3>& b, const std::array<Point<3>, 3>& t) {
  const double size =
      std::pow(std::max({distance(a, b), distance(t[0], t[1]), distance(t[0], t[2]), distance(a, t[0])}), 3);
  if (!apart(signed_volume<3>({t[0], t[1], t[2], a}), signed_volume<3>({t[0], t[1], t[2], b}), size))
    return false;
  const double x = signed_volume<3>({a, b, t[0], t[1]}), y = signed_volume<3>({a, b, t[1], t[2]}),
               z = signed_volume<3>({a, b, t[2], t[0]}), least = tolerance * size;
  return std::min({x, y, z}) > least || std::max({x, y, z}) < -least;
}

template <int D>
bool faces_cross(const SpaceMeshInput<D>& in, const std::array<Vertex, D>& f,
                 const std::array<Vertex, D>& g) {
  const auto x = [&](Vertex v) { return in.vertex[static_cast<std::size_t>(v)]; };
  if constexpr (D == 2) {
    return !has(g, f[0]) && !has(g, f[1]) && cross(x(f[0]), x(f[1]), x(g[0]), x(g[1]));
  } else if constexpr (D == 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex a = f[i], b = f[(i + 1) % 3];
      if (!has(g, a) && !has(g, b) && pierces(x(a), x(b), {x(g[0]), x(g[1]), x(g[2])})) return true;
    }
    return false;
  } else {
    return false;
  }
}

template <int D>
MeshFault check_boundary(const SpaceMeshInput<D>& in, const std::vector<std::array<Vertex, D>>& boundary) {
  std::vector<Box<D>> boxes(boundary.size());
  for (std::size_t f = 0; f < boundary.size(); ++f)
    for (const Vertex v : boundary[f]) boxes[f].add(in.vertex[static_cast<std::size_t>(v)]);
  const BoxTree<D> tree(boxes);
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    std::size_t other = boundary.size();
    tree.visit(boxes[f], [&](std::size_t g) {
      if (g != f && faces_cross<D>(in, boundary[f], boundary[g])) other = std::min(other, g);
    });
    if (other == boundary.size()) continue;
    const Words<D> words(in);
    const auto a = static_cast<std::size_t>(boundary[f][0]), b = static_cast<std::size_t>(boundary[other][0]);
    return words.fault("boundary faces at vertices " + words.vertex(a) + " and " + words.vertex(b) +
                           " cross" + words.at(in.vertex[a]),
                       "two parts overlap", {}, {a, b});
  }
  return {};
}

/// Angle at corner i: plane angle in 2D, solid angle in 3D (van Oosterom & Strackee 1983, eq. 8).
template <int D>
double angle_at(const std::array<Point<D>, D + 1>& corner, std::size_t i) {
  std::array<Point<D>, D> edge;
  for (std::size_t j = 0, to = 0; j <= D; ++j)
    if (j != i) edge[to++] = difference(corner[j], corner[i]);
  const double volume = std::abs(determinant(edge));
  if constexpr (D == 2) {
    return std::atan2(volume, dot(edge[0], edge[1]));
  } else {
    const double a = norm(edge[0]), b = norm(edge[1]), c = norm(edge[2]);
    const double below =
        a * b * c + dot(edge[0], edge[1]) * c + dot(edge[1], edge[2]) * a + dot(edge[2], edge[0]) * b;
    return 2.0 * std::atan2(volume, below);
  }
}

template <int D>
MeshFault check_angles(const SpaceMeshInput<D>& in) {
  std::vector<double> sum(in.vertex.size(), 0.0);
  for (std::size_t s = 0; s < in.simplex.size(); ++s)
    for (std::size_t i = 0; i <= D; ++i)
      sum[static_cast<std::size_t>(in.simplex[s][i])] += angle_at<D>(corners<D>(in, s), i);
  const double full = (D == 2 ? 2.0 : 4.0) * std::numbers::pi;
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (sum[v] > full * (1.0 + 1e-6)) {
      const Words<D> words(in);
      return words.fault(
          "the elements around vertex " + words.vertex(v) + " overlap" + words.at(in.vertex[v]),
          "folded mesh, or two parts overlap", {}, {v});
    }
  return {};
}

}  // namespace

template <int D>
MeshFault check_covering(const SpaceMeshInput<D>& input, const std::vector<std::array<Vertex, D>>& boundary) {
  if (MeshFault fault = check_vertices<D>(input); !fault.ok) return fault;
  if constexpr (D > 1) {
    if (MeshFault fault = check_boundary<D>(input, boundary); !fault.ok) return fault;
    if (MeshFault fault = check_angles<D>(input); !fault.ok) return fault;
  }
  return {};
}

template MeshFault check_covering<1>(const SpaceMeshInput<1>&, const std::vector<std::array<Vertex, 1>>&);
template MeshFault check_covering<2>(const SpaceMeshInput<2>&, const std::vector<std::array<Vertex, 2>>&);
template MeshFault check_covering<3>(const SpaceMeshInput<3>&, const std::vector<std::array<Vertex, 3>>&);

}  // namespace cleave::discretisation::spacetime
