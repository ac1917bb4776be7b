#pragma once
/// Tetrahedra with four and with ten nodes.

#include "discretisation/fem/isoparametric.hpp"

namespace cleave::discretisation::fem {

/// Barycentric gradients: N1 = 1 - r - s - t, N2 = r, N3 = s, N4 = t.
inline constexpr double barycentric[4][3] = {{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// 1/sqrt(sum over corners of 1/altitude^2). [length]
///
/// It bounds the step of the lumped linear tetrahedron for every shape and every Poisson's ratio: with
/// S = sum of grad N_a (x) grad N_a, the largest eigenvalue obeys rho omega^2 <= 4 (lambda tr S + 2 mu max S)
/// <= 4 (lambda + 2 mu) tr S, and 1/altitude_a = |grad N_a|, so 2/omega >= length/c. Equality is reached for
/// nu -> 1/2.
template <class Real>
Real altitude_length(const Vec3<Real>* x) {
  const auto j = jacobian(x, barycentric);
  const auto c = cofactor(j);
  const Real det = determinant(j, c);
  Real sum(0.0);
  for (int i = 0; i < 3; ++i) {
    const Real rest = -c.m[i][0] - c.m[i][1] - c.m[i][2];
    sum = sum + rest * rest + c.m[i][0] * c.m[i][0] + c.m[i][1] * c.m[i][1] + c.m[i][2] * c.m[i][2];
  }
  return det / sqrt(sum);
}

struct Tet4 {
  static constexpr int node_count = 4, point_count = 1;
  static constexpr model::Shape shape = model::Shape::tet4;
  static constexpr Quadrature<4, 1> rule{{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1.0 / 6.0}};
  static constexpr std::array<double, 4> mass_share{0.25, 0.25, 0.25, 0.25};

  template <class Real>
  static Real length(const Vec3<Real>* x, const Real&) {
    return altitude_length(x);
  }
};

constexpr Quadrature<10, 4> tet10_rule() {
  constexpr double near = 0.58541019662496845446,
                   far = 0.13819660112501051518;  // (5 + 3 sqrt 5)/20, (5 - sqrt 5)/20
  constexpr int edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  Quadrature<10, 4> q{};
  for (int p = 0; p < 4; ++p) {
    double at[4] = {far, far, far, far};
    at[p] = near;
    for (int k = 0; k < 3; ++k) {
      for (int a = 0; a < 4; ++a) q.gradient[p][a][k] = (4.0 * at[a] - 1.0) * barycentric[a][k];
      for (int m = 0; m < 6; ++m)
        q.gradient[p][4 + m][k] =
            4.0 * (at[edge[m][0]] * barycentric[edge[m][1]][k] + at[edge[m][1]] * barycentric[edge[m][0]][k]);
    }
    q.weight[p] = 1.0 / 24.0;
  }
  return q;
}

/// Four points of degree 2; mid nodes on edges 12 23 31 14 24 34.
struct Tet10 {
  static constexpr int node_count = 10, point_count = 4;
  static constexpr model::Shape shape = model::Shape::tet10;

  static constexpr Quadrature<10, 4> rule = tet10_rule();

  /// Diagonal of the consistent mass, scaled to the element's: Hinton, Rock & Zienkiewicz (1976).
  static constexpr double corner = 1.0 / 36.0, middle = 4.0 / 27.0;
  static constexpr std::array<double, 10> mass_share{corner, corner, corner, corner, middle,
                                                     middle, middle, middle, middle, middle};

  /// The bound of the linear tetrahedron on its corners times 0.39: least ratio of critical step and that
  /// bound over all shapes, 0.397 (docs/formulations/tet10.md).
  template <class Real>
  static Real length(const Vec3<Real>* x, const Real&) {
    return Real(0.39) * altitude_length(x);
  }
};

}  // namespace cleave::discretisation::fem
