#pragma once
/// Forward-mode dual numbers: a value with its partial derivatives, so that a kernel written as a template on
/// `Real` yields its exact tangent. For tests and for implicit tangents; not for explicit inner loops.
///
/// Where a function has no derivative (sqrt and pow at 0, min and max at a tie) a one-sided one is taken, and
/// 0 where that is infinite.

#include <array>
#include <cmath>

#include "base/lanes.hpp"

namespace cleave::base {

template <int N>
struct Dual {
  double value;
  std::array<double, N> partial;

  Dual() = default;
  Dual(double v) : value(v), partial{} {}  // NOLINT: a double is a Dual that does not vary
  /// The i-th independent variable.
  static Dual variable(double v, int i) {
    Dual r(v);
    r.partial[i] = 1.0;
    return r;
  }
  /// f(a) with slope f'(a).
  static Dual chain(const Dual& a, double f, double slope) {
    Dual r(f);
    for (int i = 0; i < N; ++i) r.partial[i] = slope * a.partial[i];
    return r;
  }
  static Dual chain(const Dual& a, const Dual& b, double f, double slope_a, double slope_b) {
    Dual r(f);
    for (int i = 0; i < N; ++i) r.partial[i] = slope_a * a.partial[i] + slope_b * b.partial[i];
    return r;
  }

  friend Dual operator+(const Dual& a, const Dual& b) { return chain(a, b, a.value + b.value, 1.0, 1.0); }
  friend Dual operator-(const Dual& a, const Dual& b) { return chain(a, b, a.value - b.value, 1.0, -1.0); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return chain(a, b, a.value * b.value, b.value, a.value);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double f = a.value / b.value;
    return chain(a, b, f, 1.0 / b.value, -f / b.value);
  }
  friend Dual operator-(const Dual& a) { return chain(a, -a.value, -1.0); }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  friend Dual select(bool m, const Dual& a, const Dual& b) { return m ? a : b; }
  friend Dual min(const Dual& a, const Dual& b) { return a < b ? a : b; }
  friend Dual max(const Dual& a, const Dual& b) { return a > b ? a : b; }
  friend Dual abs(const Dual& a) { return a.value < 0.0 ? -a : a; }
  friend Dual sqrt(const Dual& a) {
    const double f = std::sqrt(a.value);
    return chain(a, f, f > 0.0 ? 0.5 / f : 0.0);
  }
  friend Dual exp(const Dual& a) { return chain(a, std::exp(a.value), std::exp(a.value)); }
  friend Dual log(const Dual& a) { return chain(a, std::log(a.value), 1.0 / a.value); }
  friend Dual cbrt(const Dual& a) {
    const double f = std::cbrt(a.value);
    return chain(a, f, f != 0.0 ? f / (3.0 * a.value) : 0.0);
  }
  friend Dual sin(const Dual& a) { return chain(a, std::sin(a.value), std::cos(a.value)); }
  friend Dual cos(const Dual& a) { return chain(a, std::cos(a.value), -std::sin(a.value)); }
  friend Dual pow(const Dual& a, const Dual& b) {
    const double f = std::pow(a.value, b.value);
    return a.value > 0.0 ? chain(a, b, f, b.value * f / a.value, f * std::log(a.value)) : Dual(f);
  }
};

}  // namespace cleave::base
