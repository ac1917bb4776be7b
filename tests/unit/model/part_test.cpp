/// *PART, *SECTION_SOLID, *MAT_*, *EOS_*: references, ranges, what is missing.

#include <gtest/gtest.h>

#include "deck_text.hpp"
#include "model/material/law.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

/// The cube with other lines for material, section and part (they begin on line 4).
Built with(const std::string& middle) {
  return build_text("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + middle + cube.substr(cube.find("*NODE")));
}
const std::string steel = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n", section = "*SECTION_SOLID\n1,1\n";

TEST(Part, SeveralRowsEmptyTitlesAndSharedLaws) {
  const Built b = with(steel + section + "*PART\n\n1,1,1\n$ comment\nsecond, with comma\n2,1,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.parts.size(), 2u);
  EXPECT_EQ(b.model.parts[1].title, "second, with comma");
  EXPECT_EQ(b.model.parts[0].law, b.model.parts[1].law);
}

TEST(Part, NamesWhatIsMissing) {
  EXPECT_TRUE(with(steel + section + "*PART\n\n1,5,1\n").says(Severity::error, 10, "needs section 5"));
  EXPECT_TRUE(with(steel + section + "*PART\n\n1,1,7\n").says(Severity::error, 10, "needs material 7"));
  EXPECT_TRUE(with(steel + section + "*PART\n\n1,1,0\n").says(Severity::error, 10, "needs material 0"));
  EXPECT_TRUE(with(steel + section + "*PART\n\n1,1,1,0,9\n").says(Severity::error, 10, "hourglass card 9"));
  EXPECT_TRUE(
      with(steel + section + "*PART\n\n1,1,1,4\n").says(Severity::error, 10, "takes no equation of state"));
  EXPECT_TRUE(with(steel + section + "*PART\n\n1,1,1\n\n1,1,1\n").failed());
}

TEST(Material, RangesAndRequiredFields) {
  const std::string rest = section + "*PART\n\n1,1,1\n";
  EXPECT_TRUE(with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.5\n" + rest).says(Severity::error, 5, "found 0.5"));
  EXPECT_TRUE(with("*MAT_ELASTIC\n1,7.85e-9,,0.3\n" + rest).says(Severity::error, 5, "is needed and blank"));
  EXPECT_TRUE(with("*MAT_ELASTIC\n1,,2.1e5,0.3\n" + rest).says(Severity::error, 5, "density"));
  EXPECT_TRUE(
      with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3,0.5\n" + rest).says(Severity::warning, 5, "not used here"));
  EXPECT_TRUE(with("*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-9,0.49,1.0,0.2\n1.0,1.0,1.0\n" + rest)
                  .says(Severity::error, 6, "not honoured"));
  EXPECT_FALSE(with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3,0.0\n" + rest).failed());
}

TEST(Material, LawsThatAreNotComputedAreRefusedOnlyWhenUsed) {
  EXPECT_TRUE(with("*MAT_HONEYCOMB\n1,1e-9,1,0.3\n" + section + "*PART\n\n1,1,1\n")
                  .says(Severity::error, 4, "not computed"));
  EXPECT_FALSE(with("*MAT_HONEYCOMB\n2,1e-9,1,0.3\n" + steel + section + "*PART\n\n1,1,1\n").failed());
}

TEST(Material, NumberFormAndTitle) {
  const Built b = with("*MAT_001_TITLE\nsteel, mild\n1,7.85e-9,2.1e5,0.3\n" + section + "*PART\n\n1,1,1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.materials.size(), 1u);
  EXPECT_EQ(b.model.materials[0].keyword, "MAT_ELASTIC");
  EXPECT_EQ(b.model.materials[0].title, "steel, mild");
}

TEST(Material, EveryLawOfTheCatalogueCanBeNamedByAPart) {
  for (const LawEntry* law : law_catalogue()) EXPECT_EQ(find_law(law->keyword), law);
}

}  // namespace
}  // namespace cleave::model
