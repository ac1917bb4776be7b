#include "results/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "results/clock.hpp"

namespace cleave::results {
namespace {

class Files : public testing::Test {
 protected:
  Files()
      : directory(std::filesystem::temp_directory_path() / ("cleave_files_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(directory);
  }
  ~Files() override { std::filesystem::remove_all(directory); }
  std::string text(const std::string& name) const {
    std::ifstream file(directory / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::filesystem::path directory;
};

TEST_F(Files, AnUnfinishedFileLeavesTheOldOneAlone) {
  ASSERT_EQ(write_whole(directory / "a", "old"), "");
  {
    WholeFile file(directory / "a");
    file.write("new");
    EXPECT_EQ(text("a"), "old");
  }
  EXPECT_EQ(text("a"), "old");
  EXPECT_FALSE(std::filesystem::exists(directory / "a.part"));
}

TEST_F(Files, LargeAndSmallPiecesKeepTheirOrder) {
  std::string expected;
  WholeFile file(directory / "a");
  for (int i = 0; i < 40; ++i) {
    const std::string piece(static_cast<std::size_t>(i % 4 == 3 ? 1500000 : 100000 + i),
                            static_cast<char>('a' + i % 26));
    expected += piece;
    file.write(piece);
  }
  ASSERT_EQ(file.commit(), "");
  EXPECT_TRUE(text("a") == expected);
}

/// A child rewrites a file of 4 MB, every byte the same, until it is killed; what is left must be of one
/// piece.
TEST_F(Files, AKillLeavesAWholeFile) {
  const std::size_t size = 4u << 20;
  ASSERT_EQ(write_whole(directory / "a", std::string(size, 'x')), "");
  for (int round = 0; round < 5; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (char c = 'a';; c = c == 'z' ? 'a' : static_cast<char>(c + 1))
        if (!write_whole(directory / "a", std::string(size, c)).empty()) ::_exit(1);
    }
    ::usleep(20000 + 7000 * static_cast<unsigned>(round));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string left = text("a");
    ASSERT_EQ(left.size(), size);
    EXPECT_EQ(left.find_first_not_of(left[0]), std::string::npos);
  }
}

TEST_F(Files, AGrowingFileIsCutWhereTheRestartWas) {
  GrowingFile file;
  ASSERT_EQ(file.open(directory / "a", 0), "");
  ASSERT_EQ(file.append("one\n"), "");
  const auto keep = file.size();
  ASSERT_EQ(file.append("two\n"), "");
  ASSERT_EQ(file.open(directory / "a", keep), "");
  ASSERT_EQ(file.append("three\n"), "");
  EXPECT_EQ(text("a"), "one\nthree\n");
  ASSERT_EQ(file.open(directory / "a", 1000), "");  // a restart of another directory: begin anew
  EXPECT_EQ(file.size(), 0u);
  EXPECT_EQ(text("a"), "");
}

/// In a child, because the limit cannot be raised again: a piece that does not fit is taken back whole.
TEST_F(Files, AFullDiskTakesBackTheBrokenLine) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    GrowingFile file;
    bool good = file.open(directory / "a", 0).empty() && file.append(std::string(4000, 'a') + '\n').empty();
    good = good && file.append(std::string(200, 'b') + '\n') == "File too large" && file.size() == 4001;
    good = good && write_whole(directory / "b", std::string(5000, 'c')) == "File too large";
    ::_exit(good ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(std::filesystem::file_size(directory / "a"), 4001u);
  EXPECT_FALSE(std::filesystem::exists(directory / "b"));
  EXPECT_FALSE(std::filesystem::exists(directory / "b.part"));
}

TEST(FullDevice, IsReported) {
  GrowingFile file;
  ASSERT_EQ(file.open("/dev/full", 0), "");
  EXPECT_NE(file.append("line\n").find("No space left on device"), std::string::npos);
}

TEST(Clock, CountsMultiplesAndSurvivesRounding) {
  const std::vector<model::Curve> none;
  Clock clock({.every = 0.1}, none);
  int written = 0;
  double time = 0.0;
  for (int cycle = 0; cycle <= 1000; ++cycle, time += 0.001)  // sums to 0.0999999... in places
    if (clock.due(time)) {
      ++written;
      clock.advance(time);
    }
  EXPECT_EQ(written, 11);
  EXPECT_NEAR(clock.next(), 1.1, 1e-12);
}

TEST(Clock, WritesOnceWhenACycleSpansSeveralInstants) {
  const std::vector<model::Curve> none;
  Clock clock({.every = 0.1}, none);
  clock.advance(0.0);
  EXPECT_TRUE(clock.due(0.35));
  clock.advance(0.35);
  EXPECT_FALSE(clock.due(0.39));
  EXPECT_TRUE(clock.due(0.4));
}

TEST(Clock, FollowsACurveOfIntervals) {
  std::vector<model::Curve> curves(1);
  curves[0].x = {0.0, 1.0};
  curves[0].y = {0.1, 0.1};
  Clock clock({.curve = 0}, curves);
  EXPECT_TRUE(clock.due(0.0));
  clock.advance(0.0);
  EXPECT_FALSE(clock.due(0.05));
  EXPECT_TRUE(clock.due(0.1));
}

TEST(Clock, IsNeverDueWithoutAnInterval) {
  EXPECT_FALSE(Clock({}, {}).due(1.0e30));
}

}  // namespace
}  // namespace cleave::results
