#pragma once
/// Two faces seen along one direction: their corners in a plane, polygons there, and how what is computed of
/// a polygon depends on the corners.

#include <algorithm>
#include <cmath>

#include "base/lanes.hpp"
#include "solver/contact/surface.hpp"

namespace cleave::solver {

struct Point {
  double x, y;
};
/// Twice the area of a triangle, positive counter-clockwise.
inline double cross2(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Values of the corner functions of a face at eight points, and the slope of its height there.
struct ShadowValue {
  base::Lanes w[4], z, slope_x, slope_y;
};

/// A face seen along the common normal.
struct Shadow {
  Point p[4];
  double z[4];
  int count;

  /// The bilinear (triangles: linear) functions; points of the face only.
  ShadowValue at(base::Lanes x, base::Lanes y) const {
    using base::Lanes;
    ShadowValue v;
    if (count == 3) {
      const double per_whole = 1.0 / cross2(p[0], p[1], p[2]);
      const auto half = [&](const Point& a, const Point& b) {
        return (Lanes(b.x - a.x) * (y - a.y) - Lanes(b.y - a.y) * (x - a.x)) * per_whole;
      };
      v.w[1] = half(p[2], p[0]);
      v.w[2] = half(p[0], p[1]);
      v.w[0] = Lanes(1.0) - v.w[1] - v.w[2];
      v.w[3] = 0.0;
      v.z = v.w[0] * z[0] + v.w[1] * z[1] + v.w[2] * z[2];
      const double u = z[1] - z[0], t = z[2] - z[0];
      v.slope_x = (u * (p[2].y - p[0].y) - t * (p[1].y - p[0].y)) * per_whole;
      v.slope_y = (t * (p[1].x - p[0].x) - u * (p[2].x - p[0].x)) * per_whole;
      return v;
    }
    Lanes r = 0.5, s = 0.5;
    const Point e{p[1].x - p[0].x, p[1].y - p[0].y}, f{p[3].x - p[0].x, p[3].y - p[0].y};
    const Point h{p[2].x - p[1].x - f.x, p[2].y - p[1].y - f.y};
    // What one round of Newton leaves is the product of its changes times h.
    const double left = std::abs(h.x) + std::abs(h.y);
    const double small = 1e-15 * (std::abs(e.x) + std::abs(e.y) + std::abs(f.x) + std::abs(f.y));
    const Lanes qx = x - p[0].x, qy = y - p[0].y;
    Lanes a, b, c, d, inverse;
    const auto jacobian = [&] {
      a = s * h.x + e.x, b = r * h.x + f.x, c = s * h.y + e.y, d = r * h.y + f.y;
      const Lanes det = a * d - b * c;
      inverse = Lanes(1.0) / select(abs(det) > 0.0, det, Lanes(1e300));
    };
    if (left <= small) {
      const double per = 1.0 / (e.x * f.y - f.x * e.y);
      r = (qx * f.y - qy * f.x) * per;
      s = (qy * e.x - qx * e.y) * per;
      a = e.x, b = f.x, c = e.y, d = f.y, inverse = per;
    } else {
      for (int k = 0; k < 8; ++k) {
        jacobian();
        const Lanes rs = r * s;
        const Lanes dx = qx - r * e.x - s * f.x - rs * h.x, dy = qy - r * e.y - s * f.y - rs * h.y;
        const Lanes dr = (dx * d - dy * b) * inverse, ds = (dy * a - dx * c) * inverse;
        r += dr;
        s += ds;
        if (!any(abs(dr * ds) * left > small)) break;
      }
      jacobian();
    }
    r = max(min(r, Lanes(1.0)), Lanes(0.0));
    s = max(min(s, Lanes(1.0)), Lanes(0.0));
    const Lanes q = Lanes(1.0) - r, t = Lanes(1.0) - s;
    v.w[0] = q * t;
    v.w[1] = r * t;
    v.w[2] = r * s;
    v.w[3] = q * s;
    v.z = v.w[0] * z[0] + v.w[1] * z[1] + v.w[2] * z[2] + v.w[3] * z[3];
    const Lanes zr = t * (z[1] - z[0]) + s * (z[2] - z[3]), zs = q * (z[3] - z[0]) + r * (z[2] - z[1]);
    v.slope_x = (zr * d - zs * c) * inverse;
    v.slope_y = (zs * a - zr * b) * inverse;
    return v;
  }
};

/// How much a scalar changes with the places and heights of the corners of a shadow.
struct ShadowChange {
  Point p[4] = {};
  double z[4] = {};

  /// Changes that grow with the height at points of the face: the height changes with those of the corners,
  /// and because a slope moves sideways.
  /// @param height  sums over the points of the change times each corner function
  /// @param x, y    the same times the slopes
  void add(double sign, const double height[4], const double x[4], const double y[4]) {
    for (int c = 0; c < 4; ++c) {
      z[c] += sign * height[c];
      p[c].x -= sign * x[c];
      p[c].y -= sign * y[c];
    }
  }
};

/// A polygon whose edges remember what they lie on.
struct Polygon {
  static constexpr int most = 12;
  Point at[most];
  int edge[most];  ///< number of the line from this corner to the next
  int count = 0;

  void add(const Point& p, int line) {
    if (count == most) return;
    at[count] = p;
    edge[count++] = line;
  }
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  double area() const {
    double sum = 0.0;
    for (int i = 2; i < count; ++i) sum += cross2(at[0], at[i - 1], at[i]);
    return 0.5 * sum;
  }

  /// Keeps where a function is not negative, as if it were linear along the edges (Sutherland & Hodgman
  /// 1974).
  /// @param v     its values at the corners
  /// @param line  number of where it is zero
  /// @param from  if given: which corner each new one is, -1 for those on the line
  Polygon cut(const double* v, int line, int* from = nullptr) const {
    Polygon out;
    const auto keep = [&](const Point& p, int own, int corner) {
      if (from && out.count < most) from[out.count] = corner;
      out.add(p, own);
    };
    for (int i = 0; i < count; ++i) {
      const int j = next(i);
      // Where nothing but this corner is left of an edge, what follows is the line.
      if (v[i] >= 0.0) keep(at[i], v[i] == 0.0 && v[j] < 0.0 ? line : edge[i], i);
      if (!((v[i] > 0.0 && v[j] < 0.0) || (v[i] < 0.0 && v[j] > 0.0))) continue;
      const double t = v[i] / (v[i] - v[j]);
      keep({at[i].x + t * (at[j].x - at[i].x), at[i].y + t * (at[j].y - at[i].y)},
           v[i] > 0.0 ? line : edge[i], -1);
    }
    return out;
  }
};

}  // namespace cleave::solver
