#include <cstdio>
#include <fstream>

#include "app/commands.hpp"

namespace cleave::app {

int convert(const Options& options) {
  const Reading reading = read_deck(options);
  print_diagnostics(reading);
  if (reading.failed()) return bad_deck;
  const std::string text = model::write(reading.model);
  if (options.output.empty())
    return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) ? files_failed : done;

  // Whole or not at all: written beside the target, then renamed over it.
  const std::filesystem::path part = options.output.string() + ".part";
  std::ofstream file(part, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(part, options.output, error);
  if (!file || error) {
    std::fprintf(stderr, "cleave: cannot write %s\n", options.output.c_str());
    std::filesystem::remove(part, error);
    return files_failed;
  }
  return done;
}

}  // namespace cleave::app
