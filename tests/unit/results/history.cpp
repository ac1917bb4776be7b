#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_run.hpp"

namespace cleave::results::test {
namespace {

TEST(Glstat, CsvHasTheNamedColumnsAndRowsThatReadBackExactly) {
  SmallRun run("glstat");
  run.model.requests.glstat.every = 0.1;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);

  const auto lines = run.lines("glstat.csv");
  ASSERT_EQ(lines.size(), 12u);  // head, and 0, 0.1, ... 1.0
  const auto names = split(lines[0]);
  EXPECT_EQ(names[0], "time");
  EXPECT_EQ(names[1], "cycle");
  EXPECT_EQ(names[2], "time_step");
  EXPECT_EQ(names.back(), "percent_mass_increase");
  ASSERT_EQ(names.size(), 24u);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto values = split(lines[i]);
    ASSERT_EQ(values.size(), names.size());
    EXPECT_EQ(std::stol(values[1]), 10 * static_cast<long>(i - 1));
    EXPECT_EQ(std::stod(values[3]), 50.0 - 20.0 * std::stod(values[0]));
    EXPECT_EQ(values[14], "1");  // energy ratio: kinetic + internal stay 50
  }
  // 8 x 1 + 8 x 1 mass; half of each brick's mass sits at x = 1 (shared) and so on: sum m v = 0.1 sum m x.
  EXPECT_NEAR(std::stod(split(lines[1])[19]), 0.1 * (8.0 * 0.5 + 8.0 * 1.5), 1e-15);
  EXPECT_NEAR(std::stod(split(lines[1])[16]), 0.1, 1e-15);
}

TEST(Glstat, AsciiKeepsTheEstablishedColumns) {
  SmallRun run("glstat_ascii");
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  const auto lines = run.lines("glstat");
  EXPECT_EQ(lines[0], " two bricks");
  EXPECT_EQ(lines[1].substr(0, 57), "                         cleave (version 0.1.0)     date ");
  const auto at = std::find(lines.begin(), lines.end(), " time...........................   0.00000E+00");
  ASSERT_NE(at, lines.end());
  EXPECT_EQ(at[-2], " dt of cycle       0 is controlled by solid      element       2 of part      20");
  EXPECT_EQ(at[1], " time step......................   1.00000E-02");
  EXPECT_EQ(at[2], " kinetic energy.................   5.00000E+01");
  EXPECT_EQ(at[3], " internal energy................   0.00000E+00");
  EXPECT_EQ(at[4], " hourglass energy ..............   0.00000E+00");
  EXPECT_EQ(at[11], " total energy...................   5.00000E+01");
  EXPECT_EQ(at[12], " total energy / initial energy..   1.00000E+00");
  EXPECT_EQ(at[13], " energy ratio w/o eroded energy.   1.00000E+00");
}

TEST(Glstat, IsWrittenAThousandTimesWhenTheDeckAsksForNothing) {
  SmallRun run("glstat_default");
  run.model.control.end.time = 10.0;  // a thousandth is 0.01, one cycle
  Recorder recorder(run.model, run.options());
  run.run(recorder, 50);
  EXPECT_EQ(run.lines("glstat.csv").size(), 1u + 51u);
}

