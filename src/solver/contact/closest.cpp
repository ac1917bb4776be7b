#include "solver/contact/closest.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;

/// Barycentric coordinates of the closest point of a triangle.
void on_triangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c, double w[3]) {
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  const auto set = [&](double u, double v, double t) { w[0] = u, w[1] = v, w[2] = t; };
  if (d1 <= 0.0 && d2 <= 0.0) return set(1, 0, 0);
  const Vector bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return set(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double t = d1 / (d1 - d3);
    return set(1 - t, t, 0);
  }
  const Vector cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return set(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double t = d2 / (d2 - d6);
    return set(1 - t, 0, t);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return set(0, 1 - t, t);
  }
  const double scale = 1.0 / (va + vb + vc);
  const double v = vb * scale, t = vc * scale;
  set(1.0 - v - t, v, t);
}

/// Where on the rim of a face the weights put the point; corners are met within roundoff.
void classify(int corners, Closest& c) {
  constexpr double none = 1e-9;
  int positive = 0, last = -1, before = -1;
  for (int i = 0; i < corners; ++i)
    if (c.weight[i] > none) {
      ++positive;
      before = last;
      last = i;
    }
  if (positive == 1) c.corner = last;
  if (positive == 2 && last - before == 1) c.edge = before;
  if (positive == 2 && before == 0 && last == corners - 1 && corners > 2) c.edge = last;
}

}  // namespace

Closest closest_point(const Face& face, const Vector corner[4], const Vector& p) {
  Closest best{};
  double w[3];
  if (face.corners() == 3) {
    on_triangle(p, corner[0], corner[1], corner[2], w);
    for (int i = 0; i < 3; ++i) best.weight[i] = w[i];
    best.weight[3] = 0.0;
    best.point = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
    best.normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    classify(3, best);
    return best;
  }
  const Vector middle = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
  double least = 1e300;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    on_triangle(p, corner[i], corner[j], middle, w);
    const Vector point = w[0] * corner[i] + w[1] * corner[j] + w[2] * middle;
    const Vector to = p - point;
    const double distance = dot(to, to);
    if (distance >= least) continue;
    least = distance;
    best.point = point;
    for (int k = 0; k < 4; ++k) best.weight[k] = 0.25 * w[2];
    best.weight[i] += w[0];
    best.weight[j] += w[1];
    best.normal = cross(corner[j] - corner[i], middle - corner[i]);
  }
  classify(4, best);
  return best;
}

}  // namespace cleave::solver
