/// Every deck of tests/regression/decks parses, or fails exactly as its SOURCES.md says.
#include <filesystem>
#include <map>

#include "reading.hpp"

namespace cleave::deck {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(CLEAVE_SOURCE_DIR) / "tests/regression/decks";
const std::string pydyna = "ansys__pydyna/tests/testfiles/";
const std::string parameters = pydyna + "keywords/expand_parameters/";
const std::string mistakes = pydyna + "keywords/parameter_error_location/";
const std::string ansys = "ansys__example-data/ls-dyna/";
const std::string dynakw = "WillemJR__dynakw/test/full_files/";

struct Sample {
  Diagnostics diagnostics;
  Deck deck;
  std::map<std::string, std::size_t> rows;  ///< of bulk keywords
  std::string shown;

  explicit Sample(const std::string& path, const ReadOptions& options = {})
      : deck(Deck::read(folder / path, options, diagnostics)) {
    for (const Block& b : deck.blocks()) {
      if (!b.known || b.consumed) continue;
      if (b.options.empty() &&
          (b.keyword == "NODE" || b.keyword == "ELEMENT_SOLID" || b.keyword == "ELEMENT_SHELL")) {
        deck.rows(b, diagnostics, [&](const Row& row) {
          ++rows[b.keyword];
          for (int i = 0; i < row.field_count(); ++i) row.real(i);
        });
      } else {
        rows[b.keyword] += deck.cards(b, diagnostics).size();
      }
    }
    shown = diagnostics.render(deck.sources(), false);
  }
  std::size_t errors() const { return diagnostics.count(Severity::error); }
  std::size_t warnings() const { return diagnostics.count(Severity::warning); }
  std::vector<Card> cards(const std::string& keyword) {
    std::vector<Card> all;
    for (const Block& b : deck.blocks()) {
      if (b.keyword != keyword) continue;
      for (const Card& c : deck.cards(b, diagnostics)) all.push_back(c);
    }
    return all;
  }
  bool says(const std::string& words) const { return shown.find(words) != std::string::npos; }
};

struct Expected {
  std::string path;
  std::size_t errors, warnings;
};

/// Nothing is wrong in these, or only what the table of origins says.
TEST(SampleDeck, ErrorsAndWarningsAreAsStated) {
  const Expected table[] = {
      {pydyna + "standard/thermal_stress.k", 0, 0},
      {pydyna + "standard/nvh/frf_solid.k", 0, 1},
      {pydyna + "standard/mech.k", 0, 0},
      {pydyna + "keywords/expand_test/fol/mesh.k", 0, 0},
      {pydyna + "keywords/encoding_sample.k", 1, 1},
      {pydyna + "keywords/test_multiline_comment.k", 0, 1},
      {parameters + "collision/main.k", 0, 1},
      {parameters + "collision/main_with_consumer.k", 0, 1},
      {parameters + "collision_local/main.k", 0, 0},
      {parameters + "local/top.k", 1, 0},
      {parameters + "local/sibling_test_top.k", 1, 0},
      {parameters + "nonlocal/top.k", 0, 0},
      {parameters + "sibling/main.k", 0, 0},
      {mistakes + "test_comments.k", 1, 0},
      {mistakes + "test_multiple.k", 1, 0},
      {mistakes + "test_node_param.k", 1, 0},
      {mistakes + "test_param_format_error.k", 2, 0},
      {mistakes + "test_undefined_param.k", 1, 0},
      {ansys + "Taylor_Bar/taylor_bar_mesh.k", 0, 0},
      {ansys + "Bar_Impact/bar_impact_mesh.k", 0, 0},
      {ansys + "John_Reid_Pendulum/nodes.k", 0, 0},
      {"K1-ZR__practice-lsdyna/lsdyna-input-gallery/one-element-loadcontrol.k", 0, 0},
      {"jrycw__open-radioss-github-actions-linode/box_drop_openrs.k", 0, 0},
      {"jrycw__open-radioss-github-actions-linode/main.k", 0, 0},
      {"mlp6__fem/tests/nodes.dyn", 0, 0},
      {"mlp6__fem/tests/elems.dyn", 0, 0},
      {dynakw + "joint_revolute.k", 0, 0},
      {dynakw + "thick.k", 0, 0},
      {dynakw + "sample.k", 0, 0},
      {dynakw + "parameter.k", 0, 1},
      {dynakw + "mat.k", 0, 0},
      {dynakw + "section.k", 0, 0},
      {"cxh-1123__LS-DYNA-ablation/test.k", 0, 5},
      {"qd-cae__qd-cae-python/test/keyfile.key", 1, 1},
      {"qd-cae__qd-cae-python/test/keyfile_include_dir/keyfile_include3.key", 0, 1},
  };
  for (const Expected& e : table) {
    const Sample s(e.path);
    EXPECT_EQ(s.errors(), e.errors) << e.path << "\n" << s.shown;
    EXPECT_EQ(s.warnings(), e.warnings) << e.path << "\n" << s.shown;
  }
}

TEST(SampleDeck, MeshesAreComplete) {
  EXPECT_EQ(Sample(ansys + "Taylor_Bar/taylor_bar_mesh.k").rows["ELEMENT_SOLID"], 768u)
      << "1536 lines, two an element";
  Sample bar(ansys + "Bar_Impact/bar_impact_mesh.k");
  EXPECT_EQ(bar.rows["ELEMENT_SOLID"], 768u);
  EXPECT_EQ(bar.rows["ELEMENT_SHELL"], 256u);
  Sample pendulum(ansys + "John_Reid_Pendulum/nodes.k");
  EXPECT_EQ(pendulum.rows["ELEMENT_SHELL"], 768u);
  EXPECT_EQ(pendulum.rows["ELEMENT_BEAM"], 8u);
  EXPECT_EQ(Sample("jrycw__open-radioss-github-actions-linode/main.k").rows["ELEMENT_SOLID"], 1000u);
  EXPECT_EQ(Sample(pydyna + "standard/nvh/frf_solid.k").rows["ELEMENT_SOLID"], 252u);
  EXPECT_EQ(Sample("mlp6__fem/tests/elems.dyn").rows["ELEMENT_SOLID"], 1000u);
  EXPECT_EQ(Sample("mlp6__fem/tests/nodes.dyn").rows["NODE"], 1331u);
}

TEST(SampleDeck, SearchPathFindsTheBirdsMesh) {
  const Sample without(pydyna + "keywords/expand_test/bird_B.k");
  EXPECT_EQ(without.errors(), 1u) << without.shown;
  EXPECT_TRUE(without.says("control_cards.k:38:1: error: *INCLUDE FILENAME: the file 'mesh.k' is not found"))
      << without.shown;
  EXPECT_TRUE(without.says("in file included from")) << without.shown;
  ReadOptions options;
  options.include_paths.push_back(folder / pydyna / "keywords/expand_test/fol");
  Sample with(pydyna + "keywords/expand_test/bird_B.k", options);
  EXPECT_EQ(with.errors(), 0u) << with.shown;
  EXPECT_GT(with.rows["NODE"], 1000u);
}

TEST(SampleDeck, CubeInCommasFindsItsMesh) {
  ReadOptions options;
  options.include_paths.push_back(folder / "mlp6__fem/tests");
  for (const char* name : {"CompressElasticCubeExplicit.dyn", "CompressElasticCubeImplicit.dyn"}) {
    Sample s(std::string("mlp6__fem/examples/compress_cube/") + name, options);
    EXPECT_EQ(s.errors(), 2u) << s.shown;
    EXPECT_TRUE(s.says("the file './bc.dyn' is not found") && s.says("the file './topload.dyn' is not found"))
        << s.shown;
    EXPECT_EQ(s.rows["ELEMENT_SOLID"], 1000u);
  }
  EXPECT_EQ(Sample("mlp6__fem/examples/thermal/thermal.dyn").errors(), 3u);
  EXPECT_EQ(Sample("mlp6__fem/examples/gauss_qsym_pml/gauss_qsym_pml.dyn").errors(), 4u);
}

TEST(SampleDeck, YarisUsesItsParameterInAnInclude) {
  Sample s(ansys + "yaris_stat_shock_absorber_loading/000_yaris_stat_shock_absorber_loading_01.k");
  EXPECT_EQ(s.errors(), 3u) << "three mesh files are not there: " << s.shown;
  EXPECT_GT(s.cards("CONTROL_TERMINATION").at(0).real("ENDTIM"), 0.0);
  ASSERT_EQ(s.deck.transforms().size(), 3u);
  EXPECT_NE(s.deck.transforms()[1].transformation, 0);
  const Sample alone(ansys + "yaris_stat_shock_absorber_loading/implicit_control_cards_R9.k");
  EXPECT_EQ(alone.errors(), 1u);
  EXPECT_TRUE(alone.says("no parameter 'tend' is defined here")) << alone.shown;
}

TEST(SampleDeck, ScopesOfParameters) {
  const auto forms = [](const std::string& path) {
    Sample s(parameters + path);
    std::vector<std::int64_t> values;
    for (const Card& c : s.cards("SECTION_SOLID")) values.push_back(c.integer("ELFORM"));
    return values;
  };
  EXPECT_EQ(forms("collision/main_with_consumer.k"), (std::vector<std::int64_t>{1, 2, 2}));
  EXPECT_EQ(forms("collision_local/main.k"), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(forms("sibling/main.k"), (std::vector<std::int64_t>{5678}));
  EXPECT_EQ(forms("nonlocal/top.k"), (std::vector<std::int64_t>{100, 1, 100}));
  EXPECT_EQ(forms("local/top.k")[1], 999);
  const Sample top(parameters + "local/top.k");
  EXPECT_TRUE(top.says("top.k:15:11: error: *SECTION_SOLID ELFORM: no parameter 'loc' is defined here"))
      << top.shown;
  EXPECT_TRUE(top.says("include_with_local.k:3, but behind this line or only for another file")) << top.shown;
  const Sample sibling(parameters + "local/sibling_test_top.k");
  EXPECT_TRUE(sibling.says("sibling_b.k:6:11: error: *SECTION_SOLID ELFORM: no parameter 'aloc'"))
      << sibling.shown;
}

TEST(SampleDeck, MistakesNameFileLineAndField) {
  EXPECT_TRUE(Sample(mistakes + "test_undefined_param.k")
                  .says("test_undefined_param.k:6:3: error: *SET_NODE_LIST NODES: no parameter 'undef'"));
  EXPECT_TRUE(Sample(mistakes + "test_comments.k").says("test_comments.k:8:3: error"));
  EXPECT_TRUE(Sample(mistakes + "test_multiple.k").says("test_multiple.k:10:3: error"));
  EXPECT_TRUE(Sample(mistakes + "test_node_param.k")
                  .says("test_node_param.k:5:9: error: *NODE X: no parameter 'x_coord'"));
  const Sample columns(mistakes + "test_param_format_error.k");
  EXPECT_TRUE(columns.says(
      "test_param_format_error.k:5:9: error: *NODE X: found '1  &x_coord', expected a real number"))
      << columns.shown;
  EXPECT_TRUE(columns.says("are the columns shifted?"));
}

TEST(SampleDeck, EncryptedAndUnknownParts) {
  Sample s("qd-cae__qd-cae-python/test/keyfile.key");
  EXPECT_TRUE(s.says("this part of the deck is encrypted")) << s.shown;
  EXPECT_TRUE(s.says("unknown keyword '*ELEMENT_BEAM_SCALAR'")) << s.shown;
  EXPECT_EQ(s.rows["NODE"], 6u);
  EXPECT_EQ(s.cards("PART").size(), 1u) << "a blank line behind the last part is white space";
  EXPECT_TRUE(Sample("qd-cae__qd-cae-python/test/keyfile_include_dir/keyfile_include3.key")
                  .says("unknown keyword '*BLABLA'"));
}

TEST(SampleDeck, ValuesOfTheThermalBlock) {
  Sample s(pydyna + "standard/thermal_stress.k");
  const Card mat = s.cards("MAT_ELASTIC_PLASTIC_THERMAL").at(0);
  std::size_t temperatures = 0;
  for (int i = 1; i <= 8; ++i) temperatures += mat.given("T" + std::to_string(i)) ? 1 : 0;
  EXPECT_EQ(temperatures, 8u);
  std::vector<std::int64_t> codes;
  for (const Block& b : s.deck.blocks()) {
    if (b.keyword == "NODE")
      s.deck.rows(b, s.diagnostics, [&](const Row& n) { codes.push_back(n.integer(4)); });
  }
  EXPECT_EQ(codes.size(), 8u);
  EXPECT_TRUE(std::any_of(codes.begin(), codes.end(), [](std::int64_t c) { return c == 7; }));
}

TEST(SampleDeck, JointDeckMixesCommasAndColumns) {
  Sample s(dynakw + "joint_revolute.k");
  EXPECT_EQ(s.deck.title(), "revo-stiff.k");
  EXPECT_EQ(s.cards("CONTROL_TIMESTEP").at(0).real("TSSFAC"), 0.8);
  EXPECT_EQ(s.cards("DEFINE_CURVE").size(), 3u);
  EXPECT_EQ(s.cards("DEFINE_CURVE")[2].real("O1", 1), 200.0);
  EXPECT_EQ(s.cards("PART").size(), 3u);
  EXPECT_EQ(s.cards("CONSTRAINED_JOINT_STIFFNESS_GENERALIZED").at(0).real("ESPH"), 191.0);
}

TEST(SampleDeck, ParametersOfTheFragment) {
  Sample s(dynakw + "parameter.k");
  EXPECT_DOUBLE_EQ(s.cards("DATABASE_BINARY_D3PLOT").at(0).real("DT"), 0.2 / 50.0);
  EXPECT_TRUE(s.says("unknown keyword '*MAT_FOO'"));
}

}  // namespace
}  // namespace cleave::deck
