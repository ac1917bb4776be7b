/// The line that runs along on a terminal: how far, how long yet.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "results/log.hpp"
#include "results/text.hpp"
#include "results/writer.hpp"

namespace cleave::results {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto pause = std::chrono::milliseconds(200);

class Progress final : public Writer {
 public:
  explicit Progress(const Context& context)
      : context_(context), shown_(context.options.progress && ::isatty(STDERR_FILENO)) {}

  void begin(const Snapshot& now, const discretisation::Memory*) override {
    start_ = last_ = Clock::now();
    first_ = fraction(now.state());
  }

  void after_step(const Snapshot& now) override {
    if (context_.options.wishes && context_.options.wishes->report.exchange(false)) {
      now.evaluate(solver::energies);
      std::fprintf(stderr, "%s%s\n", shown_ ? "\r\033[K" : "", line(now.state()).c_str());
      context_.log.event(now.state(), "sw2: reported");
    }
    if (!shown_) return;
    const auto at = Clock::now();
    if (at - last_ < pause) return;
    last_ = at;
    now.evaluate(solver::energies);
    std::fprintf(stderr, "\r%s\033[K", line(now.state()).c_str());
    std::fflush(stderr);
  }

  void finish(const Snapshot&, solver::Ending, const discretisation::StepStatus&) override {
    if (shown_) std::fputs("\r\033[K", stderr);  // the summary follows on a clean line
  }

  std::vector<double> remember() const override { return {}; }

 private:
  /// Of the end time or the cycle limit, whichever is nearer.
  double fraction(const discretisation::State& state) const {
    const model::Termination& end = context_.model.control.end;
    double part = end.time > 0.0 ? state.time / end.time : 0.0;
    if (end.cycles > 0)
      part = std::max(part, static_cast<double>(state.cycle) / static_cast<double>(end.cycles));
    return std::min(part, 1.0);
  }

  std::string line(const discretisation::State& state) const {
    const double part = fraction(state);
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const double left = part > first_ ? elapsed * (1.0 - part) / (part - first_) : -1.0;
    std::string text;
    append_format(text, "%5.1f %%  %s left  cycle %lld  time %.4g  step %.3g  energy ratio %.4f",
                  100.0 * part, duration(left).c_str(), static_cast<long long>(state.cycle), state.time,
                  state.step, state.energy.ratio());
    return text;
  }

  Context context_;
  bool shown_;
  Clock::time_point start_, last_;
  double first_ = 0.0;
};

std::unique_ptr<Writer> build(const Context& context) {
  return std::make_unique<Progress>(context);
}

}  // namespace

extern const WriterEntry progress{"progress", build};

}  // namespace cleave::results
