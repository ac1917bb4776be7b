#include "solver/contact/overlap.hpp"

#include <algorithm>

#include "solver/contact/polygon_integrals.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;
using base::lane_count;
using base::Lanes;

using pair_energy::least_facing;

double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}

Shadow shadow(const Vector x[4], const Vector& origin, const Vector& e1, const Vector& e2, const Vector& n) {
  Shadow out{};
  for (int i = 0; i < 4; ++i) {
    const Vector d = x[i] - origin;
    out.p[i] = {dot(d, e1), dot(d, e2)};
    out.z[i] = dot(d, n);
  }
  out.count = x[2].x == x[3].x && x[2].y == x[3].y && x[2].z == x[3].z ? 3 : 4;
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

}  // namespace

bool Overlap::share(const Vector a[4], const Vector b[4]) {
  a_ = a;
  b_ = b;
  na_ = cross(a[2] - a[0], a[3] - a[1]);
  nb_ = cross(b[2] - b[0], b[3] - b[1]);
  la_ = norm(na_);
  lb_ = norm(nb_);
  if (!(la_ > 0.0 && lb_ > 0.0)) return false;
  na_ = (1.0 / la_) * na_;
  nb_ = (1.0 / lb_) * nb_;
  facing_ = -dot(na_, nb_);
  if (facing_ <= least_facing) return false;
  n_ = nb_ - na_;
  opening_ = norm(n_);
  n_ = (1.0 / opening_) * n_;
  const Vector edge = b[1] - b[0];
  e1_ = edge - dot(edge, n_) * n_;
  e1_ = (1.0 / norm(e1_)) * e1_;
  e2_ = cross(n_, e1_);
  sa_ = shadow(a, b[0], e1_, e2_, n_);
  sb_ = shadow(b, b[0], e1_, e2_, n_);
  if (beside(sa_, sb_)) return false;

  // Face a runs clockwise seen along the normal, face b counter-clockwise.
  shared_.count = 0;
  for (int i = sa_.count - 1; i >= 0; --i) shared_.add(sa_.p[i], i > 0 ? i - 1 : sa_.count - 1);
  for (int i = 0; i < sb_.count && shared_.count >= 3; ++i) {
    const Point &p = sb_.p[i], &q = sb_.p[(i + 1) % sb_.count];
    double v[Polygon::most];
    bool some = false;
    for (int c = 0; c < shared_.count; ++c) {
      v[c] = cross2(p, q, shared_.at[c]);
      some = some || v[c] < 0.0;
    }
    if (some) shared_ = shared_.cut(v, of_b + i);
  }
  if (shared_.count < 3) return false;
  area_ = shared_.area();
  if (!(area_ > 1e-12 * std::min(la_, lb_))) return false;

  deepest_ = 0;
  for (int k = 0; k * lane_count < shared_.count; ++k) {
    Lanes x, y;
    for (int lane = 0; lane < lane_count; ++lane) {
      const int i = k * lane_count + lane;
      const Point& at = shared_.at[i < shared_.count ? i : 0];
      x.set(lane, at.x);
      y.set(lane, at.y);
    }
    (sb_.at(x, y).z - sa_.at(x, y).z).store(gap_ + k * lane_count);
  }
  for (int i = 1; i < shared_.count; ++i)
    if (gap_[i] > gap_[deepest_]) deepest_ = i;
  return true;
}

double Overlap::penetration() const {
  const auto along = [](const Vector x[4], const Shadow& shadow, int line) {
    return x[(line + 1) % shadow.count] - x[line];
  };
  double deepest = 0.0;
  const double to_face = std::sqrt(0.5 * (1.0 + facing_));
  for (int i = 0; i < shared_.count; ++i) {
    if (!(gap_[i] > deepest)) continue;
    const int one = shared_.edge[i > 0 ? i - 1 : shared_.count - 1], other = shared_.edge[i];
    double square = to_face;
    if ((one < of_b) != (other < of_b)) {
      const Vector across =
          cross(along(a_, sa_, one < of_b ? one : other), along(b_, sb_, (one < of_b ? other : one) - of_b));
      const double size = norm(across);
      if (size > 0.0) square = std::min(std::abs(dot(across, n_)) / size, to_face);
    }
    deepest = std::max(deepest, square * gap_[i]);
  }
  if (deepest * deepest < 1e-3 * area_) return deepest;
  // How far each reaches over the edges of the other.
  const auto over = [&](const Shadow& edges, const Shadow& face, double sign) {
    for (int i = 0; i < edges.count; ++i) {
      const Point &p = edges.p[i], &q = edges.p[(i + 1) % edges.count];
      const double edge = length(q.x - p.x, q.y - p.y);
      double most = 0.0;
      for (int c = 0; c < face.count; ++c) most = std::max(most, sign * cross2(p, q, face.p[c]));
      if (edge > 0.0) deepest = std::min(deepest, most / edge);
    }
  };
  over(sb_, sa_, 1.0);
  over(sa_, sb_, -1.0);
  return deepest;
}

void Overlap::weights_there(double wa[4], double wb[4]) const {
  const Lanes x = shared_.at[deepest_].x, y = shared_.at[deepest_].y;
  const ShadowValue a = sa_.at(x, y), b = sb_.at(x, y);
  for (int c = 0; c < 4; ++c) wa[c] = a.w[c][0], wb[c] = b.w[c][0];
}

void Overlap::points(std::vector<SharedPoint>& out) const {
  const Quadrature points(shared_);
  for (int from = 0; from < points.count; from += lane_count) {
    const Lanes x = Lanes::load(points.x + from), y = Lanes::load(points.y + from);
    const ShadowValue a = sa_.at(x, y), b = sb_.at(x, y);
    for (int lane = 0; lane < lane_count; ++lane) {
      if (!(points.area[from + lane] > 0.0)) continue;
      SharedPoint point{points.area[from + lane], b.z[lane] - a.z[lane], {}, {}};
      for (int c = 0; c < 4; ++c) point.wa[c] = a.w[c][lane], point.wb[c] = b.w[c][lane];
      out.push_back(point);
    }
  }
}

}  // namespace cleave::solver
