/// Directions and values on a surface, as shading needs them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "results/surface.hpp"

namespace cleave::results {
namespace {

using Vector = std::array<double, 3>;

Vector at(std::span<const double> position, model::Index node) {
  const std::size_t n = 3 * static_cast<std::size_t>(node);
  return {position[n], position[n + 1], position[n + 2]};
}
Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Twice the area of a face times its normal: the cross product of the diagonals, right for triangles too.
Vector area_normal(const Surface& surface, std::span<const double> position, std::size_t face) {
  const model::Index* n = &surface.node[4 * face];
  const Vector p = minus(at(position, n[2]), at(position, n[0]));
  const Vector q = minus(at(position, n[3]), at(position, n[1]));
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Corners around each node: [begin[n], begin[n+1]) are indices 4 * face + corner.
struct Corners {
  std::vector<std::uint32_t> begin, corner;

  Corners(const Surface& surface, std::size_t node_count) : begin(node_count + 1, 0) {
    for_each(surface, [&](model::Index n, std::uint32_t) { ++begin[static_cast<std::size_t>(n) + 1]; });
    for (std::size_t n = 0; n < node_count; ++n) begin[n + 1] += begin[n];
    corner.resize(begin[node_count]);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for_each(surface,
             [&](model::Index n, std::uint32_t c) { corner[next[static_cast<std::size_t>(n)]++] = c; });
  }

  template <class Visit>
  static void for_each(const Surface& surface, const Visit& visit) {
    for (std::uint32_t c = 0; c < surface.node.size(); ++c)
      if (c % 4 != 3 || surface.node[c] != surface.node[c - 1]) visit(surface.node[c], c);
  }
};

}  // namespace

void orient_outwards(Surface& surface, std::span<const SolidCells> cells, std::span<const double> position) {
  for (std::size_t f = 0; f < surface.count(); ++f) {
    const SolidCells& block = cells[surface.block[f]];
    if (block.shape == model::Shape::tri3 || block.shape == model::Shape::quad4) continue;  // no inside
    const int size = model::nodes_of(block.shape);
    Vector centre{}, middle{};
    for (int a = 0; a < size; ++a) {
      const Vector x = at(position, block.node[static_cast<std::size_t>(surface.element[f]) * size + a]);
      for (int i = 0; i < 3; ++i) centre[i] += x[i] / size;
    }
    for (int k = 0; k < 4; ++k) {
      const Vector x = at(position, surface.node[4 * f + k]);
      for (int i = 0; i < 3; ++i) middle[i] += x[i] / 4;
    }
    if (dot(area_normal(surface, position, f), minus(middle, centre)) >= 0.0) continue;
    // Reversed: 0 2 1 for a triangle, 0 3 2 1 for a quadrilateral; the sides follow their corners.
    model::Index* n = &surface.node[4 * f];
    const unsigned e = surface.edges[f];
    const auto bit = [e](int k) { return (e >> k) & 1u; };
    if (n[3] == n[2]) {
      std::swap(n[1], n[2]);
      n[3] = n[2];
      surface.edges[f] = static_cast<std::uint8_t>(bit(2) | bit(1) << 1 | bit(0) << 2);
    } else {
      std::swap(n[1], n[3]);
      surface.edges[f] = static_cast<std::uint8_t>(bit(3) | bit(2) << 1 | bit(1) << 2 | bit(0) << 3);
    }
  }
}

std::vector<float> corner_normals(const Surface& surface, std::span<const double> position,
                                  double crease_degrees) {
  const double crease = std::cos(crease_degrees * std::numbers::pi / 180.0);
  std::vector<Vector> area(surface.count());
  std::vector<double> size(surface.count());
  for (std::size_t f = 0; f < surface.count(); ++f) {
    area[f] = area_normal(surface, position, f);
    size[f] = std::sqrt(dot(area[f], area[f]));
  }
  const Corners around(surface, position.size() / 3);
  std::vector<float> normals(12 * surface.count(), 0.0f);
  for (std::size_t c = 0; c < surface.node.size(); ++c) {
    const std::size_t own = c / 4, n = static_cast<std::size_t>(surface.node[c]);
    Vector sum{};
    for (std::uint32_t i = around.begin[n]; i < around.begin[n + 1]; ++i) {
      const std::size_t other = around.corner[i] / 4;
      if (other != own && dot(area[own], area[other]) < crease * size[own] * size[other]) continue;
      for (int k = 0; k < 3; ++k) sum[k] += area[other][k];
    }
    const double length = std::sqrt(dot(sum, sum));
    if (length > 0.0)
      for (int k = 0; k < 3; ++k) normals[3 * c + k] = static_cast<float>(sum[k] / length);
  }
  return normals;
}

std::vector<float> corner_averages(const Surface& surface, std::span<const float> face_value,
                                   std::size_t node_count) {
  const Corners around(surface, node_count);
  std::vector<float> averages(4 * surface.count());
  for (std::size_t n = 0; n < node_count; ++n) {
    const std::uint32_t begin = around.begin[n], end = around.begin[n + 1];
    double sum = 0.0;
    for (std::uint32_t i = begin; i < end; ++i) sum += face_value[around.corner[i] / 4];
    for (std::uint32_t i = begin; i < end; ++i)
      averages[around.corner[i]] = static_cast<float>(sum / (end - begin));
  }
  for (std::size_t f = 0; f < surface.count(); ++f)  // the repeated corner of a triangle
    if (surface.node[4 * f + 3] == surface.node[4 * f + 2]) averages[4 * f + 3] = averages[4 * f + 2];
  return averages;
}

}  // namespace cleave::results
