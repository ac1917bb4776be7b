#include <cstdio>

#include "app/commands.hpp"
#include "results/report.hpp"

namespace cleave::app {

int view(const Options& options) {
  const results::ReportOutcome outcome = results::write_report(options.input);
  if (!outcome.ok) {
    std::fprintf(stderr, "cleave: %s\n", outcome.message.c_str());
    return files_failed;
  }
  for (const std::string& note : outcome.notes) std::fprintf(stderr, "note: %s\n", note.c_str());
  std::printf("%s\n", outcome.page.c_str());
  return done;
}

}  // namespace cleave::app
