#include "base/lanes.hpp"

#include <xsimd/xsimd.hpp>

namespace cleave::base {
namespace {

using Native = xsimd::batch<double>;

/// Applies a function of native registers to the eight lanes, register by register.
template <class F>
Lanes by_register(F f, Lanes a) {
  alignas(64) double x[lane_count];
  a.store(x);
  for (std::size_t i = 0; i < lane_count; i += Native::size) f(Native::load_aligned(x + i)).store_aligned(x + i);
  return Lanes::load(x);
}

}  // namespace

Lanes exp(Lanes a) {
  return by_register([](Native x) { return xsimd::exp(x); }, a);
}
Lanes log(Lanes a) {
  return by_register([](Native x) { return xsimd::log(x); }, a);
}
Lanes cbrt(Lanes a) {
  return by_register([](Native x) { return xsimd::cbrt(x); }, a);
}
Lanes sin(Lanes a) {
  return by_register([](Native x) { return xsimd::sin(x); }, a);
}
Lanes cos(Lanes a) {
  return by_register([](Native x) { return xsimd::cos(x); }, a);
}
Lanes pow(Lanes a, Lanes b) {
  alignas(64) double x[lane_count], y[lane_count];
  a.store(x);
  b.store(y);
  for (std::size_t i = 0; i < lane_count; i += Native::size)
    xsimd::pow(Native::load_aligned(x + i), Native::load_aligned(y + i)).store_aligned(x + i);
  return Lanes::load(x);
}

}  // namespace cleave::base
