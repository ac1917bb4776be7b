#pragma once
/// The observer that leaves pictures in the run directory.

#include <filesystem>
#include <string>

#include "solver/solver.hpp"

namespace cleave::results {

struct PictureWriterOptions {
  bool initial = false;                            ///< also initial.png, before the first step
  std::string field = "effective_plastic_strain";  ///< of the blocks; displacement where no block has it
};

/// Writes picture.png of the last state, and initial.png of the first where it is wanted. Spacetime parts
/// show the length of their velocity.
class PictureWriter : public solver::Observer {
 public:
  explicit PictureWriter(std::filesystem::path run_directory, PictureWriterOptions options = {});

  void begin(const solver::Frame& frame) override;
  void after_step(const solver::Frame&) override;
  void finish(const solver::Frame& frame, solver::Ending ending,
              const discretisation::StepStatus& status) override;

  /// What went wrong, empty if nothing: a run does not fail for want of its picture.
  const std::string& problem() const { return problem_; }

 private:
  void write(const solver::Frame& frame, const char* name);
  void write_cells(const solver::Frame& frame, const char* name);

  std::filesystem::path directory_;
  PictureWriterOptions options_;
  std::string problem_;
};

}  // namespace cleave::results
