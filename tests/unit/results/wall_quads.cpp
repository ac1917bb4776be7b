/// Rigid walls as faces: they lie on the wall, look at the bodies, and end near them.

#include "results/wall_quads.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::results::test {
namespace {

using model::RigidWall;
using model::Vector;

StandingWall around_unit_box(const RigidWall& wall) {
  return {&wall, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
}
Vector normal_of(const WallQuad& quad) {
  return base::cross(quad[2] - quad[0], quad[3] - quad[1]);
}

TEST(WallQuads, PlaneEndsNearTheBodies) {
  RigidWall wall;
  wall.origin = {5, 5, -0.2};
  wall.normal = {0, 0, 1};
  const auto quads = wall_quads(around_unit_box(wall));
  ASSERT_EQ(quads.size(), 64u);
  double low = 1e9, high = -1e9;
  for (const WallQuad& quad : quads) {
    EXPECT_GT(normal_of(quad).z, 0.0);
    for (const Vector& corner : quad) {
      EXPECT_NEAR(corner.z, -0.2, 1e-15);
      low = std::min(low, corner.x), high = std::max(high, corner.x);
    }
  }
  const double beyond = std::sqrt(3.0) / 6.0;
  EXPECT_NEAR(low, -beyond, 1e-14);
  EXPECT_NEAR(high, 1.0 + beyond, 1e-14);
  wall.origin.z = -9.0;
  EXPECT_TRUE(wall_quads(around_unit_box(wall)).empty());
}

TEST(WallQuads, ARectangleKeepsItsSize) {
  RigidWall wall;
  wall.origin = {0, 0, 0};
  wall.normal = {0, 0, 1};
  wall.finite = true;
  wall.length_l = wall.length_m = 0.5;
  double most = 0.0;
  for (const WallQuad& quad : wall_quads({&wall, {0, 0, -0.1}, {0, 0, 0}, {1, 1, 1}}))
    for (const Vector& corner : quad) most = std::max({most, corner.x, corner.y, -5.0 * corner.z});
  EXPECT_NEAR(most, 0.5, 1e-14);
}

TEST(WallQuads, RoundWallsLookOutOrIn) {
  for (const RigidWall::Shape shape : {RigidWall::Shape::sphere, RigidWall::Shape::cylinder})
    for (const bool interior : {false, true}) {
      RigidWall wall;
      wall.shape = shape;
      wall.interior = interior;
      wall.normal = {0, 0, 1};
      wall.origin = interior ? Vector{0.5, 0.5, 0.5} : Vector{0.5, 0.5, -2.0};
      wall.radius = interior ? 1.0 : 1.9;
      if (shape == RigidWall::Shape::cylinder && !interior)
        wall.normal = {1, 0, 0}, wall.edge_l = {0, 1, 0}, wall.edge_m = {0, 0, 1};
      const auto quads = wall_quads(around_unit_box(wall));
      ASSERT_FALSE(quads.empty());
      for (const WallQuad& quad : quads)
        for (const Vector& corner : quad) {
          Vector radial = corner - wall.origin;
          if (shape == RigidWall::Shape::cylinder)
            radial = radial - base::dot(radial, wall.normal) * wall.normal;
          EXPECT_NEAR(std::sqrt(base::dot(radial, radial)), wall.radius, 1e-13);
          if (&corner == &quad[0] && base::dot(normal_of(quad), normal_of(quad)) > 0.0) {
            EXPECT_GT((interior ? -1.0 : 1.0) * base::dot(normal_of(quad), radial), 0.0);
          }
        }
    }
}

}  // namespace
}  // namespace cleave::results::test
