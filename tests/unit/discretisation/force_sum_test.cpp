#include "discretisation/force_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "base/threads.hpp"

namespace cleave::discretisation {
namespace {

struct Contribution {
  std::int32_t node;
  int component;
  double value;
};

/// Contributions over many magnitudes, some beyond the range of the sum.
std::vector<Contribution> contributions(std::size_t count, double outlier) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Contribution> all(count);
  for (std::size_t i = 0; i < count; ++i)
    all[i] = {static_cast<std::int32_t>(random() % 50), static_cast<int>(random() % 3),
              number(random) * (i % 97 == 0 ? outlier : 1.0)};
  return all;
}

base::Array<double> sum(const std::vector<Contribution>& all, int threads) {
  base::set_thread_count(threads);
  ForceSum force(50);
  force.begin(1.0);
  base::for_each_chunk(all.size(), [&](std::size_t i) {
    const auto& c = all[i];
    if (std::abs(c.value) < force.limit())
      force.add(c.node, c.component, force.quantum(c.value), true);
    else
      force.add_value(c.node, c.component, c.value);
  });
  base::Array<double> out;
  force.values(out);
  base::set_thread_count(1);
  return out;
}

TEST(ForceSum, SameBitsInAnyOrderAndForAnyThreads) {
  auto all = contributions(5000, 1e30);
  const auto first = sum(all, 1);
  std::mt19937_64 random(3);
  for (const int threads : {1, 2, 3, 7}) {
    std::ranges::shuffle(all, random);
    EXPECT_EQ(first, sum(all, threads)) << threads << " threads";
  }
}

TEST(ForceSum, AddsToTheRoundingOfItsScale) {
  const auto all = contributions(5000, 1.0);
  const auto out = sum(all, 1);
  std::vector<double> exact(150, 0.0);
  for (const auto& c : all) exact[static_cast<std::size_t>(3 * c.node + c.component)] += c.value;
  // Half a quantum each, about 33 contributions per slot; the quantum is 2^-51 of a limit of 16.
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(exact[i], out[i], 60 * 0.5 * 16 * 0x1p-51);
}

TEST(ForceSum, OppositeContributionsCancelExactly) {
  for (const double outlier : {1.0, 1e40}) {
    auto all = contributions(2000, outlier);
    auto opposite = all;
    for (auto& c : opposite) c.value = -c.value;
    all.insert(all.end(), opposite.begin(), opposite.end());
    for (const double v : sum(all, 2)) EXPECT_EQ(v, 0.0);
  }
}

TEST(ForceSum, LanesAndNumbersGiveTheSameIntegers) {
  ForceSum force(1);
  force.begin(3.7e-5);
  base::Lanes lanes;
  for (int i = 0; i < base::lane_count; ++i) lanes.set(i, (i - 3.3) * 1.1e-5);
  const auto integers = force.quantum(lanes);
  for (int i = 0; i < base::lane_count; ++i) EXPECT_EQ(integers[i], force.quantum((i - 3.3) * 1.1e-5));
}

TEST(ForceSum, MagnitudeBitsShowWhatIsOutOfRange) {
  ForceSum force(1);
  force.begin(1.0);
  const double inside = force.limit() * (1.0 - 0x1p-40);
  for (const double v : {0.0, 1.0, -1.0, inside, -inside}) {
    const auto bits = ForceSum::magnitude_bits(force.quantum(base::Lanes(v)));
    EXPECT_FALSE(ForceSum::out_of_range(bits[0])) << v;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double v : {force.limit() * 1.001, 2.0, 4.0, 1e3, 1e10, 1e300, inf, nan, -nan}) {
    const double outside = v < force.limit() ? v * force.limit() : v;
    for (const double signed_value : {outside, -outside}) {
      const auto bits = ForceSum::magnitude_bits(force.quantum(base::Lanes(signed_value)));
      EXPECT_TRUE(ForceSum::out_of_range(bits[5])) << signed_value;
    }
  }
}

TEST(ForceSum, TheScaleFollowsTheLargestContribution) {
  ForceSum force(1);
  force.begin(1.0);
  force.report_magnitude(ForceSum::magnitude_bits(force.quantum(base::Lanes(5.0)))[0]);
  EXPECT_EQ(force.largest(), 4.0);  // the power of two at or below
  force.begin(force.largest());
  EXPECT_GE(force.limit(), 8.0 * 4.0);
  EXPECT_EQ(force.largest(), 2.0);  // nothing came: half of what was expected
  force.add_value(0, 1, 1e20);
  EXPECT_EQ(force.largest(), 1e20);
  EXPECT_EQ(force.value(0, 1), 1e20);
  EXPECT_EQ(force.value(0, 0), 0.0);
}

}  // namespace
}  // namespace cleave::discretisation
