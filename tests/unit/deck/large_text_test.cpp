/// Text of large files, whose memory is given back while rows are taken.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "deck/deck.hpp"

namespace cleave::deck {
namespace {

constexpr int node_count = 500000;  // 28 MB

std::string node_line(int id) {
  std::string text = std::to_string(id) + "," + std::to_string(id) + ".5,0.0,1.25";
  return text + std::string(55 - text.size(), ' ');
}

struct LargeDeck : testing::Test {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("cleave_large_" + std::to_string(::getpid()) + ".k");
  Diagnostics diagnostics;
  LargeDeck() {
    std::ofstream file(path);
    file << "*KEYWORD\n*NODE\n";
    for (int id = 1; id <= node_count; ++id) file << node_line(id) << '\n';
    file << "*END\n";
  }
  ~LargeDeck() override { std::filesystem::remove(path); }

  double sum(const Deck& deck) {
    double total = 0.0;
    for (const Block& block : deck.blocks())
      if (block.keyword == "NODE")
        deck.rows(block, diagnostics, [&](const Row& row) { total += row.real(1); });
    return total;
  }
};

TEST_F(LargeDeck, CanBeReadAgain) {
  const Deck deck = Deck::read(path, {}, diagnostics);
  const double expected = 0.5 * node_count * (node_count + 1.0) + 0.5 * node_count;
  EXPECT_EQ(sum(deck), expected);
  for (const int id : {1, 2, 77777, 250000, node_count})
    EXPECT_EQ(deck.sources().line(0, id + 2), node_line(id)) << id;
  EXPECT_EQ(sum(deck), expected);
  EXPECT_FALSE(diagnostics.failed());
}

TEST_F(LargeDeck, SaysThatItsFileHasChanged) {
  const Deck deck = Deck::read(path, {}, diagnostics);
  EXPECT_GT(sum(deck), 0.0);
  EXPECT_FALSE(diagnostics.failed());
  std::filesystem::resize_file(path, 100);  // reading what was given back would be fatal now
  EXPECT_EQ(deck.sources().line(0, 250000), "");
  EXPECT_EQ(sum(deck), 0.0);
  EXPECT_TRUE(diagnostics.failed());
}

}  // namespace
}  // namespace cleave::deck
