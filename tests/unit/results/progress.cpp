#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>

#include <algorithm>

#include "small_run.hpp"

namespace cleave::results::test {
namespace {

/// What a run of three slow steps writes to its stderr, a terminal or a pipe.
std::string shown(bool terminal) {
  SmallRun run(terminal ? "terminal" : "pipe");
  int master = -1, slave = -1;
  if (terminal) {
    if (::openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return "no terminal";
  } else {
    int ends[2];
    if (::pipe(ends) != 0) return "no pipe";
    master = ends[0], slave = ends[1];
  }
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(slave, STDERR_FILENO);
    ::close(master);
    Options options = run.options();
    options.progress = true;
    Recorder recorder(run.model, options);
    recorder.begin(run.frame());
    for (run.state.cycle = 1; run.state.cycle <= 3; ++run.state.cycle) {
      ::usleep(120000);  // lines are at least 200 ms apart: one line in these 360 ms
      run.update();
      recorder.after_step(run.frame());
    }
    recorder.finish(run.frame(), solver::Ending::end_time, {});
    ::_exit(0);
  }
  ::close(slave);
  std::string text;
  char piece[4096];
  for (ssize_t got = 0; (got = ::read(master, piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(got));
  ::close(master);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST(Progress, RunsAlongOnATerminalAndLeavesACleanLine) {
  const std::string text = shown(true);
  const auto lines = std::count(text.begin(), text.end(), '%');
  EXPECT_TRUE(lines >= 1 && lines <= 3)
      << text;  // one, or more on a machine so busy that each step takes long
  EXPECT_NE(text.find("left  cycle "), std::string::npos) << text;
  EXPECT_NE(text.find("step 0.01  energy ratio 1.0000\033[K"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\r\033[K")) << text;
}

TEST(Progress, IsSilentElsewhere) {
  EXPECT_EQ(shown(false), "");
}

}  // namespace
}  // namespace cleave::results::test
