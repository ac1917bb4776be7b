#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "reading.hpp"

namespace cleave::deck {
namespace {

namespace fs = std::filesystem;

/// A folder of deck files that goes when the test ends.
class Include : public ::testing::Test {
 protected:
  Include() {
    folder_ = fs::temp_directory_path() / ("cleave_include_" + std::to_string(::getpid()) + "_" +
                                           ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  ~Include() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  Deck read(const std::string& name = "main.k") { return Deck::read(folder_ / name, options_, diagnostics_); }
  std::string rendered(const Deck& deck) { return diagnostics_.render(deck.sources(), false); }
  /// Ids of every *MAT_ELASTIC in reading order.
  std::vector<std::int64_t> materials(const Deck& deck) {
    std::vector<std::int64_t> ids;
    for (const Block& block : deck.blocks()) {
      if (block.keyword != "MAT_ELASTIC") continue;
      for (const Card& card : deck.cards(block, diagnostics_)) ids.push_back(card.integer("MID"));
    }
    return ids;
  }

  fs::path folder_;
  ReadOptions options_;
  Diagnostics diagnostics_;
};

const std::string mat1 = "*MAT_ELASTIC\n1,1.\n", mat2 = "*MAT_ELASTIC\n2,1.\n", mat3 = "*MAT_ELASTIC\n3,1.\n";

TEST_F(Include, SeveralNamesInReadingOrder) {
  write("main.k", "*KEYWORD\n*INCLUDE\na.k\n$ remark\n./sub/../b c.k\n" + mat3 + "*END\n");
  write("a.k", mat1 + "*END\n*MAT_ELASTIC\n9,1.\n");
  write("b c.k", mat2);
  fs::create_directories(folder_ / "sub");
  const Deck deck = read();
  EXPECT_EQ(materials(deck), (std::vector<std::int64_t>{1, 2, 3})) << rendered(deck);
  EXPECT_FALSE(diagnostics_.failed()) << rendered(deck);
  EXPECT_EQ(deck.sources().file(1).included_from.line, 3);
}

TEST_F(Include, NamesGoOnInTheNextLine) {
  write("main.k", "*INCLUDE\nlong_ +\nname +\n.k\n");
  write("long_name.k", mat1);
  const Deck deck = read();
  EXPECT_EQ(materials(deck).size(), 1u) << rendered(deck);
}

TEST_F(Include, BackslashesAndSearchPaths) {
  write("main.k", "*INCLUDE_PATH\n" + (folder_ / "lib").string() +
                      "\n*INCLUDE_PATH_RELATIVE\nmore\n*INCLUDE\nsub\\a.k\nb.k\nc.k\n");
  write("sub/a.k", "*INCLUDE\nb.k\nbeside.k\n");
  write("sub/beside.k", mat3);
  write("lib/b.k", mat1);
  write("more/c.k", mat2);
  const Deck deck = read();
  EXPECT_EQ(materials(deck), (std::vector<std::int64_t>{1, 3, 1, 2})) << rendered(deck);
}

TEST_F(Include, PathsOfTheCallerServeToo) {
  write("main.k", "*INCLUDE\na.k\n");
  write("elsewhere/a.k", mat1);
  options_.include_paths.push_back(folder_ / "elsewhere");
  EXPECT_EQ(materials(read()).size(), 1u);
}

TEST_F(Include, MissingFilesSayWhoAskedAndWhere) {
  write("main.k", "*INCLUDE\nsub/a.k\n");
  write("sub/a.k", "*INCLUDE_PATH\n" + folder_.string() + "/lib\n*INCLUDE\n  nowhere.k\n");
  const Deck deck = read();
  const std::string text = rendered(deck);
  EXPECT_EQ(diagnostics_.count(Severity::error), 1u);
  EXPECT_NE(text.find("in file included from " + (folder_ / "main.k").string() + ":2"), std::string::npos)
      << text;
  EXPECT_NE(text.find("sub/a.k:4:3: error: *INCLUDE FILENAME: the file 'nowhere.k' is not found"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("/lib'"), std::string::npos) << text;
}

TEST_F(Include, SelfIncludeAndDeepNesting) {
  write("main.k", "*INCLUDE\na.k\n" + mat1);
  write("a.k", "*INCLUDE\nmain.k\n" + mat2);
  Deck deck = read();
  EXPECT_EQ(diagnostics_.count(Severity::error), 1u);
  EXPECT_NE(rendered(deck).find("the file 'main.k' includes itself"), std::string::npos) << rendered(deck);
  EXPECT_EQ(materials(deck), (std::vector<std::int64_t>{2, 1}));

  for (int i = 0; i < 100; ++i)
    write("d" + std::to_string(i) + ".k", "*INCLUDE\nd" + std::to_string(i + 1) + ".k\n");
  diagnostics_ = Diagnostics();
  deck = read("d0.k");
  EXPECT_NE(rendered(deck).find("more than 64 deep"), std::string::npos);
}

TEST_F(Include, ManyBranchesStop) {
  // Each file includes the next twice: 2^40 files if nobody counted.
  for (int i = 0; i < 40; ++i) {
    const std::string next = "e" + std::to_string(i + 1) + ".k\n";
    write("e" + std::to_string(i) + ".k", "*INCLUDE\n" + next + next);
  }
  write("e40.k", mat1);
  const Deck deck = read("e0.k");
  EXPECT_NE(rendered(deck).find("more than 10000 files"), std::string::npos);
}

TEST_F(Include, FormatIsInheritedUnlessKeywordSaysOtherwise) {
  const std::string wide = "*MAT_ELASTIC\n                   7                  1.\n";
  write("main.k", "*KEYWORD LONG=Y\n*INCLUDE\na.k\nb.k\n" + wide);
  write("a.k", wide);
  write("b.k", "*KEYWORD\n*MAT_ELASTIC\n         8        1.\n");
  const Deck deck = read();
  EXPECT_EQ(materials(deck), (std::vector<std::int64_t>{7, 8, 7})) << rendered(deck);
}

TEST_F(Include, TransformsAreRecordedAndCombined) {
  write("main.k",
        "*INCLUDE_TRANSFORM\na.k\n       100       200       300       400       500       600       700\n   "
        "    800\n"
        "     1000.       0.5        2.      FtoK\n         9\n*MAT_ELASTIC\n1,1.\n");
  write("a.k", mat1 + "*INCLUDE_TRANSFORM\nb.k\n1,2,3,4,5,6,7\n8\n,,3.,KtoC\n*MAT_ELASTIC\n5,1.\n");
  write("b.k", mat2);
  const Deck deck = read();
  EXPECT_FALSE(diagnostics_.failed()) << rendered(deck);
  std::vector<int> used;
  for (const Block& b : deck.blocks()) {
    if (b.keyword == "MAT_ELASTIC") used.push_back(b.transform);
  }
  EXPECT_EQ(used, (std::vector<int>{1, 2, 1, 0}));
  const IncludeTransform& outer = deck.transforms()[1];
  EXPECT_EQ(outer.node_offset, 100);
  EXPECT_EQ(outer.definition_offset, 700);
  EXPECT_EQ(outer.other_offset, 800);
  EXPECT_EQ(outer.mass, 1000.0);
  EXPECT_EQ(outer.time, 0.5);
  EXPECT_EQ(outer.length, 2.0);
  EXPECT_EQ(outer.transformation, 9);
  EXPECT_DOUBLE_EQ(outer.temperature_factor * (32.0 + outer.temperature_shift), 273.15);
  const IncludeTransform& inner = deck.transforms()[2];
  EXPECT_EQ(inner.parent, 1);
  EXPECT_EQ(inner.node_offset, 101);
  EXPECT_EQ(inner.part_offset, 303);
  EXPECT_EQ(inner.other_offset, 808);
  EXPECT_EQ(inner.length, 6.0);
  EXPECT_EQ(inner.mass, 1000.0);
  EXPECT_EQ(inner.transformation, 0);
  // 300 K is 26.85 C; taken as Fahrenheit by the outer rule that is 270.289 K.
  EXPECT_NEAR(inner.temperature_factor * (300.0 + inner.temperature_shift), (26.85 + 459.67) * 5.0 / 9.0,
              1e-10);
}

TEST_F(Include, MistakesInTransforms) {
  write("main.k", "*INCLUDE_TRANSFORM\na.k\n1\n,,pre\n-1.,,,XtoY\n*INCLUDE_TRANSFORM\n");
  write("a.k", mat1);
  const Deck deck = read();
  const std::string text = rendered(deck);
  EXPECT_NE(text.find("a unit factor must be positive"), std::string::npos) << text;
  EXPECT_NE(text.find("found 'XtoY', expected a change of scale"), std::string::npos) << text;
  EXPECT_NE(text.find("PREFIX: the field is not honoured"), std::string::npos) << text;
  EXPECT_NE(text.find("no file is named"), std::string::npos) << text;
}

TEST_F(Include, OtherKindsAreRefused) {
  write("main.k", "*INCLUDE_BINARY\na.bin\n*INCLUDE_NASTRAN\nb.nas\n*INCLUDE_STAMPED_PART\nc.k\n*INCLUDE\n" +
                      folder_.string() + "\n");
  const Deck deck = read();
  const std::string text = rendered(deck);
  EXPECT_EQ(diagnostics_.count(Severity::error), 4u) << text;
  EXPECT_NE(text.find("*INCLUDE_NASTRAN: NASTRAN bulk data cannot be included"), std::string::npos) << text;
}

TEST_F(Include, EncryptedPartsAreNamedAndSkipped) {
  write("main.k", "*KEYWORD\n*INCLUDE\na.k\n" + mat2);
  write("a.k", mat1 +
                   "-----BEGIN PGP MESSAGE-----\n*NODE\n\x01\xff garbage\n*MAT_ELASTIC\n-----END PGP "
                   "MESSAGE-----\ntail\n");
  const Deck deck = read();
  EXPECT_EQ(materials(deck), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(diagnostics_.count(Severity::error), 1u);
  EXPECT_NE(rendered(deck).find("a.k:3:1: error: this part of the deck is encrypted"), std::string::npos)
      << rendered(deck);
}

TEST_F(Include, LocalParametersStayInTheirFiles) {
  write("main.k", "*PARAMETER\nRx, 1.\n*INCLUDE\na.k\n*CONTROL_CPU\n&x\n");
  write("a.k", "*PARAMETER_LOCAL\nRx, 2.\nRy, 5.\n*CONTROL_CPU\n&x\n*INCLUDE\nb.k\n");
  write("b.k", "*CONTROL_CPU\n&y\n*CONTROL_CPU\n&x\n");
  const Deck deck = read();
  std::vector<double> values;
  for (const Block& b : deck.blocks()) {
    if (b.keyword == "CONTROL_CPU") values.push_back(deck.cards(b, diagnostics_).at(0).real("CPUTIM"));
  }
  EXPECT_EQ(values, (std::vector<double>{2.0, 5.0, 2.0, 1.0})) << rendered(deck);
}

TEST_F(Include, UnreadableMainFile) {
  const Deck deck = read("not_there.k");
  EXPECT_TRUE(diagnostics_.failed());
  EXPECT_TRUE(deck.blocks().empty());
  EXPECT_NE(rendered(deck).find("cannot be read: there is no such file"), std::string::npos)
      << rendered(deck);
}

}  // namespace
}  // namespace cleave::deck
