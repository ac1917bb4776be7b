#include "solver/termination.hpp"

#include <cmath>

#include "solver/step_size.hpp"

namespace cleave::solver {

using discretisation::State;
using discretisation::StepStatus;

namespace {

constexpr double energy_growth = 100.0;  // times all energy that ever came in: not a matter of accuracy
constexpr double collapsed_step = 1e-6;  // of the first step: the run would never end

model::Index part_of_element(const discretisation::World& world, model::Id element) {
  for (const auto& block : world.blocks)
    for (const model::Id id : block->element_ids())
      if (id == element) return block->part();
  return -1;
}

/// The lowest element id at a node, with its part.
StepStatus at_node(const discretisation::World& world, model::Index node, std::string what,
                   std::string cause) {
  StepStatus status{false, -1, 0, std::move(what), std::move(cause)};
  for (const auto& block : world.blocks) {
    const auto ids = block->element_ids();
    const auto nodes = block->connectivity();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const model::Id id = ids[k / (nodes.size() / ids.size())];
      if (nodes[k] == node && (status.part < 0 || id < status.element)) {
        status.part = block->part();
        status.element = id;
      }
    }
  }
  return status;
}

bool out_of_bounds(const model::Termination::NodeBound& bound, const State& state) {
  const double x =
      state.position[3 * static_cast<std::size_t>(bound.node) + static_cast<std::size_t>(bound.stop - 1)];
  return x > bound.maximum || x < bound.minimum;
}

}  // namespace

std::optional<Ending> reason_to_end(const model::Model& model, const State& state, const Options& options,
                                    const Wishes& wishes) {
  const model::Termination& end = model.control.end;
  if (state.time + 1e-9 * state.next_step >= end.time) return Ending::end_time;
  if (end.cycles > 0 && state.cycle >= end.cycles) return Ending::cycle_limit;
  if (options.stop_at_cycle > 0 && state.cycle >= options.stop_at_cycle) return Ending::cycle_limit;
  if (!model.control.step.erode && state.next_step < least_step(model, state)) return Ending::step_too_small;
  if (end.energy_change > 0.0 && std::abs(state.energy.ratio() - 1.0) * 100.0 > end.energy_change)
    return Ending::energy_limit;
  if (end.mass_change > 0.0 && state.added_mass != 0.0) {
    double mass = 0.0;
    for (const double m : state.mass) mass += m;
    if (std::abs(state.added_mass) * 100.0 > end.mass_change * (mass - state.added_mass))
      return Ending::mass_limit;
  }
  for (const auto& bound : end.nodes)
    if (out_of_bounds(bound, state)) return Ending::node_bound;
  if (wishes.stop.load(std::memory_order_acquire))
    return wishes.signal.load(std::memory_order_relaxed) ? Ending::signal : Ending::switched_off;
  return std::nullopt;
}

StepStatus check_health(const discretisation::World& world, const State& state, double gross_work,
                        model::Id step_element, std::span<const double> acceleration) {
  const model::Model& model = *world.model;
  if (!std::isfinite(state.energy.kinetic)) {
    for (std::size_t k = 0; k < acceleration.size(); ++k)
      if (!std::isfinite(acceleration[k]) || !std::isfinite(state.velocity[k])) {
        const auto node = static_cast<model::Index>(k / 3);
        return at_node(
            world, node,
            "velocity of node " + std::to_string(model.mesh.nodes.id[k / 3]) + " is not a number",
            "a load or material parameter out of range, or an unstable step; look at the frames before");
      }
    return {false, -1, 0, "kinetic energy is beyond all numbers", "an unstable step: lower TSSFAC"};
  }
  const model::TimeStepControl& control = model.control.step;
  const bool usable = state.next_step > 0.0 && std::isfinite(state.next_step);
  if (!usable || (state.next_step < collapsed_step * state.first_step && control.limit_curve < 0))
    return {false, part_of_element(world, step_element), step_element,
            usable ? "stable step fell below a millionth of the first step"
                   : "stable step is zero or not a number",
            "the element is crushed; give it a failure criterion, or stop it with DTMIN and ERODE"};
  // Mass scaling during the run changes kinetic energy by itself.
  const bool mass_moves = control.mass_scaling != 0.0 && !control.mass_scaling_first_only;
  const double in = std::abs(state.energy.initial) + gross_work;
  const double surplus = state.energy.total() - state.energy.initial - state.energy.external;
  if (!mass_moves && in > 0.0 && surplus > energy_growth * in)
    return {false, part_of_element(world, step_element), step_element, "energy grows without a source",
            "an unstable step (lower TSSFAC) or a material that is not stable; the element named controls "
            "the step"};
  return {};
}

}  // namespace cleave::solver
