#include "base/tensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::base {
namespace {

using V = Vec3<double>;
using M = Mat3<double>;
using S = Sym3<double>;

M rotation(double angle) {  // about (1, 2, 2) / 3, by Rodrigues' formula
  const double n[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3}, c = std::cos(angle), s = std::sin(angle);
  const double k[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
  M r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r.m[i][j] = (i == j ? c : 0.0) + (1 - c) * n[i] * n[j] + s * k[i][j];
  return r;
}

TEST(Tensor, InverseTimesMatrixIsIdentity) {
  const M a{{{2, 1, 0.5}, {-0.3, 1.5, 0.2}, {0.1, 0.7, -1.1}}};
  const M product = a * inverse(a, determinant(a));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product.m[i][j], i == j, 1e-15);
}

TEST(Tensor, RotationKeepsInvariants) {
  const S s{3, -1, 2, 0.5, -0.7, 1.1};
  const S r = rotate(rotation(0.7), s);
  EXPECT_NEAR(trace(r), trace(s), 1e-14);
  EXPECT_NEAR(dot(r, r), dot(s, s), 1e-13);
  EXPECT_NEAR(von_mises(r), von_mises(s), 1e-14);
}

TEST(Tensor, RotationByAQuarterTurnAboutZSwapsAxes) {
  const M q{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // x -> y
  const S r = rotate(q, S{1, 2, 3, 0.4, 0.5, 0.6});
  EXPECT_EQ(r.xx, 2);
  EXPECT_EQ(r.yy, 1);
  EXPECT_EQ(r.zz, 3);
  EXPECT_EQ(r.xy, -0.4);
  EXPECT_EQ(r.yz, 0.6);
  EXPECT_EQ(r.zx, -0.5);
}

TEST(Tensor, VonMisesOfUniaxialAndShearStress) {
  EXPECT_NEAR(von_mises(S{5, 0, 0, 0, 0, 0}), 5, 1e-15);
  EXPECT_NEAR(von_mises(S{0, 0, 0, 2, 0, 0}), 2 * std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(von_mises(spherical(7.0)), 0, 1e-15);
}

TEST(Tensor, CrossProductIsRightHanded) {
  const V z = cross(V{1, 0, 0}, V{0, 1, 0});
  EXPECT_EQ(z.z, 1);
  EXPECT_EQ(dot(z, V{3, 4, 5}), 5);
}

}  // namespace
}  // namespace cleave::base
