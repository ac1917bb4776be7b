#include <cstdio>

#include "app/commands.hpp"
#include "app/simulate.hpp"
#include "base/threads.hpp"
#include "results/restart.hpp"

namespace cleave::app {
namespace {

/// taylor.k -> taylor.run, in the working folder.
std::filesystem::path run_directory(const Options& options) {
  return options.output.empty() ? options.input.stem().concat(".run") : options.output;
}

/// Makes the run directory. One that holds anything but a run is left alone: results replace files by name.
bool prepare(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    std::fprintf(stderr, "cleave: cannot make the run directory %s: %s\n", directory.c_str(),
                 error.message().c_str());
    return false;
  }
  if (std::filesystem::is_empty(directory, error) || std::filesystem::exists(directory / "messag"))
    return true;
  std::fprintf(stderr, "cleave: %s holds files that are not of a run; name another folder with -o\n",
               directory.c_str());
  return false;
}

/// NOSOL of *CONTROL_TERMINATION: what `cleave check` says, and no run directory.
int run_nothing(const Options& options) {
  const int status = check(options);
  std::printf("\n  NOSOL = 1: nothing was computed\n");
  return status;
}

}  // namespace

/// The whole program on one page: deck -> model -> world -> state -> solver and observers.
int run(const Options& options) {
  base::set_thread_count(options.threads);

  Reading reading = read_deck(options);
  if (reading.model.control.end.no_solution_check && !reading.failed()) return run_nothing(options);
  print_diagnostics(reading);
  if (reading.failed()) return bad_deck;

  const auto world = build_world(reading);
  if (!world) return bad_deck;
  discretisation::State state;
  if (const auto status = discretisation::initialise(*world, state); !status.ok) {
    print_unfit(reading, status);
    return bad_deck;
  }

  const std::filesystem::path directory = run_directory(options);
  if (!prepare(directory)) return files_failed;
  return simulate({.options = options,
                   .reading = reading,
                   .world = *world,
                   .directory = directory,
                   .deck_messages = reading.diagnostics.render(reading.deck->sources(), false),
                   .deck_fingerprint = results::fingerprint(reading.deck->sources())},
                  state);
}

}  // namespace cleave::app
