#pragma once
/// A run by hand for the tests of this room: two bricks in a row along x, two parts, a block of known values.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "results/recorder.hpp"

namespace cleave::results::test {

/// Elements whose stress is (id, 2 id, 3 id, 0, 0, 0) times `state.element[0]`, with mass 8 each.
class KnownBlock final : public discretisation::Block {
 public:
  KnownBlock(model::Index part, model::Shape shape, std::vector<model::Id> ids,
             std::vector<model::Index> nodes)
      : part_(part), shape_(shape), ids_(std::move(ids)), nodes_(std::move(nodes)) {}

  model::Index part() const override { return part_; }
  model::Shape shape() const override { return shape_; }
  std::string_view formulation() const override { return "known values"; }
  int points_per_element() const override { return 1; }
  std::span<const model::Id> element_ids() const override { return ids_; }
  std::span<const model::Index> connectivity() const override { return nodes_; }
  discretisation::StepStatus initialise(const base::Array<double>&,
                                        discretisation::BlockState& state) const override {
    state.alive.assign(8 * ((ids_.size() + 7) / 8), 1.0);
    state.element.assign(1, 1.0);
    return {};
  }
  void add_mass(const discretisation::BlockState& state, std::span<double> mass) const override {
    add_scaled_mass(state, std::vector<double>(ids_.size(), 1.0), mass);
  }
  void add_scaled_mass(const discretisation::BlockState&, std::span<const double> factor,
                       std::span<double> mass) const override {
    const std::size_t count = static_cast<std::size_t>(model::nodes_of(shape_));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      mass[static_cast<std::size_t>(nodes_[i])] += factor[i / count] * 8.0 / static_cast<double>(count);
  }
  discretisation::StepOutput add_force(const discretisation::StepInput&, discretisation::BlockState&,
                                       discretisation::ForceSum&) const override {
    return {};
  }
  void stable_steps(const base::Array<double>&, const discretisation::BlockState&,
                    std::span<double>) const override {}
  std::vector<discretisation::ElementField> fields() const override {
    return {{"stress", 6}, {"effective_plastic_strain", 1}, {"back_stress", 6}};
  }
  void evaluate(std::string_view field, const base::Array<double>&, const discretisation::BlockState& state,
                std::span<const std::size_t> elements, std::span<double> out) const override {
    const std::size_t count = elements.empty() ? ids_.size() : elements.size();
    for (std::size_t e = 0; e < count; ++e) {
      const double scale = static_cast<double>(ids_[elements.empty() ? e : elements[e]]) * state.element[0];
      if (field == "effective_plastic_strain") {
        out[e] = 0.001 * scale;
        continue;
      }
      for (std::size_t k = 0; k < 6; ++k)
        out[6 * e + k] = field == "stress" && k < 3 ? scale * static_cast<double>(k + 1) : 0.0;
    }
  }
  void alive(const discretisation::BlockState& state, std::span<bool> out) const override {
    for (std::size_t e = 0; e < out.size(); ++e) out[e] = state.alive[e] != 0.0;
  }
  double bytes_per_element() const override { return 100.0; }

 private:
  model::Index part_;
  model::Shape shape_;
  std::vector<model::Id> ids_;
  std::vector<model::Index> nodes_;
};

/// Two unit bricks, ids 1 and 2, of parts 10 and 20; nodes 101..112; the left face is held along x.
struct SmallRun {
  model::Model model;
  discretisation::World world;
  discretisation::State state;
  std::vector<double> acceleration, velocity, reaction;
  std::vector<solver::WallForce> walls;
  std::vector<model::Id> eroded;
  solver::Wishes wishes;
  std::filesystem::path directory;

