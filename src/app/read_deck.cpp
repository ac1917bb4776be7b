#include <unistd.h>

#include <cstdio>

#include "app/commands.hpp"

namespace cleave::app {

Reading read_deck(const Options& options) {
  Reading reading;
  reading.deck =
      deck::Deck::read(options.input, {.include_paths = options.include_paths}, reading.diagnostics);
  reading.model = model::build(*reading.deck, {.allow_unsupported = options.allow_unsupported},
                               reading.diagnostics, reading.account);
  if (options.end_time > 0.0) reading.model.control.end.time = options.end_time;
  return reading;
}

void print_diagnostics(const Reading& reading) {
  using deck::Severity;
  const bool colour = isatty(STDERR_FILENO);
  const std::string text = reading.diagnostics.render(reading.deck->sources(), colour);
  std::fputs(text.c_str(), stderr);
  const auto count = [&](Severity severity) { return reading.diagnostics.count(severity); };
  if (reading.failed())
    std::fprintf(stderr, "cleave: %zu error%s and %zu warning%s; the deck was not accepted\n",
                 count(Severity::error), count(Severity::error) == 1 ? "" : "s", count(Severity::warning),
                 count(Severity::warning) == 1 ? "" : "s");
}

}  // namespace cleave::app
