#include "solver/nodal.hpp"

#include <algorithm>

#include "base/lanes.hpp"
#include "base/threads.hpp"

namespace cleave::solver {

using base::Lanes;
using discretisation::State;

namespace {

constexpr std::size_t width = base::lane_count;

/// Values of eight nodes beside their components: lane i of the k-th is that of component 8 k + i.
struct Spread {
  Lanes of[3];
  explicit Spread(Lanes node)
      : of{Lanes(__builtin_shufflevector(node.v, node.v, 0, 0, 0, 1, 1, 1, 2, 2)),
           Lanes(__builtin_shufflevector(node.v, node.v, 2, 3, 3, 3, 4, 4, 4, 5)),
           Lanes(__builtin_shufflevector(node.v, node.v, 5, 5, 6, 6, 6, 7, 7, 7))} {}
};

/// Turns forces into accelerations. Arrays on 64-byte boundaries.
/// @param mass  [node]
/// @param a     [node][3] force, then acceleration
void divide_by_mass(const double* mass, double* a, std::size_t count) {
  const Lanes zero(0.0), one(1.0);
  std::size_t node = 0;
  for (; node + width <= count; node += width) {
    const Lanes m = Lanes::load(mass + node);
    const base::Mask heavy = m > zero;
    const Spread inverse(select(heavy, one / select(heavy, m, one), zero));
    for (std::size_t k = 0; k < 3; ++k) {
      double* at = a + 3 * node + k * width;
      (Lanes::load(at) * inverse.of[k]).store(at);
    }
  }
  for (; node < count; ++node) {
    const double inverse = mass[node] > 0.0 ? 1.0 / mass[node] : 0.0;
    for (std::size_t i = 0; i < 3; ++i) a[3 * node + i] *= inverse;
  }
}

/// Sum of m v^2 over nodes, v = velocity + a * since: lane by lane, then over the lanes.
double twice_kinetic(const double* mass, const double* velocity, const double* a, double since,
                     std::size_t count) {
  Lanes sum(0.0);
  std::size_t node = 0;
  for (; node + width <= count; node += width) {
    const Spread m(Lanes::load(mass + node));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = 3 * node + k * width;
      const Lanes v = Lanes::load(velocity + at) + Lanes::load(a + at) * Lanes(since);
      sum += m.of[k] * (v * v);
    }
  }
  double rest = 0.0;
  for (; node < count; ++node)
    for (std::size_t i = 3 * node; i < 3 * node + 3; ++i) {
      const double v = velocity[i] + a[i] * since;
      rest += mass[node] * (v * v);
    }
  return base::sum(sum) + rest;
}

}  // namespace

Nodal::Nodal(std::size_t node_count)
    : count_(node_count), kinetic_((node_count + grain - 1) / grain), stale_(kinetic_.size()) {}

void Nodal::accelerate(const State& state, discretisation::ForceSum& internal,
                       std::span<const double> external, std::span<double> acceleration) {
  std::fill(stale_.begin(), stale_.end(), 0);
  const double since = 0.5 * state.step;
  base::for_each_range(count_, grain, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t first = begin; first < end; first += piece) {
      const std::size_t count = std::min(piece, end - first);
      double* a = &acceleration[3 * first];
      internal.take(first, first + count, a);
      if (!external.empty())
        for (std::size_t k = 0; k < 3 * count; ++k) a[k] += external[3 * first + k];
      divide_by_mass(&state.mass[first], a, count);
      sum += twice_kinetic(&state.mass[first], &state.velocity[3 * first], a, since, count);
    }
    kinetic_[begin / grain] = sum;
  });
  internal.all_taken();
}

void Nodal::corrected(std::span<const std::int32_t> nodes) {
  for (const std::int32_t node : nodes) stale_[static_cast<std::size_t>(node) / grain] = 1;
}

void Nodal::settle(const State& state, std::span<const double> acceleration) {
  const double since = 0.5 * state.step;
  base::for_each_range(count_, grain, [&](std::size_t begin, std::size_t end) {
    if (!stale_[begin / grain]) return;
    double sum = 0.0;  // piece by piece, as in accelerate()
    for (std::size_t first = begin; first < end; first += piece)
      sum += twice_kinetic(&state.mass[first], &state.velocity[3 * first], &acceleration[3 * first], since,
                           std::min(piece, end - first));
    kinetic_[begin / grain] = sum;
  });
}

void Nodal::settle_all(const State& state, std::span<const double> acceleration) {
  std::fill(stale_.begin(), stale_.end(), 1);
  settle(state, acceleration);
}

void Nodal::move(State& state, std::span<const double> acceleration) {
  const double interval = 0.5 * (state.step + state.next_step), dt = state.next_step;
  base::for_each_range(3 * state.mass.size(), 3 * grain, [&](std::size_t begin, std::size_t end) {
    const double* a = &acceleration[begin];
    double *v = &state.velocity[begin], *x = &state.position[begin];
    const std::size_t count = end - begin;
    std::size_t k = 0;
    for (; k + width <= count; k += width) {
      const Lanes moved = Lanes::load(v + k) + Lanes::load(a + k) * Lanes(interval);
      moved.store(v + k);
      (Lanes::load(x + k) + moved * Lanes(dt)).store(x + k);
    }
    for (; k < count; ++k) {
      v[k] += a[k] * interval;
      x[k] += v[k] * dt;
    }
  });
}

double Nodal::kinetic() const {
  double sum = 0.0;
  for (const double part : kinetic_) sum += part;
  return 0.5 * sum;
}

}  // namespace cleave::solver
