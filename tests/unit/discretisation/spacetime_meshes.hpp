#pragma once
/// Space meshes to pitch tents on: lines, grids, Delaunay meshes of random points, Kuhn cubes; jittered,
/// squeezed and sheared until angles are bad.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

#include "spacetime_delaunay.hpp"

namespace cleave::discretisation::spacetime::sample {

template <int D>
void one_material(SpaceMeshInput<D>& in, double fastest = 1.0, double slowest = 0.5) {
  in.material.assign(in.simplex.size(), 0);
  in.speed = {{.fastest = fastest, .slowest = slowest}};
}

/// [0, 1] in `count` segments; inner vertices moved by up to `jitter` of a segment.
inline SpaceMeshInput<1> line(int count, double jitter = 0.0, unsigned seed = 1) {
  Random random(seed);
  SpaceMeshInput<1> in;
  for (int i = 0; i <= count; ++i) {
    const double by = i > 0 && i < count ? random(-jitter, jitter) : 0.0;
    in.vertex.push_back({(i + by) / count});
    if (i > 0) in.simplex.push_back({i - 1, i});
  }
  one_material(in, 1.0, 1.0);
  return in;
}

/// [0, 1]^2 in count^2 squares of two triangles, diagonals at random (or all alike if jitter is 0).
inline SpaceMeshInput<2> grid(int count, double jitter = 0.0, unsigned seed = 1) {
  Random random(seed);
  SpaceMeshInput<2> in;
  const auto at = [&](int i, int j) { return static_cast<Vertex>(j * (count + 1) + i); };
  for (int j = 0; j <= count; ++j)
    for (int i = 0; i <= count; ++i) {
      const double a = i > 0 && i < count ? random(-jitter, jitter) : 0.0;
      const double b = j > 0 && j < count ? random(-jitter, jitter) : 0.0;
      in.vertex.push_back({(i + a) / count, (j + b) / count});
    }
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      const Vertex a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (jitter == 0.0 || random(0.0, 1.0) < 0.5) {
        in.simplex.push_back({a, b, c});
        in.simplex.push_back({a, c, d});
      } else {
        in.simplex.push_back({a, b, d});
        in.simplex.push_back({b, c, d});
      }
    }
  one_material(in);
  return in;
}

/// [0, 1]^3 in count^3 cubes of six tetrahedra each (Kuhn).
inline SpaceMeshInput<3> cube(int count, double jitter = 0.0, unsigned seed = 1) {
  Random random(seed);
  SpaceMeshInput<3> in;
  const auto at = [&](int i, int j, int k) {
    return static_cast<Vertex>((k * (count + 1) + j) * (count + 1) + i);
  };
  for (int k = 0; k <= count; ++k)
    for (int j = 0; j <= count; ++j)
      for (int i = 0; i <= count; ++i) {
        const int n[3] = {i, j, k};
        Point<3> x;
        for (std::size_t c = 0; c < 3; ++c)
          x[c] = (n[c] + (n[c] > 0 && n[c] < count ? random(-jitter, jitter) : 0.0)) / count;
        in.vertex.push_back(x);
      }
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        for (int o = 0; o < 6; ++o) {
          int n[3] = {i, j, k};
          std::array<Vertex, 4> tet{at(i, j, k)};
          for (std::size_t s = 0; s < 3; ++s) {
            ++n[orders[o][s]];
            tet[s + 1] = at(n[0], n[1], n[2]);
          }
          if (o >= 3) std::swap(tet[2], tet[3]);  // odd orders of axes
          in.simplex.push_back(tet);
        }
  one_material(in);
  return in;
}

/// Delaunay triangulation of `count` random points in the unit disc and 30 on its rim.
inline SpaceMeshInput<2> delaunay(int count, unsigned seed) {
  Random random(seed);
  SpaceMeshInput<2> in;
  auto& x = in.vertex;
  for (int i = 0; i < 30; ++i) {  // not on one circle: the insertion would have to break ties
    const double r = random(1.0, 1.02), angle = i * std::numbers::pi / 15.0;
    x.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  while (static_cast<int>(x.size()) < 30 + count) {
    const Point<2> p{random(-1.0, 1.0), random(-1.0, 1.0)};
    if (norm(p) < 0.97) x.push_back(p);
  }
  in.simplex = triangulate<2>(x);
  one_material(in);
  return in;
}

/// x_0 += shear x_last, then x_last *= squeeze: orientation stays, angles go bad.
template <int D>
SpaceMeshInput<D> spoiled(SpaceMeshInput<D> in, double squeeze, double shear) {
  for (auto& x : in.vertex) {
    x[0] += shear * x[D - 1];
    x[D - 1] *= squeeze;
  }
  return in;
}

/// Largest angle of any triangle [degrees].
inline double largest_angle(const SpaceMeshInput<2>& in) {
  double largest = 0.0;
  for (const auto& t : in.simplex)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto x = [&](std::size_t k) { return in.vertex[static_cast<std::size_t>(t[(i + k) % 3])]; };
      const Point<2> a = difference(x(1), x(0)), b = difference(x(2), x(0));
      largest = std::max(largest, std::acos(dot(a, b) / norm(a) / norm(b)) * 180.0 / std::numbers::pi);
    }
  return largest;
}

/// Every triangle in four, by the middles of its edges: the same shapes at half the size.
inline SpaceMeshInput<2> halved(SpaceMeshInput<2> in) {
  std::map<std::pair<Vertex, Vertex>, Vertex> middle;
  const auto between = [&](Vertex a, Vertex b) {
    const auto [at, isnew] = middle.try_emplace(std::minmax(a, b), static_cast<Vertex>(in.vertex.size()));
    if (isnew) {
      const auto &x = in.vertex[static_cast<std::size_t>(a)], &y = in.vertex[static_cast<std::size_t>(b)];
      in.vertex.push_back({0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1])});
    }
    return at->second;
  };
  const auto coarse = std::move(in.simplex);
  const auto material = std::move(in.material);
  in.simplex.clear();
  in.material.clear();
  for (std::size_t s = 0; s < coarse.size(); ++s) {
    const auto [a, b, c] = coarse[s];
    const Vertex ab = between(a, b), bc = between(b, c), ca = between(c, a);
    for (const std::array<Vertex, 3>& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      in.simplex.push_back(t);
      in.material.push_back(material[s]);
    }
  }
  return in;
}

/// A mesh of `base` halved until it is that of n, a power of two times `base`.
template <class Make>
SpaceMeshInput<2> nested(const Make& make, int base, int n) {
  auto in = make(base);
  for (; base < n; base *= 2) in = halved(std::move(in));
  return in;
}

/// Two materials: simplices whose first corner lies beyond `split` along x are twice as fast.
template <int D>
SpaceMeshInput<D> two_materials(SpaceMeshInput<D> in, double split) {
  in.speed.push_back({.fastest = 2.0 * in.speed[0].fastest, .slowest = 2.0 * in.speed[0].slowest});
  for (std::size_t s = 0; s < in.simplex.size(); ++s) {
    double middle = 0.0;
    for (const Vertex v : in.simplex[s]) middle += in.vertex[static_cast<std::size_t>(v)][0] / (D + 1);
    in.material[s] = middle > split;
  }
  return in;
}

}  // namespace cleave::discretisation::spacetime::sample
