#include "results/writer.hpp"

#include <cstdio>

namespace cleave::results {

#define CLEAVE_WRITER(name) extern const WriterEntry name;
#include "results/writers.inc"
#undef CLEAVE_WRITER

std::span<const WriterEntry* const> writer_catalogue() {
  static const WriterEntry* const entries[] = {
#define CLEAVE_WRITER(name) &name,
#include "results/writers.inc"
#undef CLEAVE_WRITER
  };
  return entries;
}

void Trouble::note(const std::filesystem::path& path, const std::string& reason) {
  if (reason.empty() || any()) return;
  what_ = "cannot write " + path.string() + ": " + reason;
  std::fprintf(stderr, "\n%s\nthe run stops; what was written before is whole\n", what_.c_str());
  if (wishes_) wishes_->stop = true;
}

}  // namespace cleave::results
