/// The whole build: a small deck, keywords out of order, what is refused, what is counted.

#include <gtest/gtest.h>

#include "deck/layout.hpp"
#include "deck_text.hpp"
#include "model/material/law.hpp"

namespace cleave::model {
namespace {

TEST(Build, CubeHasNodesElementPartAndLaw) {
  const Built b = build_text(cube);
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.mesh.nodes.count(), 8u);
  ASSERT_EQ(b.model.mesh.solids.size(), 1u);
  EXPECT_EQ(b.model.mesh.solids[0].shape, Shape::hex8);
  EXPECT_EQ(b.model.mesh.solids[0].node, (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(b.model.parts.size(), 1u);
  const Part& part = b.model.parts[0];
  EXPECT_EQ(part.title, "cube");
  EXPECT_EQ(part.material_keyword, "MAT_ELASTIC");
  EXPECT_EQ(part.density, 7.85e-9);
  EXPECT_EQ(part.section.family, "SOLID");
  EXPECT_EQ(part.section.form, 1);
  ASSERT_TRUE(part.law);
  // K + 4G/3 of E = 2.1e5, nu = 0.3.
  EXPECT_NEAR(part.law->longitudinal_modulus(), 2.1e5 * 0.7 / (1.3 * 0.4), 1e-6);
  EXPECT_EQ(b.model.control.end.time, 1.0);
  EXPECT_EQ(b.model.control.step.safety, 0.9);
  EXPECT_EQ(part.hourglass.type, 2);
  EXPECT_EQ(part.hourglass.coefficient, 0.1);
}

TEST(Build, ReferencesMayPointForward) {
  const Built b = build_text(
      "*KEYWORD\n*BOUNDARY_PRESCRIBED_MOTION_SET\n5,3,2,9\n"
      "*SET_NODE_ADD\n5\n6\n*SET_NODE_LIST\n6\n5,6,7,8\n"
      "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*PART\n\n1,1,1\n"
      "*DEFINE_CURVE\n9\n0,0\n1,0.5\n" +
      cube.substr(cube.find("*CONTROL"), cube.find("*PART") - cube.find("*CONTROL")) +
      cube.substr(cube.find("*NODE"), cube.find("*ELEMENT") - cube.find("*NODE")));
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.motions.size(), 1u);
  EXPECT_EQ(b.model.motions[0].nodes, (std::vector<Index>{4, 5, 6, 7}));
  EXPECT_EQ(b.model.curves[b.model.motions[0].curve].id, 9);
}

TEST(Build, RefusedPhysicsIsAnErrorWithPlaceUnlessAllowed) {
  const std::string text = cube + "*CONTACT_AUTOMATIC_GENERAL\n0\n\n\n";
  const Built b = build_text(text);
  EXPECT_TRUE(b.says(deck::Severity::error, after_cube, "not computed")) << b.text();
  const Built allowed = build_text(text, {.allow_unsupported = true});
  EXPECT_FALSE(allowed.failed()) << allowed.text();
  EXPECT_TRUE(allowed.says(deck::Severity::warning, after_cube, "not computed"));
}

TEST(Build, PrintControlsAreNotedNotRefused) {
  const Built b = build_text(cube + "*DATABASE_EXTENT_BINARY\n0,0,3\n*CONTROL_OUTPUT\n1\n");
  EXPECT_FALSE(b.failed()) << b.text();
  bool found = false;
  for (const auto& entry : b.account.entries)
    if (entry.keyword == "DATABASE_EXTENT_BINARY") found = entry.policy == Account::Policy::output_only;
  EXPECT_TRUE(found);
}

TEST(Build, FieldsThatAreNotHonouredAreNamed) {
  // PSFAIL changes what is computed; FMATRX does not; 0 and defaults are silent.
  const Built b = build_text(cube + "*CONTROL_SOLID\n0,1,4,1,7\n");
  EXPECT_TRUE(b.says(deck::Severity::error, after_cube + 1, "not honoured")) << b.text();
  EXPECT_TRUE(b.says(deck::Severity::warning, after_cube + 1, "not used here")) << b.text();
  for (const auto& entry : b.account.entries)
    if (entry.keyword == "CONTROL_SOLID") {
      EXPECT_EQ(entry.ignored_fields, (std::vector<std::string>{"FMATRX", "PSFAIL"}));
    }
  EXPECT_FALSE(build_text(cube + "*CONTROL_SOLID\n0,0,4,1,0\n").failed());
}

TEST(Build, UnknownKeywordIsAWarningWithTheNearestName) {
  const Built b = build_text(cube + "*CONTROL_TERMINATOIN\n1.0\n");
  EXPECT_FALSE(b.failed()) << b.text();
  EXPECT_NE(b.text().find("CONTROL_TERMINATION?"), std::string::npos) << b.text();
}

/// Whatever stands under a known keyword, it is taken, noted or refused; never left without a word.
TEST(Build, EveryKnownKeywordIsAccountedFor) {
  for (const std::string_view keyword : deck::known_keywords()) {
    if (keyword.starts_with("INCLUDE") || keyword == "END" || keyword == "CASE") continue;
    for (const char* lines : {"", "1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1\n"}) {
      const Built b = build_text(cube + "*" + std::string(keyword) + "\n" + lines);
      const auto at = std::find_if(b.account.entries.begin(), b.account.entries.end(),
                                   [&](const auto& entry) { return entry.keyword == keyword; });
      if (at == b.account.entries.end()) continue;  // a synonym: accounted under its canonical name
      EXPECT_NE(at->policy, Account::Policy::unknown) << keyword;
      if (at->policy == Account::Policy::refused) {
        EXPECT_TRUE(b.failed()) << keyword;
      }
    }
  }
}

TEST(Build, AccountCountsCards) {
  const Built b = build_text(cube);
  ASSERT_FALSE(b.account.entries.empty());
  for (const auto& entry : b.account.entries) {
    if (entry.keyword == "NODE") {
      EXPECT_EQ(entry.cards, 8u);
    }
    if (entry.keyword == "PART") {
      EXPECT_EQ(entry.cards, 1u);
    }
    if (entry.keyword == "MAT_ELASTIC") {
      EXPECT_EQ(entry.policy, Account::Policy::honoured);
    }
  }
}

}  // namespace
}  // namespace cleave::model
