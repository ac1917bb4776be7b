/// *NODE and *ELEMENT_SOLID: order, repeats, shapes, mistakes with their place.

#include <gtest/gtest.h>

#include "deck_text.hpp"
#include "model/outer_faces.hpp"
#include "model/solid_geometry.hpp"
#include "model/solid_shape.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

TEST(Nodes, FindWithoutGapsWithFewAndWithMany) {
  for (const std::vector<Id>& ids :
       {std::vector<Id>{5, 6, 7}, std::vector<Id>{5, 7, 9, 10}, std::vector<Id>{1, 1000, 9'000'000'000}}) {
    Nodes nodes;
    nodes.id = ids;
    nodes.index();
    for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(nodes.find(ids[i]), static_cast<Index>(i));
    for (const Id absent : {Id(0), Id(4), Id(8), Id(11), Id(2000), Id(9'000'000'001)})
      EXPECT_EQ(nodes.find(absent), std::find(ids.begin(), ids.end(), absent) == ids.end() ? -1 : 0);
  }
  EXPECT_EQ(Nodes().find(1), -1);
}

TEST(Nodes, AreSortedAndRepeatsWithEqualCoordinatesMerge) {
  const Built b = build_text(cube + "*NODE\n1,0,0,0\n11,5,5,5\n10,4,4,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.mesh.nodes.id, (std::vector<Id>{1, 2, 3, 4, 5, 6, 7, 8, 10, 11}));
  EXPECT_EQ(b.model.mesh.nodes.position[3 * 8], 4.0);
}

TEST(Nodes, RepeatsWithOtherCoordinatesAreAnErrorAtTheSecondLine) {
  const Built b = build_text(cube + "*NODE\n1,0,0,0.5\n");
  EXPECT_TRUE(b.says(Severity::error, after_cube + 1, "node 1 is given twice")) << b.text();
}

TEST(Nodes, ConstraintCodesBecomeFixedNodes) {
  const Built b =
      build_text(cube +
                 "*NODE\n      11             0.0             0.0             5.0       4       7\n"
                 "      12             1.0             0.0             5.0       4       7\n"
                 "      13             1.0             1.0             5.0       3       0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.fixed.size(), 2u);
  // TC 3 is z; TC 4 is x and y, RC 7 all rotations.
  EXPECT_EQ(b.model.fixed[0].directions, 4u);
  EXPECT_EQ(b.model.fixed[1].directions, 3u | 7u << 3);
  EXPECT_EQ(b.model.fixed[1].nodes, (std::vector<Index>{8, 9}));
  EXPECT_TRUE(build_text(cube + "*NODE\n11,0,0,5,8,0\n").says(Severity::error, after_cube + 1, "0 to 7"));
}

TEST(Solids, ShapesByRepeatedNodes) {
  using Row = std::array<Id, 10>;
  const auto shape = [](Row row) { return classify(row); };
  EXPECT_EQ(shape({1, 2, 3, 4, 5, 6, 7, 8}).shape, Shape::hex8);
  const auto tet = shape({1, 2, 3, 4, 4, 4, 4, 4});
  EXPECT_EQ(tet.shape, Shape::tet4);
  EXPECT_EQ((std::vector<Id>(tet.node.begin(), tet.node.begin() + 4)), (std::vector<Id>{1, 2, 3, 4}));
  EXPECT_EQ(shape({1, 2, 3, 4}).shape, Shape::tet4);              // N5-N8 blank
  EXPECT_EQ(shape({1, 2, 3, 3, 4, 4, 4, 4}).shape, Shape::tet4);  // as some mesh programs write it
  EXPECT_EQ(shape({1, 2, 3, 4, 5, 5, 7, 7}).shape, Shape::penta6);
  EXPECT_EQ(shape({1, 2, 3, 3, 5, 6, 7, 7}).shape, Shape::penta6);
  EXPECT_EQ(shape({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}).shape, Shape::tet10);
  EXPECT_EQ(shape({1, 2, 3, 4, 5, 5, 5, 5}).shape, Shape::hex8);  // pyramid
  for (const Row& bad : {Row{1, 2, 3, 3, 3, 3, 3, 3}, Row{1, 1, 1, 1, 1, 1, 1, 1},
                         Row{1, 2, 3, 4, 5, 6, 1, 8}, Row{1, 2, 3, 4, 5, 6, 7, 8, 9, 9}, Row{}})
    EXPECT_FALSE(shape(bad).ok);
}

/// Whatever edges are collapsed, the unfolded wedge has the volume of the solid, not its negative.
TEST(Solids, WedgesUnfoldWithPositiveVolume) {
  const Corner corner[8] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::array<std::array<int, 4>, 4> pairs{{{4, 5, 6, 7}, {3, 2, 7, 6}, {0, 1, 3, 2}, {1, 0, 5, 4}}};
  for (const auto& p : pairs) {
    std::array<Id, 10> row{1, 2, 3, 4, 5, 6, 7, 8};
    row[p[1]] = row[p[0]];
    row[p[3]] = row[p[2]];
    const Classified c = classify(row);
    ASSERT_EQ(c.shape, Shape::penta6);
    std::vector<Corner> x;
    for (int a = 0; a < 6; ++a) x.push_back(corner[c.node[a] - 1]);
    EXPECT_NEAR(volume(Shape::penta6, x), 0.5, 1e-14);
    EXPECT_GT(centre_volume(Shape::penta6, x), 0.0);
  }
}

TEST(Solids, FacesPointOutwardsAndClose) {
  const std::vector<std::pair<Shape, std::vector<Corner>>> solids = {
      {Shape::hex8, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
      {Shape::penta6, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      {Shape::tet4, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (const auto& [shape, x] : solids) {
    // Divergence theorem: the flux of the position through the faces is three volumes.
    double flux = 0.0;
    Corner area{0, 0, 0};
    for (const auto& f : faces_of(shape))
      for (const auto& [a, b, c] : {std::array{f[0], f[1], f[2]}, std::array{f[0], f[2], f[3]}}) {
        const Corner n = 0.5 * cross(x[b] - x[a], x[c] - x[a]);
        flux += dot(n, (1.0 / 3.0) * (x[a] + x[b] + x[c]));
        area = area + n;
      }
    EXPECT_NEAR(flux, 3.0 * volume(shape, x), 1e-14) << name_of(shape);
    EXPECT_NEAR(dot(area, area), 0.0, 1e-28);
  }
}

TEST(Solids, OuterFacesLeaveOutSharedOnes) {
  const Built b = build_text(cube +
                             "*NODE\n9,0,0,2\n10,1,0,2\n11,1,1,2\n12,0,1,2\n"
                             "*ELEMENT_SOLID\n2,1,5,6,7,8,9,10,11,12\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(outer_faces(b.model.mesh, {}).size(), 10u);
}

TEST(Solids, MistakesHaveTheirPlace) {
  EXPECT_TRUE(build_text(cube + "*ELEMENT_SOLID\n2,1,1,2,3,4,5,6,7,88\n")
                  .says(Severity::error, after_cube + 1, "node 88"));
  EXPECT_TRUE(build_text(cube + "*ELEMENT_SOLID\n2,9,1,2,3,4,5,6,7,8\n")
                  .says(Severity::error, after_cube + 1, "part 9"));
  EXPECT_TRUE(build_text(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n")
                  .says(Severity::error, after_cube + 1, "second time"));
  EXPECT_TRUE(build_text(cube + "*ELEMENT_SOLID\n2,1,1,2,3,4,5,6,1,8\n")
                  .says(Severity::error, after_cube + 1, "make no solid"));
  const Built turned = build_text(cube + "*ELEMENT_SOLID\n2,1,4,3,2,1,8,7,6,5\n");
  EXPECT_TRUE(turned.says(Severity::error, after_cube + 1, "element 2 has volume 0 or less"))
      << turned.text();
}

TEST(Solids, OneAndTwoLineFormsMix) {
  const Built b = build_text(
      cube +
      "*ELEMENT_SOLID\n       2       1\n       1       2       3       4       5       6       7       8\n"
      "       3       1       1       2       3       5       5       5       5       5\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.mesh.solids.size(), 2u);
  EXPECT_EQ(b.model.mesh.solids[0].id, (std::vector<Id>{1, 2}));
  EXPECT_EQ(b.model.mesh.solids[1].shape, Shape::tet4);
  EXPECT_EQ(b.model.mesh.solids[1].node, (std::vector<Index>{0, 1, 2, 4}));
}

}  // namespace
}  // namespace cleave::model
