#pragma once
/// The observer that leaves a picture of the spacetime mesh in the run directory.

#include <filesystem>
#include <string>

#include "solver/solver.hpp"

namespace cleave::results {

/// Writes tents.vtu and tents.png at the end of a run whose solver kept its first tents: spacetime elements
/// coloured by the order in which their tents were solved, with time upwards as the way of the fastest wave.
class TentPicture final : public solver::Observer {
 public:
  explicit TentPicture(std::filesystem::path run_directory) : directory_(std::move(run_directory)) {}

  void begin(const solver::Frame&) override {}
  void after_step(const solver::Frame&) override {}
  void finish(const solver::Frame& frame, solver::Ending, const discretisation::StepStatus&) override;

  /// What went wrong, empty if nothing.
  const std::string& problem() const { return problem_; }

 private:
  std::filesystem::path directory_;
  std::string problem_;
};

}  // namespace cleave::results
