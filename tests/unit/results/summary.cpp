#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "small_run.hpp"

namespace cleave::results::test {
namespace {

nlohmann::json summary_of(SmallRun& run, std::int64_t cycles) {
  Recorder recorder(run.model, run.options());
  run.run(recorder, cycles);
  solver::Outcome outcome;
  outcome.seconds = 2.0;
  outcome.element_cycles = 200.0;
  outcome.phases = {{"elements", 1.5}, {"output", 0.5}};
  recorder.summarise(outcome);
  return nlohmann::json::parse(run.text("summary.json"));
}

TEST(Summary, SaysHowTheRunEndedAndWhatCameOfIt) {
  SmallRun run("summary");
  const auto summary = summary_of(run, 100);
  EXPECT_EQ(summary["title"], "two bricks");
  EXPECT_EQ(summary["ending"], "end_time");
  EXPECT_EQ(summary["normal"], true);
  EXPECT_EQ(summary["final_time"], 1.0);
  EXPECT_EQ(summary["cycles"], 100);
  EXPECT_EQ(summary["energy"]["kinetic"], 30.0);
  EXPECT_EQ(summary["energy"]["kinetic_high"], 50.0);
  EXPECT_EQ(summary["energy"]["ratio_low"], 1.0);
  EXPECT_EQ(summary["mass"]["total"], 16.0);
  EXPECT_EQ(summary["counts"]["elements"], 2);
  EXPECT_EQ(summary["speed"]["element_cycles_per_second"], 100.0);
  EXPECT_EQ(summary["speed"]["phases"]["elements"], 1.5);
  EXPECT_EQ(summary["eroded_elements"], 0);
}

TEST(Summary, MeasuresPartsAlongAndAcrossTheirAxes) {
  SmallRun run("summary_parts");
  const auto parts = summary_of(run, 100)["parts"];
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0]["id"], 10);
  EXPECT_EQ(parts[0]["mass"], 8.0);
  EXPECT_EQ(parts[0]["initial"]["length"][0], 1.0);
  EXPECT_NEAR(parts[0]["final"]["length"][0].get<double>(), 1.1, 1e-15);
  EXPECT_EQ(parts[1]["final"]["low"][0], 1.1);
  // The left face is held along x and bounds the part: a plane of symmetry. About y the part is then as wide
  // as the diagonal of its doubled x-extent and its height.
  EXPECT_EQ(parts[0]["symmetry"], nlohmann::json({"x"}));
  EXPECT_EQ(parts[1]["symmetry"], nlohmann::json::array());
  EXPECT_NEAR(parts[0]["final"]["diameter"][1].get<double>(), 2.0 * std::hypot(1.1, 0.5), 1e-14);
  EXPECT_NEAR(parts[0]["final"]["diameter"][0].get<double>(), std::sqrt(2.0), 1e-14);
}

TEST(Summary, CountsErodedElementsAndLeavesThemOutOfTheShape) {
  SmallRun run("summary_eroded");
  run.state.blocks[1].alive[0] = 0.0;
  const auto summary = summary_of(run, 10);
  EXPECT_EQ(summary["eroded_elements"], 1);
  EXPECT_EQ(summary["parts"][1]["eroded_elements"], 1);
}

TEST(Summary, StaysJsonWhenNumbersOrTitlesAreBroken) {
  SmallRun run("summary_nan");
  run.model.title = "caf\xe9";  // Latin-1
  run.state.added_mass = std::nan("");
  run.state.first_step = INFINITY;
  const auto summary = summary_of(run, 1);
  EXPECT_TRUE(summary["mass"]["added"].is_null());
  EXPECT_TRUE(summary["time_step"]["first"].is_null());
  EXPECT_EQ(summary["title"], "caf\xef\xbf\xbd");
}

TEST(Summary, TellsPeopleOfAFailure) {
  SmallRun run("summary_text");
  Recorder recorder(run.model, run.options());
  recorder.begin(run.frame());
  discretisation::StepStatus status;
  status.ok = false;
  status.part = 1;
  status.element = 2;
  status.what = "volume became negative";
  recorder.finish(run.frame(), solver::Ending::physics, status);
  solver::Outcome outcome;
  const std::string text = recorder.text_summary(outcome);
  EXPECT_NE(text.find("STOPPED"), std::string::npos);
  EXPECT_NE(text.find("element 2: volume became negative"), std::string::npos);
  recorder.summarise(outcome);
  const auto summary = nlohmann::json::parse(run.text("summary.json"));
  EXPECT_EQ(summary["failure"]["element"], 2);
  EXPECT_EQ(summary["failure"]["part"], 20);
  EXPECT_EQ(summary["normal"], false);
}

}  // namespace
}  // namespace cleave::results::test
