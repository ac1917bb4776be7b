#include <gtest/gtest.h>

#include "spacetime_account.hpp"

namespace cleave::discretisation::spacetime::sample {
namespace {

TEST(SpacetimePitcher, CausalityLimitIsTheCharacteristicSlope) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    Cell<3> cell;
    for (std::size_t i = 0; i < 4; ++i) {
      for (double& c : cell.corner[i]) c = random(0.0, 1.0);
      cell.time[i] = random(0.0, 0.05);
    }
    std::array<Point<3>, 3> edge;
    for (std::size_t i = 0; i < 3; ++i) edge[i] = difference(cell.corner[i + 1], cell.corner[0]);
    const double det = determinant(edge);
    if (std::abs(det) < 0.05) continue;
    cell.bound = 1.0;
    cell.time[2] = rise_limit<3>(cell, 2, Progress::causality, 0.1);
    // The gradient by Cramer's rule, with the times of the edges as right-hand side.
    double slope2 = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      auto m = edge;
      for (std::size_t i = 0; i < 3; ++i) m[i][k] = cell.time[i + 1] - cell.time[0];
      slope2 += std::pow(determinant(m) / det, 2);
    }
    EXPECT_NEAR(slope2, 1.0, 1e-9);
    EXPECT_NEAR(strain_on_bounds<3>(cell, Progress::causality, 0.1), 1.0, 1e-9);
  }
}

TEST(SpacetimePitcher, UniformLineAtTheCharacteristicSlope) {
  // N vertices, tents 2 h / c high but for the first and last half ones: about N T c / (2 h) of them.
  SpaceMesh<1> mesh;
  const int count = 64;
  ASSERT_TRUE(mesh.build(line(count)).ok);
  const double h = 1.0 / count, end_time = 40 * h;
  const Account a = pitch_all(mesh, {.chi = 1.0}, end_time);
  ASSERT_TRUE(a.status.ok);
  EXPECT_EQ(a.fault, "");
  EXPECT_DOUBLE_EQ(a.most, 2.0 * h);
  EXPECT_DOUBLE_EQ(a.least, h);
  // Even vertices: half a tent at either end and 19 between; odd ones 20.
  EXPECT_EQ(a.status.patches, 33 * 21 + 32 * 20);
  EXPECT_NEAR(static_cast<double>(a.status.patches), (count + 1) * end_time / (2.0 * h),
              0.5 * (count + 1) + 1);
  EXPECT_NEAR(a.volume, end_time, 1e-12 * end_time);
}

TEST(SpacetimePitcher, FrontsNeverStallInOneDimension) {
  expect_whole_slab<1>(line(50, 0.45), {}, 0.7, "line, jittered");
  expect_whole_slab<1>(two_materials<1>(line(40, 0.45, 3), 0.5), {.chi = 0.5}, 0.7, "line, two materials");
}

TEST(SpacetimePitcher, FrontsNeverStallInTwoDimensions) {
  const auto sliver = spoiled<2>(grid(7, 0.25, 7), 0.25, 1.5);
  EXPECT_GT(largest_angle(sliver), 165.0);
  const auto random = delaunay(150, 11);
  for (const Progress progress : {Progress::high_mid, Progress::subsimplex, Progress::budget})
    for (const double eps : {0.1, 0.3, 0.5}) {
      const PitchOptions options{.progress = progress, .eps = eps};
      const std::string name = word(progress);
      expect_whole_slab<2>(grid(8), options, 0.5, ("grid, " + name).c_str());
      expect_whole_slab<2>(random, options, 0.25, ("Delaunay, " + name).c_str());
      expect_whole_slab<2>(sliver, options, 0.1, ("slivers, " + name).c_str());
      expect_whole_slab<2>(two_materials<2>(grid(8, 0.3, 2), 0.5), options, 0.25,
                           ("two materials, " + name).c_str());
    }
}

TEST(SpacetimePitcher, FrontsNeverStallInThreeDimensions) {
  for (const double eps : {0.1, 0.3, 0.5}) {
    const PitchOptions options{.eps = eps};
    expect_whole_slab<3>(cube(3), options, 1.0, "cube");
    expect_whole_slab<3>(cube(3, 0.18, 4), options, 1.0, "cube, jittered");
    expect_whole_slab<3>(spoiled<3>(cube(3, 0.15, 9), 0.3, 0.8), options, 0.3, "cube, slivers");
  }
}

TEST(SpacetimePitcher, CausalityAloneStalls) {
  int stalled = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SpaceMesh<2> mesh;
    ASSERT_TRUE(mesh.build(delaunay(150, seed)).ok);
    const Account a = pitch_all(mesh, {.progress = Progress::causality}, 1.0);
    stalled += !a.status.ok;
    EXPECT_EQ(a.fault, "");
  }
  EXPECT_EQ(stalled, 5);
}

