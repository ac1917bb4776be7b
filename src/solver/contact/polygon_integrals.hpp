#pragma once
/// Integrals over the polygon that two faces share, and how they change when its edges move.

#include <algorithm>

#include "solver/contact/shadow.hpp"

namespace cleave::solver {

/// The sum over all lanes.
inline double total(const base::Lanes& lanes) {
  alignas(64) double x[base::lane_count];
  lanes.store(x);
  return ((x[0] + x[4]) + (x[1] + x[5])) + ((x[2] + x[6]) + (x[3] + x[7]));
}

/// The middles of the edges of a fan of triangles, with weights: exact to second degree. Lanes that are
/// not needed have no weight and lie on the first corner.
struct Quadrature {
  static constexpr int room = 24;  // the edges of a fan of most corners are 2 most - 3
  static_assert(room >= 2 * Polygon::most - 3 && room % base::lane_count == 0);
  alignas(64) double x[room], y[room], area[room];
  int count = 0;

  explicit Quadrature(const Polygon& polygon) {
    const auto add = [&](const Point& a, const Point& b, double weight) {
      x[count] = 0.5 * (a.x + b.x);
      y[count] = 0.5 * (a.y + b.y);
      area[count++] = weight;
    };
    const Point* p = polygon.at;
    double last = 0.0;
    for (int i = 2; i < polygon.count; ++i) {
      const double third = std::max(cross2(p[0], p[i - 1], p[i]) / 6.0, 0.0);
      add(p[0], p[i - 1], last + third);
      add(p[i - 1], p[i], third);
      last = third;
    }
    add(p[0], p[polygon.count - 1], last);
    while (count % base::lane_count != 0) add(p[0], p[0], 0.0);
  }
  /// The point in the middle of the edge from a corner to the next.
  static int of_edge(const Polygon& polygon, int i) {
    if (i == 0) return 0;
    return i + 1 < polygon.count ? 2 * i - 1 : 2 * (polygon.count - 2);
  }
};

/// Integrals of a depth that is linear in each triangle of a fan: positive however much faces are warped.
struct Cone {
  static constexpr int room = 16;
  static_assert(room >= Polygon::most && room % base::lane_count == 0);
  alignas(64) double x[room], y[room];                      // the corners
  alignas(64) double with_square[room], with_volume[room];  // changes of both integrals with their depths
  double area = 0.0, volume = 0.0, square = 0.0;

  void integrate(const Polygon& polygon, const double* depth) {
    for (int i = 0; i < room; ++i) {
      x[i] = polygon.at[i < polygon.count ? i : 0].x;
      y[i] = polygon.at[i < polygon.count ? i : 0].y;
      with_square[i] = with_volume[i] = 0.0;
    }
    for (int i = 2; i < polygon.count; ++i) {
      const int corner[3] = {0, i - 1, i};
      const double part = std::max(0.5 * cross2(polygon.at[0], polygon.at[i - 1], polygon.at[i]), 0.0);
      const double sum = depth[0] + depth[i - 1] + depth[i];
      area += part;
      volume += part * sum / 3.0;
      for (const int c : corner) {
        square += part / 12.0 * depth[c] * (sum + depth[c]);
        with_square[c] += part / 6.0 * (sum + depth[c]);
        with_volume[c] += part / 3.0;
      }
    }
  }
};

/// How wide a polygon is across its long side, from its second moments M around the centroid: of a long strip
/// w, of a square a / sqrt 2, without a kink between them.
///     w^2 = 12 det M / (area trace M)
struct Width {
  double square = 0.0;  ///< w^2 [length^2]