  explicit SmallRun(const std::string& name) {
    directory =
        std::filesystem::temp_directory_path() / ("cleave_results_" + name + std::to_string(::getpid()));
    std::filesystem::remove_all(directory);
    model.title = "two bricks";
    for (int i = 0; i < 3; ++i)
      for (const auto& yz : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        model.mesh.nodes.id.push_back(101 + static_cast<model::Id>(model.mesh.nodes.id.size()));
        model.mesh.nodes.position.insert(model.mesh.nodes.position.end(),
                                         {static_cast<double>(i), yz.first, yz.second});
      }
    const std::vector<model::Index> left = {0, 1, 2, 3, 4, 5, 6, 7}, right = {4, 5, 6, 7, 8, 9, 10, 11};
    model.mesh.solids = {{model::Shape::hex8, {1, 2}, {0, 1}, left}};
    model.mesh.solids[0].node.insert(model.mesh.solids[0].node.end(), right.begin(), right.end());
    model.parts.resize(2);
    model.parts[0].id = 10;
    model.parts[0].title = "left";
    model.parts[1].id = 20;
    model.parts[1].title = "right";
    model.fixed.resize(1);
    model.fixed[0].nodes = {0, 1, 2, 3};
    model.fixed[0].directions = 1;
    model.control.end.time = 1.0;
    world.model = &model;
    world.blocks.push_back(
        std::make_unique<KnownBlock>(0, model::Shape::hex8, std::vector<model::Id>{1}, left));
    world.blocks.push_back(
        std::make_unique<KnownBlock>(1, model::Shape::hex8, std::vector<model::Id>{2}, right));
    state.position.assign(model.mesh.nodes.position.begin(), model.mesh.nodes.position.end());
    state.velocity.assign(36, 0.0);
    state.mass.assign(12, 0.0);
    state.blocks.resize(2);
    state.parts.resize(2);
    for (std::size_t b = 0; b < 2; ++b) {
      world.blocks[b]->initialise(state.position, state.blocks[b]);
      world.blocks[b]->add_mass(state.blocks[b], state.mass);
    }
    acceleration.assign(36, 0.0);
    velocity.assign(36, 0.0);
    reaction.assign(36, 0.0);
    state.next_step = 0.01;
    state.energy.initial = 50.0;
    update();
  }
  ~SmallRun() { std::filesystem::remove_all(directory); }

  /// Everything a smooth function of the cycle, so that a run can go on from any cycle.
  void update() {
    state.time = 0.01 * static_cast<double>(state.cycle);
    state.step = state.cycle > 0 ? 0.01 : 0.0;
    for (std::size_t a = 0; a < 12; ++a) {
      state.position[3 * a] = model.mesh.nodes.position[3 * a] * (1.0 + 0.1 * state.time);
      velocity[3 * a] = 0.1 * model.mesh.nodes.position[3 * a];
      acceleration[3 * a + 1] = state.time;
      reaction[3 * a] = a < 4 ? -1.5 * state.time : 7.0;
      reaction[3 * a + 1] = 3.0;
    }
    for (auto& block : state.blocks) block.element[0] = 1.0 + state.time;
    state.energy.kinetic = 50.0 - 20.0 * state.time;
    state.energy.internal = 20.0 * state.time;
    state.parts[0].internal = 5.0 * state.time;
    state.parts[1].internal = 15.0 * state.time;
  }
  solver::Frame frame() const {
    return {model, world, state, acceleration, {velocity, acceleration, 0.0}, reaction, walls, 2, eroded};
  }
  Options options() {
    Options options;
    options.directory = directory;
    options.version = "0.1.0";
    options.deck = "bricks.k";
    options.progress = false;
    options.wishes = &wishes;
    return options;
  }
  /// Steps up to `last` cycle; ends the run there if wanted.
  void run(Recorder& recorder, std::int64_t last, bool end = true) {
    recorder.begin(frame());
    while (state.cycle < last && !wishes.stop) {
      ++state.cycle;
      update();
      recorder.after_step(frame());
    }
    if (end) recorder.finish(frame(), solver::Ending::end_time, {});
  }
  std::string text(const std::string& name) const {
    std::ifstream file(directory / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::vector<std::string> lines(const std::string& name) const {
    std::ifstream file(directory / name);
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  }
};

inline std::vector<std::string> split(const std::string& line, char separator = ',') {
  std::vector<std::string> words(1);
  for (const char c : line)
    if (c == separator)
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

}  // namespace cleave::results::test
