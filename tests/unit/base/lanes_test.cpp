#include "base/lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>

namespace cleave::base {
namespace {

Lanes random_lanes(std::mt19937_64& generator, double low, double high) {
  std::uniform_real_distribution<double> draw(low, high);
  Lanes r;
  for (int i = 0; i < lane_count; ++i) r.set(i, draw(generator));
  return r;
}

/// Distance in units of the last place.
std::int64_t ulp(double a, double b) {
  const auto ordered = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const std::int64_t d = ordered(a) - ordered(b);
  return d < 0 ? -d : d;
}

TEST(Lanes, ArithmeticIsTheScalarOperationPerLane) {
  std::mt19937_64 generator(1);
  for (int n = 0; n < 100; ++n) {
    const Lanes a = random_lanes(generator, -3, 3), b = random_lanes(generator, -3, 3),
                c = random_lanes(generator, 1, 2);
    const Lanes r = (a + b * c - a / c) * sqrt(c) + fma(a, b, c) - abs(b) + min(a, b) * max(b, c);
    for (int i = 0; i < lane_count; ++i) {
      const double x = a[i], y = b[i], z = c[i];
      const double expected = (x + y * z - x / z) * sqrt(z) + fma(x, y, z) - abs(y) + min(x, y) * max(y, z);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(r[i]), std::bit_cast<std::uint64_t>(expected));
    }
  }
}

TEST(Lanes, SelectAndReductionsFollowTheLanes) {
  Lanes a;
  for (int i = 0; i < lane_count; ++i) a.set(i, i * i - 9.0);
  const Lanes r = select(a < Lanes(0.0), Lanes(-1.0), a);
  for (int i = 0; i < lane_count; ++i) EXPECT_EQ(r[i], a[i] < 0 ? -1.0 : a[i]);
  EXPECT_EQ(least(a), -9.0);
  EXPECT_EQ(greatest(a), 40.0);
  EXPECT_EQ(sum(a), 140.0 - 72.0);
  EXPECT_TRUE(any(a < Lanes(-8.5)));
  EXPECT_FALSE(any(a < Lanes(-9.5)));
  EXPECT_TRUE(all(a < Lanes(41.0)));
  EXPECT_FALSE(all(a < Lanes(40.0)));
}

TEST(Lanes, MinAndMaxTreatNaNAlikeOnLanesAndDoubles) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(min(Lanes(nan), Lanes(1.0))[0], min(nan, 1.0));
  EXPECT_EQ(max(Lanes(nan), Lanes(1.0))[3], max(nan, 1.0));
  EXPECT_TRUE(std::isnan(min(Lanes(1.0), Lanes(nan))[0]));
  EXPECT_TRUE(std::isnan(min(1.0, nan)));
}

TEST(Lanes, TranscendentalFunctionsAgreeWithTheScalarTwinToFourUlp) {
  std::mt19937_64 generator(2);
  for (int n = 0; n < 500; ++n) {
    const Lanes x = random_lanes(generator, -20, 20), p = random_lanes(generator, 1e-3, 50),
                e = random_lanes(generator, -3, 3);
    for (int i = 0; i < lane_count; ++i) {
      EXPECT_LE(ulp(exp(x)[i], exp(x[i])), 4) << x[i];
      EXPECT_LE(ulp(log(p)[i], log(p[i])), 4) << p[i];
      EXPECT_LE(ulp(cbrt(p)[i], cbrt(p[i])), 4) << p[i];
      EXPECT_LE(ulp(pow(p, e)[i], pow(p[i], e[i])), 4) << p[i] << " ^ " << e[i];
      EXPECT_NEAR(sin(x)[i], sin(x[i]), 1e-15);
      EXPECT_NEAR(cos(x)[i], cos(x[i]), 1e-15);
    }
  }
}

TEST(Lanes, PowersOfZeroAndOneAreExact) {
  EXPECT_EQ(pow(Lanes(0.0), Lanes(0.3))[0], 0.0);
  EXPECT_EQ(pow(Lanes(1.0), Lanes(2.7))[0], 1.0);
  EXPECT_EQ(pow(Lanes(5.0), Lanes(0.0))[0], 1.0);
  EXPECT_TRUE(std::isnan(pow(Lanes(std::numeric_limits<double>::quiet_NaN()), Lanes(2.0))[0]));
  EXPECT_EQ(exp(Lanes(0.0))[7], 1.0);
  EXPECT_EQ(log(Lanes(1.0))[7], 0.0);
}

}  // namespace
}  // namespace cleave::base
