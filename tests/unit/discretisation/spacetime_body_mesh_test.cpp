/// Bodies of decks: bars, tetrahedra, cracks and their faces, silent faces, forces, local frames; and what is
/// wrong with a mesh, told with its place.

#include <gtest/gtest.h>

#include <cmath>

#include "discretisation/spacetime/estimate.hpp"
#include "spacetime_deck.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

TEST(SpacetimeBodyMesh, Bar) {
  const FromDeck<1> b(bar_of_two + "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n*LOAD_SEGMENT\n9,3.0,0,3\n");
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_EQ(dimension_of(b.model), 1);
  EXPECT_EQ(b.body->mesh.simplex_count(), 2);
  EXPECT_EQ(b.body->thickness, 0.5);
  EXPECT_NEAR(b.body->problem.materials[0].fastest, std::sqrt(1.25), 1e-14);  // sqrt(E / rho)
  EXPECT_NEAR(b.star(b.face({1}), 0.5, {0.3}, {0.2}).v_minus[0], 0.0, 1e-15);
  EXPECT_NEAR(b.star(b.face({3}), 0.5).s[0], -1.5, 1e-14);  // a pressure pushes
}

TEST(SpacetimeBodyMesh, Tetrahedron) {
  const FromDeck<3> b(tetrahedron +
                      "*LOAD_SEGMENT\n9,2.0,0,1,3,2,2\n*SET_NODE\n1\n1,2,4\n*BOUNDARY_SPC_SET\n1,0,0,1\n");
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_EQ(b.body->mesh.simplex_count(), 1);
  EXPECT_NEAR(b.body->mesh.volume(), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(b.body->problem.materials[0].fastest, std::sqrt(1.5), 1e-12);
  const Star<3> loaded = b.star(b.face({1, 2, 3}), 0.5);  // outward is -z: the pressure pushes along +z
  EXPECT_NEAR(loaded.s[2], 1.0, 1e-14);
  EXPECT_NEAR(loaded.s[0], 0.0, 1e-15);
  const Star<3> held = b.star(b.face({1, 2, 4}), 0.5, {0.1, 0.2, 0.3}, {0.0, 0.0, 0.0});
  EXPECT_NEAR(held.v_minus[1], 0.0, 1e-15);
  EXPECT_NEAR(held.v_minus[2], 0.3, 1e-15);
}

TEST(SpacetimeBodyMesh, CracksHaveTwoFaces) {
  // From the middle of the lower edge (node 2) to the centre (node 5); pressure on the face whose body lies
  // to the left when going up.
  const FromDeck<2> b(plate(2) +
                      "*BOUNDARY_PRECRACK\n1,1,2\n0.5,0,0\n0.5,0.5,0\n*LOAD_SEGMENT\n9,4.0,0,2,5\n");
  ASSERT_TRUE(b.body) << b.text();
  const SpaceMesh<2>& mesh = b.body->mesh;
  EXPECT_EQ(mesh.boundary().size(), 10u);
  EXPECT_EQ(mesh.vertex_count(), 10);  // node 2 is doubled, the tip is not
  EXPECT_EQ(b.body->node_of_vertex.back(), 1);
  int opened = 0;
  for (const BoundaryFace<2>& face : mesh.boundary()) {
    if (face.crack < 0) continue;
    ++opened;
    const BoundaryFace<2>& twin = mesh.boundary()[static_cast<std::size_t>(face.twin)];
    EXPECT_NEAR(face.normal[0], -twin.normal[0], 1e-15);
    const auto at = static_cast<int>(&face - mesh.boundary().data());
    EXPECT_NEAR(b.star(at, 0.5).s[0], face.normal[0] > 0.0 ? -2.0 : 0.0, 1e-14);
  }
  EXPECT_EQ(opened, 2);
}

TEST(SpacetimeBodyMesh, CracksMustFollowEdges) {
  const auto crack = [](const std::string& points) {
    return FromDeck<2>(plate(2) + "*BOUNDARY_PRECRACK\n1,1,2\n" + points);
  };
  EXPECT_TRUE(crack("0.3,0,0\n0.3,0.5,0\n").refuses(after_plate(2) + 1, "crack segment 1 from (0.3, 0)"));
  EXPECT_TRUE(crack("0.5,0,0\n0.5,0.4,0\n").refuses(after_plate(2) + 1, "crack segment 1"));
  EXPECT_TRUE(FromDeck<1>(bar_of_two + "*BOUNDARY_PRECRACK\n1,1,1\n0.4,0,0\n")
                  .refuses(after_bar + 1, "no node lies at x"));
}

TEST(SpacetimeBodyMesh, SilentFacesTakeWhatComes) {
  const FromDeck<2> b(square + "*SET_SEGMENT\n4\n2,3\n*BOUNDARY_NON_REFLECTING\n4\n");
  ASSERT_TRUE(b.body) << b.text();
  // A wave that leaves at normal incidence: s = -Z v, Z = rho c_p = sqrt(6).
  const Star<2> star = b.star(b.face({2, 3}), 0.3, {0.5, 0.0}, {-0.5 * std::sqrt(6.0), 0.0});
  EXPECT_NEAR(star.v_minus[0], 0.5, 1e-14);
  EXPECT_NEAR(star.s[0], -0.5 * std::sqrt(6.0), 1e-14);
  EXPECT_TRUE(
      FromDeck<2>(square + "*SET_SEGMENT\n4\n2,3\n*BOUNDARY_NON_REFLECTING\n4\n*LOAD_SEGMENT\n9,1,0,2,3\n")
          .refuses(after_square + 4, "is to be silent and is held or loaded as well"));
  EXPECT_TRUE(FromDeck<2>(square + "*SET_SEGMENT\n4\n2,3\n*BOUNDARY_NON_REFLECTING\n4,1.0\n")
                  .refuses(after_square + 4, "absorbs one kind of wave only"));
}

TEST(SpacetimeBodyMesh, BodyForceAndInitialVelocity) {
  const FromDeck<2> b(
      square + "*LOAD_BODY_Y\n9,3.0\n*LOAD_BODY_RZ\n9,2.0,0,0.5,0.5,0\n*INITIAL_VELOCITY_NODE\n5,3.0,1.0\n");
  ASSERT_TRUE(b.body) << b.text();
  // Base acceleration 3 t along y, and a spin of 2 t about z through the centre.
  const Vector<2> f = b.body->problem.body_force({0.75, 0.5, 0.5});
  EXPECT_NEAR(f[0], 0.25 * 1.0, 1e-14);
  EXPECT_NEAR(f[1], -1.5, 1e-14);
  // A spin of 3 at t = 1.5: r times its square.
  EXPECT_NEAR(b.body->problem.body_force({0.75, 0.5, 1.5})[0], 0.25 * 9.0, 1e-14);
  const Vector<2> v = b.body->problem.initial(0, {0.5, 0.25, 0.0}).v;  // half-way from the edge to node 5
  EXPECT_NEAR(v[0], 1.5, 1e-14);
  EXPECT_NEAR(v[1], 0.5, 1e-14);
  EXPECT_TRUE(FromDeck<2>(square + "*LOAD_BODY_Z\n9,1.0\n").refuses(after_square + 1, "out of the plane"));
  EXPECT_NE(FromDeck<2>(square + "*INITIAL_VELOCITY_NODE\n5,0,0,1.0\n").text().find("out of the plane"),
            std::string::npos);
}

TEST(SpacetimeBodyMesh, SupportsInLocalFrames) {
  const FromDeck<2> b(
      square + "*DEFINE_COORDINATE_VECTOR\n7,1,1,0,-1,1,0\n*SET_NODE\n1\n1,2\n*BOUNDARY_SPC_SET\n1,7,1\n");
  ASSERT_TRUE(b.body) << b.text();
  const Star<2> star = b.star(b.face({1, 2}), 0.3, {0.5, 0.25}, {0.4, 0.1});
  EXPECT_NEAR(star.v_minus[0] + star.v_minus[1], 0.0, 1e-14);  // held along (1, 1)
  EXPECT_NEAR(star.s[1] - star.s[0], 0.0, 1e-14);              // free across
}

TEST(SpacetimeBodyMesh, FaultsOfTheMesh) {
  // Node 7 in the middle of the lower edge 1-2 of the square, a corner of an element below.
  const auto below = [](const std::string& nodes, const std::string& elements) {
    return FromDeck<2>(square_with("5,0.5,0.5,0\n", "5,0.5,0.5,0\n" + nodes) + "*ELEMENT_SHELL\n" + elements);
  };
  const FromDeck<2> hanging = below("6,0.25,-1,0\n7,0.5,0,0\n", "15,1,1,6,7,7\n");
  EXPECT_FALSE(hanging.body);
  EXPECT_TRUE(hanging.refuses(18, "vertex 7 hangs on a face of element 11 at (0.5, 0)")) << hanging.text();
  // A T-junction: two elements below meet the middle of one edge above.
  const FromDeck<2> junction = below("6,0.5,-1,0\n7,0.5,0,0\n", "15,1,1,6,7,7\n16,1,6,2,7,7\n");
  EXPECT_TRUE(junction.refuses(18, "vertex 7 hangs on a face of element 11")) << junction.text();
  const FromDeck<2> inside = below("6,0.4,-1,0\n7,0.5,0.1,0\n8,0.6,-1,0\n", "15,1,6,8,7,7\n");
  EXPECT_TRUE(inside.refuses(18, "vertex 7 lies inside element 11")) << inside.text();
  EXPECT_NE(inside.text().find("18:1 NODE NID"), std::string::npos) << inside.text();
  const FromDeck<2> across = below("6,-0.5,0.2,0\n7,1.5,0.2,0\n8,1.5,0.3,0\n", "15,1,6,7,8,8\n");
  EXPECT_TRUE(across.refuses(12, "boundary faces at vertices 1 and 6 cross")) << across.text();
  // Two elements more around node 5 than there is room for.
  const FromDeck<2> folded = below("6,0.2,0.6,0\n7,0.3,0.7,0\n", "15,1,5,7,6,6\n");
  EXPECT_TRUE(folded.refuses(17, "vertex 6 lies inside element 14")) << folded.text();
  const FromDeck<2> twice = below("", "15,1,1,2,5,5\n");
  EXPECT_TRUE(twice.refuses(18, "elements 11 and 15")) << twice.text();
  const FromDeck<2> seam = below("6,0,-1,0\n7,1,0,0\n8,0,0,0\n", "15,1,8,6,7,7\n");
  EXPECT_TRUE(seam.refuses(12, "lie at the same place")) << seam.text();
}

TEST(SpacetimeBodyMesh, FlatTetrahedraAreShownByTheirRow) {
  std::string text = tetrahedron;
  text.replace(text.find("4,0,0,1\n"), 8, "4,0.3,0.3,0\n");
  const FromDeck<3> flat(text);
  EXPECT_FALSE(flat.body);
  EXPECT_NE(flat.text().find("17:1 ELEMENT_SOLID EID"), std::string::npos) << flat.text();
}

TEST(SpacetimeBodyMesh, EstimateOfTents) {
  // A bar of two elements of length 1/2, waves of speed sqrt(1.25): tents rise 0.95 of what a wave needs,
  // less the share of the progress constraint in two dimensions only.
  const FromDeck<1> bar(bar_of_two);
  const TentEstimate a = estimate_tents(bar.model);
  EXPECT_NEAR(a.lowest, 0.95 * 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(a.lowest, a.highest);
  EXPECT_NEAR(a.patches, 0.7 * 3 * bar.model.control.end.time / a.lowest, 1e-9);
  // A node close to an edge: the lowest tent stands on one of the corners of the flattest triangle.
  const FromDeck<2> b(square_with("5,0.5,0.5,0", "5,0.5,0.1,0"));
  const TentEstimate tents = estimate_tents(b.model);
  EXPECT_EQ(tents.lowest_at, 5);
  EXPECT_EQ(tents.position[1], 0.1);
  EXPECT_LT(tents.lowest, 0.1);
  EXPECT_GT(tents.lowest, 0.02);
  EXPECT_EQ(estimate_tents({}).lowest, 0.0);
}

TEST(SpacetimeBodyMesh, DensityAndModulusMustBePositive) {
  for (const auto* bad : {"1,0.0,2.5,0.25", "1,-2.0,2.5,0.25"})
    EXPECT_TRUE(FromDeck<2>(square_with("1,2.0,2.5,0.25", bad)).refuses(5, "above 0")) << bad;
  for (const auto* bad : {"1,2.0,0.0,0.25", "1,2.0,-1.0,0.25"})
    EXPECT_TRUE(FromDeck<2>(square_with("1,2.0,2.5,0.25", bad)).diagnostics.failed()) << bad;
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
