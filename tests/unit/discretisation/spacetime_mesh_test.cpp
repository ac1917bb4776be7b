#include <gtest/gtest.h>

#include <set>

#include "discretisation/spacetime/mesh.hpp"
#include "spacetime_meshes.hpp"

namespace cleave::discretisation::spacetime::sample {
namespace {

/// Builds what must be refused; the message must hold `word`.
template <int D>
MeshFault refusal(const SpaceMeshInput<D>& input, const std::string& word) {
  SpaceMesh<D> mesh;
  MeshFault fault = mesh.build(input);
  EXPECT_FALSE(fault.ok);
  EXPECT_NE(fault.what.find(word), std::string::npos) << fault.what;
  EXPECT_EQ(mesh.vertex_count(), 0);
  return fault;
}

template <int D>
void expect_sound(const SpaceMeshInput<D>& input, double volume, double surface) {
  SpaceMesh<D> mesh;
  const MeshFault fault = mesh.build(input);
  ASSERT_TRUE(fault.ok) << fault.what;
  EXPECT_NEAR(mesh.volume(), volume, 1e-12 * volume);
  double area = 0.0;
  Point<D> sum{};
  for (const auto& face : mesh.boundary()) {
    area += face.area;
    EXPECT_NEAR(norm(face.normal), 1.0, 1e-14);
    for (std::size_t k = 0; k < D; ++k) sum[k] += face.area * face.normal[k];
  }
  EXPECT_NEAR(area, surface, 1e-12 * surface);
  EXPECT_NEAR(norm(sum), 0.0, 1e-12 * surface);
  for (Simplex s = 0; s < mesh.simplex_count(); ++s)
    for (int i = 0; i <= D; ++i) {
      const Simplex other = mesh.across(s, i);
      EXPECT_EQ(other < 0, mesh.boundary_face(s, i) >= 0);
      if (other < 0) continue;
      int back = 0;
      for (int j = 0; j <= D; ++j) back += mesh.across(other, j) == s;
      EXPECT_EQ(back, 1);
    }
  std::set<std::int32_t> ranks;
  int lowest = 0;
  for (Vertex v = 0; v < mesh.vertex_count(); ++v) {
    ranks.insert(mesh.rank(v));
    bool low = true;
    for (const Vertex w : mesh.neighbours(v)) {
      low = low && mesh.rank(v) < mesh.rank(w);
      EXPECT_NE(w, v);
    }
    lowest += low;
    for (const Simplex s : mesh.star(v)) {
      const auto& simplex = mesh.simplex(s);
      EXPECT_NE(std::find(simplex.begin(), simplex.end(), v), simplex.end());
    }
  }
  EXPECT_EQ(static_cast<Vertex>(ranks.size()), mesh.vertex_count());
  EXPECT_GE(lowest * (D == 3 ? 16 : 8), mesh.vertex_count());  // a level front has many places to begin
}

TEST(SpacetimeMesh, ConnectsSimplices) {
  expect_sound<1>(line(20, 0.3), 1.0, 2.0);
  expect_sound<2>(grid(9, 0.3), 1.0, 4.0);
  expect_sound<3>(cube(4, 0.2), 1.0, 6.0);
  auto backwards = line(5);
  std::swap(backwards.simplex[2][0], backwards.simplex[2][1]);  // the order of a segment's ends is free
  expect_sound<1>(backwards, 1.0, 2.0);
}

TEST(SpacetimeMesh, RefusesBadSimplices) {
  auto in = grid(4);
  std::swap(in.simplex[7][0], in.simplex[7][1]);
  in.simplex_id.resize(in.simplex.size());
  for (std::size_t s = 0; s < in.simplex_id.size(); ++s)
    in.simplex_id[s] = 1000 + static_cast<std::int64_t>(s);
  EXPECT_EQ(refusal(in, "element 1007 is inverted").element, std::vector<std::int64_t>{1007});

  in = grid(4);
  in.vertex[6] = in.vertex[7];
  refusal(in, "degenerate");
  in = grid(4);
  in.simplex[3][1] = in.simplex[3][0];
  refusal(in, "element 4 is degenerate");
  in.simplex[3][1] = 99;
  refusal(in, "does not exist");
  in = grid(4);
  in.vertex.push_back({3.0, 3.0});
  EXPECT_EQ(refusal(in, "vertex 26 belongs to no element").vertex, std::vector<std::int64_t>{26});
  in = grid(4);
  in.speed[0].slowest = 0.0;
  refusal(in, "wave speed");
  in = grid(4);
  in.material[2] = 5;
  refusal(in, "element 3 has no material");
  auto solid = cube(2);
  std::swap(solid.simplex[5][2], solid.simplex[5][3]);
  refusal(solid, "element 6 is inverted");
  refusal(SpaceMeshInput<2>{}, "no elements");
}

TEST(SpacetimeMesh, RefusesHangingAndDoubledVertices) {
  // One square of two triangles beside two half squares: vertex 7 hangs on the edge 2-3.
  SpaceMeshInput<2> in;
  in.vertex = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}, {1, 0.5}};
  in.simplex = {{0, 1, 2}, {0, 2, 3}, {1, 4, 6}, {6, 4, 5}, {6, 5, 2}};
  one_material(in);
  const MeshFault hanging = refusal(in, "vertex 7 hangs");
  EXPECT_EQ(hanging.element, std::vector<std::int64_t>{1});
  EXPECT_NE(hanging.what.find("(1, 0.5)"), std::string::npos);

