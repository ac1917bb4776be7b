#include "results/picture_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "results/picture.hpp"
#include "results/surface_cells.hpp"

namespace cleave::results {
namespace {

using discretisation::Block;

bool has_field(const Block& block, const std::string& name) {
  const auto fields = block.fields();
  return std::any_of(fields.begin(), fields.end(),
                     [&](const auto& field) { return field.name == name && field.size == 1; });
}

/// Values of a scalar field, 0 in blocks that do not know it. [block][element]
std::vector<std::vector<float>> element_values(const solver::Frame& frame, const std::string& field) {
  std::vector<std::vector<float>> values;
  for (std::size_t b = 0; b < frame.world.blocks.size(); ++b) {
    const Block& block = *frame.world.blocks[b];
    std::vector<double> numbers(block.element_ids().size(), 0.0);
    if (has_field(block, field))
      block.evaluate(field, frame.state.position, frame.state.blocks[b], {}, numbers);
    values.emplace_back(numbers.begin(), numbers.end());
  }
  return values;
}

/// "effective plastic strain, at most 2.71 in element 1234": colours are averaged at nodes, this is not.
std::string name_with_largest(const solver::Frame& frame, std::string name,
                              const std::vector<std::vector<float>>& values,
                              const std::vector<std::vector<std::uint8_t>>& alive) {
  const float* largest = nullptr;
  discretisation::Id element = 0;
  for (std::size_t b = 0; b < values.size(); ++b)
    for (std::size_t e = 0; e < values[b].size(); ++e)
      if (alive[b][e] && std::isfinite(values[b][e]) && (!largest || values[b][e] > *largest)) {
        largest = &values[b][e];
        element = frame.world.blocks[b]->element_ids()[e];
      }
  std::replace(name.begin(), name.end(), '_', ' ');
  if (largest) name += ", at most " + number_text(*largest) + " in element " + std::to_string(element);
  return name;
}

std::string moment_of(const solver::Frame& frame) {
  char moment[80];
  std::snprintf(moment, sizeof moment, "t = %.4g,  cycle %lld", frame.state.time,
                static_cast<long long>(frame.state.cycle));
  return moment;
}

/// Length of each node's way from where it started. [node] [length]
std::vector<float> displacements(const solver::Frame& frame) {
  const std::vector<double>& start = frame.model.mesh.nodes.position;
  std::vector<float> lengths(start.size() / 3);
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    double square = 0.0;
    for (std::size_t i = 3 * n; i < 3 * n + 3; ++i)
      square += (frame.state.position[i] - start[i]) * (frame.state.position[i] - start[i]);
    lengths[n] = static_cast<float>(std::sqrt(square));
  }
  return lengths;
}

/// Walls that act now, where they stand.
std::vector<StandingWall> walls_of(const solver::Frame& frame) {
  std::vector<StandingWall> walls;
  for (std::size_t w = 0; w < frame.walls.size(); ++w) {
    const model::RigidWall& wall = frame.model.walls[w];
    if (frame.state.time < wall.birth || frame.state.time >= wall.death) continue;
    if (wall.nodes.empty()) continue;
    const double way = frame.walls[w].position;
    StandingWall standing{&wall, wall.geometric ? way * wall.motion_direction
                                                : (way - base::dot(wall.origin, wall.normal)) * wall.normal};
    const auto at = [&](model::Index node) {
      const double* x = &frame.state.position[3 * static_cast<std::size_t>(node)];
      return model::Vector{x[0], x[1], x[2]};
    };
    standing.low = standing.high = at(wall.nodes[0]);
    for (const model::Index node : wall.nodes) {
      const model::Vector x = at(node);
      model::Vector &low = standing.low, &high = standing.high;
      low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    walls.push_back(standing);
  }
  return walls;
}

}  // namespace

PictureWriter::PictureWriter(std::filesystem::path run_directory, PictureWriterOptions options)
    : directory_(std::move(run_directory)), options_(std::move(options)) {}

void PictureWriter::begin(const solver::Frame& frame) {
  if (options_.initial) write(frame, "initial.png");
}

void PictureWriter::after_step(const solver::Frame&) {}  // pictures are of the ends of a run only

void PictureWriter::finish(const solver::Frame& frame, solver::Ending, const discretisation::StepStatus&) {
  write(frame, "picture.png");
}

/// Cells with fields of their own: the length of the velocity, for waves are what they are about.
void PictureWriter::write_cells(const solver::Frame& frame, const char* name) {
  const solver::CellFields cells = frame.cells->cells();
  const CellSurface shown = surface_of(cells);
  const auto& velocity = *std::find_if(cells.fields.begin(), cells.fields.end(),
                                       [](const auto& field) { return field.name == "velocity"; });
  PictureModel picture{.cells = {}, .position = shown.position, .surface = &shown.surface};
  for (const std::uint32_t p : shown.point_of)
    picture.node_value.push_back(static_cast<float>(
        std::hypot(velocity.value[3 * p], velocity.value[3 * p + 1], velocity.value[3 * p + 2])));
  PictureOptions look;
  look.title = frame.model.title;
  look.field = "velocity";
  look.moment = moment_of(frame);
  look.edges = false;
  if (cells.dimension < 3) look.views = {{.eye = {0, 0, 1}, .up = {0, 1, 0}}};
  if (std::string wrong = write_picture(picture, look, directory_ / name); !wrong.empty()) problem_ = wrong;
}

void PictureWriter::write(const solver::Frame& frame, const char* name) {
  if (frame.cells) return write_cells(frame, name);
  const auto& blocks = frame.world.blocks;
  std::vector<std::vector<std::uint8_t>> alive;
  std::vector<SolidCells> cells;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t count = blocks[b]->element_ids().size();
    const auto flags = std::make_unique<bool[]>(count);
    blocks[b]->alive(frame.state.blocks[b], {flags.get(), count});
    alive.emplace_back(flags.get(), flags.get() + count);
    cells.push_back({blocks[b]->shape(), blocks[b]->connectivity(), alive.back()});
  }

  PictureModel picture{.cells = cells, .position = frame.state.position};
  PictureOptions look;
  if (std::any_of(blocks.begin(), blocks.end(),
                  [&](const auto& b) { return has_field(*b, options_.field); })) {
    picture.element_value = element_values(frame, options_.field);
    look.field = name_with_largest(frame, options_.field, picture.element_value, alive);
  } else {
    picture.node_value = displacements(frame);
    look.field = "displacement";
  }
  look.title = frame.model.title;
  look.moment = moment_of(frame);
  picture.walls = walls_of(frame);
  if (std::string wrong = write_picture(picture, look, directory_ / name); !wrong.empty()) problem_ = wrong;
}

}  // namespace cleave::results
