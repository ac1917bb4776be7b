#include "results/restart.hpp"

#include <cstdio>

#include "app/simulate.hpp"
#include "base/threads.hpp"

namespace cleave::app {

/// The deck is read again from where the restart file says it was; its text must not have changed. What the
/// command line said about it holds on, but for an end time given now.
int restart(const Options& asked) {
  base::set_thread_count(asked.threads);
  const bool is_folder = std::filesystem::is_directory(asked.input);
  const std::filesystem::path file = is_folder ? asked.input / "restart.h5" : asked.input;

  results::Restart saved = results::read_restart(file);
  if (!saved.error.empty()) {
    std::fprintf(stderr, "cleave: %s\n", saved.error.c_str());
    return files_failed;
  }

  Options options = asked;
  options.input = saved.origin.deck;
  options.include_paths = saved.origin.include_paths;
  options.allow_unsupported = saved.origin.allow_unsupported;
  if (options.end_time < 0.0) options.end_time = saved.origin.end_time;
  Reading reading = read_deck(options);
  print_diagnostics(reading);
  if (reading.failed()) return bad_deck;
  const auto world = build_world(reading);
  if (!world) return bad_deck;

  const std::string fingerprint = results::fingerprint(reading.deck->sources());
  if (const std::string problem = results::misfit(saved, *world, fingerprint); !problem.empty()) {
    std::fprintf(stderr, "cleave: %s does not fit %s: %s\n", file.c_str(), options.input.c_str(),
                 problem.c_str());
    return bad_deck;
  }
  return simulate({.options = options,
                   .reading = reading,
                   .world = *world,
                   .directory = is_folder ? asked.input : asked.input.parent_path(),
                   .deck_messages = {},
                   .deck_fingerprint = fingerprint},
                  saved.state);
}

}  // namespace cleave::app
