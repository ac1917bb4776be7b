#pragma once
/// Hexahedron with 2 x 2 x 2 points and wedge with 3 x 2, as topologies for isoparametric.hpp.

#include "discretisation/fem/isoparametric.hpp"

namespace cleave::discretisation::fem {

inline constexpr double gauss = 0.57735026918962576451;  ///< 1/sqrt 3

/// Four times the square of the area of a warped quadrilateral between its diagonals. [length^4]
template <class Real>
Real quad_area_squared(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c, const Vec3<Real>& d) {
  const auto n = cross(c - a, d - b);
  return dot(n, n);
}

/// Reference corners.
inline constexpr double hex8_corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                             {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

constexpr Quadrature<8, 8> hex8_rule() {
  Quadrature<8, 8> q{};
  for (int p = 0; p < 8; ++p) {
    q.weight[p] = 1.0;
    for (int a = 0; a < 8; ++a)
      for (int k = 0; k < 3; ++k) {
        double g = 0.125 * hex8_corner[a][k];
        for (int o = 0; o < 3; ++o)
          if (o != k) g *= 1.0 + hex8_corner[a][o] * gauss * hex8_corner[p][o];
        q.gradient[p][a][k] = g;
      }
  }
  return q;
}

struct Hex8 {
  static constexpr int node_count = 8, point_count = 8;
  static constexpr model::Shape shape = model::Shape::hex8;

  static constexpr Quadrature<8, 8> rule = hex8_rule();
  static constexpr std::array<double, 8> mass_share{0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125};

  /// Volume over the largest face.
  template <class Real>
  static Real length(const Vec3<Real>* x, const Real& volume) {
    const Real a = max(quad_area_squared(x[0], x[1], x[2], x[3]), quad_area_squared(x[4], x[5], x[6], x[7]));
    const Real b = max(quad_area_squared(x[0], x[1], x[5], x[4]), quad_area_squared(x[3], x[2], x[6], x[7]));
    const Real c = max(quad_area_squared(x[1], x[2], x[6], x[5]), quad_area_squared(x[0], x[3], x[7], x[4]));
    return Real(2.0) * volume / sqrt(max(a, max(b, c)));
  }
};

constexpr Quadrature<6, 6> penta6_rule() {
  constexpr double triangle[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
  Quadrature<6, 6> q{};
  for (int p = 0; p < 6; ++p) {
    q.weight[p] = 1.0 / 6.0;
    const double z = p < 3 ? -gauss : gauss;
    double at[3] = {1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0};  // area coordinates of the point
    at[p % 3] = 2.0 / 3.0;
    for (int a = 0; a < 6; ++a) {
      const double side = a < 3 ? -1.0 : 1.0;
      for (int k = 0; k < 2; ++k) q.gradient[p][a][k] = 0.5 * triangle[a % 3][k] * (1.0 + side * z);
      q.gradient[p][a][2] = 0.5 * side * at[a % 3];
    }
  }
  return q;
}

/// Wedge: triangles (0,1,2) below and (3,4,5) above, three points in each of two planes between them. (Two
/// points on the line between the centres leave the twist about that line without stiffness.)
struct Penta6 {
  static constexpr int node_count = 6, point_count = 6;
  static constexpr model::Shape shape = model::Shape::penta6;

  static constexpr Quadrature<6, 6> rule = penta6_rule();
  static constexpr double sixth = 1.0 / 6.0;
  static constexpr std::array<double, 6> mass_share{sixth, sixth, sixth, sixth, sixth, sixth};

  /// Volume over the largest face, triangles and quadrilaterals alike.
  template <class Real>
  static Real length(const Vec3<Real>* x, const Real& volume) {
    const auto triangle = [](const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
      const auto n = cross(b - a, c - a);
      return dot(n, n);
    };
    const Real ends = max(triangle(x[0], x[1], x[2]), triangle(x[3], x[4], x[5]));
    const Real sides =
        max(quad_area_squared(x[0], x[1], x[4], x[3]),
            max(quad_area_squared(x[1], x[2], x[5], x[4]), quad_area_squared(x[2], x[0], x[3], x[5])));
    return Real(2.0) * volume / sqrt(max(ends, sides));
  }
};

}  // namespace cleave::discretisation::fem
