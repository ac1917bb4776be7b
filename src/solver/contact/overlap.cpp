#include "solver/contact/overlap.hpp"

#include <algorithm>

#include "base/lanes.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;
using base::lane_count;
using base::Lanes;

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

  /// Values of the corner functions at points of the face.
  void weights(Lanes x, Lanes y, Lanes w[4]) const {
    if (count == 3) {
      const Lanes per_whole = 1.0 / cross2(p[0], p[1], p[2]);
      const auto half = [&](const Point& a, const Point& b) {
        return (Lanes(b.x - a.x) * (y - a.y) - Lanes(b.y - a.y) * (x - a.x)) * per_whole;
      };
      w[1] = half(p[2], p[0]);
      w[2] = half(p[0], p[1]);
      w[0] = Lanes(1.0) - w[1] - w[2];
      w[3] = 0.0;
      return;
    }
    Lanes r = 0.5, s = 0.5;
    const Point e{p[1].x - p[0].x, p[1].y - p[0].y}, f{p[3].x - p[0].x, p[3].y - p[0].y};
    const Point h{p[2].x - p[1].x - f.x, p[2].y - p[1].y - f.y};
    const Lanes qx = x - p[0].x, qy = y - p[0].y;
    for (int k = 0; k < 8; ++k) {  // Newton; one round for a parallelogram
      const Lanes rs = r * s;
      const Lanes dx = qx - r * e.x - s * f.x - rs * h.x, dy = qy - r * e.y - s * f.y - rs * h.y;
      const Lanes a = s * h.x + e.x, b = r * h.x + f.x, c = s * h.y + e.y, d = r * h.y + f.y;
      const Lanes det = a * d - b * c;
      const Lanes inverse =
          select(det > 0.0, Lanes(1.0) / det, select(det < 0.0, Lanes(1.0) / det, Lanes(0.0)));
      const Lanes dr = (dx * d - dy * b) * inverse, ds = (dy * a - dx * c) * inverse;
      r += dr;
      s += ds;
      if (!any(abs(dr) + abs(ds) >= 1e-14)) break;
    }
    r = max(min(r, Lanes(1.0)), Lanes(0.0));
    s = max(min(s, Lanes(1.0)), Lanes(0.0));
    const Lanes q = Lanes(1.0) - r, t = Lanes(1.0) - s;
    w[0] = q * t;
    w[1] = r * t;
    w[2] = r * s;
    w[3] = q * s;
  }
};

/// The middles of the edges of a fan of triangles, with weights: exact to second degree. Lanes that are not
/// needed have no weight and lie on the first corner.
struct Quadrature {
  static constexpr int room = 24;  // the edges of a fan of most corners are 2 most - 3
  static_assert(room >= 2 * most - 3 && room % lane_count == 0);
  alignas(64) double x[room], y[room], area[room];
  int count = 0;

  explicit Quadrature(const Polygon& polygon) {
    const auto add = [&](const Point& a, const Point& b, double weight) {
      x[count] = 0.5 * (a.x + b.x);
      y[count] = 0.5 * (a.y + b.y);
      area[count++] = weight;
    };
    double last = 0.0;
    for (int i = 2; i < polygon.count; ++i) {
      const double third = std::max(cross2(polygon.p[0], polygon.p[i - 1], polygon.p[i]) / 6.0, 0.0);
      add(polygon.p[0], polygon.p[i - 1], last + third);
      add(polygon.p[i - 1], polygon.p[i], third);
      last = third;
    }
    add(polygon.p[0], polygon.p[polygon.count - 1], last);
    while (count % lane_count != 0) add(polygon.p[0], polygon.p[0], 0.0);
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
  const auto each_batch = [&](const Polygon& polygon, const auto& visit) {
    const Quadrature points(polygon);
    for (int i = 0; i < points.count; i += lane_count) {
      Lanes wa[4], wb[4], gap = 0.0;
      const Lanes x = Lanes::load(points.x + i), y = Lanes::load(points.y + i);
      sa.weights(x, y, wa);
      sb.weights(x, y, wb);
      for (int c = 0; c < 4; ++c) gap += wb[c] * sb.z[c] - wa[c] * sa.z[c];
      visit(Lanes::load(points.area + i), gap, wa, wb);
    }
  };
  if (whole) {
    each_batch(shared, [&](Lanes area, Lanes gap, const Lanes wa[4], const Lanes wb[4]) {
      for (int lane = 0; lane < lane_count; ++lane) {
        if (!(area[lane] > 0.0)) continue;
        SharedPoint point{area[lane], gap[lane], {}, {}};
        for (int c = 0; c < 4; ++c) point.wa[c] = wa[c][lane], point.wb[c] = wb[c][lane];
        whole->push_back(point);
      }
    });
    return !whole->empty();
  }
  const Polygon deep = cut(shared, depth);
  if (deep.count < 3) return false;

  Lanes deep_area = 0.0, volume = 0.0, va[4] = {0.0, 0.0, 0.0, 0.0}, vb[4] = {0.0, 0.0, 0.0, 0.0};
  each_batch(deep, [&](Lanes area, Lanes gap, const Lanes wa[4], const Lanes wb[4]) {
    const Lanes some = area * max(gap, Lanes(0.0));
    deep_area += area;
    volume += some;
    for (int c = 0; c < 4; ++c) {
      va[c] += some * wa[c];
      vb[c] += some * wb[c];
    }
  });
  const auto total = [](const Lanes& lanes) {
    double sum = 0.0;
    for (int lane = 0; lane < lane_count; ++lane) sum += lanes[lane];
    return sum;
  };
  out.deep_area = total(deep_area);
  out.volume = total(volume);
  if (!(out.volume > 0.0)) return false;
  const double per_volume = 1.0 / out.volume;
  for (int c = 0; c < 4; ++c) {
    out.wa[c] = total(va[c]) * per_volume;
    out.wb[c] = total(vb[c]) * per_volume;
  }
  return true;
}

}  // namespace cleave::solver