  // Two squares that touch without sharing vertices.
  in.vertex = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}};
  in.simplex = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  one_material(in);
  refusal(in, "vertices 2 and 5 lie at the same place");
  in.touching_allowed = true;
  SpaceMesh<2> mesh;
  EXPECT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(mesh.boundary().size(), 8u);
}

TEST(SpacetimeMesh, RefusesOverlaps) {
  auto in = grid(4);
  in.simplex.push_back(in.simplex[10]);
  in.material.push_back(0);
  refusal(in, "");  // given twice: its faces have too many sides
  // A triangle on the wrong side of an edge of another.
  SpaceMeshInput<2> pair;
  pair.vertex = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  pair.simplex = {{0, 1, 2}, {0, 1, 3}};
  one_material(pair);
  refusal(pair, "same side");

  // Two bars that cross without a vertex of either in the other.
  SpaceMeshInput<2> cross;
  cross.vertex = {{-3, -1}, {3, -1}, {3, 1}, {-3, 1}, {-0.9, -3}, {1, -3}, {1, 3}, {-0.9, 3}};
  cross.simplex = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  one_material(cross);
  refusal(cross, "cross");

  // A small body inside a large one.
  auto inside = grid(1);
  inside.vertex.insert(inside.vertex.end(), {{0.6, 0.1}, {0.7, 0.1}, {0.6, 0.2}});
  inside.simplex.push_back({4, 5, 6});
  one_material(inside);
  refusal(inside, "vertex 5 lies inside element 1");

  // A fan of seven triangles of 60 degrees.
  SpaceMeshInput<2> fan;
  fan.vertex.push_back({0, 0});
  for (int i = 0; i < 8; ++i) {
    const double r = 1.0 + 0.2 * i;
    fan.vertex.push_back({r * std::cos(i * std::numbers::pi / 3), r * std::sin(i * std::numbers::pi / 3)});
    if (i > 0) fan.simplex.push_back({0, i, i + 1});
  }
  one_material(fan);
  SpaceMesh<2> mesh;
  EXPECT_FALSE(mesh.build(fan).ok);

  // Bars through each other in space.
  SpaceMeshInput<3> bars;
  bars.vertex = {{-3, 0, 0},   {3, -1, 0},   {3, 1, 0},   {3, 0, 1},
                 {0, -3, 0.3}, {-1, 3, 0.3}, {1, 3, 0.3}, {0, 3, 2}};
  bars.simplex = {{0, 1, 2, 3}, {4, 6, 5, 7}};
  one_material(bars);
  refusal(bars, "cross");
  SpaceMeshInput<1> line_twice = line(3);
  line_twice.vertex.insert(line_twice.vertex.end(), {{0.1}, {0.2}});
  line_twice.simplex.push_back({4, 5});
  one_material(line_twice);
  refusal(line_twice, "inside");
}

