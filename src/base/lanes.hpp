#pragma once
/// Eight doubles that move together: the one door to SIMD.
///
/// The width is eight on every machine (one AVX-512 register, two AVX, four SSE), so layouts,
/// restart files and results do not depend on the hardware. Every operation is the IEEE operation
/// per lane; kernels written as templates on `Real` give the same bits with `Real = double`.
/// Kernels must not branch on a Real: use min, max, select. No intrinsics outside this file.

#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__AVX512F__) || defined(__FMA__)
#include <immintrin.h>
#endif

namespace cleave::base {

inline constexpr int lane_count = 8;

/// The truth of a comparison, lane by lane (all bits set, or none).
struct Mask {
  using Vector = std::int64_t __attribute__((vector_size(64)));
  Vector v;

  friend Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
  friend Mask operator|(Mask a, Mask b) { return {a.v | b.v}; }
  friend Mask operator!(Mask a) { return {~a.v}; }
  bool operator[](int lane) const { return v[lane] != 0; }
};

struct Lanes {
  using Vector = double __attribute__((vector_size(64)));
  Vector v;

  Lanes() = default;
  Lanes(double s) : v{s, s, s, s, s, s, s, s} {}  // NOLINT: a double is a Lanes with equal lanes
  explicit Lanes(Vector vector) : v(vector) {}

  static Lanes load(const double* aligned) {
    return Lanes(*static_cast<const Vector*>(__builtin_assume_aligned(aligned, 64)));
  }
  void store(double* aligned) const { *static_cast<Vector*>(__builtin_assume_aligned(aligned, 64)) = v; }
  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double value) { v[lane] = value; }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  Lanes& operator+=(Lanes b) {
    v += b.v;
    return *this;
  }
  Lanes& operator-=(Lanes b) {
    v -= b.v;
    return *this;
  }
  Lanes& operator*=(Lanes b) {
    v *= b.v;
    return *this;
  }
  Lanes& operator/=(Lanes b) {
    v /= b.v;
    return *this;
  }

  friend Mask operator<(Lanes a, Lanes b) { return {(Mask::Vector)(a.v < b.v)}; }
  friend Mask operator<=(Lanes a, Lanes b) { return {(Mask::Vector)(a.v <= b.v)}; }
  friend Mask operator>(Lanes a, Lanes b) { return {(Mask::Vector)(a.v > b.v)}; }
  friend Mask operator>=(Lanes a, Lanes b) { return {(Mask::Vector)(a.v >= b.v)}; }
};

// --- the operations a kernel may use, for lanes and for a plain double -------------------------

inline Lanes select(Mask m, Lanes a, Lanes b) {  ///< m ? a : b
  Mask::Vector ab, bb;
  std::memcpy(&ab, &a.v, sizeof ab);
  std::memcpy(&bb, &b.v, sizeof bb);
  const Mask::Vector r = (m.v & ab) | (~m.v & bb);
  Lanes out;
  std::memcpy(&out.v, &r, sizeof r);
  return out;
}
inline double select(bool m, double a, double b) {
  return m ? a : b;
}

/// min and max return the second argument when either is NaN, on lanes and doubles alike.
inline Lanes min(Lanes a, Lanes b) {
  return select(a < b, a, b);
}
inline Lanes max(Lanes a, Lanes b) {
  return select(a > b, a, b);
}
inline double min(double a, double b) {
  return a < b ? a : b;
}
inline double max(double a, double b) {
  return a > b ? a : b;
}

inline bool any(Mask m) {
  std::int64_t r = 0;
  for (int i = 0; i < lane_count; ++i) r |= m.v[i];
  return r != 0;
}
inline bool any(bool m) {
  return m;
}
inline bool all(Mask m) {
  return !any(!m);
}
inline bool all(bool m) {
  return m;
}

inline Lanes sqrt(Lanes a) {
#if defined(__AVX512F__)
  return Lanes((Lanes::Vector)_mm512_sqrt_pd((__m512d)a.v));
#else
  Lanes r;
  for (int i = 0; i < lane_count; ++i) r.v[i] = std::sqrt(a.v[i]);
  return r;
#endif
}
inline double sqrt(double a) {
  return std::sqrt(a);
}

inline Lanes abs(Lanes a) {
  return select(a < Lanes(0.0), -a, a);
}
inline double abs(double a) {
  return std::fabs(a);
}

/// a * b + c with one rounding.
inline Lanes fma(Lanes a, Lanes b, Lanes c) {
#if defined(__AVX512F__)
  return Lanes((Lanes::Vector)_mm512_fmadd_pd((__m512d)a.v, (__m512d)b.v, (__m512d)c.v));
#else
  Lanes r;
  for (int i = 0; i < lane_count; ++i) r.v[i] = std::fma(a.v[i], b.v[i], c.v[i]);
  return r;
#endif
}
inline double fma(double a, double b, double c) {
  return std::fma(a, b, c);
}

// Transcendental functions: agree between lanes and double to 4 ulp, not to the bit.
Lanes exp(Lanes a);
Lanes log(Lanes a);
Lanes pow(Lanes a, Lanes b);  ///< a >= 0
Lanes cbrt(Lanes a);
Lanes sin(Lanes a);
Lanes cos(Lanes a);
inline double exp(double a) {
  return std::exp(a);
}
inline double log(double a) {
  return std::log(a);
}
inline double pow(double a, double b) {
  return std::pow(a, b);
}
inline double cbrt(double a) {
  return std::cbrt(a);
}
inline double sin(double a) {
  return std::sin(a);
}
inline double cos(double a) {
  return std::cos(a);
}

/// Reductions over the lanes of one batch, always in lane order.
inline double least(Lanes a) {
  double r = a.v[0];
  for (int i = 1; i < lane_count; ++i) r = min(a.v[i], r);
  return r;
}
inline double greatest(Lanes a) {
  return -least(-a);
}
inline double sum(Lanes a) {
  return ((a.v[0] + a.v[1]) + (a.v[2] + a.v[3])) + ((a.v[4] + a.v[5]) + (a.v[6] + a.v[7]));
}

}  // namespace cleave::base