TEST(Matsum, SharesNodesBetweenPartsByTheirElements) {
  SmallRun run("matsum");
  run.model.requests.matsum.every = 0.5;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  const auto lines = run.lines("matsum.csv");
  ASSERT_EQ(lines.size(), 1u + 3u * 2u);
  const auto names = split(lines[0]), left = split(lines[3]), right = split(lines[4]);
  EXPECT_EQ(names[2], "id");
  EXPECT_EQ(names[3], "internal_energy");
  EXPECT_EQ(left[0], "0.5");
  EXPECT_EQ(left[2], "10");
  EXPECT_EQ(left[3], "2.5");
  EXPECT_EQ(right[3], "7.5");
  // v = 0.1 x on masses of 1 at x = 0, 1 (left) and x = 1, 2 (right): momentum, then velocity of the centre.
  EXPECT_NEAR(std::stod(left[9]), 4 * 0.1, 1e-15);
  EXPECT_NEAR(std::stod(right[9]), 4 * 0.1 + 4 * 0.2, 1e-15);
  EXPECT_NEAR(std::stod(right[12]), 1.2 / 8.0, 1e-15);
  EXPECT_NEAR(std::stod(right[4]), 0.5 * (4 * 0.01 + 4 * 0.04), 1e-15);
  EXPECT_EQ(names[15], "mass");
  EXPECT_EQ(right[15], "8");

  const auto ascii = run.lines("matsum");
  EXPECT_EQ(ascii[3], "{BEGIN LEGEND}");
  EXPECT_EQ(ascii[4], " Entity #        Title");
  EXPECT_EQ(ascii[5], "       10     left");
  EXPECT_EQ(ascii[7], "{END LEGEND}");
  const auto at = std::find(ascii.begin(), ascii.end(), " time =   5.0000E-01");
  ASSERT_NE(at, ascii.end());
  EXPECT_EQ(
      at[1],
      " mat.#=   10             inten=   2.5000E+00     kinen=   2.0000E-02     eroded_ie=   0.0000E+00     "
      "eroded_ke=   0.0000E+00");
  EXPECT_EQ(at[2], " x-mom=   4.0000E-01     y-mom=   0.0000E+00     z-mom=   0.0000E+00");
  EXPECT_EQ(at[3], " x-rbv=   5.0000E-02     y-rbv=   0.0000E+00     z-rbv=   0.0000E+00");
  EXPECT_EQ(
      at[4],
      "                         hgeng=   0.0000E+00     +mass=   0.0000E+00     eroded_he=   0.0000E+00");
}

TEST(Matsum, CountsMassThatScalingAddsAndDeletionTakes) {
  SmallRun run("matsum_scaled");
  run.model.requests.matsum.every = 1.0;
  for (std::size_t a = 8; a < 12; ++a) run.state.mass[a] *= 2.0;  // the right face: 4 more
  run.state.added_mass = 4.0;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 1);
  const auto left = split(run.lines("matsum.csv")[1]), right = split(run.lines("matsum.csv")[2]);
  EXPECT_EQ(left[15], "8");
  EXPECT_EQ(left[16], "0");
  EXPECT_EQ(right[15], "12");
  EXPECT_EQ(right[16], "4");
}

TEST(Nodout, HasTheFixedColumnsThatReadersCount) {
  SmallRun run("nodout");
  run.model.requests.nodout.every = 0.5;
  run.model.requests.history_nodes = {8, 0};
  run.model.requests.history_node_titles = {{109, "free end"}};
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  const auto lines = run.lines("nodout.csv");
  EXPECT_EQ(lines[0],
            "time,cycle,id,x_displacement,y_displacement,z_displacement,x_velocity,y_velocity,z_velocity,"
            "x_acceleration,y_acceleration,z_acceleration,x_coordinate,y_coordinate,z_coordinate");
  const auto row = split(lines[3]);
  EXPECT_EQ(row[2], "109");
  EXPECT_EQ(std::stod(row[3]), run.model.mesh.nodes.position[24] * 1.05 - 2.0);
  EXPECT_EQ(row[6], "0.2");
  EXPECT_EQ(row[10], "0.5");
  EXPECT_EQ(row[12], "2.1");

  const auto ascii = run.lines("nodout");
  const std::string head = " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p";
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < ascii.size(); ++i)
    if (ascii[i].starts_with(head)) blocks.push_back(i);
  ASSERT_EQ(blocks.size(), 3u);
  const std::size_t at = blocks[1];
  EXPECT_EQ(ascii[at], head + "      50                              ( at time 5.0000000E-01 )");
  EXPECT_TRUE(ascii[at + 2].starts_with(" nodal point  x-disp     y-disp      z-disp "));
  const std::string& line = ascii[at + 3];
  ASSERT_EQ(line.size(), 10u + 12u * 12u);
  EXPECT_EQ(line.substr(0, 10), "      109 ");
  EXPECT_EQ(line.substr(10, 12), "  1.0000E-01");
  EXPECT_EQ(line.substr(46, 12), "  2.0000E-01");
  EXPECT_EQ(line.substr(94, 12), "  5.0000E-01");
  EXPECT_EQ(line.substr(118, 12), "  2.1000E+00");
}

