#pragma once
/// Where the wall-clock time of a run goes.

#include <array>
#include <chrono>
#include <vector>

#include "solver/solver.hpp"

namespace cleave::solver {

enum class Phase : std::size_t { elements, contact, loads, update, output };

/// lap(phase) books the time since the lap before; about 30 ns.
class Stopwatch {
 public:
  void lap(Phase phase) {
    const Clock::time_point now = Clock::now();
    spent_[static_cast<std::size_t>(phase)] += now - last_;
    last_ = now;
  }
  double total() const {
    double sum = 0.0;
    for (const Clock::duration& one : spent_) sum += seconds(one);
    return sum;
  }
  std::vector<Outcome::Phase> phases() const {
    return {{"elements", seconds(spent_[0])},
            {"contact", seconds(spent_[1])},
            {"loads", seconds(spent_[2])},
            {"update", seconds(spent_[3])},
            {"output", seconds(spent_[4])}};
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

  std::array<Clock::duration, 5> spent_{};
  Clock::time_point last_ = Clock::now();
};

}  // namespace cleave::solver
