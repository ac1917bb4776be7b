/// What reading a large deck takes of memory, beside what the model itself needs.

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "deck/deck.hpp"
#include "model/model.hpp"

namespace cleave::model {
namespace {

/// A line of /proc/self/status [bytes].
double status(const std::string& name) {
  std::ifstream lines("/proc/self/status");
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(name + ":")) return 1024.0 * std::stod(line.substr(name.size() + 1));
  return 0.0;
}

/// The peak of resident memory counts from now. False: the system does not let us.
bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good() && status("VmHWM") < status("VmRSS") + 1e6;
}

/// A cube of n^3 hexahedra, in the columns of the format.
void write_cube(const std::filesystem::path& path, int n) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"), std::fclose);
  ASSERT_NE(file, nullptr);
  std::fputs(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1,1.0,200.0,0.3\n*SECTION_SOLID\n1,1\n"
      "*PART\ncube\n1,1,1\n*NODE\n",
      file.get());
  const auto node = [n](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i + 1; };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        std::fprintf(file.get(), "%8d%16.8f%16.8f%16.8f\n", node(i, j, k), 0.1 * i, 0.1 * j, 0.1 * k);
  std::fputs("*ELEMENT_SOLID\n", file.get());
  int id = 0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        std::fprintf(file.get(), "%8d%8d%8d%8d%8d%8d%8d%8d%8d%8d\n", ++id, 1, node(i, j, k),
                     node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
                     node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1));
  std::fputs("*END\n", file.get());
}

template <class T>
double bytes(const std::vector<T>& array) {
  return static_cast<double>(array.size() * sizeof(T));
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

TEST(Reading, TakesLessThanThreeTimesTheArraysOfTheModel) {
  if (sanitized) GTEST_SKIP() << "the sanitizers' own memory is many times what is measured";
  const auto path =
      std::filesystem::temp_directory_path() / ("cleave_memory_" + std::to_string(::getpid()) + ".k");
  write_cube(path, 67);  // 300,763 elements, 38 MB of text
  malloc_trim(0);
  if (!forget_peak()) {
    std::filesystem::remove(path);
    GTEST_SKIP() << "the system does not tell the peak of memory";
  }
  const double before = status("VmRSS");
  deck::Diagnostics diagnostics;
  Account account;
  const deck::Deck deck = deck::Deck::read(path, {}, diagnostics);
  const Model model = build(deck, {}, diagnostics, account);
  const double peak = status("VmHWM") - before;
  std::filesystem::remove(path);
  ASSERT_FALSE(diagnostics.failed());

  const Nodes& nodes = model.mesh.nodes;
  const Elements& solids = model.mesh.solids.at(0);
  ASSERT_EQ(solids.count(), 300763u);
  const double arrays = bytes(nodes.id) + bytes(nodes.position) + bytes(nodes.dense) + bytes(solids.id) +
                        bytes(solids.part) + bytes(solids.node);
  RecordProperty("peak_over_arrays", std::to_string(peak / arrays));
  std::printf("peak %.1f MB, arrays %.1f MB, ratio %.2f\n", 1e-6 * peak, 1e-6 * arrays, peak / arrays);
  EXPECT_GT(peak, arrays) << "not measured";
  EXPECT_LT(peak, 3.0 * arrays);
}

}  // namespace
}  // namespace cleave::model
