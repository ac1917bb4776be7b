#include "solver/nodal.hpp"

#include <algorithm>

#include "base/lanes.hpp"
#include "base/threads.hpp"

namespace cleave::solver {

using discretisation::State;

namespace {

/// out = x + factor * y. All on 64-byte boundaries. @param count of doubles
void add_scaled(const double* x, const double* y, double factor, double* out, std::size_t count) {
  using base::Lanes;
  constexpr std::size_t width = base::lane_count;
  const Lanes f(factor);
  std::size_t k = 0;
  for (; k + width <= count; k += width) (Lanes::load(x + k) + Lanes::load(y + k) * f).store(out + k);
  for (; k < count; ++k) out[k] = x[k] + y[k] * factor;
}

}  // namespace

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
    double* a = &acceleration[3 * begin];
    internal.values(begin, end, a);
    if (!external.empty())
      for (std::size_t k = 0; k < 3 * (end - begin); ++k) a[k] += external[3 * begin + k];
    const double* inverse = &inverse_mass_[begin];
    for (std::size_t node = 0; node < end - begin; ++node) {
      a[3 * node] *= inverse[node];
      a[3 * node + 1] *= inverse[node];
      a[3 * node + 2] *= inverse[node];
    }
    settle_range(state, acceleration, begin, end);
  });
}

void Nodal::settle_range(const State& state, std::span<const double> acceleration, std::size_t begin,
                         std::size_t end) {
  const double back = 0.5 * state.step;
  double* middle = &middle_[3 * begin];
  add_scaled(&state.velocity[3 * begin], &acceleration[3 * begin], back, middle, 3 * (end - begin));
  const double* mass = &state.mass[begin];
  double sum = 0.0;
  for (std::size_t node = 0; node < end - begin; ++node) {
    const double* v = middle + 3 * node;
    sum += mass[node] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
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
    double *v = &state.velocity[begin], *x = &state.position[begin];
    add_scaled(v, &acceleration[begin], interval, v, end - begin);
    add_scaled(x, v, dt, x, end - begin);
  });
}

double Nodal::kinetic() const {
  double sum = 0.0;
  for (const double part : kinetic_) sum += part;
  return 0.5 * sum;
}

}  // namespace cleave::solver
