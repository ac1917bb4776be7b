/// The inputs the fuzzer found telling: reading them must neither crash nor hang, and twice gives the same
/// words.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Corpus, ReadsTheSameTwice) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(CLEAVE_SOURCE_DIR) /
                                                               "tests/fuzz/corpus/read_deck")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto words = [&] {
      Diagnostics diagnostics;
      ReadOptions options;
      options.follow_includes = false;
      const Deck deck = Deck::read_text(text, "corpus.k", options, diagnostics);
      std::string fields;
      for (const Block& b : deck.blocks()) {
        for (const Card& c : deck.cards(b, diagnostics)) {
          for (const std::string& f : c.given_fields()) fields += f + " ";
        }
      }
      return fields + diagnostics.render(deck.sources(), false);
    };
    EXPECT_EQ(words(), words()) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace cleave::deck
