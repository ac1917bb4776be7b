#pragma once
/// Everything that is written during a run, behind one observer.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/summary.hpp"
#include "results/writer.hpp"

namespace cleave::results {

/// Owns the writers of the catalogue, the restart file and the summary of one run directory.
///
/// In begin() a state that carries the memory of a recorder (it comes from a restart file) continues the
/// files of the directory: what was written after the restart point is cut off. Any other state starts them
/// anew.
class Recorder final : public solver::Observer {
 public:
  /// @param model    must outlive the recorder
  Recorder(const model::Model& model, Options options);
  ~Recorder() override;

  void begin(const solver::Frame& frame) override;
  void after_step(const solver::Frame& frame) override;
  void finish(const solver::Frame& frame, solver::Ending ending,
              const discretisation::StepStatus& status) override;

  /// Writes summary.json; after the solver has come back.
  void summarise(const solver::Outcome& outcome);
  /// The table for people at the end of a run; after the solver has come back.
  std::string text_summary(const solver::Outcome& outcome) const;

  /// Could some file not be written? Then the run was asked to stop and the program must not exit with 0.
  bool failed() const { return trouble_.any(); }
  const std::string& failure() const { return trouble_.what(); }

 private:
  void write_restart(const solver::Frame& frame, const std::string& name);
  void serve_restarts(const solver::Frame& frame);

  Options options_;
  Trouble trouble_;
  Log log_;
  Context context_;
  struct Named {
    std::string name;
    std::unique_ptr<Writer> writer;
  };
  std::vector<Named> writers_;
  Summary summary_;
  std::optional<Masses> masses_;
};

}  // namespace cleave::results
