#include "results/picture_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "picture_meshes.hpp"
#include "results/report_vtu.hpp"
#include "results/vtu.hpp"

namespace cleave::results {
namespace {

namespace fs = std::filesystem;
using discretisation::BlockState;
using Positions = base::Array<double>;

/// Two cubes whose plastic strain is 0.5 and 1.5; `alive` of the state says which is left. It does no
/// mechanics.
class TwoCubes final : public discretisation::Block {
 public:
  explicit TwoCubes(bool plastic) : plastic_(plastic) {}
  model::Index part() const override { return 0; }
  model::Shape shape() const override { return model::Shape::hex8; }
  std::string_view formulation() const override { return "two cubes"; }
  int points_per_element() const override { return 1; }
  std::span<const model::Id> element_ids() const override { return ids_; }
  std::span<const model::Index> connectivity() const override { return mesh_.node; }
  discretisation::StepStatus initialise(const Positions&, BlockState&) const override { return {}; }
  void add_mass(const BlockState&, std::span<double>) const override {}
  void add_scaled_mass(const BlockState&, std::span<const double>, std::span<double>) const override {}
  discretisation::StepOutput add_force(const discretisation::StepInput&, BlockState&,
                                       discretisation::ForceSum&) const override {
    return {};
  }
  void stable_steps(const Positions&, const BlockState&, std::span<double>) const override {}
  std::vector<discretisation::ElementField> fields() const override {
    if (!plastic_) return {};
    return {{"effective_plastic_strain", 1}};
  }
  void evaluate(std::string_view, const Positions&, const BlockState&, std::span<const std::size_t>,
                std::span<double> out) const override {
    out[0] = 0.5;
    out[1] = 1.5;
  }
  void alive(const BlockState& state, std::span<bool> out) const override {
    for (std::size_t e = 0; e < out.size(); ++e) out[e] = state.alive[e] != 0.0;
  }
  double bytes_per_element() const override { return 0.0; }

 private:
  bool plastic_;
  test::TestMesh mesh_ = test::cubes(2, 1, 1);
  std::vector<model::Id> ids_ = {71, 72};
};

class PictureWriterTest : public testing::Test {
 protected:
  PictureWriterTest() : run(fs::temp_directory_path() / ("cleave_writer_" + std::to_string(::getpid()))) {
    fs::create_directories(run);
    const auto mesh = test::cubes(2, 1, 1);
    model.title = "two cubes";
    model.mesh.nodes.position = mesh.position;
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
      model.mesh.nodes.id.push_back(static_cast<model::Id>(n + 1));
    model.parts.resize(1);
    model.parts[0].id = 3;
    world.model = &model;
    state.position.assign(mesh.position.begin(), mesh.position.end());
    state.position[2] += 0.25;
    state.blocks.resize(1);
    state.blocks[0].alive.assign(8, 1.0);
    zeros.assign(mesh.position.size(), 0.0);
  }
  ~PictureWriterTest() override { fs::remove_all(run); }

  void make_world(bool plastic) { world.blocks.push_back(std::make_unique<TwoCubes>(plastic)); }
  solver::Frame frame() const { return {model, world, state, zeros, {zeros, zeros, 0.0}, zeros, {}, 0, {}}; }

  fs::path run;
  model::Model model;
  discretisation::World world;
  discretisation::State state;
  std::vector<double> zeros;
};

TEST_F(PictureWriterTest, LeavesThePicturesThatAreWanted) {
  make_world(true);
  PictureWriter last_only(run);
  last_only.begin(frame());
  EXPECT_FALSE(fs::exists(run / "initial.png"));
  last_only.finish(frame(), solver::Ending::end_time, {});
  EXPECT_EQ(last_only.problem(), "");
  EXPECT_GT(fs::file_size(run / "picture.png"), 10000u);

  PictureWriter both(run, {.initial = true});
  both.begin(frame());
  EXPECT_TRUE(fs::exists(run / "initial.png"));
}

TEST_F(PictureWriterTest, ShowsDisplacementWhereThereIsNoPlasticStrain) {
  make_world(false);
  PictureWriter writer(run);
  writer.finish(frame(), solver::Ending::end_time, {});
  EXPECT_EQ(writer.problem(), "");
  EXPECT_TRUE(fs::exists(run / "picture.png"));
}

TEST_F(PictureWriterTest, ProblemIsKeptAndTheRunGoesOn) {
  make_world(true);
  std::fill(state.blocks[0].alive.begin(), state.blocks[0].alive.end(), 0.0);
  PictureWriter nothing_left(run);
  nothing_left.finish(frame(), solver::Ending::end_time, {});
  EXPECT_NE(nothing_left.problem().find("no active solid"), std::string::npos);
}

TEST_F(PictureWriterTest, PageReadsTheFieldFilesOfARun) {
  make_world(true);
  state.blocks[0].alive[0] = 0.0;  // only the second cube is left
  ASSERT_EQ(write_vtu(run / "a.vtu", frame(), false), "");
  VtuFrame read;
  ASSERT_EQ(read_vtu(run / "a.vtu", read), "");
  ASSERT_EQ(read.groups.size(), 1u);
  EXPECT_EQ(read.groups[0].node.size(), 8u);
  EXPECT_EQ(read.position.size(), 24u);
  EXPECT_EQ(read.element_id, (std::vector<double>{72.0}));
  const auto strain = std::find_if(read.fields.begin(), read.fields.end(),
                                   [](const auto& f) { return f.name == "effective_plastic_strain"; });
  ASSERT_NE(strain, read.fields.end());
  EXPECT_EQ(strain->value, (std::vector<float>{1.5f}));
}

}  // namespace
}  // namespace cleave::results
