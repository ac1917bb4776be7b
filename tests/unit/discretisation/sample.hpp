#pragma once
/// Small models for the tests of this room: boxes of hexahedra with a law read from a line of deck.

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "deck/deck.hpp"
#include "discretisation/formulation.hpp"
#include "model/material/law.hpp"

namespace cleave::discretisation::sample {

using Point = base::Vec3<double>;

/// A law from its keyword block, e.g. "*MAT_ELASTIC\n1,1.0,200.0,0.3\n".
inline std::shared_ptr<const model::Law> law(const std::string& block) {
  static const std::vector<model::Curve> curves;
  static const std::vector<model::Table> tables;
  deck::Diagnostics diagnostics;
  auto deck = deck::Deck::read_text("*KEYWORD\n" + block + "*END\n", "sample.k", {}, diagnostics);
  for (const auto& b : deck.blocks()) {
    const auto* entry = model::find_law(b.keyword);
    if (entry)
      return entry->build(deck.cards(b, diagnostics).at(0),
                          model::LawContext{curves, tables, nullptr, diagnostics});
  }
  return nullptr;
}

inline std::shared_ptr<const model::Law> elastic(double young = 200.0, double poisson = 0.3) {
  return law("*MAT_ELASTIC\n1,1.0," + std::to_string(young) + "," + std::to_string(poisson) + "\n");
}

/// One part of hex8 elements.
struct Sample {
  model::Model model;

  Sample(std::shared_ptr<const model::Law> law, double density) {
    model::Part part;
    part.id = 1;
    part.section.family = "SOLID";
    part.section.form = 1;
    part.law = std::move(law);
    part.density = density;
    model.parts.push_back(part);
    model.mesh.solids.push_back({});
  }
  model::Part& part() { return model.parts[0]; }
  model::Elements& solids() { return model.mesh.solids[0]; }
  std::size_t node_count() const { return model.mesh.nodes.count(); }

  void add_node(const Point& x) {
    model.mesh.nodes.id.push_back(static_cast<model::Id>(node_count()) + 1);
    for (const double c : {x.x, x.y, x.z}) model.mesh.nodes.position.push_back(c);
  }
  void add_element(std::initializer_list<Index> nodes) {
    solids().id.push_back(static_cast<model::Id>(solids().count()) + 1);
    solids().part.push_back(0);
    solids().node.insert(solids().node.end(), nodes);
  }

  std::unique_ptr<Block> block(int form = 1) const {
    deck::Diagnostics diagnostics;
    const auto& solids = model.mesh.solids[0];
    const PartElements elements{model, 0, solids.shape, solids.id, solids.node};
    return find_formulation("SOLID", form, solids.shape)->build(elements, diagnostics);
  }
};

/// nx * ny * nz elements over [0,1]^3 moved to where `shape` says.
inline Sample box(
    int nx, int ny, int nz, std::shared_ptr<const model::Law> law, double density = 1.0,
    const std::function<Point(Point)>& shape = [](Point x) { return x; }) {
  Sample s(std::move(law), density);
  const auto node = [&](int i, int j, int k) {
    return static_cast<Index>((k * (ny + 1) + j) * (nx + 1) + i);
  };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) s.add_node(shape({double(i) / nx, double(j) / ny, double(k) / nz}));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        s.add_element({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                       node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                       node(i, j + 1, k + 1)});
  return s;
}

/// Deterministic numbers in [-1, 1).
class Noise {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(static_cast<std::int64_t>(state_ >> 11)) / 4503599627370496.0 - 1.0;
  }

 private:
  std::uint64_t state_ = 88172645463325252ull;
};

/// A block with its state, moved by giving new positions.
struct Body {
  const Sample& sample;
  std::unique_ptr<Block> block;
  base::Array<double> position, velocity;
  BlockState state;
  ForceSum force;
  double time = 0.0;
  StepStatus start;

  explicit Body(const Sample& s, int form = 1) : sample(s), block(s.block(form)), force(s.node_count()) {
    position.assign(s.model.mesh.nodes.position.begin(), s.model.mesh.nodes.position.end());
    velocity.assign(position.size(), 0.0);
    start = block->initialise(position, state);
  }

  /// Steps to positions given by a function of the reference position, at constant velocity in the step.
  StepOutput move_to(double dt, const std::function<Point(Point)>& where, double expected_force = 1e3) {
    const auto& reference = sample.model.mesh.nodes.position;
    base::Array<double> next(position.size());
    for (std::size_t n = 0; n < sample.node_count(); ++n) {
      const Point x = where({reference[3 * n], reference[3 * n + 1], reference[3 * n + 2]});
      next[3 * n] = x.x;
      next[3 * n + 1] = x.y;
      next[3 * n + 2] = x.z;
    }
    return move_nodes(dt, next, expected_force);
  }
  StepOutput move_nodes(double dt, const base::Array<double>& next, double expected_force = 1e3) {
    for (std::size_t i = 0; i < next.size(); ++i) velocity[i] = dt > 0.0 ? (next[i] - position[i]) / dt : 0.0;
    position = next;
    time += dt;
    force.begin(expected_force);
    return block->add_force({time, dt, position.data(), velocity.data(), 0.0}, state, force);
  }
  std::vector<double> field(std::string_view name, std::size_t size) const {
    std::vector<double> out(block->element_ids().size() * size);
    block->evaluate(name, position, state, {}, out);
    return out;
  }
  Point force_at(Index node) const {
    return {force.value(node, 0), force.value(node, 1), force.value(node, 2)};
  }
};

/// Rotation by an angle about a unit axis.
inline Point rotated(const Point& x, const Point& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * x + s * cross(axis, x) + ((1.0 - c) * dot(axis, x)) * axis;
}

}  // namespace cleave::discretisation::sample
