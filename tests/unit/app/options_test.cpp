/// The command line: what is typed, the habits of other codes' users included.

#include "app/options.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace cleave::app {
namespace {

struct Parsed {
  int status;
  Options options;
};

Parsed parsed(std::initializer_list<const char*> words) {
  std::vector<const char*> line{"cleave"};
  line.insert(line.end(), words);
  Parsed r;
  r.status = parse(static_cast<int>(line.size()), line.data(), r.options);
  return r;
}

TEST(CommandLine, RunTakesEveryOption) {
  const auto [status, o] =
      parsed({"run", "a.k", "-o", "out", "-j", "3", "--end-time", "0.5", "--stop-at-cycle", "12", "-q",
              "--allow-unsupported", "-I", "parts", "-I", "more"});
  EXPECT_EQ(status, -1);
  EXPECT_EQ(o.command, Command::run);
  EXPECT_EQ(o.input, "a.k");
  EXPECT_EQ(o.output, "out");
  EXPECT_EQ(o.threads, 3);
  EXPECT_EQ(o.end_time, 0.5);
  EXPECT_EQ(o.stop_at_cycle, 12);
  EXPECT_TRUE(o.quiet);
  EXPECT_TRUE(o.allow_unsupported);
  EXPECT_EQ(o.include_paths, (std::vector<std::filesystem::path>{"parts", "more"}));
}

TEST(CommandLine, OldHabitsMeanTheSame) {
  for (const auto& [status, o] : {parsed({"i=a.k", "ncpu=2", "o=out", "endtime=1e-3", "memory=200m"}),
                                  parsed({"run", "I=a.k", "NCPU=2", "O=out", "ENDTIME=1e-3", "memory2=20m"}),
                                  parsed({"run", "a.k", "-j", "2", "-o", "out", "--end-time", "1e-3"})}) {
    EXPECT_EQ(status, -1);
    EXPECT_EQ(o.command, Command::run);
    EXPECT_EQ(o.input, "a.k");
    EXPECT_EQ(o.output, "out");
    EXPECT_EQ(o.threads, 2);
    EXPECT_EQ(o.end_time, 1e-3);
  }
  const auto [status, o] = parsed({"check", "i=a.k"});
  EXPECT_EQ(status, -1);
  EXPECT_EQ(o.command, Command::check);
  EXPECT_EQ(o.input, "a.k");
}

// Only the names that other codes know are taken apart: a file name may hold an equals sign.
TEST(CommandLine, AnEqualsSignInAFileNameIsKept) {
  const auto [status, o] = parsed({"run", "speed=100.k", "-o", "v=100"});
  EXPECT_EQ(status, -1);
  EXPECT_EQ(o.input, "speed=100.k");
  EXPECT_EQ(o.output, "v=100");
}

TEST(CommandLine, EveryCommandIsFound) {
  const std::pair<const char*, Command> commands[] = {
      {"run", Command::run},          {"restart", Command::restart}, {"check", Command::check},
      {"view", Command::view},        {"explain", Command::explain}, {"convert", Command::convert},
      {"examples", Command::examples}};
  for (const auto& [name, command] : commands) {
    const auto [status, o] = parsed({name, "word"});
    EXPECT_EQ(status, -1) << name;
    EXPECT_EQ(o.command, command);
  }
}

TEST(CommandLine, WrongUseIsStatusTwo) {
  EXPECT_EQ(parsed({}).status, bad_usage);
  EXPECT_EQ(parsed({"walk"}).status, bad_usage);
  EXPECT_EQ(parsed({"run"}).status, bad_usage);
  EXPECT_EQ(parsed({"run", "a.k", "-j", "0"}).status, bad_usage);
  EXPECT_EQ(parsed({"i=a.k", "ncpu=two"}).status, bad_usage);
  EXPECT_EQ(parsed({"--help"}).status, done);
  EXPECT_EQ(parsed({"run", "--help"}).status, done);
}

}  // namespace
}  // namespace cleave::app
