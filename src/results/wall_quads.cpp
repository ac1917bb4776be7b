#include "results/wall_quads.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::results {
namespace {

using base::cross;
using base::dot;
using model::RigidWall;
using model::Vector;

constexpr double pi = 3.14159265358979323846;

double norm(const Vector& v) {
  return std::sqrt(dot(v, v));
}
Vector unit(const Vector& v) {
  return (1.0 / norm(v)) * v;
}
/// A unit vector across one.
Vector across(const Vector& n) {
  return unit(cross(n, std::abs(n.x) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0}));
}

/// What is drawn around the bodies.
struct Near {
  Vector middle, half;  ///< of the box [length]
  double reach;         ///< [length]

  /// Half the extent of the box along a direction, and some more [length].
  double along(const Vector& d) const {
    return std::abs(half.x * d.x) + std::abs(half.y * d.y) + std::abs(half.z * d.z) + reach / 4.5;
  }
};

/// A grid of quads over [a0, a1] x [b0, b1]; `place` maps to space, `outward` tells the side of the bodies.
template <class Place, class Outward>
void add_grid(double a0, double a1, double b0, double b1, int na, int nb, const Place& place,
              const Outward& outward, std::vector<WallQuad>& quads) {
  if (!(a1 > a0) || !(b1 > b0)) return;
  const auto at = [&](int i, int j) { return place(a0 + (a1 - a0) * i / na, b0 + (b1 - b0) * j / nb); };
  for (int i = 0; i < na; ++i)
    for (int j = 0; j < nb; ++j) {
      WallQuad quad{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      const Vector normal = cross(quad[2] - quad[0], quad[3] - quad[1]);
      if (dot(normal, outward(quad[0])) < 0.0) std::swap(quad[1], quad[3]);
      quads.push_back(quad);
    }
}

/// A plane rectangle: from the corner along u and v; a length of 0 has no end, either way.
void add_rectangle(const Vector& corner, const Vector& u, const Vector& v, const Vector& normal, double lu,
                   double lv, const Near& near, std::vector<WallQuad>& quads) {
  const Vector from = near.middle - corner;
  if (std::abs(dot(from, normal)) > near.reach) return;
  const auto part = [&](const Vector& d, double length, double& low, double& high) {
    low = dot(from, d) - near.along(d), high = dot(from, d) + near.along(d);
    if (length > 0.0) low = std::max(low, 0.0), high = std::min(high, length);
  };
  double a0, a1, b0, b1;
  part(u, lu, a0, a1), part(v, lv, b0, b1);
  add_grid(
      a0, a1, b0, b1, 8, 8, [&](double a, double b) { return corner + a * u + b * v; },
      [&](const Vector&) { return normal; }, quads);
}

void add_prism(const RigidWall& wall, const Vector& origin, const Near& near, std::vector<WallQuad>& quads) {
  const Vector &n = wall.normal, &l = wall.edge_l, &m = wall.edge_m;
  const double ll = wall.length_l, lm = wall.length_m, ln = wall.length_n;
  const Vector down = -1.0 * n;
  add_rectangle(origin, l, m, n, ll, lm, near, quads);
  if (ln > 0.0) add_rectangle(origin + ln * down, l, m, down, ll, lm, near, quads);
  const auto sides = [&](const Vector& out, double length, const Vector& along, double size) {
    if (!(length > 0.0)) return;
    // Down from the top; without a bottom as far as is drawn.
    const double deep = ln > 0.0 ? ln : near.reach;
    add_rectangle(origin, along, down, -1.0 * out, size, deep, near, quads);
    add_rectangle(origin + length * out, along, down, out, size, deep, near, quads);
  };
  sides(l, ll, m, lm);
  sides(m, lm, l, ll);
}

void add_cylinder(const RigidWall& wall, const Vector& origin, const Near& near,
                  std::vector<WallQuad>& quads) {
  const Vector axis = wall.normal, from = near.middle - origin;
  const Vector radial = from - dot(from, axis) * axis;
  const double r = wall.radius, distance = norm(radial), sign = wall.interior ? -1.0 : 1.0;
  if (std::abs(distance - r) > near.reach && distance > r) return;
  const Vector first = distance > 1e-9 * r ? unit(radial) : across(axis), second = cross(axis, first);
  double low = dot(from, axis) - near.reach, high = dot(from, axis) + near.reach;
  if (wall.length_n > 0.0) low = std::max(low, 0.0), high = std::min(high, wall.length_n);
  const double turn = std::min(pi, near.reach / r);
  const auto place = [&](double angle, double along) {
    return origin + along * axis + r * (std::cos(angle) * first + std::sin(angle) * second);
  };
  add_grid(
      -turn, turn, low, high, 48, 4, place,
      [&](const Vector& p) { return sign * (p - origin - dot(p - origin, axis) * axis); }, quads);
  if (wall.interior || !(wall.length_n > 0.0) || turn < pi) return;
  for (const double end : {0.0, wall.length_n})
    add_grid(
        -pi, pi, 0.0, r, 48, 2,
        [&](double angle, double radius) {
          return origin + end * axis + radius * (std::cos(angle) * first + std::sin(angle) * second);
        },
        [&](const Vector&) { return end > 0.0 ? axis : -1.0 * axis; }, quads);
}

void add_sphere(const RigidWall& wall, const Vector& origin, const Near& near, std::vector<WallQuad>& quads) {
  const Vector from = near.middle - origin;
  const double r = wall.radius, distance = norm(from), sign = wall.interior ? -1.0 : 1.0;
  if (distance > r + near.reach) return;
  // Around the place next to the bodies, as far as is drawn.
  const Vector pole = distance > 1e-9 * r ? unit(from) : Vector{0, 0, 1};
  const Vector first = across(pole), second = cross(pole, first);
  const double away = std::min(pi, near.reach / r);
  add_grid(
      -pi, pi, 0.0, away, 48, 24,
      [&](double angle, double polar) {
        return origin + r * (std::cos(polar) * pole +
                             std::sin(polar) * (std::cos(angle) * first + std::sin(angle) * second));
      },
      [&](const Vector& p) { return sign * (p - origin); }, quads);
}

}  // namespace

std::vector<WallQuad> wall_quads(const StandingWall& standing) {
  const RigidWall& wall = *standing.wall;
  const Vector origin = wall.origin + standing.shift;
  const Vector size = standing.high - standing.low;
  const Near near{0.5 * (standing.low + standing.high), 0.5 * size, 0.75 * norm(size)};
  std::vector<WallQuad> quads;
  switch (wall.shape) {
    case RigidWall::Shape::plane: {
      const bool edges = wall.finite;
      const Vector l = edges ? wall.edge_l : across(wall.normal),
                   m = edges ? wall.edge_m : cross(wall.normal, l);
      add_rectangle(origin, l, m, wall.normal, edges ? wall.length_l : 0.0, edges ? wall.length_m : 0.0, near,
                    quads);
      break;
    }
    case RigidWall::Shape::prism:
      add_prism(wall, origin, near, quads);
      break;
    case RigidWall::Shape::cylinder:
      add_cylinder(wall, origin, near, quads);
      break;
    case RigidWall::Shape::sphere:
      add_sphere(wall, origin, near, quads);
      break;
  }
  return quads;
}

}  // namespace cleave::results
