#include "solver/step_size.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::solver {

using discretisation::State;

double choose_step(const model::Model& model, const State& state, const StableStep& stable) {
  const model::TimeStepControl& control = model.control.step;
  constexpr double none = 1.0e30;
  double limit = none;
  if (control.limit_curve >= 0) {
    const double value = model.curves[static_cast<std::size_t>(control.limit_curve)].value(state.time);
    if (value > 0.0) limit = value;
  }
  if (state.cycle == 0 && control.first > 0.0) limit = std::min(limit, control.first);
  if (stable.step < 1.0e29) return std::min(limit, control.safety * stable.step);
  return limit < none ? limit : 0.01 * model.control.end.time;
}

double limit_step(double step, double stable, double rate, double damping, double& last) {
  constexpr double margin = 0.99, growth = 1.01;
  double limit = last > 0.0 ? growth * last : step;
  if (rate > 0.0) {
    const double elements = stable < 1.0e29 ? 4.0 / (stable * stable) : 0.0;
    const double bound = 2.0 / std::sqrt(elements + rate) * (std::sqrt(1.0 + damping * damping) - damping);
    limit = std::min(limit, margin * bound);
  }
  last = limit < step ? limit : 0.0;
  return std::min(step, limit);
}

double least_step(const model::Model& model, const State& state) {
  return model.control.end.step_fraction * state.first_step;
}

bool MassScaling::active() const {
  const model::TimeStepControl& control = world_.model->control.step;
  return control.mass_scaling != 0.0 || control.mass_scaling_fraction > 0.0;
}

base::Array<double> MassScaling::first_memory(std::size_t block) const {
  return base::Array<double>(world_.blocks[block]->element_ids().size(), 1.0);
}

double MassScaling::wanted(double time, double first) const {
  const model::TimeStepControl& control = world_.model->control.step;
  double step = std::abs(control.mass_scaling);
  if (control.mass_scaling_fraction > 0.0) step = control.mass_scaling_fraction * first;
  if (control.mass_scaling_curve >= 0) {  // the curve may only increase it
    const model::Curve& curve = world_.model->curves[static_cast<std::size_t>(control.mass_scaling_curve)];
    step = std::max(step, std::abs(curve.value(time)));
  }
  return step;
}

bool MassScaling::apply(State& state, const std::vector<base::Array<double>*>& factors, bool start,
                        double first, StableStep& stable) {
  const model::TimeStepControl& control = world_.model->control.step;
  const bool all = control.mass_scaling > 0.0;
  const bool may_change = start || !control.mass_scaling_first_only;
  const double goal = wanted(state.time, first);
  stable = StableStep{};
  mass_.assign(world_.node_count(), 0.0);
  bool changed = false;
  for (std::size_t b = 0; b < world_.blocks.size(); ++b) {
    const discretisation::Block& block = *world_.blocks[b];
    base::Array<double>& factor = *factors[b];
    const auto ids = block.element_ids();
    steps_.resize(ids.size());
    change_.assign(ids.size(), 0.0);
    block.stable_steps(state.position, state.blocks[b], steps_);
    bool block_changed = false;
    for (std::size_t e = 0; e < ids.size(); ++e) {
      if (steps_[e] >= 1.0e29) continue;  // deleted
      if (may_change) {
        const double needed = (goal / steps_[e]) * (goal / steps_[e]);
        const double now = all ? needed : std::max(factor[e], needed);
        change_[e] = now - factor[e];
        block_changed = block_changed || change_[e] != 0.0;
        factor[e] = now;
      }
      const double step = steps_[e] * std::sqrt(factor[e]);
      if (step < stable.step || (step == stable.step && ids[e] < stable.element)) stable = {step, ids[e]};
    }
    if (block_changed) block.add_scaled_mass(state.blocks[b], change_, mass_);
    changed = changed || block_changed;
  }
  if (!changed) return false;
  for (std::size_t a = 0; a < mass_.size(); ++a) {
    state.mass[a] += mass_[a];
    state.added_mass += mass_[a];
  }
  return true;
}

}  // namespace cleave::solver
