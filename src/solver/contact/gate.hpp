#pragma once
/// Lets through the pairs of faces that may overlap, eight at a time. Most that are near each other look
/// elsewhere, lie beside each other, or do not reach each other.

#include <array>

#include "base/lanes.hpp"
#include "solver/contact/surface.hpp"

namespace cleave::solver {

class Gate {
 public:
  using Lanes = base::Lanes;
  using Wide = base::Vec3<Lanes>;

  /// Corners of eight faces.
  struct Corners {
    alignas(64) double at[4][3][base::lane_count];
    void set(std::size_t corner, std::size_t lane, const Vector& x) {
      at[corner][0][lane] = x.x;
      at[corner][1][lane] = x.y;
      at[corner][2][lane] = x.z;
    }
    std::array<Vector, 4> face(std::size_t lane) const {
      std::array<Vector, 4> x;
      for (std::size_t i = 0; i < 4; ++i) x[i] = {at[i][0][lane], at[i][1][lane], at[i][2][lane]};
      return x;
    }
    Wide corner(std::size_t i) const {
      return {Lanes::load(at[i][0]), Lanes::load(at[i][1]), Lanes::load(at[i][2])};
    }
  };

  /// @param face  corners; a triangle repeats the third [length]
  explicit Gate(const Vector face[4]) {
    const bool triangle = face[3].x == face[2].x && face[3].y == face[2].y && face[3].z == face[2].z;
    Vector normal = base::cross(face[2] - face[0], face[3] - face[1]);
    const double size = norm(normal);
    normal = (size > 0.0 ? 1.0 / size : 0.0) * normal;
    Vector middle{0, 0, 0};
    const int count = triangle ? 3 : 4;
    for (int i = 0; i < count; ++i) middle = middle + (1.0 / count) * face[i];
    for (std::size_t i = 0; i < 4; ++i) x_[i] = wide(face[i]);
    normal_ = wide(normal);
    warp_ = 0.25 * std::abs(base::dot(face[0] - face[1] + face[2] - face[3], normal));
    middle_ = wide(middle);
  }

  /// False only where `Overlap::meet` of the face with that of a lane is false, or it is everywhere deeper
  /// than a limit: most of those are the other sides of a body.
  base::Mask open(const Corners& corners, Lanes limit = Lanes(1e300)) const {
    Wide y[4];
    for (std::size_t i = 0; i < 4; ++i) y[i] = corners.corner(i);
    const Wide area = cross(y[2] - y[0], y[3] - y[1]);
    const Lanes size = sqrt(dot(area, area));
    const Lanes facing = -dot(normal_, area);
    base::Mask may = (facing > least_facing * size) & (size > Lanes(0.0));

    // Axes across the mean normal, of any length: boxes along them.
    const Wide n = area - size * normal_;
    const Wide edge = y[1] - y[0];
    const Wide e1 = dot(n, n) * edge - dot(edge, n) * n;
    may = may & meet(e1, y) & meet(cross(n, e1), y);

    // How far the plane of the face lies behind that of the other, along n: the largest over the corners of
    // each must not be before it.
    const Wide triple = (1.0 / 3.0) * (y[0] + y[1] + y[2]), four = 0.25 * (y[0] + y[1] + y[2] + y[3]);
    const base::Mask triangle = equal(y[2], y[3]);
    const Wide middle{select(triangle, triple.x, four.x), select(triangle, triple.y, four.y),
                      select(triangle, triple.z, four.z)};
    const Lanes steep_a = dot(n, normal_), steep_b = dot(n, area);  // below and above zero
    Lanes of_a = -1e300, of_b = -1e300, least = 1e300;
    for (std::size_t i = 0; i < 4; ++i) {
      const Lanes a = depth(x_[i], middle, area, steep_a, steep_b);
      const Lanes b = depth(y[i], middle, area, steep_a, steep_b);
      of_a = max(of_a, a);
      of_b = max(of_b, b);
      least = min(least, min(a, b));
    }
    // A face that is not plane deviates from its plane by as much as its corners do.
    const Lanes slack = warp_ * steep_b - 0.25 * abs(dot(y[0] - y[1] + y[2] - y[3], area)) * steep_a;
    return may & (of_a + slack >= Lanes(0.0)) & (of_b + slack >= Lanes(0.0)) &
           ((least - slack) * sqrt(dot(n, n)) <= -limit * steep_a * steep_b);
  }

 private:
  static constexpr double least_facing = 0.1;  // as in overlap.cpp

  static Wide wide(const Vector& v) { return {Lanes(v.x), Lanes(v.y), Lanes(v.z)}; }
  static base::Mask equal(const Wide& a, const Wide& b) {
    return (a.x <= b.x) & (a.x >= b.x) & (a.y <= b.y) & (a.y >= b.y) & (a.z <= b.z) & (a.z >= b.z);
  }
  base::Mask meet(const Wide& axis, const Wide y[4]) const {
    Lanes low_a = 1e300, high_a = -1e300, low_b = 1e300, high_b = -1e300;
    for (std::size_t i = 0; i < 4; ++i) {
      const Lanes a = dot(x_[i] - y[0], axis), b = dot(y[i] - y[0], axis);
      low_a = min(low_a, a);
      high_a = max(high_a, a);
      low_b = min(low_b, b);
      high_b = max(high_b, b);
    }
    return (low_a <= high_b) & (low_b <= high_a);
  }
  /// Times minus the product of both steepnesses, which is above zero.
  Lanes depth(const Wide& at, const Wide& middle, const Wide& area, Lanes steep_a, Lanes steep_b) const {
    const Lanes to_a = dot(middle_ - at, normal_), to_b = dot(middle - at, area);
    return to_a * steep_b - to_b * steep_a;
  }

  Wide x_[4], normal_, middle_;
  double warp_ = 0.0;
};

}  // namespace cleave::solver
