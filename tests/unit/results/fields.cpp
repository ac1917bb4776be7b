#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "results/vtu.hpp"
#include "small_run.hpp"

namespace cleave::results::test {
namespace {

/// The parts of a .vtu that a reader needs: counts, and each array's type, width and bytes.
struct Vtu {
  std::size_t points = 0, cells = 0;
  struct Array {
    std::string type;
    std::size_t components = 1;
    std::string bytes;
  };
  std::map<std::string, Array> arrays;

  explicit Vtu(const std::string& text) {
    const auto attribute = [](const std::string& tag, const std::string& name) {
      const auto at = tag.find(name + "=\"");
      if (at == std::string::npos) return std::string();
      const auto from = at + name.size() + 2;
      return tag.substr(from, tag.find('"', from) - from);
    };
    const auto data = text.find("<AppendedData encoding=\"raw\">\n_") + 31;
    for (auto at = text.find('<'); at < data - 2; at = text.find('<', at + 1)) {
      const std::string tag = text.substr(at, text.find('>', at) - at);
      if (tag.starts_with("<Piece")) {
        points = std::stoul(attribute(tag, "NumberOfPoints"));
        cells = std::stoul(attribute(tag, "NumberOfCells"));
      }
      if (attribute(tag, "format") != "appended") continue;
      const auto from = data + std::stoul(attribute(tag, "offset"));
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, text.data() + from, 8);
      arrays[attribute(tag, "Name")] = {attribute(tag, "type"),
                                        std::stoul(attribute(tag, "NumberOfComponents")),
                                        text.substr(from + 8, bytes)};
      end = from + 8 + bytes;
    }
    closed = text.substr(end) == "\n</AppendedData>\n</VTKFile>\n";
  }
  template <class Value>
  std::vector<Value> values(const std::string& name) const {
    const std::string& bytes = arrays.at(name).bytes;
    std::vector<Value> all(bytes.size() / sizeof(Value));
    std::memcpy(all.data(), bytes.data(), bytes.size());
    return all;
  }
  std::size_t end = 0;
  bool closed = false;  ///< the last array ends where the closing tags begin
};

TEST(Vtu, HoldsWhatTheStateHolds) {
  SmallRun run("vtu");
  run.state.cycle = 50;
  run.update();
  std::filesystem::create_directories(run.directory);
  ASSERT_EQ(write_vtu(run.directory / "one.vtu", run.frame(), true), "");
  const Vtu vtu(run.text("one.vtu"));
  EXPECT_TRUE(vtu.closed);
  EXPECT_EQ(vtu.points, 12u);
  EXPECT_EQ(vtu.cells, 2u);
  EXPECT_EQ(vtu.values<std::int64_t>("part_id"), (std::vector<std::int64_t>{10, 20}));
  EXPECT_EQ(vtu.values<std::int64_t>("element_id"), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(vtu.values<std::int32_t>("offsets"), (std::vector<std::int32_t>{8, 16}));
  EXPECT_EQ(vtu.values<std::uint8_t>("types"), (std::vector<std::uint8_t>{12, 12}));
  EXPECT_EQ(vtu.values<std::int64_t>("node_id").front(), 101);
  // Scale 1.5 at t = 0.5: stress (1.5, 3, 4.5) id, so pressure is -3 id and von Mises stress 1.5 sqrt(3) id.
  EXPECT_EQ(vtu.arrays.at("stress").components, 6u);
  EXPECT_EQ(vtu.values<double>("stress")[6 + 2], 9.0);
  EXPECT_EQ(vtu.values<double>("pressure"), (std::vector<double>{-3.0, -6.0}));
  EXPECT_NEAR(vtu.values<double>("von_mises")[1], 2 * 1.5 * std::sqrt(3.0), 1e-14);
  EXPECT_EQ(vtu.values<double>("effective_plastic_strain")[0], 0.001 * 1.5);
  EXPECT_EQ(vtu.arrays.at("back_stress").components, 6u);
  const auto displacement = vtu.values<double>("displacement"), points = vtu.values<double>("Points");
  EXPECT_NEAR(displacement[3 * 8], 2.0 * 0.05, 1e-15);
  EXPECT_EQ(points[3 * 8], run.state.position[3 * 8]);
  EXPECT_EQ(vtu.values<double>("velocity")[3 * 8], 0.2);
  EXPECT_EQ(vtu.values<double>("acceleration")[1], 0.5);
}

TEST(Vtu, LeavesOutDeletedElementsAndTheirNodes) {
  SmallRun run("vtu_eroded");
  run.state.blocks[0].alive[0] = 0.0;
  std::filesystem::create_directories(run.directory);
  ASSERT_EQ(write_vtu(run.directory / "one.vtu", run.frame(), false), "");
  const Vtu vtu(run.text("one.vtu"));
  EXPECT_TRUE(vtu.closed);
  EXPECT_EQ(vtu.points, 8u);
  EXPECT_EQ(vtu.values<std::int64_t>("element_id"), (std::vector<std::int64_t>{2}));
  EXPECT_EQ(vtu.values<std::int32_t>("connectivity"), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(vtu.values<std::int64_t>("node_id").front(), 105);
  EXPECT_EQ(vtu.arrays.at("stress").type, "Float32");
  EXPECT_EQ(vtu.values<float>("stress")[1], 4.0f);
}

TEST(Vtu, TurnsWedgesTheWayVtkHasThemAndDrawsPyramids) {
  SmallRun run("vtu_wedge");
  run.world.blocks.clear();
  run.world.blocks.push_back(std::make_unique<KnownBlock>(0, model::Shape::penta6, std::vector<model::Id>{7},
                                                          std::vector<model::Index>{0, 1, 2, 4, 5, 6}));
  run.world.blocks.push_back(std::make_unique<KnownBlock>(1, model::Shape::hex8, std::vector<model::Id>{8},
                                                          std::vector<model::Index>{4, 5, 6, 7, 8, 8, 8, 8}));
  std::filesystem::create_directories(run.directory);
  ASSERT_EQ(write_vtu(run.directory / "one.vtu", run.frame(), false), "");
  const Vtu vtu(run.text("one.vtu"));
  EXPECT_EQ(vtu.values<std::uint8_t>("types"), (std::vector<std::uint8_t>{13, 14}));
  EXPECT_EQ(vtu.values<std::int32_t>("connectivity"),
            (std::vector<std::int32_t>{0, 2, 1, 3, 5, 4, /* pyramid */ 3, 4, 5, 6, 7}));
}

TEST(Fields, AreWrittenAtTheIntervalAndAtBothEnds) {
  SmallRun run("frames");
  run.model.requests.field.every = 0.25;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 60);
  const std::string list = run.text("result.pvd");
  for (const char* entry : {"timestep=\"0\" part=\"0\" file=\"result/result_0000.vtu\"",
                            "timestep=\"0.25\" part=\"0\" file=\"result/result_0001.vtu\"",
                            "timestep=\"0.5\" part=\"0\" file=\"result/result_0002.vtu\"",
                            "timestep=\"0.6\" part=\"0\" file=\"result/result_0003.vtu\""})
    EXPECT_NE(list.find(entry), std::string::npos) << entry;
  EXPECT_EQ(list.find("result_0004"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(run.directory / "result/result_0003.vtu"));
}

TEST(Fields, AnExtraFrameIsWrittenOnRequest) {
  SmallRun run("frames_sw4");
  Recorder recorder(run.model, run.options());
  recorder.begin(run.frame());
  run.wishes.field = true;
  run.state.cycle = 3;
  run.update();
  recorder.after_step(run.frame());
  EXPECT_FALSE(run.wishes.field);
  EXPECT_NE(run.text("result.pvd").find("timestep=\"0.03\""), std::string::npos);
}

}  // namespace
}  // namespace cleave::results::test
