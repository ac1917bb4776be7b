/// Cuts and clips of simplices by planes of constant time.

#include <gtest/gtest.h>

#include <cmath>

#include "discretisation/spacetime/cut.hpp"
#include "spacetime_meshes.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Random simplices of C corners, with equal times among them; every kind of split occurs.
template <int C>
struct RandomSimplices {
  sample::Random random{7};
  std::array<std::array<double, C - 1>, C> corner;  ///< C - 2 places and the time
  std::array<double, C> time;
  void next() {
    for (auto& x : corner)
      for (double& component : x) component = random(0.0, 1.0);
    if (random(0.0, 1.0) < 0.3) corner[1][C - 2] = corner[0][C - 2];
    for (std::size_t c = 0; c < C; ++c) time[c] = corner[c][C - 2];
  }
};

/// The volume of a simplex is the integral of its cuts over time, and the clip is the part of that integral;
/// both also weighted with a linear function.
template <int C>
void cuts_add_up() {
  RandomSimplices<C> sample;
  for (int trial = 0; trial < 50; ++trial) {
    sample.next();
    const double whole = std::fabs(signed_volume<C - 1>(sample.corner));
    for (const double t : {-0.1, 0.2, sample.time[0], 0.5, 0.8, 1.1}) {
      double clipped = 0.0, rest = 0.0, mean_before = 0.0, mean_after = 0.0;
      const auto add = [&](const auto& piece, double& sum, double& mean) {
        const double share = std::fabs(determinant<C>(piece));
        sum += share;
        for (const auto& lambda : piece)
          for (std::size_t c = 0; c < C; ++c) mean += share / C * lambda[c] * sample.time[c];
      };
      clip<C>(sample.time, t, [&](const auto& piece) { add(piece, clipped, mean_before); });
      std::array<double, C> reversed;
      for (std::size_t c = 0; c < C; ++c) reversed[c] = -sample.time[c];
      clip<C>(reversed, -t, [&](const auto& piece) { add(piece, rest, mean_after); });
      double mean = 0.0;
      for (const double time : sample.time) mean += time / C;
      EXPECT_NEAR(clipped + rest, 1.0, 1e-12);
      EXPECT_NEAR(mean_before + mean_after, mean, 1e-12);
      if (clipped > 1e-9) {
        EXPECT_LT(mean_before / clipped, t + 1e-9);
      }
      // d/dt of the clipped volume is the area of the cut.
      constexpr double step = 1e-5;
      const auto volume_before = [&](double until) {
        double sum = 0.0, unused = 0.0;
        clip<C>(sample.time, until, [&](const auto& piece) { add(piece, sum, unused); });
        return sum * whole;
      };
      double area = 0.0;
      cut<C>(sample.time, t, [&](const auto& piece) {
        std::array<std::array<double, C - 2>, C - 1> x{};
        for (std::size_t p = 0; p < C - 1; ++p)
          for (std::size_t c = 0; c < C; ++c)
            for (std::size_t k = 0; k < C - 2; ++k) x[p][k] += piece[p][c] * sample.corner[c][k];
        area += std::fabs(signed_volume<C - 2>(x));
        for (const auto& lambda : piece) {
          double at = 0.0;
          for (std::size_t c = 0; c < C; ++c) at += lambda[c] * sample.time[c];
          EXPECT_NEAR(at, t, 1e-14);
        }
      });
      bool near_a_corner = false;
      for (const double time : sample.time) near_a_corner = near_a_corner || std::fabs(time - t) < 2 * step;
      if (!near_a_corner) {
        EXPECT_NEAR(area, (volume_before(t + step) - volume_before(t - step)) / (2 * step), 1e-4);
      }
    }
  }
}

TEST(SpacetimeCut, PiecesAddUp) {
  cuts_add_up<3>();
  cuts_add_up<4>();
  cuts_add_up<5>();
}

TEST(SpacetimeCut, FacetInThePlaneBelongsToTheElementBefore) {
  int before = 0, after = 0;
  cut<3>({0.0, 1.0, 1.0}, 1.0, [&](const auto&) { ++before; });
  cut<3>({1.0, 1.0, 2.0}, 1.0, [&](const auto&) { ++after; });
  EXPECT_EQ(before, 1);
  EXPECT_EQ(after, 0);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime
