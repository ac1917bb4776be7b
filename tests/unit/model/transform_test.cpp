/// *INCLUDE_TRANSFORM and *DEFINE_TRANSFORMATION: ids offset, geometry scaled and moved, what is refused.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

/// Writes files into a folder of their own and builds main.k.
class Transform : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("cleave_transform_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void file(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  Built build_main() {
    Built b;
    const deck::Deck deck = deck::Deck::read(folder_ / "main.k", {}, b.diagnostics);
    b.model = build(deck, {}, b.diagnostics, b.account);
    return b;
  }
  std::filesystem::path folder_;
};

const std::string mesh =
    "*KEYWORD\n" + cube.substr(cube.find("*NODE")) + "*SET_NODE\n1\n1,2\n*BOUNDARY_SPC_SET\n1,0,1\n";
const std::string frame = cube.substr(0, cube.find("*PART")) +
                          "*PART\n\n1,1,1\n*PART\n\n11,1,1\n*INCLUDE\nmesh.k\n*INCLUDE_TRANSFORM\nmesh.k\n";

TEST_F(Transform, OffsetsAndScaledMovedGeometry) {
  file("mesh.k", mesh);
  // Offsets: nodes 100, elements 200, parts 10, sets 50. Length factor 2, then a quarter turn about z and a
  // shift.
  file("main.k", frame +
                     "100,200,10,0,50,0,0\n0\n1,1,2\n7\n"
                     "*DEFINE_TRANSFORMATION\n7\nROTATE,0,0,1,0,0,0,90\nTRANSL,0,0,5\n");
  const Built b = build_main();
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.mesh.nodes.count(), 16u);
  EXPECT_EQ(b.model.mesh.nodes.id[8], 101);
  EXPECT_EQ(b.model.mesh.solids[0].id, (std::vector<Id>{1, 201}));
  EXPECT_EQ(b.model.parts[b.model.mesh.solids[0].part[1]].id, 11);
  EXPECT_EQ(b.model.node_sets[1].id, 51);
  EXPECT_EQ(b.model.node_sets[1].members, (std::vector<Index>{8, 9}));
  ASSERT_EQ(b.model.fixed.size(), 2u);
  EXPECT_EQ(b.model.fixed[1].nodes, (std::vector<Index>{8, 9}));
  // Node 2 at (1, 0, 0): times 2, turned to (0, 2, 0), shifted to (0, 2, 5).
  const double* p = b.model.mesh.nodes.position.data() + 3 * 9;
  EXPECT_NEAR(p[0], 0.0, 1e-15);
  EXPECT_NEAR(p[1], 2.0, 1e-15);
  EXPECT_NEAR(p[2], 5.0, 1e-15);
}

TEST_F(Transform, FactorsScaleFieldsOfKnownDimensionAndRefuseTheRest) {
  file("mesh.k", mesh + "*INITIAL_VELOCITY\n1\n3,0,0\n*ELEMENT_MASS\n1,1,0.5\n");
  // From kg, m, s to tonne, mm, s.
  file("main.k", frame + "100,200,10,0,50,30,0\n0\n0.001,1,1000\n0\n");
  const Built b = build_main();
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.mesh.nodes.position[3 * 9], 1000.0);
  EXPECT_EQ(b.model.initial_velocity[3 * 8], 3000.0);
  EXPECT_EQ(b.model.point_masses[1].mass, 0.0005);

  file("mesh.k", mesh + "*DEFINE_CURVE\n1\n0,0\n1,1\n");
  EXPECT_NE(build_main().text().find("a curve inside a file with unit factors"), std::string::npos);
}

TEST_F(Transform, MissingDefinitionIsNamed) {
  file("mesh.k", mesh);
  file("main.k", frame + "100,200,10,0,50,0,0\n0\n1,1,1\n8\n");
  EXPECT_NE(build_main().text().find("transformation 8 is not defined"), std::string::npos);
}

}  // namespace
}  // namespace cleave::model
