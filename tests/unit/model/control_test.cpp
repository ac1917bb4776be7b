/// *CONTROL_*, *DATABASE_*, *TERMINATION_NODE: defaults and what 0 means.

#include <gtest/gtest.h>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

TEST(Control, DefaultsOfTheFormat) {
  const Control c = build_text(cube).model.control;
  EXPECT_EQ(c.step.safety, 0.9);
  EXPECT_EQ(c.viscosity.quadratic, 1.5);
  EXPECT_EQ(c.viscosity.linear, 0.06);
  EXPECT_FALSE(c.energy.hourglass);
  EXPECT_TRUE(c.energy.wall);
  EXPECT_EQ(c.hourglass.type, 2);
  EXPECT_EQ(c.end.mass_change, 0.0);
}

TEST(Control, TimeStepFields) {
  const Built b =
      build_text(cube + "*DEFINE_CURVE\n4\n0,1e-6\n1,1e-6\n*CONTROL_TIMESTEP\n1e-7,0,0,0,-2e-6,4,1,1\n0,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const TimeStepControl& s = b.model.control.step;
  EXPECT_EQ(s.first, 1e-7);
  EXPECT_EQ(s.safety, 0.9);  // TSSFAC = 0
  EXPECT_EQ(s.mass_scaling, -2e-6);
  EXPECT_EQ(s.limit_curve, 0);
  EXPECT_EQ(s.mass_scaling_curve, 0);
  EXPECT_TRUE(s.erode);
  EXPECT_TRUE(s.mass_scaling_first_only);
  EXPECT_EQ(build_text(cube + "*CONTROL_TIMESTEP\n,.8\n").model.control.step.safety, 0.8);
  EXPECT_TRUE(build_text(cube + "*CONTROL_TIMESTEP\n0,0.9\n0,0,1\n")
                  .says(Severity::error, after_cube + 2, "not honoured"));
}

TEST(Control, TerminationCriteria) {
  const std::string rest = cube.substr(cube.find("*MAT"));
  const Built b = build_text("*KEYWORD\n*CONTROL_TERMINATION\n2,500,0.01,5,10\n" + rest +
                             "*TERMINATION_NODE\n5,3,2\n6,1,,-1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const Termination& e = b.model.control.end;
  EXPECT_EQ(e.time, 2.0);
  EXPECT_EQ(e.cycles, 500);
  EXPECT_EQ(e.step_fraction, 0.01);
  EXPECT_EQ(e.energy_change, 5.0);
  EXPECT_EQ(e.mass_change, 10.0);
  ASSERT_EQ(e.nodes.size(), 2u);
  EXPECT_EQ(e.nodes[0].node, 4);
  EXPECT_EQ(e.nodes[0].maximum, 2.0);
  EXPECT_EQ(e.nodes[0].minimum, -1e21);
  EXPECT_EQ(e.nodes[1].minimum, -1.0);
  EXPECT_FALSE(e.no_solution_check);
  EXPECT_TRUE(
      build_text("*KEYWORD\n*CONTROL_TERMINATION\n2,0,0,0,0,1\n" + rest).model.control.end.no_solution_check);
  EXPECT_NE(build_text("*KEYWORD\n" + rest).text().find("no end time"), std::string::npos);
}

TEST(Control, MassScalingByAFractionOfTheFirstStep) {
  const Built b = build_text(cube + "*CONTROL_TIMESTEP\n0,0.9\n0.8\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.control.step.mass_scaling_fraction, 0.8);
  const Built both = build_text(cube + "*CONTROL_TIMESTEP\n0,0.9,0,0,-1e-7\n0.8\n");
  EXPECT_EQ(both.model.control.step.mass_scaling_fraction, 0.0);
  EXPECT_TRUE(both.says(Severity::warning, after_cube + 2, "not used with DT2MS"));
  EXPECT_TRUE(build_text(cube + "*CONTROL_TIMESTEP\n0,0.9\n-1\n")
                  .says(Severity::error, after_cube + 2, "0 or above"));
}

TEST(Control, EnergySwitchesAreOneAndTwo) {
  const EnergyControl e = build_text(cube + "*CONTROL_ENERGY\n2,1,0,2\n").model.control.energy;
  EXPECT_TRUE(e.hourglass);
  EXPECT_FALSE(e.wall);
  EXPECT_TRUE(e.sliding);
  EXPECT_TRUE(e.damping);
}

TEST(Control, HourglassOfAPartGoesBeforeTheControlCard) {
  const std::string head = cube.substr(0, cube.find("*PART")), tail = cube.substr(cube.find("*NODE"));
  const Built b = build_text(head +
                             "*CONTROL_HOURGLASS\n4,0.05\n*CONTROL_BULK_VISCOSITY\n1.2,0.07\n"
                             "*HOURGLASS\n3,6,0,0,1.0\n*PART\n\n1,1,1,0,3\n*PART\n\n2,1,1\n" +
                             tail);
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.parts[0].hourglass.type, 6);
  EXPECT_EQ(b.model.parts[0].hourglass.coefficient, 0.05);
  EXPECT_EQ(b.model.parts[0].hourglass.quadratic_bulk, 1.0);
  EXPECT_EQ(b.model.parts[0].hourglass.linear_bulk, 0.07);
  EXPECT_EQ(b.model.parts[1].hourglass.type, 4);
  EXPECT_EQ(b.model.parts[1].hourglass.quadratic_bulk, 1.2);
  EXPECT_NE(b.text().find("part 2 has no elements"), std::string::npos);
}

TEST(Control, ALaterCardReplacesWithAWarning) {
  const Built b = build_text(cube + "*CONTROL_TERMINATION\n5.0\n");
  EXPECT_EQ(b.model.control.end.time, 5.0);
  EXPECT_TRUE(b.says(Severity::warning, after_cube, "given before"));
}

TEST(Database, IntervalsHistoriesAndRestarts) {
  const Built b =
      build_text(cube +
                 "*DEFINE_CURVE\n4\n0,0.1\n1,0.1\n*DATABASE_GLSTAT\n0.25\n*DATABASE_NODOUT\n0,0,4\n"
                 "*DATABASE_BINARY_D3PLOT\n0.5,0,0,10\n*DATABASE_BINARY_D3DUMP\n2000\n"
                 "*DATABASE_BINARY_RUNRSF\n300\n*DATABASE_HISTORY_NODE\n1,2\n8\n"
                 "*DATABASE_HISTORY_NODE_ID\n         2the tip\n*DATABASE_HISTORY_SOLID\n1\n"
                 "*DATABASE_RCFORC\n0.1\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const Requests& r = b.model.requests;
  EXPECT_EQ(r.glstat.every, 0.25);
  EXPECT_EQ(r.nodout.curve, 0);
  EXPECT_TRUE(r.nodout.active());
  EXPECT_FALSE(r.matsum.active());
  EXPECT_EQ(r.field.every, 0.1);  // NPLTC = 10 over an end time of 1
  EXPECT_EQ(r.restart_cycles, 2000);
  EXPECT_EQ(r.running_restart_cycles, 300);
  EXPECT_EQ(r.history_nodes, (std::vector<Index>{0, 1, 7}));
  ASSERT_EQ(r.history_node_titles.size(), 1u);
  EXPECT_EQ(r.history_node_titles[0], (std::pair<Id, std::string>(2, "the tip")));
  EXPECT_EQ(r.history_solids, (std::vector<Id>{1}));
  EXPECT_TRUE(
      build_text(cube + "*DATABASE_HISTORY_NODE\n99\n").says(Severity::error, after_cube + 1, "node 99"));
}

}  // namespace
}  // namespace cleave::model
