#pragma once
/// A small world for tests of the solver: point masses joined by linear springs.

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "base/threads.hpp"
#include "solver/solver.hpp"

namespace cleave::solver::test {

using discretisation::BlockState;
using discretisation::ForceSum;
using discretisation::State;
using discretisation::StepInput;
using discretisation::StepOutput;
using discretisation::StepStatus;
using model::Id;
using model::Index;
using model::Vector;

/// Springs along the line between two nodes, half of the spring's mass on each; no force at the start.
class Springs final : public discretisation::Block {
 public:
  struct Spring {
    Index node[2];
    double stiffness = 1.0;
    double mass = 1.0;
    double breaks_at = 1e300;  ///< elongation at which it is deleted [length]
    double fails_at = 1e300;   ///< elongation at which it reports a physics failure [length]
  };

  Springs(Index part, std::vector<Spring> springs, Id first_id = 1)
      : part_(part), springs_(std::move(springs)) {
    for (std::size_t e = 0; e < springs_.size(); ++e) {
      ids_.push_back(first_id + static_cast<Id>(e));
      nodes_.insert(nodes_.end(), springs_[e].node, springs_[e].node + 2);
    }
  }

  Index part() const override { return part_; }
  model::Shape shape() const override { return model::Shape::hex8; }
  std::string_view formulation() const override { return "spring"; }
  int points_per_element() const override { return 1; }
  std::span<const Id> element_ids() const override { return ids_; }
  std::span<const Index> connectivity() const override { return nodes_; }

  StepStatus initialise(const base::Array<double>& position, BlockState& state) const override {
    state.element.clear();
    for (const Spring& spring : springs_) state.element.push_back(length(spring, position.data()));
    state.alive.assign(springs_.size(), 1.0);
    return {};
  }
  void add_mass(const BlockState& state, std::span<double> mass) const override {
    add_scaled_mass(state, std::vector<double>(springs_.size(), 1.0), mass);
  }
  void add_scaled_mass(const BlockState&, std::span<const double> factor,
                       std::span<double> mass) const override {
    for (std::size_t e = 0; e < springs_.size(); ++e)
      for (const Index node : springs_[e].node)
        mass[static_cast<std::size_t>(node)] += 0.5 * factor[e] * springs_[e].mass;
  }
  StepOutput add_force(const StepInput& input, BlockState& state, ForceSum& force) const override {
    StepOutput out;
    for (std::size_t e = 0; e < springs_.size(); ++e) {
      const Spring& spring = springs_[e];
      if (state.alive[e] == 0.0) continue;
      const double now = length(spring, input.position), stretch = now - state.element[e];
      const double energy = 0.5 * spring.stiffness * stretch * stretch;
      if (stretch > spring.fails_at)
        out.status.merge({false, part_, ids_[e], "spring failed", "pulled too far"});
      if (stretch > spring.breaks_at || stable_step(spring) < input.erosion_step) {
        state.alive[e] = 0.0;
        out.eroded_internal += energy;
        out.eroded.push_back(ids_[e]);
        continue;
      }
      for (int i = 0; i < 3 && now > 0.0; ++i) {
        const double f = spring.stiffness * stretch *
                         (at(input.position, spring.node[1], i) - at(input.position, spring.node[0], i)) /
                         now;
        force.add_value(spring.node[0], i, f);
        force.add_value(spring.node[1], i, -f);
      }
      out.internal_energy += energy;
      if (stable_step(spring) < out.stable_step) {
        out.stable_step = stable_step(spring);
        out.stable_element = ids_[e];
      }
    }
    return out;
  }
  void stable_steps(const base::Array<double>&, const BlockState& state,
                    std::span<double> steps) const override {
    for (std::size_t e = 0; e < springs_.size(); ++e)
      steps[e] = state.alive[e] == 0.0 ? 1.0e30 : stable_step(springs_[e]);
  }
  std::vector<discretisation::ElementField> fields() const override { return {}; }
  void evaluate(std::string_view, const base::Array<double>&, const BlockState&, std::span<const std::size_t>,
                std::span<double>) const override {}
  void alive(const BlockState& state, std::span<bool> out) const override {
    for (std::size_t e = 0; e < out.size(); ++e) out[e] = state.alive[e] != 0.0;
  }
  double bytes_per_element() const override { return sizeof(Spring); }

 private:
  static double at(const double* x, Index node, int i) { return x[3 * static_cast<std::size_t>(node) + i]; }
  static double length(const Spring& spring, const double* x) {
    double square = 0.0;
    for (int i = 0; i < 3; ++i) square += std::pow(at(x, spring.node[1], i) - at(x, spring.node[0], i), 2);
    return std::sqrt(square);
  }
  /// 2 / omega of the free element with half its mass on each side; no say without mass.
  static double stable_step(const Spring& spring) {
    return spring.mass > 0.0 ? std::sqrt(spring.mass / spring.stiffness) : 1.0e30;
  }

