#pragma once
/// Finite rotations of rigid bodies, and the step of a free one. Theory: docs/solver/rigid-bodies.md.

#include <cmath>

#include "base/tensor.hpp"

namespace cleave::solver {

using Vector = base::Vec3<double>;

/// A rotation as a unit quaternion w + x i + y j + z k.
struct Rotation {
  double w = 1.0;
  Vector v{0, 0, 0};

  /// This rotation of a vector, less the vector: without the loss of digits that a small rotation would
  /// bring.
  Vector shift(const Vector& r) const {
    const Vector c = base::cross(v, r);
    return 2.0 * (w * c + base::cross(v, c));
  }
  Vector operator()(const Vector& r) const { return r + shift(r); }
  Rotation inverse() const { return {w, -1.0 * v}; }
};

/// First b, then a; of unit length again.
inline Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation c{a.w * b.w - base::dot(a.v, b.v), a.w * b.v + b.w * a.v + base::cross(a.v, b.v)};
  const double size = std::sqrt(c.w * c.w + base::dot(c.v, c.v));
  return {c.w / size, (1.0 / size) * c.v};
}

/// Rotation about a vector by its length [radian].
inline Rotation turn(const Vector& by) {
  const double angle = std::sqrt(base::dot(by, by)), half = 0.5 * angle;
  return {std::cos(half), (angle > 0.0 ? std::sin(half) / angle : 0.5) * by};
}

/// Cayley's map of a vector: rotation about it by twice the arc tangent of half its length.
inline Rotation cayley(const Vector& by) {
  return Rotation{1.0, 0.5 * by} * Rotation{};
}

/// The rotation of a body without moments in a step, as the argument of cayley(), in the body's principal
/// axes. Angular momentum (in space) and energy stay as they are, to roundoff; a spin about a principal axis
/// turns by the exact angle. Second order. Source: Simo & Wong, IJNME 31 (1991) 19-52; Austin, Krishnaprasad
/// & Wang, J. Comp. Phys. 107 (1993) 105-117 (midpoint rule with Cayley's map).
/// @param momentum  angular, components along the principal axes at the start of the step
/// @param inverse   of the principal moments; 0 where there is no inertia
inline Vector free_turn(const Vector& momentum, const double inverse[3], double dt) {
  // The mean momentum m of the step in the body satisfies m + theta(m) x m / 2 = momentum.
  const double size = std::sqrt(base::dot(momentum, momentum));
  Vector mean = momentum, theta{0, 0, 0};
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Vector spin{inverse[0] * mean.x, inverse[1] * mean.y, inverse[2] * mean.z};
    const double rate = std::sqrt(base::dot(spin, spin)), angle = std::fmin(0.5 * rate * dt, 1.5);
    theta = (rate > 0.0 ? 2.0 * std::tan(angle) / rate : dt) * spin;
    const Vector a = 0.5 * theta;
    const Vector better =
        (1.0 / (1.0 + base::dot(a, a))) * (momentum - base::cross(a, momentum) + base::dot(a, momentum) * a);
    const Vector change = better - mean;
    mean = better;
    if (std::sqrt(base::dot(change, change)) <= 1e-16 * size) break;
  }
  return theta;
}

}  // namespace cleave::solver
