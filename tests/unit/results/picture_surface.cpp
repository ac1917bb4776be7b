#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

#include "picture_meshes.hpp"
#include "results/surface.hpp"

namespace cleave::results {
namespace {

using model::Index;
using model::Shape;

std::array<double, 3> area_vector(const Surface& s, const std::vector<double>& x, std::size_t f) {
  std::array<double, 3> p{}, q{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](int k) { return x[3 * static_cast<std::size_t>(s.node[4 * f + k]) + i]; };
    p[i] = at(2) - at(0);
    q[i] = at(3) - at(1);
  }
  return {0.5 * (p[1] * q[2] - p[2] * q[1]), 0.5 * (p[2] * q[0] - p[0] * q[2]),
          0.5 * (p[0] * q[1] - p[1] * q[0])};
}

/// A third of the sum of x . area over a closed surface: the volume, positive only if normals point outwards.
double enclosed_volume(const Surface& s, const std::vector<double>& x) {
  double volume = 0.0;
  for (std::size_t f = 0; f < s.count(); ++f) {
    const auto a = area_vector(s, x, f);
    const int corners = s.node[4 * f + 3] == s.node[4 * f + 2] ? 3 : 4;
    for (int k = 0; k < corners; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        volume += x[3 * static_cast<std::size_t>(s.node[4 * f + k]) + i] * a[i] / (3.0 * corners);
  }
  return volume;
}

TEST(Surface, CubeOfCubesShowsSixSquares) {
  for (const int n : {1, 2, 5}) {
    const auto mesh = test::cubes(n, n, n);
    const SolidCells cells[] = {mesh.cells()};
    const Surface surface = outer_faces(cells, mesh.node_count());
    EXPECT_EQ(surface.count(), static_cast<std::size_t>(6 * n * n));
    EXPECT_NEAR(enclosed_volume(surface, mesh.position), n * n * n, 1e-12 * n * n * n);
    EXPECT_TRUE(std::all_of(surface.edges.begin(), surface.edges.end(), [](auto e) { return e == 0b1111; }));
  }
}

TEST(Surface, DeletedElementOpensACave) {
  const auto mesh = test::cubes(3, 3, 3);
  std::vector<std::uint8_t> alive(27, 1);
  alive[13] = 0;  // the middle one
  const SolidCells cells[] = {{mesh.shape, mesh.node, alive}};
  EXPECT_EQ(outer_faces(cells, mesh.node_count()).count(), 54u + 6u);
}

TEST(Surface, EveryShapeIsClosedAndPointsOutwards) {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  const std::vector<Index> wedge = {0, 1, 2, 3, 4, 5}, tet = {0, 1, 2, 3};
  const SolidCells wedges[] = {{Shape::penta6, wedge, {}}}, tets[] = {{Shape::tet4, tet, {}}};
  const Surface w = outer_faces(wedges, 6), t = outer_faces(tets, 6);
  EXPECT_EQ(w.count(), 5u);
  EXPECT_NEAR(enclosed_volume(w, corners), 0.5, 1e-15);
  EXPECT_EQ(t.count(), 4u);
  EXPECT_NEAR(enclosed_volume(t, corners), 1.0 / 6.0, 1e-15);

  // Ten nodes: mid nodes halfway, so the same volume from sixteen triangles.
  std::vector<double> x(corners.begin(), corners.begin() + 12);
  const int sides[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (const auto& side : sides)
    for (int i = 0; i < 3; ++i) x.push_back(0.5 * (corners[3 * side[0] + i] + corners[3 * side[1] + i]));
  const std::vector<Index> ten = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const SolidCells tens[] = {{Shape::tet10, ten, {}}};
  const Surface q = outer_faces(tens, 10);
  EXPECT_EQ(q.count(), 16u);
  EXPECT_NEAR(enclosed_volume(q, x), 1.0 / 6.0, 1e-15);
  int lines = 0;
  for (const auto edges : q.edges) lines += std::popcount(edges);
  EXPECT_EQ(lines, 4 * 6);  // each face: three edges of two halves
}

TEST(Surface, PyramidWrittenAsHexahedronHasFiveFaces) {
  const std::vector<Index> pyramid = {0, 1, 2, 3, 4, 4, 4, 4};
  const SolidCells cells[] = {{Shape::hex8, pyramid, {}}};
  const Surface surface = outer_faces(cells, 5);
  ASSERT_EQ(surface.count(), 5u);
  int triangles = 0;
  for (std::size_t f = 0; f < 5; ++f) triangles += surface.node[4 * f + 3] == surface.node[4 * f + 2];
  EXPECT_EQ(triangles, 4);
}

TEST(Surface, HexahedronAndWedgeShareTheirFace) {
  const std::vector<Index> cube = {0, 1, 2, 3, 4, 5, 6, 7}, wedge = {1, 8, 2, 5, 9, 6};
  const SolidCells cells[] = {{Shape::hex8, cube, {}}, {Shape::penta6, wedge, {}}};
  EXPECT_EQ(outer_faces(cells, 10).count(), 5u + 4u);
}

TEST(Surface, InvertedNumberingIsTurnedOutwards) {
  auto mesh = test::cubes(2, 2, 2);
  for (std::size_t e = 0; e < 8; ++e)  // mirrored: lower and upper quadrilaterals exchanged
    std::swap_ranges(&mesh.node[8 * e], &mesh.node[8 * e + 4], &mesh.node[8 * e + 4]);
  const SolidCells cells[] = {mesh.cells()};
  Surface surface = outer_faces(cells, mesh.node_count());
  EXPECT_DOUBLE_EQ(enclosed_volume(surface, mesh.position), -8.0);
  orient_outwards(surface, cells, mesh.position);
  EXPECT_DOUBLE_EQ(enclosed_volume(surface, mesh.position), 8.0);
}

TEST(Surface, NormalsAreSharpAtTheRimAndSmoothOnTheSphere) {
  const auto cube = test::cubes(2, 2, 2);
  const SolidCells cube_cells[] = {cube.cells()};
  const Surface flat = outer_faces(cube_cells, cube.node_count());
  const auto flat_normals = corner_normals(flat, cube.position);
  for (std::size_t c = 0; c < flat_normals.size(); c += 3)  // along an axis, even at the cube's corners
    EXPECT_FLOAT_EQ(
        std::max({std::abs(flat_normals[c]), std::abs(flat_normals[c + 1]), std::abs(flat_normals[c + 2])}),
        1.0f);

  const auto ball = test::ball(12);
  const SolidCells ball_cells[] = {ball.cells()};
  const Surface round = outer_faces(ball_cells, ball.node_count());
  const auto normals = corner_normals(round, ball.position);
  for (std::size_t c = 0; c < round.node.size(); ++c) {
    double cosine = 0.0;  // the normal of a sphere is its position
    for (std::size_t i = 0; i < 3; ++i)
      cosine += normals[3 * c + i] * ball.position[3 * static_cast<std::size_t>(round.node[c]) + i];
    EXPECT_GT(cosine, 0.995);
  }
}

TEST(Surface, AveragesKeepConstantsAndMeetAtNodes) {
  const auto mesh = test::cubes(4, 1, 1);
  const SolidCells cells[] = {mesh.cells()};
  const Surface surface = outer_faces(cells, mesh.node_count());
  const std::vector<float> three(surface.count(), 3.0f);
  for (const float v : corner_averages(surface, three, mesh.node_count())) EXPECT_FLOAT_EQ(v, 3.0f);

  std::vector<float> element(surface.count());
  for (std::size_t f = 0; f < element.size(); ++f) element[f] = static_cast<float>(surface.element[f]);
  const auto averages = corner_averages(surface, element, mesh.node_count());
  for (std::size_t c = 0; c < averages.size(); ++c) {
    const double x = mesh.position[3 * static_cast<std::size_t>(surface.node[c])];
    if (x < 0.5 || x > 3.5) continue;
    EXPECT_NEAR(averages[c], x - 0.5, 1e-6);  // halfway between the elements beside it
  }
}

}  // namespace
}  // namespace cleave::results
