#include "solver/contact/overlap.hpp"

#include <algorithm>

#include "solver/contact/polygon_integrals.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;
using base::lane_count;
using base::Lanes;

constexpr double least_facing = 0.1;  // faces at more than 84 degrees do not push each other,
constexpr double full_facing = 0.3;   // and fully at less than 73
constexpr double flat = 0.996;        // less than 5 degrees: the depth is integrated,
constexpr double poking = 0.95;       // more than 18: a corner or an edge meets the whole face,
constexpr double grasp = 4.0;         // of a small shared area: this and one times as stiff
constexpr int of_b = 4;               // edges of a have their number, those of b theirs and this,
constexpr int of_depth = 8;           // and this is where the depth is that which counts as none

struct Ramp {
  double value, slope;
};
/// From 0 to 1 without a kink.
Ramp ramp(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return {t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (to - from)};
}

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

void turn_back(const Vector x[4], const Vector& unit, double size, const Vector& with_unit, double with_size,
               Vector force[4]) {
  const Vector with = (1.0 / size) * (with_unit - dot(with_unit, unit) * unit) + with_size * unit;
  const Vector on2 = cross(x[3] - x[1], with), on3 = cross(with, x[2] - x[0]);
  force[2] = force[2] - on2;
  force[0] = force[0] + on2;
  force[3] = force[3] - on3;
  force[1] = force[1] + on3;
}

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

bool Overlap::push(const Springs& springs, double offset, Push& out) {
  if (!(deepest() > offset)) return false;
  double above[Polygon::most], at_corner[Polygon::most];
  int from[Polygon::most];
  for (int i = 0; i < shared_.count; ++i) above[i] = gap_[i] - offset;
  Polygon cut;
  bool some = false;
  for (int i = 0; i < shared_.count; ++i) {
    from[i] = i;
    some = some || above[i] < 0.0;
  }
  if (some) cut = shared_.cut(above, of_depth, from);
  const Polygon& deep = some ? cut : shared_;
  if (deep.count < 3) return false;
  for (int i = 0; i < deep.count; ++i) at_corner[i] = from[i] < 0 ? 0.0 : std::max(above[from[i]], 0.0);

  const Quadrature points(deep);
  constexpr int most = Quadrature::room / lane_count;
  ShadowValue at_a[most], at_b[most];
  alignas(64) double gap[Quadrature::room];
  Lanes deep_area = 0.0, volume = 0.0, square = 0.0;
  const int count = points.count / lane_count;
  for (int k = 0; k < count; ++k) {
    const Lanes x = Lanes::load(points.x + k * lane_count), y = Lanes::load(points.y + k * lane_count);
    at_a[k] = sa_.at(x, y);
    at_b[k] = sb_.at(x, y);
    const Lanes g = max(at_b[k].z - at_a[k].z - offset, Lanes(0.0));
    const Lanes area = Lanes::load(points.area + k * lane_count);
    g.store(gap + k * lane_count);
    deep_area += area;
    volume += area * g;
    square += area * (g * g);
  }
  out.deep_area = total(deep_area);
  out.volume = total(volume);

  // Where the faces are parallel: half the integral of g^2, and more by its mean over the shared polygon.
  // Where a corner or an edge pokes: that of a depth d = (integral of g^2) / (integral of g) over as much as
  // a whole face, unless they share hardly anything.
  const Ramp pokes = ramp(-facing_, -flat, -poking);
  const double squares = total(square), mean = squares / area_;
  Cone cone;
  double d = 0.0;
  if (pokes.value > 0.0) {
    cone.integrate(deep, at_corner);
    if (!(cone.volume > 0.0)) return false;
    d = cone.square / cone.volume;
  } else if (!(squares > 0.0)) {
    return false;
  }
  const double harder = springs.hardening, poke_harder = springs.poke_hardening;
  const double share = 1.0 / (1.0 + grasp * area_ / springs.smaller_area);
  const double poke_area = (1.0 + grasp) * area_ * share;
  const double flat_energy = 0.5 * squares * (1.0 + 0.5 * harder * mean);
  const double poke_energy = 0.5 * poke_area * d * d * (1.0 + 0.5 * poke_harder * d * d);
  Ramp fade = ramp(facing_, least_facing, full_facing);
  const double stretch = 2.0 * springs.area / la_;
  fade.value *= stretch;
  fade.slope *= stretch;
  const double mixed = flat_energy + pokes.value * (poke_energy - flat_energy);
  out.energy = fade.value * mixed;
  const double of_flat = fade.value * (1.0 - pokes.value), of_poke = fade.value * pokes.value;
  const double with_square = 0.5 * of_flat * (1.0 + harder * mean);
  const double with_area =
      0.5 * of_poke * (1.0 + grasp) * share * share * d * d * (1.0 + 0.5 * poke_harder * d * d) -
      0.25 * of_flat * harder * mean * mean;
  const double with_d =  // per volume
      of_poke > 0.0 ? of_poke * poke_area * d * (1.0 + poke_harder * d * d) / cone.volume : 0.0;
  const double with_facing = fade.slope * mixed - fade.value * pokes.slope * (poke_energy - flat_energy);

  Gathered on_a, on_b;
  Lanes normal = 0.0;
  for (int k = 0; k < count; ++k) {
    const Lanes with_gap =
        (2.0 * with_square) * Lanes::load(points.area + k * lane_count) * Lanes::load(gap + k * lane_count);
    on_a.add(at_a[k], with_gap);
    on_b.add(at_b[k], with_gap);
    normal += with_gap;
  }
  if (of_poke > 0.0)
    for (int k = 0; k * lane_count < deep.count; ++k) {
      const Lanes x = Lanes::load(cone.x + k * lane_count), y = Lanes::load(cone.y + k * lane_count);
      const Lanes with_gap = with_d * (Lanes::load(cone.with_square + k * lane_count) -
                                       d * Lanes::load(cone.with_volume + k * lane_count));
      on_a.add(sa_.at(x, y), with_gap);
      on_b.add(sb_.at(x, y), with_gap);
      normal += with_gap;
    }
  out.normal = total(normal);
  // The edges of what they share stiffen it as well: they pull by the square of the depth.
  double around = 0.0;
  for (int i = 0; i < shared_.count; ++i) {
    const Point &p = shared_.at[i], &q = shared_.at[shared_.next(i)];
    around += length(q.x - p.x, q.y - p.y);
  }
  out.rate = of_flat * (out.deep_area * (1.0 + 3.0 * harder * mean) + around * std::sqrt(mean));
  if (of_poke > 0.0) {
    const double along = 2.0 - d * cone.area / cone.volume;  // by how much d grows with the depth
    out.rate += of_poke * (poke_area * along * along + (1.0 + grasp) * share * share * around * d) *
                (1.0 + 3.0 * poke_harder * d * d);
  }
  const double per_normal = out.normal > 0.0 ? 1.0 / out.normal : 0.0;
  for (int c = 0; c < 4; ++c) {
    out.wa[c] = total(on_a.z[c]) * per_normal;
    out.wb[c] = total(on_b.z[c]) * per_normal;
  }

  ShadowChange a, b;
  on_a.give(-1.0, a);
  on_b.give(1.0, b);
  const auto edge = [&](const Polygon& polygon, int i, const double density[3]) {
    const int line = polygon.edge[i];
    const Shadow& face = line < of_b ? sa_ : sb_;
    ShadowChange& change = line < of_b ? a : b;
    const int one = line % of_b, other = (one + 1) % face.count;
    move_edge(polygon.at[i], polygon.at[polygon.next(i)], density, face.p[one], face.p[other], change.p[one],
              change.p[other]);
  };
  const double with_all = some ? 0.0 : with_area;
  for (int i = 0; i < deep.count; ++i) {
    if (deep.edge[i] == of_depth) continue;
    const double from_here = at_corner[i], to_there = at_corner[deep.next(i)];
    const auto density = [&](double g, double linear) {
      return with_square * g * g + with_d * linear * (linear - d) + with_all;
    };
    const double at[3] = {density(from_here, from_here),
                          density(gap[Quadrature::of_edge(deep, i)], 0.5 * (from_here + to_there)),
                          density(to_there, to_there)};
    edge(deep, i, at);
  }
  const double whole[3] = {with_area, with_area, with_area};
  if (with_area != 0.0 && some)
    for (int i = 0; i < shared_.count; ++i) edge(shared_, i, whole);
  balance(a, b);
  to_corners(a, b, with_facing, -out.energy / la_, out);
  return true;
}

