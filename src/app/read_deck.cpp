#include <unistd.h>

#include <cstdio>

#include "app/commands.hpp"

namespace cleave::app {

Reading read_deck(const Options& options, bool needs_end_time) {
  Reading reading;
  reading.deck = deck::Deck::read(
      options.input, {.include_paths = options.include_paths, .refuse_unknown = !options.allow_unsupported},
      reading.diagnostics);
  if (reading.deck->blocks().empty()) {  // one plain error in place of all that an empty model lacks
    if (!reading.failed())
      reading.diagnostics.error({}, {}, {}, "there is no keyword in '" + options.input.string() + "'",
                                "is it a keyword deck? Its first line should be *KEYWORD");
    return reading;
  }
  reading.model = model::build(*reading.deck,
                               {.allow_unsupported = options.allow_unsupported,
                                .end_time = options.end_time,
                                .needs_end_time = needs_end_time},
                               reading.diagnostics, reading.account);
  if (options.verify) reading.model.control.spacetime.verify = true;
  return reading;
}

void print_diagnostics(const Reading& reading) {
  const bool colour = isatty(STDERR_FILENO);
  const std::string text = reading.diagnostics.render(reading.deck->sources(), colour);
  std::fputs(text.c_str(), stderr);
  if (reading.failed()) std::fputs("cleave: the deck was not accepted\n", stderr);
}

}  // namespace cleave::app
