/// Dual numbers against central differences.

#include <gtest/gtest.h>

#include <cmath>

#include "base/dual.hpp"

namespace cleave::base {
namespace {

TEST(Dual, DerivativesOfEveryFunction) {
  using D = Dual<2>;
  const auto f = [](auto x, auto y) {
    using T = decltype(x);
    return exp(x) * log(y) + sqrt(x * y) / (T(1.0) + cbrt(y)) - sin(x) * cos(y) + pow(x, y) +
           max(x, y) * min(x, T(0.5)) + select(x < y, x * x, y) + abs(-x);
  };
  const double x = 0.7, y = 1.3, h = 1e-6;
  const D r = f(D::variable(x, 0), D::variable(y, 1));
  EXPECT_DOUBLE_EQ(r.value, f(D(x), D(y)).value);
  const double dx = (f(D(x + h), D(y)).value - f(D(x - h), D(y)).value) / (2.0 * h);
  const double dy = (f(D(x), D(y + h)).value - f(D(x), D(y - h)).value) / (2.0 * h);
  EXPECT_NEAR(r.partial[0], dx, 1e-8);
  EXPECT_NEAR(r.partial[1], dy, 1e-8);
}

TEST(Dual, StaysFiniteWhereTheDerivativeDoesNot) {
  const auto zero = Dual<1>::variable(0.0, 0);
  for (const auto& r : {sqrt(zero), cbrt(zero), pow(zero, Dual<1>(0.3))}) {
    EXPECT_EQ(r.value, 0.0);
    EXPECT_EQ(r.partial[0], 0.0);
  }
}

}  // namespace
}  // namespace cleave::base
