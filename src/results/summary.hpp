#pragma once
/// What a run came to: summary.json for programs, a table for people.

#include <string>
#include <string_view>
#include <vector>

#include "results/extents.hpp"
#include "results/writer.hpp"

namespace cleave::results {

/// "end_time", "step_too_small", ...: as in summary.json.
std::string_view name_of(solver::Ending ending);
/// The ending in words: "the end time was reached".
std::string_view describe(solver::Ending ending);
/// Did the run end as the deck asked (also by a switch), or by an error?
bool is_normal(solver::Ending ending);

/// Follows a run and sums it up at its end.
class Summary {
 public:
  explicit Summary(const Context& context) : context_(context) {}

  void begin(const Snapshot& now, const discretisation::Memory* resumed);
  void after_step(const Snapshot& now);
  void finish(const Snapshot& now, solver::Ending ending, const discretisation::StepStatus& status);
  std::vector<double> remember() const;

  /// After finish(). Numbers that are not finite become null.
  std::string json(const solver::Outcome& outcome) const;
  /// After finish().
  std::string text(const solver::Outcome& outcome) const;

 private:
  struct Range {
    double low = 1.0e300, high = -1.0e300;
    void include(double value) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  };
  struct PartFacts {
    double mass = 0.0;
    discretisation::PartEnergy energy;
    double kinetic = 0.0;
    Extent before, after;
    PartAxes axes;
  };

  Context context_;
  std::vector<PartAxes> axes_;
  std::vector<Extent> before_;
  Range step_, ratio_, kinetic_, internal_, hourglass_;

  // Known from finish() on.
  solver::Ending ending_ = solver::Ending::end_time;
  discretisation::StepStatus status_;
  discretisation::Energy energy_;
  double time_ = 0.0, last_step_ = 0.0, first_step_ = 0.0, mass_ = 0.0, added_mass_ = 0.0, base_mass_ = 0.0;
  std::int64_t cycles_ = 0;
  std::vector<PartFacts> parts_;
  double bytes_ = 0.0;  // of blocks and nodes
};

}  // namespace cleave::results
