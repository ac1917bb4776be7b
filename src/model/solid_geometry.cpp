#include "model/solid_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleave::model {
namespace {

double triple(const Corner& a, const Corner& b, const Corner& c) {
  return dot(a, cross(b, c));
}

using Edge = std::array<int, 2>;
constexpr Edge hex_edges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                              {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr Edge penta_edges[] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
constexpr Edge tet_edges[] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

/// For each corner its three neighbours, right-handed.
using Neighbours = std::array<int, 3>;
constexpr Neighbours hex_corners[] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                      {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr Neighbours penta_corners[] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
constexpr Neighbours tet_corners[] = {{1, 2, 3}};

constexpr Edge quad_edges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, triangle_edges[] = {{0, 1}, {1, 2}, {2, 0}},
               line_edges[] = {{0, 1}};

std::span<const Edge> edges(Shape shape) {
  if (shape == Shape::hex8) return hex_edges;
  if (shape == Shape::penta6) return penta_edges;
  if (shape == Shape::quad4) return quad_edges;
  if (shape == Shape::tri3) return triangle_edges;
  if (shape == Shape::line2) return line_edges;
  return tet_edges;
}

std::span<const Neighbours> corners(Shape shape) {
  if (shape == Shape::hex8) return hex_corners;
  if (shape == Shape::penta6) return penta_corners;
  return tet_corners;
}

double hex_jacobian(std::span<const Corner> x, double r, double s, double t) {
  static constexpr double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Corner d[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (int a = 0; a < 8; ++a) {
    const double p = 1 + sign[a][0] * r, q = 1 + sign[a][1] * s, w = 1 + sign[a][2] * t;
    d[0] = d[0] + (0.125 * sign[a][0] * q * w) * x[a];
    d[1] = d[1] + (0.125 * sign[a][1] * p * w) * x[a];
    d[2] = d[2] + (0.125 * sign[a][2] * p * q) * x[a];
  }
  return triple(d[0], d[1], d[2]);
}

/// Triangle coordinates (r, s) with weights over area 1/2, t along the prism in -1..1.
double penta_jacobian(std::span<const Corner> x, double r, double s, double t) {
  const double low = 0.5 * (1 - t), high = 0.5 * (1 + t);
  const Corner dr = low * (x[1] - x[0]) + high * (x[4] - x[3]);
  const Corner ds = low * (x[2] - x[0]) + high * (x[5] - x[3]);
  const double u = 1 - r - s;
  const Corner dt = 0.5 * (u * (x[3] - x[0]) + r * (x[4] - x[1]) + s * (x[5] - x[2]));
  return triple(dr, ds, dt);
}

}  // namespace

double volume(Shape shape, std::span<const Corner> x) {
  const double g = 1.0 / std::sqrt(3.0);
  double sum = 0.0;
  switch (shape) {
    case Shape::hex8:
      for (const double r : {-g, g})
        for (const double s : {-g, g})
          for (const double t : {-g, g}) sum += hex_jacobian(x, r, s, t);
      return sum;
    case Shape::penta6:
      for (const double t : {-g, g})
        for (const auto& [r, s] : {Edge{0, 0}, Edge{1, 0}, Edge{0, 1}})
          sum += penta_jacobian(x, 1.0 / 6.0 + 0.5 * r, 1.0 / 6.0 + 0.5 * s, t) / 6.0;
      return sum;
    case Shape::tet4:
    case Shape::tet10:
      return triple(x[1] - x[0], x[2] - x[0], x[3] - x[0]) / 6.0;
    case Shape::tri3:
    case Shape::quad4: {
      const Corner area = cross(x[2] - x[0], x[shape == Shape::tri3 ? 2 : 3] - x[1]);
      return 0.5 * std::sqrt(dot(area, area));
    }
    case Shape::line2:
      return std::sqrt(dot(x[1] - x[0], x[1] - x[0]));
  }
  return 0.0;
}

double centre_volume(Shape shape, std::span<const Corner> x) {
  if (shape == Shape::hex8) {
    const Corner r = (x[1] - x[0]) + (x[2] - x[3]) + (x[5] - x[4]) + (x[6] - x[7]);
    const Corner s = (x[3] - x[0]) + (x[2] - x[1]) + (x[7] - x[4]) + (x[6] - x[5]);
    const Corner t = (x[4] - x[0]) + (x[5] - x[1]) + (x[6] - x[2]) + (x[7] - x[3]);
    return triple(r, s, t) / 64.0;
  }
  if (shape == Shape::penta6) return penta_jacobian(x, 1.0 / 3.0, 1.0 / 3.0, 0.0);
  return volume(shape, x);
}

double jacobian_ratio(Shape shape, std::span<const Corner> x) {
  double low = 0.0, high = 0.0;
  bool first = true;
  const auto all = corners(shape);
  for (std::size_t a = 0; a < all.size(); ++a) {
    const Corner e[3] = {x[all[a][0]] - x[a], x[all[a][1]] - x[a], x[all[a][2]] - x[a]};
    if (dot(e[0], e[0]) == 0.0 || dot(e[1], e[1]) == 0.0 || dot(e[2], e[2]) == 0.0) continue;
    const double det = triple(e[0], e[1], e[2]);
    low = first ? det : std::min(low, det);
    high = first ? det : std::max(high, det);
    first = false;
  }
  return high > 0.0 ? low / high : -1.0;
}

namespace {

/// Squares of the shortest and the longest edge, edges of zero length left out.
std::pair<double, double> edge_range(Shape shape, std::span<const Corner> x) {
  double low = 0.0, high = 0.0;
  for (const auto& [a, b] : edges(shape)) {
    const Corner d = x[b] - x[a];
    const double square = dot(d, d);
    if (square == 0.0) continue;
    low = low == 0.0 ? square : std::min(low, square);
    high = std::max(high, square);
  }
  return {low, high};
}

}  // namespace

double shortest_edge(Shape shape, std::span<const Corner> x) {
  return std::sqrt(edge_range(shape, x).first);
}

double aspect_ratio(Shape shape, std::span<const Corner> x) {
  const auto [low, high] = edge_range(shape, x);
  return low > 0.0 ? std::sqrt(high / low) : 0.0;
}

}  // namespace cleave::model
