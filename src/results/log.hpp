#pragma once
/// messag: what happened during the run, in words, line by line.

#include <filesystem>
#include <string>
#include <string_view>

#include "discretisation/state.hpp"
#include "results/files.hpp"

namespace cleave::results {

class Trouble;

class Log {
 public:
  explicit Log(Trouble& trouble) : trouble_(trouble) {}

  /// Starts the file, or goes on with the one of an earlier leg of the run.
  void open(const std::filesystem::path& path, bool go_on);
  /// Whole lines; nothing before open() or after a failed write.
  void write(std::string_view lines);
  /// One line of the established layout: cycle, time, step, what, date and time of day.
  void event(const discretisation::State& state, std::string_view what);

 private:
  Trouble& trouble_;
  std::filesystem::path path_;
  GrowingFile file_;
};

}  // namespace cleave::results
