#include "base/lanes.hpp"

#include <limits>
#include <xsimd/xsimd.hpp>

namespace cleave::base {
namespace {

using Native = xsimd::batch<double>;

/// Applies a function of native registers to the eight lanes, register by register.
template <class F>
Lanes by_register(F f, Lanes a) {
  alignas(64) double x[lane_count];
  a.store(x);
  for (std::size_t i = 0; i < lane_count; i += Native::size)
    f(Native::load_aligned(x + i)).store_aligned(x + i);
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
/// exp(b log a) with the logarithm carried in two parts, so that the error does not grow with |b log a|:
/// log a = k ln 2 + log m with m in [sqrt(1/2), sqrt(2)), k ln 2 split into an exact and a small part.
/// Source: the argument split of Cody & Waite, Software Manual for the Elementary Functions (1980), ch. 7.
Lanes pow(Lanes a, Lanes b) {
  constexpr double ln2_high = 0x1.62e42fefa38p-1,
                   ln2_low = 0x1.ef35793c7673p-45;  // high: 11 trailing zero bits
  constexpr std::int64_t one_bits = 0x3ff0000000000000, mantissa = 0x000fffffffffffff;

  // m in [1, 2), then halved above sqrt(2)
  Mask::Vector bits;
  std::memcpy(&bits, &a.v, sizeof bits);
  const Mask::Vector exponent = (bits >> 52) - 1023;
  const Mask::Vector m_bits = (bits & mantissa) | one_bits;
  Lanes m, k(__builtin_convertvector(exponent, Lanes::Vector));
  std::memcpy(&m.v, &m_bits, sizeof m_bits);
  const Mask upper = m > Lanes(1.4142135623730951);
  m = select(upper, m * Lanes(0.5), m);
  k = select(upper, k + Lanes(1.0), k);

  // log a = high + low
  const Lanes log_m = log(m), k_ln2 = k * Lanes(ln2_high);
  const Lanes high = k_ln2 + log_m;
  const Lanes from_m = high - k_ln2;
  const Lanes low = (k_ln2 - (high - from_m)) + (log_m - from_m) + k * Lanes(ln2_low);

  // b log a = p + rest
  const Lanes p = b * high;
  const Lanes rest = fma(b, high, -p) + b * low;
  const Lanes e = exp(p);
  const Lanes result = fma(e, rest, e) + (a - a);  // NaN stays NaN
  const Lanes of_zero = select(b > Lanes(0.0), Lanes(0.0), Lanes(std::numeric_limits<double>::infinity()));
  const Lanes positive = select(a <= Lanes(0.0), of_zero, result);
  return select((b <= Lanes(0.0)) & (b >= Lanes(0.0)), Lanes(1.0), positive);
}

}  // namespace cleave::base
