#pragma once
/// Small simplices in space and time: volumes, distances, slopes, and how high a corner may rise.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "discretisation/spacetime/patch.hpp"

namespace cleave::discretisation::spacetime {

/// A point of space. [length]
template <int D>
using Point = std::array<double, D>;

template <std::size_t N>
std::array<double, N> difference(const std::array<double, N>& a, const std::array<double, N>& b) {
  std::array<double, N> d;
  for (std::size_t k = 0; k < N; ++k) d[k] = a[k] - b[k];
  return d;
}

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double s = 0.0;
  for (std::size_t k = 0; k < N; ++k) s += a[k] * b[k];
  return s;
}

template <std::size_t N>
double norm(const std::array<double, N>& a) {
  return std::sqrt(dot(a, a));
}

template <std::size_t N>
double distance(const std::array<double, N>& a, const std::array<double, N>& b) {
  return norm(difference(a, b));
}

/// Determinant of the N rows.
template <std::size_t N>
double determinant(const std::array<std::array<double, N>, N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    double sum = 0.0;
    for (std::size_t k = 0; k < N; ++k) {
      std::array<std::array<double, N - 1>, N - 1> minor;
      for (std::size_t i = 1; i < N; ++i)
        for (std::size_t j = 0, to = 0; j < N; ++j)
          if (j != k) minor[i - 1][to++] = m[i][j];
      sum += (k % 2 == 0 ? 1.0 : -1.0) * m[0][k] * determinant(minor);
    }
    return sum;
  }
}

/// Signed volume of the simplex with N + 1 corners in N dimensions. [length^N], or [length^D time]
template <std::size_t N>
double signed_volume(const std::array<std::array<double, N>, N + 1>& corner) {
  std::array<std::array<double, N>, N> edge;
  double factorial = 1.0;
  for (std::size_t i = 0; i < N; ++i) {
    edge[i] = difference(corner[i + 1], corner[0]);
    factorial *= static_cast<double>(i + 1);
  }
  return determinant(edge) / factorial;
}

/// Area vector of the simplex with N corners in N dimensions: normal to it, as long as its measure is large;
/// points away from `behind`.
template <std::size_t N>
std::array<double, N> area_vector(const std::array<std::array<double, N>, N>& corner,
                                  const std::array<double, N>& behind) {
  std::array<double, N> normal;
  if constexpr (N == 1) {
    normal[0] = 1.0;
  } else {
    double factorial = 1.0;
    for (std::size_t i = 2; i < N; ++i) factorial *= static_cast<double>(i);
    for (std::size_t k = 0; k < N; ++k) {
      std::array<std::array<double, N - 1>, N - 1> minor;
      for (std::size_t i = 1; i < N; ++i)
        for (std::size_t j = 0, to = 0; j < N; ++j)
          if (j != k) minor[i - 1][to++] = corner[i][j] - corner[0][j];
      normal[k] = (k % 2 == 0 ? 1.0 : -1.0) * determinant(minor) / factorial;
    }
  }
  if (dot(normal, difference(behind, corner[0])) > 0.0)
    for (double& component : normal) component = -component;
  return normal;
}

/// Where a corner stands above the K other corners of a sub-simplex whose times are given.
struct Foot {
  double time = 0.0;    ///< affine extension of the times of the others to the foot of the altitude [time]
  double height = 0.0;  ///< altitude of the corner over the others [length]
  double slope2 = 0.0;  ///< square of the gradient of time on the others [time^2 / length^2]
};

/// The altitude from x over K = 1, 2, 3 others.
template <int D, int K>
Foot foot_of(const Point<D>& x, const std::array<Point<D>, K>& other, const std::array<double, K>& time) {
  const Point<D> to = difference(x, other[0]);
  if constexpr (K == 1) {
    return {.time = time[0], .height = norm(to), .slope2 = 0.0};
  } else if constexpr (K == 2) {
    const Point<D> e = difference(other[1], other[0]);
    const double length2 = dot(e, e), rise = time[1] - time[0], along = dot(to, e) / length2;
    Point<D> up;
    for (std::size_t k = 0; k < D; ++k) up[k] = to[k] - along * e[k];
    return {.time = time[0] + along * rise, .height = norm(up), .slope2 = rise * rise / length2};
  } else {
    const Point<D> e = difference(other[1], other[0]), f = difference(other[2], other[0]);
    const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), det = ee * ff - ef * ef;
    const double xe = dot(to, e), xf = dot(to, f), re = time[1] - time[0], rf = time[2] - time[0];
    const double a = (xe * ff - xf * ef) / det, b = (xf * ee - xe * ef) / det;
    Point<D> up;
    for (std::size_t k = 0; k < D; ++k) up[k] = to[k] - a * e[k] - b * f[k];
    return {.time = time[0] + a * re + b * rf,
            .height = norm(up),
            .slope2 = (re * re * ff - 2.0 * re * rf * ef + rf * rf * ee) / det};
  }
}

/// Latest time of the corner that keeps |grad time| <= bound: the causality limit of docs/spacetime.md.
/// Minus infinity when the others are already steeper than the bound. [time]
inline double highest(const Foot& foot, double bound) {
  const double rest = bound * bound - foot.slope2;
  if (rest < -1e-12 * bound * bound) return -std::numeric_limits<double>::infinity();
  return foot.time + foot.height * std::sqrt(std::max(rest, 0.0));
}

/// |grad time| with the corner at `time`. [time / length]
inline double slope(const Foot& foot, double time) {
  const double rise = (time - foot.time) / foot.height;
  return std::sqrt(foot.slope2 + rise * rise);
}

/// Distance of p from the segment ab.
template <int D>
double distance_to_segment(const Point<D>& p, const Point<D>& a, const Point<D>& b) {
  const Point<D> e = difference(b, a), to = difference(p, a);
  const double s = std::clamp(dot(to, e) / dot(e, e), 0.0, 1.0);
  Point<D> rest;
  for (std::size_t k = 0; k < D; ++k) rest[k] = to[k] - s * e[k];
  return norm(rest);
}

/// Distance of p from the line through a and b.
template <int D>
double distance_to_line(const Point<D>& p, const Point<D>& a, const Point<D>& b) {
  return foot_of<D, 2>(p, {a, b}, {0.0, 0.0}).height;
}

/// sin of the angle under which a face turns away from the corner p: distance from the face's plane over
/// distance from the face; 1 when p projects into the face.
template <int D>
double openness_of_edge(const Point<D>& p, const Point<D>& a, const Point<D>& b) {
  return std::min(1.0, distance_to_line<D>(p, a, b) / distance_to_segment<D>(p, a, b));
}

/// As above for a triangle in three dimensions.
inline double openness_of_triangle(const Point<3>& p, const std::array<Point<3>, 3>& f) {
  const Point<3> e = difference(f[1], f[0]), g = difference(f[2], f[0]), to = difference(p, f[0]);
  const double ee = dot(e, e), eg = dot(e, g), gg = dot(g, g), det = ee * gg - eg * eg;
  const double a = (dot(to, e) * gg - dot(to, g) * eg) / det, b = (dot(to, g) * ee - dot(to, e) * eg) / det;
  if (a >= 0.0 && b >= 0.0 && a + b <= 1.0) return 1.0;
  const double nearest =
      std::min({distance_to_segment<3>(p, f[0], f[1]), distance_to_segment<3>(p, f[0], f[2]),
                distance_to_segment<3>(p, f[1], f[2])});
  return std::min(1.0, foot_of<3, 3>(p, f, {0.0, 0.0, 0.0}).height / nearest);
}

}  // namespace cleave::discretisation::spacetime
