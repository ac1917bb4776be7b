/// The forces between two faces: the gradient of their energy.

#include <algorithm>

#include "solver/contact/overlap.hpp"
#include "solver/contact/polygon_integrals.hpp"

namespace cleave::solver {

using base::cross;
using base::dot;
using base::lane_count;
using base::Lanes;

void turn_back(const Vector x[4], const Vector& unit, double size, const Vector& with_unit, double with_size,
               Vector force[4]) {
  const Vector with = (1.0 / size) * (with_unit - dot(with_unit, unit) * unit) + with_size * unit;
  const Vector on2 = cross(x[3] - x[1], with), on3 = cross(with, x[2] - x[0]);
  force[2] = force[2] - on2;
  force[0] = force[0] + on2;
  force[3] = force[3] - on3;
  force[1] = force[1] + on3;
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

  Measures measures{facing_, 2.0 * springs.area / la_, area_, total(square), out.volume};
  if (!(measures.square > 0.0)) return false;
  const bool pokes = pair_energy::pokes(facing_).value > 0.0;
  Cone cone;
  Width width;
  if (pokes) {
    cone.integrate(deep, at_corner);
    if (!(cone.volume > 0.0)) return false;
    width.measure(shared_);
    measures.cone_square = cone.square;
    measures.cone_volume = cone.volume;
    measures.cone_area = cone.area;
    measures.width_square = width.square;
  }
  const PairEnergy energy(springs, measures, out.deep_area);
  out.energy = energy.value;
  out.rate = energy.rate;

  Gathered on_a, on_b;
  Lanes centre_a[4] = {0.0, 0.0, 0.0, 0.0}, centre_b[4] = {0.0, 0.0, 0.0, 0.0};
  Lanes normal = 0.0;
  for (int k = 0; k < count; ++k) {
    const Lanes area = Lanes::load(points.area + k * lane_count), g = Lanes::load(gap + k * lane_count);
    const Lanes with_gap = area * ((2.0 * energy.with_square) * g + energy.with_volume), part = area * g;
    for (int c = 0; c < 4; ++c) {
      centre_a[c] += part * at_a[k].w[c];
      centre_b[c] += part * at_b[k].w[c];
    }
    on_a.add(at_a[k], with_gap);
    on_b.add(at_b[k], with_gap);
    normal += with_gap;
  }
  if (pokes)
    for (int k = 0; k * lane_count < deep.count; ++k) {
      const Lanes x = Lanes::load(cone.x + k * lane_count), y = Lanes::load(cone.y + k * lane_count);
      const Lanes with_gap = energy.with_cone_square * Lanes::load(cone.with_square + k * lane_count) +
                             energy.with_cone_volume * Lanes::load(cone.with_volume + k * lane_count);
      on_a.add(sa_.at(x, y), with_gap);
      on_b.add(sb_.at(x, y), with_gap);
      normal += with_gap;
    }
  out.normal = total(normal);
  const double per_volume = 1.0 / out.volume;
  for (int c = 0; c < 4; ++c) {
    out.wa[c] = total(centre_a[c]) * per_volume;
    out.wb[c] = total(centre_b[c]) * per_volume;
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
  for (int i = 0; i < deep.count; ++i) {
    if (deep.edge[i] == of_depth) continue;
    const double from_here = at_corner[i], to_there = at_corner[deep.next(i)];
    const auto density = [&](double g, double linear) {
      return (energy.with_square * g + energy.with_volume) * g +
             (energy.with_cone_square * linear + energy.with_cone_volume) * linear;
    };
    const double at[3] = {density(from_here, from_here),
                          density(gap[Quadrature::of_edge(deep, i)], 0.5 * (from_here + to_there)),
                          density(to_there, to_there)};
    edge(deep, i, at);
  }
  if (pokes)
    for (int i = 0; i < shared_.count; ++i) {
      const Point &p = shared_.at[i], &q = shared_.at[shared_.next(i)];
      const auto density = [&](const Point& at) {
        return energy.with_area + energy.with_width_square * width.change(at);
      };
      const double at[3] = {density(p), density({0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}), density(q)};
      edge(shared_, i, at);
    }
  balance(a, b);
  to_corners(a, b, energy.with_facing, -out.energy / la_, out);
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

}  // namespace cleave::solver
