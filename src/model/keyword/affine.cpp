#include "model/keyword/affine.hpp"

#include <cmath>
#include <limits>

namespace cleave::model {
namespace {
constexpr double roundoff = 8.0 * std::numeric_limits<double>::epsilon();
}

Vector Affine::direction(const Vector& v) const {
  const auto& m = linear.m;
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

bool Affine::turns() const {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (linear.m[i][j] != (i == j ? 1.0 : 0.0)) return true;
  return false;
}

Affine followed_by(const Affine& first, const Affine& next) {
  return {.linear = next.linear * first.linear, .shift = next.point(first.shift)};
}

double length(const Vector& v) {
  return std::sqrt(dot(v, v));
}

Vector unit(const Vector& v) {
  const double square = dot(v, v);
  if (square == 0.0 || std::fabs(square - 1.0) <= roundoff) return v;
  return (1.0 / std::sqrt(square)) * v;
}

bool make_frame(const Vector& x, const Vector& in_plane, Frame& frame) {
  const Vector a = unit(x);
  const double along = dot(a, in_plane), size = length(in_plane);
  // Already at right angles to roundoff: keep the bits.
  Vector b = in_plane;
  if (std::fabs(along) > roundoff * size) b = in_plane - along * a;
  if (length(x) == 0.0 || length(b) <= 1e-10 * size || size == 0.0) return false;
  b = unit(b);
  frame.axis[0] = a;
  frame.axis[1] = b;
  frame.axis[2] = cross(a, b);
  return true;
}

Affine rotation(const Vector& axis, const Vector& through, double angle) {
  const Vector n = unit(axis);
  const double c = std::cos(angle), s = std::sin(angle);
  const double k[3][3] = {{0, -n.z, n.y}, {n.z, 0, -n.x}, {-n.y, n.x, 0}};
  const double component[3] = {n.x, n.y, n.z};
  Affine r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r.linear.m[i][j] = (i == j ? c : 0.0) + s * k[i][j] + (1.0 - c) * component[i] * component[j];
  r.shift = through - r.direction(through);
  return r;
}

}  // namespace cleave::model