/// The forces across the normal balance as far as the quadrature is exact; this takes away what is left.
void Overlap::balance(ShadowChange& a, ShadowChange& b) const {
  Point sum{0.0, 0.0}, middle{0.0, 0.0};
  const auto each = [&](const auto& visit) {
    for (int c = 0; c < 4; ++c) {
      visit(sa_.p[c], a.p[c]);
      visit(sb_.p[c], b.p[c]);
    }
  };
  each([&](const Point& at, const Point& change) {
    sum.x += change.x;
    sum.y += change.y;
    middle.x += 0.125 * at.x;
    middle.y += 0.125 * at.y;
  });
  double moment = 0.0, square = 0.0;
  each([&](const Point& at, Point& change) {
    change.x -= 0.125 * sum.x;
    change.y -= 0.125 * sum.y;
    const double x = at.x - middle.x, y = at.y - middle.y;
    moment += x * change.y - y * change.x;
    square += x * x + y * y;
  });
  const double turn = moment / square;
  each([&](const Point& at, Point& change) {
    change.x += turn * (at.y - middle.y);
    change.y -= turn * (at.x - middle.x);
  });
}

void Overlap::to_corners(const ShadowChange& a, const ShadowChange& b, double with_facing, double with_la,
                         Push& out) const {
  double turn1 = 0.0, turn2 = 0.0;  // the change with the normal along e1 and e2
  const auto place = [&](const Shadow& shadow, const ShadowChange& with, Vector to[4]) {
    for (int c = 0; c < 4; ++c) {
      to[c] = -1.0 * (with.p[c].x * e1_ + with.p[c].y * e2_ + with.z[c] * n_);
      turn1 += shadow.p[c].x * with.z[c] - shadow.z[c] * with.p[c].x;
      turn2 += shadow.p[c].y * with.z[c] - shadow.z[c] * with.p[c].y;
    }
  };
  place(sa_, a, out.on_a);
  place(sb_, b, out.on_b);
  const Vector mean = (1.0 / opening_) * (turn1 * e1_ + turn2 * e2_);
  turn_back(a_, na_, la_, -1.0 * (mean + with_facing * nb_), with_la, out.on_a);
  turn_back(b_, nb_, lb_, mean - with_facing * na_, 0.0, out.on_b);
  for (Vector* on : {sa_.count == 3 ? out.on_a : nullptr, sb_.count == 3 ? out.on_b : nullptr})
    if (on) {
      on[2] = on[2] + on[3];
      on[3] = {0, 0, 0};
    }
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
