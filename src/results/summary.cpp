#include "results/summary.hpp"

namespace cleave::results {

using solver::Ending;

std::string_view name_of(Ending ending) {
  switch (ending) {
    case Ending::end_time:
      return "end_time";
    case Ending::cycle_limit:
      return "cycle_limit";
    case Ending::step_too_small:
      return "step_too_small";
    case Ending::energy_limit:
      return "energy_limit";
    case Ending::mass_limit:
      return "mass_limit";
    case Ending::node_bound:
      return "node_bound";
    case Ending::switched_off:
      return "switched_off";
    case Ending::signal:
      return "signal";
    case Ending::physics:
      return "physics";
  }
  return "unknown";
}

std::string_view describe(Ending ending) {
  switch (ending) {
    case Ending::end_time:
      return "the end time was reached";
    case Ending::cycle_limit:
      return "the cycle limit was reached";
    case Ending::step_too_small:
      return "the time step fell below the limit of *CONTROL_TERMINATION DTMIN";
    case Ending::energy_limit:
      return "the energy changed by more than *CONTROL_TERMINATION ENDENG allows";
    case Ending::mass_limit:
      return "mass scaling added more than *CONTROL_TERMINATION ENDMAS allows";
    case Ending::node_bound:
      return "a node reached its *TERMINATION_NODE bound";
    case Ending::switched_off:
      return "it was asked to stop";
    case Ending::signal:
      return "a signal asked it to stop";
    case Ending::physics:
      return "an element failed";
  }
  return "of an unknown reason";
}

bool is_normal(Ending ending) {
  return ending != Ending::physics && ending != Ending::step_too_small && ending != Ending::energy_limit &&
         ending != Ending::mass_limit;
}

void Summary::begin(const Snapshot& now, const discretisation::Memory* resumed) {
  axes_ = part_axes(now.frame().world);
  before_ = extents(now.frame().world, now.model().mesh.nodes.position, nullptr, axes_);
  if (resumed && resumed->values.size() == 10) {
    Range* const ranges[] = {&step_, &ratio_, &kinetic_, &internal_, &hourglass_};
    for (std::size_t i = 0; i < 5; ++i) *ranges[i] = {resumed->values[2 * i], resumed->values[2 * i + 1]};
  }
  after_step(now);
}

void Summary::after_step(const Snapshot& now) {
  const discretisation::State& state = now.state();
  if (state.step > 0.0) step_.include(state.step);
  if (!now.frame().energies_due) return;  // the same, whoever asked for them
  ratio_.include(state.energy.ratio());
  kinetic_.include(state.energy.kinetic);
  internal_.include(state.energy.internal);
  hourglass_.include(state.energy.hourglass);
}

std::vector<double> Summary::remember() const {
  std::vector<double> values;
  for (const Range* range : {&step_, &ratio_, &kinetic_, &internal_, &hourglass_})
    values.insert(values.end(), {range->low, range->high});
  return values;
}

void Summary::finish(const Snapshot& now, Ending ending, const discretisation::StepStatus& status) {
  now.evaluate(solver::everything);
  const discretisation::State& state = now.state();
  ending_ = ending;
  status_ = status;
  energy_ = state.energy;
  time_ = state.time;
  cycles_ = state.cycle;
  first_step_ = state.first_step;
  last_step_ = state.step;
  mass_ = now.whole().mass;
  base_mass_ = now.masses().total();
  added_mass_ = state.added_mass;
  const std::vector<Extent> after = extents(now.frame().world, state.position, &state, axes_);
  for (std::size_t p = 0; p < axes_.size(); ++p)
    parts_.push_back({now.parts()[p].mass,
                      p < state.parts.size() ? state.parts[p] : discretisation::PartEnergy{},
                      now.parts()[p].kinetic, before_[p], after[p], axes_[p]});
  bytes_ = static_cast<double>(now.frame().world.node_count()) * 10.0 * sizeof(double);
  for (const auto& block : now.frame().world.blocks)
    bytes_ += block->bytes_per_element() * static_cast<double>(block->element_ids().size());
}

}  // namespace cleave::results