  Index part_;
  std::vector<Spring> springs_;
  std::vector<Id> ids_;
  std::vector<Index> nodes_;
};

/// Calls a function after every step.
class Watch final : public Observer {
 public:
  explicit Watch(std::function<void(const Frame&)> look) : look_(std::move(look)) {}
  void begin(const Frame& frame) override { look_(frame); }
  void after_step(const Frame& frame) override { look_(frame); }
  void finish(const Frame& frame, Ending why, const StepStatus& how) override {
    last_cycle = frame.state.cycle;
    ending = why;
    status = how;
  }
  std::int64_t last_cycle = -1;  ///< given to finish()
  Ending ending = Ending::end_time;
  StepStatus status;

 private:
  std::function<void(const Frame&)> look_;
};

/// Model, world and state of a test. Fill in the model, add springs, then run.
struct Rig {
  model::Model model;
  discretisation::World world;
  State state;
  deck::Diagnostics diagnostics;

  Rig() {
    model.parts.resize(1);
    model.parts[0].id = 1;
    model.control.step.safety = 1.0;
    model.control.energy.damping = true;
    world.model = &model;
  }
  Rig(const Rig&) = delete;

  Index node(double x, double y = 0.0, double z = 0.0) {
    model.mesh.nodes.id.push_back(static_cast<Id>(model.mesh.nodes.id.size() + 1));
    for (const double c : {x, y, z}) model.mesh.nodes.position.push_back(c);
    model.initial_velocity.resize(model.mesh.nodes.position.size());
    return static_cast<Index>(model.mesh.nodes.id.size() - 1);
  }
  /// A node with a mass of its own.
  Index particle(double mass, Vector x, Vector v = {0, 0, 0}) {
    const Index a = node(x.x, x.y, x.z);
    model.point_masses.push_back({0, a, mass});
    velocity(a, v);
    return a;
  }
  void velocity(Index a, Vector v) {
    double* to = &model.initial_velocity[3 * static_cast<std::size_t>(a)];
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
  }
  Index curve(std::vector<double> x, std::vector<double> y) {
    model::Curve curve;
    curve.id = static_cast<Id>(model.curves.size() + 1);
    curve.x = std::move(x);
    curve.y = std::move(y);
    model.curves.push_back(curve);
    return static_cast<Index>(model.curves.size() - 1);
  }
  Index constant(double value) { return curve({0.0, 1e20}, {value, value}); }
  /// The step of the whole run, by the limit curve.
  void fixed_step(double dt) { model.control.step.limit_curve = constant(dt); }
  void springs(std::vector<Springs::Spring> list, Index part = 0, Id first_id = 1) {
    world.blocks.push_back(std::make_unique<Springs>(part, std::move(list), first_id));
  }
  void fix(std::vector<Index> nodes, unsigned directions) {
    model::FixedNodes fixed;
    fixed.nodes = std::move(nodes);
    fixed.directions = directions;
    model.fixed.push_back(fixed);
  }

  void initialise() {
    state = State{};
    const auto& x = model.mesh.nodes.position;
    state.position.assign(x.begin(), x.end());
    state.velocity.assign(model.initial_velocity.begin(), model.initial_velocity.end());
    state.mass.assign(model.mesh.nodes.count(), 0.0);
    state.blocks.resize(world.blocks.size());
    for (std::size_t b = 0; b < world.blocks.size(); ++b) {
      world.blocks[b]->initialise(state.position, state.blocks[b]);
      world.blocks[b]->add_mass(state.blocks[b], state.mass);
    }
    for (const auto& point : model.point_masses)
      state.mass[static_cast<std::size_t>(point.node)] += point.mass;
  }

  /// Goes on from `state` to a time.
  Outcome advance(double end, const Options& options = {}, std::function<void(const Frame&)> look = nullptr) {
    model.control.end.time = end;
    Wishes wishes;
    const auto solver = make_explicit(world, options, diagnostics);
    if (!look) return solver->advance(state, {}, wishes);
    Watch watch(std::move(look));
    Observer* const observers[] = {&watch};
    return solver->advance(state, observers, wishes);
  }
  /// From the start to a time.
  Outcome run(double end, std::function<void(const Frame&)> look = nullptr) {
    initialise();
    return advance(end, {}, std::move(look));
  }

  double x(Index a, int i = 0) const { return state.position[3 * static_cast<std::size_t>(a) + i]; }
  double v(Index a, int i = 0) const { return state.velocity[3 * static_cast<std::size_t>(a) + i]; }
};

}  // namespace cleave::solver::test
