#pragma once
/// Signals and sense switches, turned into the solver's wishes.

#include <atomic>
#include <filesystem>
#include <thread>

#include "solver/solver.hpp"

namespace cleave::app {

/// While it lives: SIGINT and SIGTERM ask the run to finish the cycle, write a restart and end (a second one
/// ends the program at once); `sw1 sw2 sw3 sw4` do what users know, typed at a terminal or written into a
/// file `d3kil` in the run directory or the working folder. The file is removed when it has been read.
class Switches {
 public:
  Switches(solver::Wishes& wishes, std::filesystem::path run_directory);
  ~Switches();
  Switches(const Switches&) = delete;
  Switches& operator=(const Switches&) = delete;

  /// The signal that asked for the end, 0 for none.
  static int signal_received();

 private:
  void watch();
  void obey(std::string_view text);

  solver::Wishes& wishes_;
  std::filesystem::path run_directory_;
  std::atomic<bool> done_{false};
  std::thread watcher_;
};

}  // namespace cleave::app