TEST(Elout, NamesStressesAndHistoryVariables) {
  SmallRun run("elout");
  run.model.requests.elout.every = 0.5;
  run.model.requests.history_solids = {2, 1};
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  const auto lines = run.lines("elout.csv");
  EXPECT_EQ(lines[0],
            "time,cycle,id,part,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx,"
            "effective_plastic_strain,pressure,von_mises,back_stress_xx,back_stress_yy,back_stress_zz,"
            "back_stress_xy,back_stress_yz,back_stress_zx");
  const auto row = split(lines[3]);
  EXPECT_EQ(row[2], "2");
  EXPECT_EQ(row[3], "20");
  EXPECT_EQ(row[4], "3");
  EXPECT_EQ(row[6], "9");
  EXPECT_EQ(row[11], "-6");

  const auto ascii = run.lines("elout");
  const auto at = std::find(ascii.begin(), ascii.end(), "       2-     20");
  ASSERT_NE(at, ascii.end());
  EXPECT_EQ(at[1],
            "       1 plastic   2.0000E+00  4.0000E+00  6.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00    "
            "3.4641E+00    2.0000E-03");
  EXPECT_EQ(at[-3], " element  materl");
}

TEST(Elout, LeavesOutDeletedElements) {
  SmallRun run("elout_eroded");
  run.model.requests.elout.every = 0.5;
  run.model.requests.history_solids = {1, 2};
  run.state.blocks[0].alive[0] = 0.0;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 1);
  const auto lines = run.lines("elout.csv");
  ASSERT_EQ(lines.size(), 3u);  // head, cycle 0, and the end
  EXPECT_EQ(split(lines[1])[2], "2");
}

TEST(Rwforc, HasOneRowPerWall) {
  SmallRun run("rwforc");
  run.model.requests.rwforc.every = 1.0;
  run.model.walls.resize(2);
  run.model.walls[1].id = 77;
  run.walls.resize(2);
  run.walls[1].normal = 2.5;
  run.walls[1].force[0] = -2.5;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 1);
  const auto lines = run.lines("rwforc.csv");
  EXPECT_EQ(lines[0], "time,cycle,id,normal_force,x_force,y_force,z_force,position,velocity");
  EXPECT_EQ(lines[1], "0,0,1,0,0,0,0,0,0");
  EXPECT_EQ(lines[2], "0,0,77,2.5,-2.5,0,0,0,0");
  const auto ascii = run.lines("rwforc");
  EXPECT_NE(std::find(ascii.begin(), ascii.end(),
                      " 0.00000E+00      77   2.500000E+00  -2.500000E+00   0.000000E+00   0.000000E+00"),
            ascii.end());
}

TEST(Spcforc, ReportsOnlyWhatTheConstraintsHold) {
  SmallRun run("spcforc");
  run.model.requests.spcforc.every = 0.5;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  const auto lines = run.lines("spcforc.csv");
  EXPECT_EQ(lines[0], "time,cycle,id,x_force,y_force,z_force");
  // Held along x with -1.5 t each; 3 along y belongs to something else, and so does node 105.
  EXPECT_EQ(lines[6], "0.5,50,101,-0.75,0,0");
  EXPECT_EQ(lines[10], "0.5,50,0,-3,0,0");  // the sum
  EXPECT_EQ(lines.size(), 1u + 3u * 5u);
  const auto ascii = run.lines("spcforc");
  EXPECT_NE(std::find(ascii.begin(), ascii.end(),
                      " node=     101 local x,y,z forces =   -7.5000E-01    0.0000E+00    0.0000E+00"),
            ascii.end());
  EXPECT_NE(std::find(ascii.begin(), ascii.end(),
                      "             force resultants   =   -3.0000E+00    0.0000E+00    0.0000E+00"),
            ascii.end());
}

TEST(Spcforc, TurnsIntoTheAxesOfALocalSystem) {
  SmallRun run("spcforc_local");
  run.model.requests.spcforc.every = 0.5;
  run.model.fixed[0].nodes = {0};
  run.model.fixed[0].local = true;
  const double c = std::sqrt(0.5);
  run.model.fixed[0].frame.axis[0] = {c, c, 0.0};
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  // Reaction (-1.5, 3, 0) at t = 1: along (1, 1, 0)/sqrt(2) it is 1.5/sqrt(2), so 0.75 along x and y.
  const auto row = split(run.lines("spcforc.csv")[5]);
  EXPECT_NEAR(std::stod(row[3]), 0.75, 1e-15);
  EXPECT_NEAR(std::stod(row[4]), 0.75, 1e-15);
}

}  // namespace
}  // namespace cleave::results::test