TEST(SpacetimePitcher, EndsWithoutSlivers) {
  // On a uniform line tents end at multiples of h / c: an end a tenth beyond one would leave slivers there.
  SpaceMesh<1> mesh;
  ASSERT_TRUE(mesh.build(line(16)).ok);
  const double h = 1.0 / 16;
  for (int i = 0; i < 20; ++i) {
    const Account a = pitch_all(mesh, {.chi = 1.0}, (10.0 + 0.1 * i) * h);
    EXPECT_TRUE(a.level);
    EXPECT_GT(a.least, 0.29 * h) << i;
  }
  const Pitcher<1> pitcher(mesh, {.chi = 1.0});
  const Front<1> front = pitcher.level_front(0.0);
  EXPECT_EQ(pitcher.pitch(front, 2, 1.0).top[1], h);            // far from the end
  EXPECT_EQ(pitcher.pitch(front, 2, 1.2 * h).top[1], 0.6 * h);  // two equal tents instead of a sliver
  EXPECT_EQ(pitcher.pitch(front, 2, 0.9 * h).top[1], 0.9 * h);  // the end itself
}

TEST(SpacetimePitcher, CapsAndFactorsLowerTents) {
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(grid(6)).ok);
  EXPECT_LE(pitch_all(mesh, {.height_cap = 0.01}, 0.2).most, 0.01 * (1.0 + 1e-12));
  const Account full = pitch_all(mesh, {}, 0.5), lower = pitch_all(mesh, {.height_factor = 0.8}, 0.5);
  EXPECT_TRUE(lower.level);
  EXPECT_GT(lower.status.patches, full.status.patches);
}

TEST(SpacetimePitcher, InclinedPolesSmoothTheMesh) {
  const auto input = grid(10, 0.4, 3);
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(input).ok);
  for (const Progress progress : {Progress::high_mid, Progress::subsimplex, Progress::budget}) {
    const Account a = pitch_all(mesh, {.progress = progress, .smoothing = 0.2}, 0.4);
    EXPECT_TRUE(a.status.ok && a.level) << a.status.what;
    EXPECT_EQ(a.fault, "");
    EXPECT_NEAR(a.volume, 0.4, 4e-13);
    EXPECT_LE(a.strain, 1.0 + 1e-9);
    const double share = static_cast<double>(a.inclined) / static_cast<double>(a.status.patches);
    std::printf("inclined, %s: %.0f %% of %lld tents\n", word(progress), 100.0 * share,
                static_cast<long long>(a.status.patches));
    EXPECT_GE(share, 0.6);
  }
  SpaceMesh<3> solid;
  ASSERT_TRUE(solid.build(cube(4, 0.18, 4)).ok);
  const Account a = pitch_all(solid, {.smoothing = 0.3}, 0.2);
  EXPECT_TRUE(a.status.ok && a.level);
  EXPECT_EQ(a.fault, "");
  EXPECT_NEAR(a.volume, 0.2, 2e-13);
  EXPECT_GT(a.inclined, 0);
  SpaceMesh<1> bar;
  ASSERT_TRUE(bar.build(two_materials<1>(line(30, 0.4), 0.5)).ok);
  const Account b = pitch_all(bar, {.smoothing = 0.5}, 0.5);
  EXPECT_TRUE(b.status.ok && b.level);
  EXPECT_EQ(b.fault, "");
  EXPECT_NEAR(b.volume, 0.5, 5e-13);
  EXPECT_GT(b.inclined, 0);
}

TEST(SpacetimePitcher, MovedVerticesStayOnBoundariesAndInterfaces) {
  auto input = two_materials<2>(grid(8, 0.3, 3), 0.5);
  for (std::size_t v = 0; v < input.vertex.size(); ++v)  // a straight interface at the middle column
    if (v % 9 == 4) input.vertex[v][0] = 0.5;
  for (std::size_t s = 0; s < input.simplex.size(); ++s) input.material[s] = (s / 2) % 8 >= 4;
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(input).ok);
  base::set_thread_count(1);
  const Pitcher<2> pitcher(mesh, {.smoothing = 0.3});
  Front<2> front = pitcher.level_front(0.0);
  ASSERT_TRUE(Scheduler<2>(pitcher).advance(front, 0.5, [](const Patch<2>&) { return Verdict{}; }).ok);
  int along = 0;
  for (std::size_t v = 0; v < front.position.size(); ++v) {
    const Point<2>&before = input.vertex[v], &after = front.position[v];
    const bool side = v % 9 == 0 || v % 9 == 8, end = v / 9 == 0 || v / 9 == 8, seam = v % 9 == 4;
    EXPECT_DOUBLE_EQ(after[0], side || seam ? before[0] : after[0]);
    EXPECT_DOUBLE_EQ(after[1], end ? before[1] : after[1]);
    along += (side != end || seam) && distance(before, after) > 1e-3;
  }
  EXPECT_GT(along, 10);
}

TEST(SpacetimePitcher, RefusesOptionsWithoutMeaning) {
  EXPECT_EQ(complaint<2>({}), "");
  EXPECT_NE(complaint<2>({.chi = 0.0}), "");
  EXPECT_NE(complaint<2>({.chi = 1.1}), "");
  EXPECT_NE(complaint<2>({.eps = 0.6}), "");
  EXPECT_NE(complaint<2>({.height_factor = 0.0}), "");
  EXPECT_NE(complaint<2>({.height_cap = -1.0}), "");
  EXPECT_NE(complaint<3>({.progress = Progress::budget}), "");
  EXPECT_NE(complaint<1>({.progress = Progress::high_mid}), "");
  EXPECT_NE(complaint<2>({.smoothing = 2.0}), "");
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::sample