  void measure(const Polygon& polygon) {
    // From one corner, along the way to the farthest: so a strip leaves no difference of large numbers.
    origin_ = polygon.at[0];
    double far = 0.0;
    Point along{1.0, 0.0};
    for (int i = 1; i < polygon.count; ++i) {
      const Point way{polygon.at[i].x - origin_.x, polygon.at[i].y - origin_.y};
      const double length2 = way.x * way.x + way.y * way.y;
      if (length2 > far) far = length2, along = way;
    }
    if (!(far > 0.0)) return;
    const double per = 1.0 / std::sqrt(far);
    axis_ = {along.x * per, along.y * per};
    Point last = turned(polygon.at[1]);
    for (int i = 2; i < polygon.count; ++i) {
      const Point next = turned(polygon.at[i]);
      const double part = 0.5 * (last.x * next.y - last.y * next.x);
      const double x = last.x + next.x, y = last.y + next.y;
      area_ += part;
      middle_.x += part * x / 3.0;
      middle_.y += part * y / 3.0;
      xx_ += part * (last.x * last.x + next.x * next.x + x * x) / 12.0;
      yy_ += part * (last.y * last.y + next.y * next.y + y * y) / 12.0;
      xy_ += part * (last.x * last.y + next.x * next.y + x * y) / 12.0;
      last = next;
    }
    if (!(area_ > 0.0)) return;
    middle_ = {middle_.x / area_, middle_.y / area_};
    xx_ -= area_ * middle_.x * middle_.x;
    yy_ -= area_ * middle_.y * middle_.y;
    xy_ -= area_ * middle_.x * middle_.y;
    determinant_ = xx_ * yy_ - xy_ * xy_;
    if (determinant_ > 0.0) square = 12.0 * determinant_ / (area_ * (xx_ + yy_));
  }
  /// By how much w^2 grows per area that is added at a place [-].
  double change(const Point& at) const {
    if (!(square > 0.0)) return 0.0;
    Point d = turned(at);
    d = {d.x - middle_.x, d.y - middle_.y};
    const double of_determinant = yy_ * d.x * d.x + xx_ * d.y * d.y - 2.0 * xy_ * d.x * d.y;
    return square * (of_determinant / determinant_ - (d.x * d.x + d.y * d.y) / (xx_ + yy_) - 1.0 / area_);
  }

 private:
  Point turned(const Point& p) const {
    const double x = p.x - origin_.x, y = p.y - origin_.y;
    return {x * axis_.x + y * axis_.y, y * axis_.x - x * axis_.y};
  }
  Point origin_{0.0, 0.0}, axis_{1.0, 0.0}, middle_{0.0, 0.0};
  double area_ = 0.0, xx_ = 0.0, yy_ = 0.0, xy_ = 0.0, determinant_ = 0.0;
};

/// Sums over points of the change with the gap times what the gap depends on.
struct Gathered {
  base::Lanes z[4] = {0.0, 0.0, 0.0, 0.0}, x[4] = {0.0, 0.0, 0.0, 0.0}, y[4] = {0.0, 0.0, 0.0, 0.0};

  void add(const ShadowValue& v, base::Lanes with_gap) {
    const base::Lanes sx = with_gap * v.slope_x, sy = with_gap * v.slope_y;
    for (int c = 0; c < 4; ++c) {
      z[c] += with_gap * v.w[c];
      x[c] += sx * v.w[c];
      y[c] += sy * v.w[c];
    }
  }
  /// @param sign  1 where the gap grows with the height of the face
  void give(double sign, ShadowChange& to) const {
    double height[4], along_x[4], along_y[4];
    for (int c = 0; c < 4; ++c) height[c] = total(z[c]), along_x[c] = total(x[c]), along_y[c] = total(y[c]);
    to.add(sign, height, along_x, along_y);
  }
};

/// The energy changes where an edge of a polygon moves outward with the line it lies on: by its density times
/// the way, which is linear between the ends of the line (Simpson's rule).
/// @param density  at the first corner, the middle and the second
inline void move_edge(const Point& first, const Point& second, const double density[3], const Point& from,
                      const Point& to, Point& with_from, Point& with_to) {
  const double lx = to.x - from.x, ly = to.y - from.y;
  const double per = 1.0 / (lx * lx + ly * ly);
  const double s = ((first.x - from.x) * lx + (first.y - from.y) * ly) * per;
  const double t = ((second.x - from.x) * lx + (second.y - from.y) * ly) * per;
  const double all = (density[0] + 4.0 * density[1] + density[2]) / 6.0;
  const double at_to = (density[0] * s + 2.0 * density[1] * (s + t) + density[2] * t) / 6.0;
  const double out_x = second.y - first.y, out_y = first.x - second.x;  // outward, times the length
  with_to.x += at_to * out_x;
  with_to.y += at_to * out_y;
  with_from.x += (all - at_to) * out_x;
  with_from.y += (all - at_to) * out_y;
}

}  // namespace cleave::solver
