#pragma once
/// Forces of touches into sums.

#include <algorithm>
#include <cmath>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Adds a force on the nodes a and its opposite on the nodes b so that the integers cancel exactly.
class Balanced {
 public:
  explicit Balanced(discretisation::ForceSum& sum) : sum_(sum) {}

  void add(const Touch& touch, const Vector& force) {
    const double f[3] = {force.x, force.y, force.z};
    for (int i = 0; i < 3; ++i) {
      if (f[i] == 0.0) continue;
      largest_ = std::max(largest_, std::abs(f[i]));
      if (std::abs(f[i]) < 0.25 * sum_.limit())
        integers(touch, i, f[i]);
      else
        values(touch, i, f[i]);
    }
  }
  double largest() const { return largest_; }

 private:
  void integers(const Touch& touch, int i, double f) {
    std::int64_t rest = 0;
    int last = 0;
    for (int k = 0; k < 4; ++k) {
      if (touch.wa[k] != 0.0) give(touch.a[k], i, sum_.quantum(touch.wa[k] * f), rest);
      if (touch.wb[k] != 0.0) give(touch.b[k], i, sum_.quantum(-touch.wb[k] * f), rest), last = k;
    }
    sum_.add(touch.b[last], i, -rest, true);
  }
  void give(Index node, int i, std::int64_t integer, std::int64_t& rest) {
    sum_.add(node, i, integer, true);
    rest += integer;
  }
  /// Beyond the range of the sum: parts that are multiples of one power of two, so that each is exact in
  /// whatever scale it is summed.
  void values(const Touch& touch, int i, double f) {
    int exponent = 0;
    std::frexp(f, &exponent);
    const double unit = std::ldexp(1.0, exponent - 17);
    double rest = 0.0;
    int last = 0;
    const auto part = [&](Index node, double value) {
      const double whole = unit * std::nearbyint(value / unit);
      sum_.add_value(node, i, whole);
      rest += whole;
    };
    for (int k = 0; k < 4; ++k) {
      if (touch.wa[k] != 0.0) part(touch.a[k], touch.wa[k] * f);
      if (touch.wb[k] != 0.0) part(touch.b[k], -touch.wb[k] * f), last = k;
    }
    sum_.add_value(touch.b[last], i, -rest);
  }
  discretisation::ForceSum& sum_;
  double largest_ = 0.0;
};

/// Adds the shares of a force to the nodes of both sides [node][3].
inline void add_touch(const Touch& touch, const Vector& f, std::span<double> force) {
  const auto add = [&](Index node, double share) {
    double* to = &force[3 * static_cast<std::size_t>(node)];
    to[0] += share * f.x;
    to[1] += share * f.y;
    to[2] += share * f.z;
  };
  for (int k = 0; k < 4; ++k) {
    add(touch.a[k], touch.wa[k]);
    add(touch.b[k], -touch.wb[k]);
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
