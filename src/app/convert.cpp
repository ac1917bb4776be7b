#include <cstdio>

#include "app/commands.hpp"
#include "results/files.hpp"

namespace cleave::app {

int convert(const Options& options) {
  const Reading reading = read_deck(options);
  print_diagnostics(reading);
  if (reading.failed()) return bad_deck;
  const std::string text = model::write(reading.model);
  if (options.output.empty())
    return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) ? files_failed : done;

  if (const std::string problem = results::write_whole(options.output, text); !problem.empty()) {
    std::fprintf(stderr, "cleave: cannot write %s: %s\n", options.output.c_str(), problem.c_str());
    return files_failed;
  }
  return done;
}

}  // namespace cleave::app
