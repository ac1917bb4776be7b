#include "results/log.hpp"

#include <ctime>

#include "results/text.hpp"
#include "results/writer.hpp"

namespace cleave::results {

void Log::open(const std::filesystem::path& path, bool go_on) {
  path_ = path;
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  trouble_.note(path_, file_.open(path, go_on && !missing ? size : 0));
}

void Log::write(std::string_view lines) {
  if (!file_.is_open() || trouble_.any()) return;
  trouble_.note(path_, file_.append(lines));
}

void Log::event(const discretisation::State& state, std::string_view what) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char clock[24];
  std::strftime(clock, sizeof clock, "%m/%d/%y %H:%M:%S", &local);
  std::string line;
  append_format(line, "%8lld t %10.4E dt %8.2E %-28s %s\n", static_cast<long long>(state.cycle), state.time,
                state.step > 0.0 ? state.step : state.next_step, std::string(what).c_str(), clock);
  write(line);
}

}  // namespace cleave::results
