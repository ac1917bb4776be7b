/// Fields of contact that change what another field says: friction of parts, stiffness and thickness of
/// solids.

#include "body_run.hpp"

namespace cleave::solver::test {
namespace {

/// A soft cube comes down on the rigid box, sliding.
BodyRun run_of(const std::string& friction, const std::string& of_box, const std::string& of_cube,
               const std::string& rest = "") {
  std::string deck = box("*CONTROL_TERMINATION\n0.3\n*CONTROL_ENERGY\n2,2,2,2\n") + cube;
  const auto part = [&](const std::string& name, const std::string& card) {
    if (card.empty()) return;
    const std::size_t at = deck.find("*PART\n" + name);
    deck.insert(deck.find('\n', deck.find('\n', at + 6) + 1) + 1, card + "\n");
    deck.replace(at, 5, "*PART_CONTACT");
  };
  part("box", of_box);
  part("soft", of_cube);
  return BodyRun(deck + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n" + friction + "\n\n" + rest +
                 "*INITIAL_VELOCITY_GENERATION\n2,2,0,0.5,0,-1.0\n0,0,0,0,0,1\n");
}

// Parts of 0.4 and 0.2 rub as a contact of 0.3 does, to the last bit; and they do rub.
TEST(ContactChoices, FrictionOfPartsIsTheMeanOfBoth) {
  const BodyRun parts = run_of("-1.0", "0.2,0.2", "0.4,0.4"), card = run_of("0.3,0.3", "", "");
  const BodyRun smooth = run_of("0", "", "");
  ASSERT_FALSE(parts.diagnostics.failed()) << parts.text();
  EXPECT_GT(parts.state.cycle, 5);
  for (std::size_t i = 0; i < parts.state.velocity.size(); ++i)
    EXPECT_EQ(parts.state.velocity[i], card.state.velocity[i]);
  EXPECT_NE(parts.last.velocity[0], smooth.last.velocity[0]);
  EXPECT_NEAR(smooth.last.velocity[0], 0.0, 1e-6);
  EXPECT_GT(card.last.velocity[0], 1e-5);
}

// Springs of half the stiffness, far softer than the bodies, give the box half the speed.
TEST(ContactChoices, StiffnessOfSolidsStandsForTheirModulus) {
  const BodyRun one = run_of("0", "", "", "0\n,,,,,,,0.8\n"), half = run_of("0", "", "", "0\n,,,,,,,0.4\n");
  ASSERT_FALSE(one.diagnostics.failed()) << one.text();
  EXPECT_LT(one.last.velocity[2], -1e-4);
  EXPECT_NEAR(one.last.velocity[2] / half.last.velocity[2], 2.0, 0.02);
}

// With a thickness of 0.2 they meet when their nodes are 0.2 apart.
TEST(ContactChoices, ThicknessOfSolidsKeepsThemApart) {
  std::string deck = box("*CONTROL_TERMINATION\n0.4\n") + cube;
  deck.replace(deck.find("2.0,1.0,0.3"), 11, "2.0,1e4,0.3");
  for (const char* corner : {"11,0,0,3", "12,1,0,3", "13,1,2,3", "14,0,2,3"})
    deck.replace(deck.find(corner), 8, std::string(corner, 7) + "3.3");
  double nearest = 1e9;
  const BodyRun run(deck +
                        "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n\n5,5\n0\n,,,,,,0.2\n"
                        "*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,-1.0\n0,0,0,0,0,1\n",
                    0, [&](const Frame& frame) {
                      nearest = std::min(nearest,
                                         frame.state.position[3 * 8 + 2] - frame.state.position[3 * 4 + 2]);
                    });
  ASSERT_FALSE(run.diagnostics.failed()) << run.text();
  EXPECT_LT(nearest, 0.2);
  EXPECT_GT(nearest, 0.12);
}

}  // namespace
}  // namespace cleave::solver::test
