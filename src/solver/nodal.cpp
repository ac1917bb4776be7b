#include "solver/nodal.hpp"

#include <algorithm>

#include "base/threads.hpp"

namespace cleave::solver {

using discretisation::State;

Nodal::Nodal(std::size_t node_count)
    : count_(node_count),
      inverse_mass_(node_count),
      middle_(3 * node_count),
      kinetic_((node_count + grain - 1) / grain),
      stale_(kinetic_.size()) {}

void Nodal::mass_changed(const State& state) {
  base::for_each_range(count_, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      inverse_mass_[a] = state.mass[a] > 0.0 ? 1.0 / state.mass[a] : 0.0;
  });
}

void Nodal::accelerate(const State& state, const discretisation::ForceSum& internal,
                       std::span<const double> external, std::span<double> acceleration) {
  std::fill(stale_.begin(), stale_.end(), 0);
  base::for_each_range(count_, grain, [&](std::size_t begin, std::size_t end) {
    // Forces first: a range of them stays in the nearest cache for the rest.
    for (std::size_t a = begin; a < end; ++a)
      for (int i = 0; i < 3; ++i) acceleration[3 * a + i] = internal.value(static_cast<std::int32_t>(a), i);
    if (!external.empty())
      for (std::size_t k = 3 * begin; k < 3 * end; ++k) acceleration[k] += external[k];
    for (std::size_t a = begin; a < end; ++a)
      for (int i = 0; i < 3; ++i) acceleration[3 * a + i] *= inverse_mass_[a];
    settle_range(state, acceleration, begin, end);
  });
}

void Nodal::settle_range(const State& state, std::span<const double> acceleration, std::size_t begin,
                         std::size_t end) {
  const double back = 0.5 * state.step;
  double sum = 0.0;
  for (std::size_t a = begin; a < end; ++a) {
    double square = 0.0;
    for (std::size_t k = 3 * a; k < 3 * a + 3; ++k) {
      const double v = state.velocity[k] + acceleration[k] * back;
      middle_[k] = v;
      square += v * v;
    }
    sum += state.mass[a] * square;
  }
  kinetic_[begin / grain] = sum;
}

void Nodal::corrected(std::span<const std::int32_t> nodes) {
  for (const std::int32_t node : nodes) stale_[static_cast<std::size_t>(node) / grain] = 1;
}

void Nodal::settle(const State& state, std::span<const double> acceleration) {
  base::for_each_range(count_, grain, [&](std::size_t begin, std::size_t end) {
    if (stale_[begin / grain]) settle_range(state, acceleration, begin, end);
  });
}

void Nodal::settle_all(const State& state, std::span<const double> acceleration) {
  std::fill(stale_.begin(), stale_.end(), 1);
  settle(state, acceleration);
}

void Nodal::move(State& state, std::span<const double> acceleration) {
  const double interval = 0.5 * (state.step + state.next_step), dt = state.next_step;
  base::for_each_range(3 * state.mass.size(), 3 * grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double v = state.velocity[k] + acceleration[k] * interval;
      state.velocity[k] = v;
      state.position[k] += v * dt;
    }
  });
}

double Nodal::kinetic() const {
  double sum = 0.0;
  for (const double part : kinetic_) sum += part;
  return 0.5 * sum;
}

}  // namespace cleave::solver
