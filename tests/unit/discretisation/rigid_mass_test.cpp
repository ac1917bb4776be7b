/// Mass properties of elements, and of bodies made of them.

#include <gtest/gtest.h>

#include <cmath>

#include "base/symmetric_eigen.hpp"
#include "discretisation/rigid/mass.hpp"

namespace cleave::discretisation {
namespace {

using model::Shape;
using model::Vector;

const Vector cube[8] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

void expect_equal(const RigidMass& a, const RigidMass& b, double tolerance = 1e-13) {
  EXPECT_NEAR(a.mass, b.mass, tolerance * b.mass);
  for (const auto& [p, q] :
       {std::pair{a.centre.x, b.centre.x}, {a.centre.y, b.centre.y}, {a.centre.z, b.centre.z}})
    EXPECT_NEAR(p, q, tolerance);
  const double scale = tolerance * trace(b.tensor);
  EXPECT_NEAR(a.tensor.xx, b.tensor.xx, scale);
  EXPECT_NEAR(a.tensor.yy, b.tensor.yy, scale);
  EXPECT_NEAR(a.tensor.zz, b.tensor.zz, scale);
  EXPECT_NEAR(a.tensor.xy, b.tensor.xy, scale);
  EXPECT_NEAR(a.tensor.yz, b.tensor.yz, scale);
  EXPECT_NEAR(a.tensor.zx, b.tensor.zx, scale);
}

TEST(RigidMass, BoxHasTheMomentsOfTheTextbook) {
  std::vector<Vector> box;
  for (const Vector& x : cube) box.push_back({2 * x.x + 5, 3 * x.y - 1, 4 * x.z});
  const double m = 7.0 * 24.0;
  expect_equal(solid_mass(Shape::hex8, box, 7.0),
               {m, {6, 0.5, 2}, {m * (9 + 16) / 12, m * (4 + 16) / 12, m * (4 + 9) / 12, 0, 0, 0}});
}

// Vertices 0, x, y, z of length 1: integrals of x^2 are 1/60, of x y 1/120 over a volume of 1/6.
TEST(RigidMass, TetrahedronAgainstItsIntegrals) {
  const Vector tet[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double square = 1.0 / 60.0 - 1.0 / 96.0, product = 1.0 / 120.0 - 1.0 / 96.0;
  expect_equal(
      solid_mass(Shape::tet4, tet, 1.0),
      {1.0 / 6.0, {0.25, 0.25, 0.25}, {2 * square, 2 * square, 2 * square, -product, -product, -product}});
}

TEST(RigidMass, PiecesMakeTheWhole) {
  // Five tetrahedra, or two wedges, of a parallelepiped.
  const auto at = [](const Vector& x) {
    return Vector{2 * x.x + 0.3 * x.y, x.y + 0.2 * x.z, 1.5 * x.z + 0.1 * x.x};
  };
  Vector hex[8];
  for (int a = 0; a < 8; ++a) hex[a] = at(cube[a]);
  const RigidMass whole = solid_mass(Shape::hex8, hex, 2.0);
  RigidMass sum;
  for (const auto& t : {std::array{0, 1, 3, 4}, {1, 2, 3, 6}, {4, 7, 6, 3}, {4, 6, 5, 1}, {1, 3, 4, 6}}) {
    const Vector tet[4] = {hex[t[0]], hex[t[1]], hex[t[2]], hex[t[3]]};
    sum += solid_mass(Shape::tet4, tet, 2.0);
  }
  expect_equal(sum, whole);
  sum = {};
  for (const auto& w : {std::array{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}}) {
    Vector wedge[6];
    for (int a = 0; a < 6; ++a) wedge[a] = hex[w[a]];
    sum += solid_mass(Shape::penta6, wedge, 2.0);
  }
  expect_equal(sum, whole);
}

// The middle of edge 2-3 moved by d: x = X + 4 r s d, so det J = 1 + 4 (s d_x + r d_y), and the integrals of
// r and s are 1/24.
TEST(RigidMass, QuadraticTetrahedronFollowsItsCurvedFaces) {
  Vector tet[10] = {{0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
                    {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  expect_equal(solid_mass(Shape::tet10, tet, 3.0), solid_mass(Shape::tet4, {tet, 4}, 3.0));
  tet[5] = {0.6, 0.7, 0};
  EXPECT_NEAR(solid_mass(Shape::tet10, tet, 3.0).mass, 3.0 * (1.0 / 6.0 + 4.0 * (0.1 + 0.2) / 24.0), 1e-14);
}

TEST(RigidMass, PlateHasItsThickness) {
  const Vector quad[4] = {{0, 0, 1}, {2, 0, 1}, {2, 3, 1}, {0, 3, 1}};
  const double m = 5.0 * 6.0 * 0.5 + 6.0 * 0.25, thick = 5.0 * 6.0 * 0.5 * 0.25 / 12;
  expect_equal(shell_mass(Shape::quad4, quad, 5.0, 0.5, 0.25),
               {m, {1, 1.5, 1}, {m * 9 / 12 + thick, m * 4 / 12 + thick, m * 13 / 12, 0, 0, 0}});
}

TEST(SymmetricEigen, FindsValuesAndVectors) {
  double a[3][3] = {{4, 1, -2}, {1, 3, 0.5}, {-2, 0.5, 5}}, v[3][3];
  const double kept[3][3] = {{4, 1, -2}, {1, 3, 0.5}, {-2, 0.5, 5}};
  base::symmetric_eigen<3>(a, v);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) {
      double row = 0.0, one = 0.0;
      for (int j = 0; j < 3; ++j) row += kept[i][j] * v[j][k], one += v[j][i] * v[j][k];
      EXPECT_NEAR(row, a[k][k] * v[i][k], 1e-13);
      EXPECT_NEAR(one, i == k ? 1.0 : 0.0, 1e-14);
    }
}

}  // namespace
}  // namespace cleave::discretisation
