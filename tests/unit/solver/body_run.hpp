#pragma once
/// Runs of deck text with rigid bodies.

#include <algorithm>
#include <cmath>
#include <functional>

#include "deck_run.hpp"

namespace cleave::solver::test {

/// A run that keeps what its first body does.
struct BodyRun final : DeckRun, Observer {
  BodyMotion first, last;
  /// Least and most of what is there less what came in [energy].
  double least_energy = 1e300, most_energy = -1e300, most_momentum = 0.0;

  std::function<void(const Frame&)> look;

  explicit BodyRun(const std::string& text, std::int64_t stop = 0,
                   std::function<void(const Frame&)> look_at = nullptr)
      : look(std::move(look_at)) {
    run(text, stop, this);
  }
  void begin(const Frame& frame) override {
    first = frame.bodies.empty() ? BodyMotion{} : frame.bodies[0];
    after_step(frame);
  }
  void after_step(const Frame& frame) override {
    if (look) look(frame);
    if (frame.bodies.empty()) return;
    last = frame.bodies[0];
    least_energy = std::min(least_energy, frame.state.energy.total() - frame.state.energy.external);
    most_energy = std::max(most_energy, frame.state.energy.total() - frame.state.energy.external);
    for (int i = 0; i < 3; ++i)
      most_momentum = std::max(most_momentum, std::abs(last.momentum[i] - first.momentum[i]));
  }
  void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}

  double distance(std::size_t a, std::size_t b) const {
    double square = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      square += std::pow(state.position[3 * a + i] - state.position[3 * b + i], 2);
    return std::sqrt(square);
  }
};

/// A rigid box 1 x 2 x 3, nodes 1 to 8, part 1, density 2.
inline std::string box(const std::string& control) {
  return "*KEYWORD\n" + control +
         "*MAT_RIGID\n1,2.0,1.0,0.3\n0\n\n*SECTION_SOLID\n1,1\n*PART\nbox\n1,1,1\n*NODE\n1,0,0,0\n2,1,0,0\n"
         "3,1,2,0\n4,0,2,0\n5,0,0,3\n6,1,0,3\n7,1,2,3\n8,0,2,3\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";
}

/// A soft cube above the box, with a common face that does not share nodes.
inline const std::string cube =
    "*MAT_ELASTIC\n2,2.0,1e3,0.3\n*PART\nsoft\n2,1,2\n*NODE\n11,0,0,3\n12,1,0,3\n13,1,2,3\n14,0,2,3\n15,0,0,"
    "4\n"
    "16,1,0,4\n17,1,2,4\n18,0,2,4\n*ELEMENT_SOLID\n2,2,11,12,13,14,15,16,17,18\n";

}  // namespace cleave::solver::test
