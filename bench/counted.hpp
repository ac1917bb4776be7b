#pragma once
/// A number that counts what is done with it: the kernels are templates on the value type, so running one
/// element with it gives their floating-point operations exactly. Comparisons and selections are free, a
/// fused multiply-add counts two, a division and a square root one each.

#include <cmath>

namespace cleave::bench {

struct Counted {
  double value = 0.0;
  static inline long operations = 0;

  Counted() = default;
  Counted(double v) : value(v) {}  // NOLINT: a constant becomes a number as it does with lanes

  static Counted counted(double v, int cost = 1) {
    operations += cost;
    return Counted(v);
  }
  friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return counted(a.value / b.value); }
  friend Counted operator-(Counted a) { return Counted(-a.value); }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
  friend bool operator<=(Counted a, Counted b) { return a.value <= b.value; }
  friend bool operator>=(Counted a, Counted b) { return a.value >= b.value; }
};

inline Counted sqrt(Counted a) {
  return Counted::counted(std::sqrt(a.value));
}
inline Counted cbrt(Counted a) {
  return Counted::counted(std::cbrt(a.value));
}
inline Counted min(Counted a, Counted b) {
  return a < b ? a : b;
}
inline Counted max(Counted a, Counted b) {
  return a > b ? a : b;
}
inline Counted abs(Counted a) {
  return Counted(std::fabs(a.value));
}
inline Counted select(bool m, Counted a, Counted b) {
  return m ? a : b;
}
inline Counted fma(Counted a, Counted b, Counted c) {
  return Counted::counted(a.value * b.value + c.value, 2);
}

}  // namespace cleave::bench
