#pragma once
/// What was typed: the command and its options.

#include <filesystem>
#include <string>
#include <vector>

namespace cleave::app {

enum class Command { none, run, restart, check, view, explain, convert, examples };

struct Options {
  Command command = Command::none;
  std::filesystem::path input;   ///< deck, or run directory for view and restart
  std::filesystem::path output;  ///< run directory or file; empty: derived from the input
  std::vector<std::filesystem::path> include_paths;
  std::string keyword;  ///< of explain; name of examples
  int threads = 0;      ///< 0: one per core
  bool allow_unsupported = false;
  bool quiet = false;
  int tents = 0;                   ///< spacetime parts: draw so many of the first tents
  bool verify = false;             ///< hold every spacetime patch to its balances
  double end_time = -1.0;          ///< replaces ENDTIM when given [time]
  std::int64_t stop_at_cycle = 0;  ///< write a restart and stop there
};

/// Exit statuses of the program; docs/command-line.md lists them for users.
enum Exit : int {
  done = 0,
  internal_error = 1,
  bad_usage = 2,
  bad_deck = 3,
  physics_failed = 4,
  files_failed = 5
};

/// Reads the command line; both `cleave run taylor.k --threads 2` and `cleave i=taylor.k ncpu=2`.
/// @return -1 to go on with `options`, else the exit status (help and usage errors are printed).
int parse(int argc, const char* const* argv, Options& options);

}  // namespace cleave::app
