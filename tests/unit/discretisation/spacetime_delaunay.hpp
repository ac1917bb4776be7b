#pragma once
/// Delaunay meshes for the tests, in two and three dimensions: by insertion of points one after the other
/// (Bowyer and Watson 1981). Truly unstructured: vertices have any number of neighbours, and in three
/// dimensions slivers come by themselves.

#include <algorithm>
#include <map>
#include <random>

#include "discretisation/spacetime/mesh.hpp"

namespace cleave::discretisation::spacetime::sample {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * (engine_() * 0x1p-32); }

 private:
  std::mt19937 engine_;
};

/// Is p inside the sphere around a positively oriented simplex?
template <int D>
bool in_sphere(const std::array<Point<D>, D + 1>& corner, const Point<D>& p) {
  std::array<std::array<double, D + 1>, D + 1> m;
  for (std::size_t i = 0; i <= D; ++i) {
    const Point<D> to = difference(corner[i], p);
    std::copy(to.begin(), to.end(), m[i].begin());
    m[i][D] = dot(to, to);
  }
  return (D % 2 == 0 ? 1.0 : -1.0) * determinant(m) > 0.0;
}

/// Triangulates points, no D + 2 of which lie on one sphere. Points may lie on the plane faces of their hull.
template <int D>
std::vector<std::array<Vertex, D + 1>> triangulate(std::vector<Point<D>> x) {
  using Cell = std::array<Vertex, D + 1>;
  const auto real = static_cast<Vertex>(x.size());
  const auto at = [&](Vertex v) { return x[static_cast<std::size_t>(v)]; };
  const auto corners = [&](const Cell& cell) {
    std::array<Point<D>, D + 1> corner;
    for (std::size_t i = 0; i <= D; ++i) corner[i] = at(cell[i]);
    return corner;
  };
  const auto orient = [&](Cell cell) {
    if (signed_volume<D>(corners(cell)) < 0.0) std::swap(cell[0], cell[1]);
    return cell;
  };
  Cell around;  // a simplex around everything
  for (std::size_t i = 0; i <= D; ++i) {
    Point<D> far;
    for (std::size_t k = 0; k < D; ++k) far[k] = i == 0 ? -2.1e3 : (i == k + 1 ? 7.3e3 + 100.0 * k : -1.9e3);
    around[i] = static_cast<Vertex>(x.size());
    x.push_back(far);
  }
  std::vector<Cell> cells{orient(around)}, kept;
  for (Vertex v = 0; v < real; ++v) {
    std::map<std::array<Vertex, D>, int> rim;  // faces of the cavity; inner ones are met twice
    kept.clear();
    for (const Cell& cell : cells) {
      if (!in_sphere<D>(corners(cell), at(v))) {
        kept.push_back(cell);
        continue;
      }
      for (std::size_t skip = 0; skip <= D; ++skip) {
        std::array<Vertex, D> face;
        for (std::size_t i = 0, to = 0; i <= D; ++i)
          if (i != skip) face[to++] = cell[i];
        std::sort(face.begin(), face.end());
        ++rim[face];
      }
    }
    for (const auto& [face, times] : rim) {
      if (times > 1) continue;
      Cell cell;
      std::copy(face.begin(), face.end(), cell.begin());
      cell[D] = v;
      kept.push_back(orient(cell));
    }
    cells.swap(kept);
  }
  std::erase_if(cells, [&](const Cell& c) { return *std::max_element(c.begin(), c.end()) >= real; });
  return cells;
}

/// The unit box with vertices about 1 / n apart: regular, a little disturbed, on edges and faces, thrown at
/// random inside, no two closer than `closest` / n. Planes x_0 = `seam` get vertices of their own when asked
/// for, so that a material interface can lie there.
template <int D>
std::vector<Point<D>> scattered_points(int n, double closest, unsigned seed, double seam = -1.0) {
  Random random(seed);
  std::vector<Point<D>> all;
  int count = 1;
  for (int k = 0; k < D; ++k) count *= n + 1;
  const int layer = seam > 0.0 ? static_cast<int>(seam * n + 0.5) : -1;
  for (int v = 0; v < count; ++v) {
    Point<D> x;
    int fixed = 0;
    for (int k = 0, rest = v; k < D; ++k, rest /= n + 1) {
      const int i = rest % (n + 1);
      const bool held = i == 0 || i == n || (k == 0 && i == layer);
      fixed += held;
      x[static_cast<std::size_t>(k)] = (i + (held ? 0.0 : random(-0.2, 0.2))) / n;
    }
    if (fixed > 0) all.push_back(x);
  }
  for (int tries = 0; tries < 60 * count; ++tries) {
    Point<D> x;
    for (double& c : x) c = random(0.3 / n, 1.0 - 0.3 / n);
    if (layer > 0 && std::abs(x[0] - seam) < 0.4 / n) continue;
    const bool free =
        std::none_of(all.begin(), all.end(), [&](const Point<D>& y) { return distance(x, y) < closest / n; });
    if (free) all.push_back(x);
  }
  return all;
}

/// Delaunay mesh of the unit box.
template <int D>
SpaceMeshInput<D> scattered(int n, double closest, unsigned seed, double seam = -1.0) {
  SpaceMeshInput<D> in;
  in.vertex = scattered_points<D>(n, closest, seed, seam);
  in.simplex = triangulate<D>(in.vertex);
  in.material.assign(in.simplex.size(), 0);
  in.speed = {{.fastest = 1.0, .slowest = 0.5}};
  return in;
}

}  // namespace cleave::discretisation::spacetime::sample