TEST(SpacetimeMesh, AcceptsPlaneFacesAskewToTheAxes) {
  // The faces of a plane boundary lie in one plane up to rounding only.
  Random random(3);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SpaceMesh<3> solid;
    const MeshFault fault = solid.build(spoiled<3>(cube(3, 0.15, seed), random(0.2, 1.0), random(-1.0, 1.0)));
    EXPECT_TRUE(fault.ok) << fault.what;
    SpaceMesh<2> plate;
    EXPECT_TRUE(plate.build(spoiled<2>(grid(5, 0.2, seed), random(0.1, 1.0), random(-2.0, 2.0))).ok);
  }
}

TEST(SpacetimeMesh, TagsBoundaryFaces) {
  auto in = grid(3);
  in.tag = {{.vertex = {1, 0}, .tag = 7}};
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(in).ok);
  int tagged = 0;
  for (const auto& face : mesh.boundary())
    if (face.tag == 7) {
      ++tagged;
      EXPECT_EQ(face.normal, (Point<2>{0.0, -1.0}));
      EXPECT_DOUBLE_EQ(face.area, 1.0 / 3.0);
    }
  EXPECT_EQ(tagged, 1);
  in.tag = {{.vertex = {5, 6}, .tag = 7}};
  EXPECT_EQ(refusal(in, "not on the boundary").vertex, (std::vector<std::int64_t>{6, 7}));
}

/// Number of mesh vertices that stand for v.
template <int D>
int copies(const SpaceMesh<D>& mesh, Vertex v) {
  int count = 0;
  for (Vertex w = 0; w < mesh.vertex_count(); ++w) count += mesh.origin(w) == v;
  return count;
}

TEST(SpacetimeMesh, CracksDoubleTheirVerticesButNotTheirTips) {
  // Vertices of grid(4) are 5 j + i. A crack inside, along y = 1/2 from 11 to 13.
  auto in = grid(4);
  ASSERT_TRUE(add_crack(in, std::vector<Point<2>>{{0.25, 0.5}, {0.75, 0.5}}).ok);
  EXPECT_EQ(in.crack.size(), 2u);
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(mesh.vertex_count(), 26);
  EXPECT_EQ(copies(mesh, 11), 1);
  EXPECT_EQ(copies(mesh, 12), 2);
  EXPECT_EQ(copies(mesh, 13), 1);
  EXPECT_EQ(mesh.boundary().size(), 16u + 4u);
  int faces = 0;
  for (const auto& face : mesh.boundary()) {
    if (face.crack < 0) continue;
    ++faces;
    const auto& twin = mesh.boundary()[static_cast<std::size_t>(face.twin)];
    EXPECT_EQ(&mesh.boundary()[static_cast<std::size_t>(twin.twin)], &face);
    EXPECT_EQ(twin.normal[1], -face.normal[1]);
    EXPECT_EQ(std::abs(face.normal[1]), 1.0);
    std::set<Vertex> here, there;
    for (const Vertex v : face.vertex) here.insert(mesh.origin(v));
    for (const Vertex v : twin.vertex) there.insert(mesh.origin(v));
    EXPECT_EQ(here, there);
    EXPECT_NE(face.vertex, twin.vertex);
  }
  EXPECT_EQ(faces, 4);

  // From the boundary: the mouth is doubled too. An L: no vertex more than twice.
  in = grid(4);
  ASSERT_TRUE(add_crack(in, std::vector<Point<2>>{{0.0, 0.5}, {0.5, 0.5}, {0.5, 0.25}}).ok);
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(copies(mesh, 10), 2);
  EXPECT_EQ(copies(mesh, 12), 2);
  EXPECT_EQ(copies(mesh, 7), 1);
  EXPECT_EQ(mesh.vertex_count(), 28);

  // A cross: four copies of its centre, and a cut through the body.
  in = grid(4);
  ASSERT_TRUE(add_crack(in, std::vector<Point<2>>{{0.25, 0.5}, {0.75, 0.5}}).ok);
  ASSERT_TRUE(add_crack(in, std::vector<Point<2>>{{0.5, 0.25}, {0.5, 0.75}}).ok);
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(copies(mesh, 12), 4);
  EXPECT_EQ(mesh.vertex_count(), 28);
  in = grid(4);
  ASSERT_TRUE(add_crack(in, std::vector<Point<2>>{{0.0, 0.5}, {1.0, 0.5}}).ok);
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(mesh.vertex_count(), 30);
}

