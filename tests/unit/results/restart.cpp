#include "results/restart.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <cstring>

#include "../base/same_bits.hpp"
#include "small_run.hpp"

namespace cleave::results::test {
namespace {

using base::test::same_bits;

class RestartFile : public testing::Test {
 protected:
  RestartFile() : run("restart"), path(run.directory / "restart.h5") {
    std::filesystem::create_directories(run.directory);
    run.state.cycle = 7;
    run.update();
    run.state.memory.push_back({"rigid wall 1", {1.0, -0.0, std::nextafter(1.0, 2.0)}});
    run.state.memory.push_back({"nothing", {}});
    run.state.blocks[0].point = {5.0e-324, 1.0 / 3.0, -1.0e308};
    run.state.added_mass = 0.1;
    run.state.largest_force = std::bit_cast<double>(0x7ff8000000000123u);  // NaN with a payload
    run.state.parts[1].eroded_kinetic = 0.7;
    run.state.energy.initial = 1.0e-17;
  }
  std::string write() { return write_restart(path, run.state, origin); }

  const RestartOrigin origin{"bricks.k", "00ff", "0.1.0", "two bricks", {"/mesh", "/my parts"}, true, 0.25};

  SmallRun run;
  std::filesystem::path path;
};

TEST_F(RestartFile, GivesBackEveryBit) {
  ASSERT_EQ(write(), "");
  const Restart back = read_restart(path);
  ASSERT_EQ(back.error, "");
  const auto &a = run.state, &b = back.state;
  EXPECT_EQ(a.cycle, b.cycle);
  EXPECT_TRUE(same_bits(a.time, b.time) && same_bits(a.step, b.step) && same_bits(a.next_step, b.next_step));
  EXPECT_TRUE(same_bits(a.first_step, b.first_step) && same_bits(a.added_mass, b.added_mass));
  EXPECT_TRUE(same_bits(a.largest_force, b.largest_force));
  EXPECT_TRUE(same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity) &&
              same_bits(a.mass, b.mass));
  EXPECT_EQ(std::memcmp(&a.energy, &b.energy, sizeof a.energy), 0);
  ASSERT_EQ(b.parts.size(), 2u);
  EXPECT_EQ(std::memcmp(a.parts.data(), b.parts.data(), 2 * sizeof a.parts[0]), 0);
  ASSERT_EQ(b.blocks.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(same_bits(a.blocks[k].point, b.blocks[k].point));
    EXPECT_TRUE(same_bits(a.blocks[k].element, b.blocks[k].element));
    EXPECT_TRUE(same_bits(a.blocks[k].alive, b.blocks[k].alive));
  }
  ASSERT_EQ(b.memory.size(), 2u);
  EXPECT_EQ(b.memory[0].name, "rigid wall 1");
  EXPECT_TRUE(same_bits(a.memory[0].values, b.memory[0].values));
  EXPECT_EQ(b.memory[1].name, "nothing");
  EXPECT_TRUE(b.memory[1].values.empty());
  EXPECT_EQ(back.origin.deck, "bricks.k");
  EXPECT_EQ(back.origin.include_paths, origin.include_paths);
  EXPECT_TRUE(back.origin.allow_unsupported);
  EXPECT_EQ(back.origin.end_time, 0.25);
  EXPECT_EQ(misfit(back, run.world, "00ff"), "");
}

TEST_F(RestartFile, SaysThatItIsMissingCutOffOrSomethingElse) {
  EXPECT_NE(read_restart(path).error.find("there is no such file"), std::string::npos);
  ASSERT_EQ(write(), "");
  const auto size = std::filesystem::file_size(path);
  for (const std::uintmax_t left : {size - 1, size / 2, std::uintmax_t{100}, std::uintmax_t{0}}) {
    std::filesystem::resize_file(path, left);
    EXPECT_NE(read_restart(path).error.find("cut off"), std::string::npos) << left;
  }
  std::ofstream(path) << "*KEYWORD\n*END\n";
  EXPECT_NE(read_restart(path).error.find("not an HDF5 file"), std::string::npos);
  H5Fclose(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_NE(read_restart(path).error.find("not a restart file of cleave"), std::string::npos);
}

TEST_F(RestartFile, RefusesAnotherVersionOfTheFormat) {
  ASSERT_EQ(write(), "");
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t item = H5Aopen(file, "format_version", H5P_DEFAULT);
  const std::int64_t later = 99;
  H5Awrite(item, H5T_NATIVE_INT64, &later);
  H5Aclose(item);
  H5Fclose(file);
  EXPECT_NE(read_restart(path).error.find("its format is version 99"), std::string::npos);
}

TEST_F(RestartFile, RefusesAnotherDeckOrModel) {
  ASSERT_EQ(write(), "");
  Restart back = read_restart(path);
  EXPECT_NE(misfit(back, run.world, "00fe").find("has changed since"), std::string::npos);
  back.state.position.resize(3);
  EXPECT_NE(misfit(back, run.world, "00ff").find("1 nodes, the deck 12"), std::string::npos);
}

TEST_F(RestartFile, FingerprintsSeeEveryFileAndWhereItEnds) {
  deck::Diagnostics diagnostics;
  const auto of = [&](const char* text) {
    return fingerprint(deck::Deck::read_text(text, "a.k", {}, diagnostics).sources());
  };
  EXPECT_EQ(of("*KEYWORD\n*END\n"), of("*KEYWORD\n*END\n"));
  EXPECT_NE(of("*KEYWORD\n*END\n"), of("*KEYWORD\n*END \n"));
  EXPECT_EQ(of("*KEYWORD\n").size(), 16u);
}

/// In a child, because the limit cannot be raised again.
TEST_F(RestartFile, AFullDiskLeavesTheOldFile) {
  ASSERT_EQ(write(), "");
  run.state.cycle = 8;
  run.state.position.resize(300000);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100000, 100000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::exit(write() == "File too large" ? 0 : 1);  // with what libraries do at exit
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(read_restart(path).state.cycle, 7);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

}  // namespace
}  // namespace cleave::results::test
