#pragma once
/// What every kind of result file has in common. One file per writer, one line in writers.inc.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/log.hpp"
#include "results/snapshot.hpp"

namespace cleave::results {

/// What the run directory is told at the start.
struct Options {
  std::filesystem::path directory;                   ///< created when missing
  std::string version;                               ///< of the program
  std::filesystem::path deck;                        ///< main file, for logs and the restart file
  std::string deck_fingerprint;                      ///< of all its text, see fingerprint() in restart.hpp
  std::vector<std::filesystem::path> include_paths;  ///< as given beside the deck; a restart needs them
  bool allow_unsupported = false;                    ///< as given
  double end_time = -1.0;                            ///< as given in place of ENDTIM; negative: not [time]
  bool double_fields = false;                        ///< field files in float64 instead of float32
  bool progress = true;                              ///< a progress line on stderr when that is a terminal
  solver::Wishes* wishes = nullptr;  ///< sense switches served here; also stopped when the disk is full
  const model::Account* account = nullptr;
  std::string deck_messages;  ///< diagnostics of the deck as text, for the log
  std::size_t warnings = 0;   ///< how many of them were warnings
};

/// Files that could not be written. The first reason is told to the user, once; then the run is asked to
/// stop.
class Trouble {
 public:
  explicit Trouble(solver::Wishes* wishes) : wishes_(wishes) {}
  /// @param reason  empty: all is well
  void note(const std::filesystem::path& path, const std::string& reason);
  bool any() const { return !what_.empty(); }
  const std::string& what() const { return what_; }

 private:
  solver::Wishes* wishes_;
  std::string what_;
};

/// What a writer may use; outlives it.
struct Context {
  const model::Model& model;
  const Options& options;
  Trouble& trouble;
  Log& log;
};

class Writer {
 public:
  virtual ~Writer() = default;
  /// Start of a run, or of a restarted one: then `resumed` holds what remember() gave when the restart was
  /// written.
  virtual void begin(const Snapshot& now, const discretisation::Memory* resumed) = 0;
  virtual void after_step(const Snapshot& now) = 0;
  /// The last state, after its after_step() and after the restart file was written.
  virtual void finish(const Snapshot& now, solver::Ending ending,
                      const discretisation::StepStatus& status) = 0;
  /// What begin() needs to go on from here.
  virtual std::vector<double> remember() const = 0;
  /// sw4: an extra frame now. Only field files answer.
  virtual void extra(const Snapshot&) {}
};

struct WriterEntry {
  std::string_view name;  ///< also of its memory in the restart file: "results.NAME"
  /// Null when the model does not ask for this output.
  std::unique_ptr<Writer> (*build)(const Context& context);
};

std::span<const WriterEntry* const> writer_catalogue();

}  // namespace cleave::results