TEST(SpacetimeMesh, CracksInSpaceAndOnALine) {
  // The square [1/4, 3/4]^2 at z = 1/2 of cube(4): nine vertices, of which the inner one is doubled.
  auto in = cube(4);
  const double a = 0.25, b = 0.75, z = 0.5;
  ASSERT_TRUE(add_crack(in, std::vector<Point<3>>{{a, a, z}, {b, a, z}, {b, b, z}, {a, b, z}}).ok);
  EXPECT_EQ(in.crack.size(), 8u);
  SpaceMesh<3> mesh;
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(mesh.vertex_count(), 126);
  EXPECT_EQ(mesh.boundary().size(), 6u * 32u + 16u);
  EXPECT_EQ(copies(mesh, 62), 2);
  // Through the body: all 25 vertices of the plane.
  in = cube(4);
  ASSERT_TRUE(add_crack(in, std::vector<Point<3>>{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}).ok);
  ASSERT_TRUE(mesh.build(in).ok);
  EXPECT_EQ(mesh.vertex_count(), 150);

  auto bar = line(4);
  bar.crack = {{2}};
  SpaceMesh<1> halves;
  ASSERT_TRUE(halves.build(bar).ok);
  EXPECT_EQ(halves.vertex_count(), 6);
  EXPECT_EQ(halves.boundary().size(), 4u);
}

TEST(SpacetimeMesh, RefusesCracksOffTheFaces) {
  auto in = grid(4);
  const auto refuse = [&](const std::vector<Point<2>>& polyline, const char* word) {
    const MeshFault fault = add_crack(in, polyline);
    EXPECT_FALSE(fault.ok);
    EXPECT_NE(fault.what.find(word), std::string::npos) << fault.what;
  };
  refuse({{0.25, 0.5}, {0.6, 0.5}}, "segment 1 from (0.25, 0.5) to (0.6, 0.5)");  // ends inside an edge
  refuse({{0.25, 0.5}, {0.6, 0.5}}, "at (0.5, 0.5)");                             // where it leaves the edges
  refuse({{0.25, 0.5}, {0.5, 0.5}, {0.75, 0.6}}, "segment 2");                    // cuts triangles
  refuse({{0.25, 0.75}, {0.5, 0.5}}, "segment 1");                                // across a diagonal
  refuse({{0.0, 0.0}, {0.5, 0.0}}, "segment 1");                                  // along the boundary
  refuse({{0.5, 0.5}}, "two points");
  in.crack = {{0, 1}};
  EXPECT_EQ(refusal(in, "the crack face with vertices 1, 2").vertex, (std::vector<std::int64_t>{1, 2}));
  auto solid = cube(2);
  const MeshFault fault = add_crack(solid, std::vector<Point<3>>{{0, 0, 0.4}, {1, 0, 0.4}, {1, 1, 0.4}});
  EXPECT_FALSE(fault.ok);
  EXPECT_NE(fault.what.find("0.0"), std::string::npos) << fault.what;
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::sample
