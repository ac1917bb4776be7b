#include "solver/contact/overlap.hpp"

#include <algorithm>

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;

constexpr double least_facing = 0.25;  // faces at more than 75 degrees do not push each other
constexpr int most = 12;               // corners of a polygon

struct Point {
  double x, y;
};
double cross2(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct Polygon {
  Point p[most];
  int count = 0;
  void add(const Point& q) {
    if (count < most) p[count++] = q;
  }
  double area() const {
    double sum = 0.0;
    for (int i = 2; i < count; ++i) sum += cross2(p[0], p[i - 1], p[i]);
    return 0.5 * sum;
  }
};

/// Keeps where a linear function, given by its values at the corners, is not negative.
template <class Value>
Polygon cut(const Polygon& from, const Value& value) {
  Polygon out;
  for (int i = 0; i < from.count; ++i) {
    const Point &p = from.p[i], &q = from.p[(i + 1) % from.count];
    const double vp = value(p), vq = value(q);
    if (vp >= 0.0) out.add(p);
    if ((vp > 0.0 && vq < 0.0) || (vp < 0.0 && vq > 0.0)) {
      const double t = vp / (vp - vq);
      out.add({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return out;
}

/// A face seen along the common normal.
struct Shadow {
  Point p[4];
  double z[4];
  int count;
  double slope_x, slope_y, height;  // z = height + slope_x x + slope_y y of its plane
  double plane(const Point& q) const { return height + slope_x * q.x + slope_y * q.y; }

  /// Values of the corner functions at a point of the face.
  void weights(const Point& q, double w[4]) const {
    if (count == 3) {
      const double whole = cross2(p[0], p[1], p[2]);
      w[1] = cross2(p[0], q, p[2]) / whole;
      w[2] = cross2(p[0], p[1], q) / whole;
      w[0] = 1.0 - w[1] - w[2];
      w[3] = 0.0;
      return;
    }
    double r = 0.5, s = 0.5;
    const Point e{p[1].x - p[0].x, p[1].y - p[0].y}, f{p[3].x - p[0].x, p[3].y - p[0].y};
    const Point h{p[2].x - p[1].x - f.x, p[2].y - p[1].y - f.y};
    for (int k = 0; k < 8; ++k) {  // Newton; one round for a parallelogram
      const double dx = q.x - p[0].x - r * e.x - s * f.x - r * s * h.x;
      const double dy = q.y - p[0].y - r * e.y - s * f.y - r * s * h.y;
      const double a = e.x + s * h.x, b = f.x + r * h.x, c = e.y + s * h.y, d = f.y + r * h.y;
      const double det = a * d - b * c;
      if (det == 0.0) break;
      const double dr = (dx * d - dy * b) / det, ds = (dy * a - dx * c) / det;
      r += dr;
      s += ds;
      if (std::abs(dr) + std::abs(ds) < 1e-14) break;
    }
    r = std::clamp(r, 0.0, 1.0);
    s = std::clamp(s, 0.0, 1.0);
    w[0] = (1.0 - r) * (1.0 - s);
    w[1] = r * (1.0 - s);
    w[2] = r * s;
    w[3] = (1.0 - r) * s;
  }
};

Shadow shadow(const Vector x[4], int count, const Vector& origin, const Vector& e1, const Vector& e2,
              const Vector& n, const Vector& normal) {
  Shadow out{};
  out.count = count;
  double mx = 0.0, my = 0.0, mz = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vector d = x[i] - origin;
    out.p[i] = {dot(d, e1), dot(d, e2)};
    out.z[i] = dot(d, n);
    if (i >= count) continue;
    mx += out.p[i].x / count;
    my += out.p[i].y / count;
    mz += out.z[i] / count;
  }
  const double steep = dot(normal, n);
  out.slope_x = -dot(normal, e1) / steep;
  out.slope_y = -dot(normal, e2) / steep;
  out.height = mz - out.slope_x * mx - out.slope_y * my;
  return out;
}

/// Do their boxes across the normal miss each other?
bool beside(const Shadow& a, const Shadow& b) {
  double low[2][2], high[2][2];
  const Shadow* both[2] = {&a, &b};
  for (int s = 0; s < 2; ++s) {
    const Point* p = both[s]->p;  // triangles repeat the third
    low[s][0] = std::min(std::min(p[0].x, p[1].x), std::min(p[2].x, p[3].x));
    low[s][1] = std::min(std::min(p[0].y, p[1].y), std::min(p[2].y, p[3].y));
    high[s][0] = std::max(std::max(p[0].x, p[1].x), std::max(p[2].x, p[3].x));
    high[s][1] = std::max(std::max(p[0].y, p[1].y), std::max(p[2].y, p[3].y));
  }
  return low[0][0] > high[1][0] || low[1][0] > high[0][0] || low[0][1] > high[1][1] || low[1][1] > high[0][1];
}

/// Is the linear depth below zero at all corners?
template <class Depth>
bool before(const Shadow& face, const Depth& depth) {
  for (int i = 0; i < face.count; ++i)
    if (depth(face.p[i]) >= 0.0) return false;
  return true;
}

bool same(const Vector& a, const Vector& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace

bool overlap(const Vector a[4], const Vector b[4], Overlap& out, std::vector<SharedPoint>* whole) {
  Vector na = cross(a[2] - a[0], a[3] - a[1]), nb = cross(b[2] - b[0], b[3] - b[1]);
  const double la = norm(na), lb = norm(nb);
  if (!(la > 0.0 && lb > 0.0)) return false;
  na = (1.0 / la) * na;
  nb = (1.0 / lb) * nb;
  out.facing = -dot(na, nb);
  if (out.facing <= least_facing) return false;
  Vector n = nb - na;
  n = (1.0 / norm(n)) * n;
  const Vector edge = b[1] - b[0];
  Vector e1 = edge - dot(edge, n) * n;
  e1 = (1.0 / norm(e1)) * e1;
  const Vector e2 = cross(n, e1);
  out.normal = n;

  const int count_a = same(a[2], a[3]) ? 3 : 4, count_b = same(b[2], b[3]) ? 3 : 4;
  const Shadow sa = shadow(a, count_a, b[0], e1, e2, n, na), sb = shadow(b, count_b, b[0], e1, e2, n, nb);

  // Most pairs that are near each other lie beside each other, or a is before b everywhere.
  if (beside(sa, sb)) return false;
  const auto depth = [&](const Point& c) { return sb.plane(c) - sa.plane(c); };
  if (!whole && (before(sa, depth) || before(sb, depth))) return false;

  // Face a runs clockwise seen along the normal, face b counter-clockwise.
  Polygon shared;
  for (int i = count_a - 1; i >= 0; --i) shared.add(sa.p[i]);
  for (int i = 0; i < count_b && shared.count >= 3; ++i) {
    const Point &p = sb.p[i], &q = sb.p[(i + 1) % count_b];
    shared = cut(shared, [&](const Point& c) { return cross2(p, q, c); });
  }
  if (shared.count < 3) return false;
  out.area = shared.area();
  if (!(out.area > 1e-12 * std::min(la, lb))) return false;
  // The middles of the edges of a fan of triangles: exact to second degree.
  const auto each_point = [&](const Polygon& polygon, const auto& visit) {
    for (int i = 2; i < polygon.count; ++i) {
      const Point tri[3] = {polygon.p[0], polygon.p[i - 1], polygon.p[i]};
      const double third = cross2(tri[0], tri[1], tri[2]) / 6.0;
      if (!(third > 0.0)) continue;
      for (int k = 0; k < 3; ++k) {
        const Point q{0.5 * (tri[k].x + tri[(k + 1) % 3].x), 0.5 * (tri[k].y + tri[(k + 1) % 3].y)};
        SharedPoint point{third, 0.0, {}, {}};
        sa.weights(q, point.wa);
        sb.weights(q, point.wb);
        for (int c = 0; c < 4; ++c) point.gap += point.wb[c] * sb.z[c] - point.wa[c] * sa.z[c];
        visit(point);
      }
    }
  };
  if (whole) {
    each_point(shared, [&](const SharedPoint& point) { whole->push_back(point); });
    return !whole->empty();
  }
  const Polygon deep = cut(shared, depth);
  if (deep.count < 3) return false;

  out.deep_area = out.volume = 0.0;
  for (int i = 0; i < 4; ++i) out.wa[i] = out.wb[i] = 0.0;
  each_point(deep, [&](const SharedPoint& point) {
    out.deep_area += point.area;
    if (!(point.gap > 0.0)) return;
    out.volume += point.area * point.gap;
    for (int c = 0; c < 4; ++c) {
      out.wa[c] += point.area * point.gap * point.wa[c];
      out.wb[c] += point.area * point.gap * point.wb[c];
    }
  });
  if (!(out.volume > 0.0)) return false;
  for (int c = 0; c < 4; ++c) {
    out.wa[c] /= out.volume;
    out.wb[c] /= out.volume;
  }
  return true;
}

}  // namespace cleave::solver
