#include "solver/constraint/rigid_wall_shape.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::solver {
namespace {

using Vector = model::Vector;
using Wall = model::RigidWall;

double length(const Vector& v) {
  return std::sqrt(base::dot(v, v));
}

}  // namespace

WallShape::WallShape(const Wall& wall) : wall_(wall) {
  const Vector &n = wall.normal, &l = wall.edge_l, &m = wall.edge_m;
  const auto plane = [&](const Vector& normal, double offset) { faces_.push_back({false, normal, offset}); };
  const auto opposite = [](const Vector& v) { return -1.0 * v; };
  const bool round = wall.shape == Wall::Shape::cylinder || wall.shape == Wall::Shape::sphere;
  if (round) {
    faces_.push_back({true, {0, 0, 1}, 0.0});
    if (wall.length_n > 0.0 && !wall.interior) {
      plane(n, wall.length_n);
      plane(opposite(n), 0.0);
    }
    ends_ = wall.interior && wall.length_n > 0.0;
  } else {
    plane(n, 0.0);
    ends_ = wall.finite;
  }
  if (wall.shape == Wall::Shape::prism) {
    // The top face lies at the origin; the prism hangs below it. Without an end along an edge, none either
    // way.
    if (wall.length_l > 0.0) plane(l, wall.length_l), plane(opposite(l), 0.0);
    if (wall.length_m > 0.0) plane(m, wall.length_m), plane(opposite(m), 0.0);
    if (wall.length_n > 0.0) plane(opposite(n), wall.length_n);
  }
  close_ = 1e-9 * (wall.radius + wall.length_l + wall.length_m + wall.length_n + length(wall.origin));
}

Vector WallShape::across(const Vector& place) const {
  if (wall_.shape == Wall::Shape::sphere) return place;
  return place - base::dot(place, wall_.normal) * wall_.normal;
}

double WallShape::measure(const Face& face, const Vector& place) const {
  if (!face.round) return base::dot(place, face.normal) - face.offset;
  const double outside = length(across(place)) - wall_.radius;
  return wall_.interior ? -outside : outside;
}

double WallShape::measure(const Vector& place) const {
  double largest = measure(faces_[0], place);
  for (std::size_t f = 1; f < faces_.size(); ++f) largest = std::max(largest, measure(faces_[f], place));
  return largest;
}

double WallShape::depth(const Vector& place) const {
  const double behind = -measure(place);
  return behind > close_ ? behind : 0.0;
}

Vector WallShape::normal(const Face& face, const Vector& place) const {
  if (!face.round) return face.normal;
  const Vector radial = across(place);
  const double size = length(radial);
  if (size == 0.0) return wall_.shape == Wall::Shape::sphere ? wall_.normal : wall_.edge_l;
  return ((wall_.interior ? -1.0 : 1.0) / size) * radial;
}

/// |p + s d|^2 = R^2 for the first s in [0, 1], seen from the side the step comes from.
double WallShape::passed(const Vector& from, const Vector& step, double radius) const {
  const Vector p = across(from), d = across(step);
  const double a = base::dot(d, d), b = base::dot(p, d), c = base::dot(p, p) - radius * radius;
  if (a == 0.0 || (wall_.interior ? c >= 0.0 : c <= 0.0)) return 0.0;
  const double root = std::sqrt(std::max(b * b - a * c, 0.0));
  return std::clamp((wall_.interior ? root - b : -b - root) / a, 0.0, 1.0);
}

bool WallShape::within(const Vector& place) const {
  const auto inside = [](double at, double end) { return end == 0.0 || (at >= 0.0 && at <= end); };
  if (wall_.shape == Wall::Shape::cylinder) return inside(base::dot(place, wall_.normal), wall_.length_n);
  return inside(base::dot(place, wall_.edge_l), wall_.length_l) &&
         inside(base::dot(place, wall_.edge_m), wall_.length_m);
}

std::optional<WallShape::Hit> WallShape::enters(const Vector& from, const Vector& to) const {
  const double before = measure(from);
  double level = 0.0;
  if (before < -close_) {
    if (ends_) return std::nullopt;
    level = before;
  }
  if (!(measure(to) < level)) return std::nullopt;

  // The face that is passed last; of several at once the one that the step began nearest to.
  const Vector step = to - from;
  Hit hit{{0, 0, 0}, 0.0, 0, level};
  double last = -1.0, nearest = 0.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const double start = measure(faces_[f], from) - level, end = measure(faces_[f], to) - level;
    double at = 0.0;
    if (start > 0.0)
      at = faces_[f].round ? passed(from, step, wall_.radius + (wall_.interior ? -level : level))
                           : start / (start - end);
    if (at < last || (at == last && start <= nearest)) continue;
    last = at;
    nearest = start;
    hit.face = f;
  }
  const Vector place = from + last * step;
  if (ends_ && !within(place)) return std::nullopt;
  hit.normal = normal(faces_[hit.face], place);
  hit.push = push(hit, to);
  if (hit.push > 0.0) return hit;
  // A step that a hollow turns back by more than its size has no way along the normal: straight to the face.
  hit.normal = normal(faces_[hit.face], to);
  hit.push = level - measure(faces_[hit.face], to);
  return hit;
}

double WallShape::push(const Hit& hit, const Vector& place) const {
  const Face& face = faces_[hit.face];
  if (!face.round) return hit.level - measure(face, place);
  // |q + s n| = R, n a radius of length 1: the root that is nearest in the direction of the normal.
  const Vector q = across(place);
  const double radius = wall_.radius + (wall_.interior ? -hit.level : hit.level);
  const double b = base::dot(q, hit.normal), square = b * b - (base::dot(q, q) - radius * radius);
  if (square < 0.0) return 0.0;
  return wall_.interior ? -b - std::sqrt(square) : std::sqrt(square) - b;
}

}  // namespace cleave::solver
