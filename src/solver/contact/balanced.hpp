#pragma once
/// Forces of touches into sums.

#include <algorithm>
#include <cmath>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Adds the forces of touches so that the integers of both sides cancel exactly.
class Balanced {
 public:
  explicit Balanced(discretisation::ForceSum& sum) : sum_(sum) {}

  void add(const Touch& touch) {
    Index node[8];
    double force[8][3];
    int count = 0;
    const auto part = [&](Index at, const Vector& f) {
      node[count] = at;
      force[count][0] = f.x;
      force[count][1] = f.y;
      force[count++][2] = f.z;
    };
    for (int k = 0; k < 4; ++k) {
      if (touch.wa[k] != 0.0 || touch.faces) part(touch.a[k], force_on_a(touch, k));
      if (touch.wb[k] != 0.0 || touch.faces) part(touch.b[k], force_on_b(touch, k));
    }
    for (int i = 0; i < 3; ++i) {
      double most = 0.0;
      for (int k = 0; k < count; ++k) most = std::max(most, std::abs(force[k][i]));
      if (most == 0.0) continue;
      largest_ = std::max(largest_, most);
      if (most < 0.25 * sum_.limit())
        integers(node, force, count, i);
      else
        values(node, force, count, i, most);
    }
  }
  double largest() const { return largest_; }

 private:
  void integers(const Index* node, const double (*force)[3], int count, int i) {
    std::int64_t rest = 0;
    for (int k = 0; k < count; ++k) {
      const std::int64_t integer = sum_.quantum(force[k][i]);
      sum_.add(node[k], i, integer, true);
      rest += integer;
    }
    sum_.add(node[count - 1], i, -rest, true);
  }
  /// Beyond the range of the sum: parts that are multiples of one power of two, so that each is exact in
  /// whatever scale it is summed.
  void values(const Index* node, const double (*force)[3], int count, int i, double most) {
    int exponent = 0;
    std::frexp(most, &exponent);
    const double unit = std::ldexp(1.0, exponent - 17);
    double rest = 0.0;
    for (int k = 0; k < count; ++k) {
      const double whole = unit * std::nearbyint(force[k][i] / unit);
      sum_.add_value(node[k], i, whole);
      rest += whole;
    }
    sum_.add_value(node[count - 1], i, -rest);
  }
  discretisation::ForceSum& sum_;
  double largest_ = 0.0;
};

/// Adds the forces of a touch to the nodes of both sides [node][3].
inline void add_touch(const Touch& touch, std::span<double> force) {
  const auto add = [&](Index node, const Vector& f) {
    double* to = &force[3 * static_cast<std::size_t>(node)];
    to[0] += f.x;
    to[1] += f.y;
    to[2] += f.z;
  };
  for (int k = 0; k < 4; ++k) {
    add(touch.a[k], force_on_a(touch, k));
    add(touch.b[k], force_on_b(touch, k));
  }
}

/// Adds the pressure of forces [node][3] on areas [node] to each node [stress].
inline void add_pressure(std::span<const double> force, std::span<const Vector> area,
                         std::span<double> pressure) {
  for (std::size_t a = 0; a < area.size(); ++a) {
    const double square = base::dot(area[a], area[a]);
    if (square > 0.0) pressure[a] -= base::dot(area[a], vector_at(force, static_cast<Index>(a))) / square;
  }
}

/// Sets the forces of the nodes of both sides to zero [node][3].
inline void clear_touch(const Touch& touch, std::span<double> force) {
  for (const auto& nodes : {touch.a, touch.b})
    for (int k = 0; k < 4; ++k) {
      double* at = &force[3 * static_cast<std::size_t>(nodes[k])];
      at[0] = at[1] = at[2] = 0.0;
    }
}

}  // namespace cleave::solver
