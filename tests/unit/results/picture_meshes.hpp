#pragma once
/// Small meshes that the tests of surfaces, pictures and pages share.

#include <cmath>
#include <cstdint>
#include <vector>

#include "results/surface.hpp"

namespace cleave::results::test {

struct TestMesh {
  model::Shape shape = model::Shape::hex8;
  std::vector<double> position;    ///< [node][3]
  std::vector<model::Index> node;  ///< [element][8]
  std::size_t node_count() const { return position.size() / 3; }
  SolidCells cells() const { return {shape, node, {}}; }
};

/// A block of nx x ny x nz unit cubes.
inline TestMesh cubes(int nx, int ny, int nz) {
  TestMesh mesh;
  const auto id = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) mesh.position.insert(mesh.position.end(), {1.0 * i, 1.0 * j, 1.0 * k});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        mesh.node.insert(mesh.node.end(),
                         {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
                          id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
  return mesh;
}

/// n^3 elements of a cube, mapped to the ball of radius 1 (each surface of the cube to the sphere).
inline TestMesh ball(int n) {
  TestMesh mesh = cubes(n, n, n);
  for (std::size_t p = 0; p < mesh.position.size(); p += 3) {
    double x[3], largest = 0.0, square = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = 2.0 * mesh.position[p + i] / n - 1.0;
      largest = std::max(largest, std::abs(x[i]));
      square += x[i] * x[i];
    }
    for (std::size_t i = 0; i < 3; ++i)
      mesh.position[p + i] = square > 0.0 ? x[i] * largest / std::sqrt(square) : 0.0;
  }
  return mesh;
}

/// A bar of square cross-section mapped to a round one, mushroomed at z = 0 as after an impact.
inline TestMesh mushroom(int across, int along, double radius, double length, double impact) {
  TestMesh mesh = cubes(across, across, along);
  for (std::size_t p = 0; p < mesh.position.size(); p += 3) {
    const double u = 2.0 * mesh.position[p] / across - 1.0, v = 2.0 * mesh.position[p + 1] / across - 1.0;
    const double largest = std::max(std::abs(u), std::abs(v)), r = std::hypot(u, v);
    const double s = mesh.position[p + 2] / along;
    const double wide = radius * (1.0 + impact * std::exp(-9.0 * s)) * (r > 0.0 ? largest / r : 0.0);
    mesh.position[p] = wide * u;
    mesh.position[p + 1] = wide * v;
    mesh.position[p + 2] = length * s * (1.0 - 0.25 * impact * (1.0 - s));
  }
  return mesh;
}

}  // namespace cleave::results::test
