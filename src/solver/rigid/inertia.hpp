#pragma once
/// Inertia of a rigid body in any position.

#include "discretisation/rigid/body.hpp"
#include "solver/rigid/rotation.hpp"

namespace cleave::solver {

/// The inertia of a body as it stands.
class Inertia {
 public:
  Inertia(const discretisation::RigidBody& body, const Rotation& rotation)
      : body_(body), rotation_(rotation) {}
  /// Components along the principal axes, and back.
  Vector to_axes(const Vector& v) const {
    const Vector r = rotation_.inverse()(v);
    const auto& e = body_.axis;
    return {e[0][0] * r.x + e[1][0] * r.y + e[2][0] * r.z, e[0][1] * r.x + e[1][1] * r.y + e[2][1] * r.z,
            e[0][2] * r.x + e[1][2] * r.y + e[2][2] * r.z};
  }
  Vector from_axes(const Vector& v) const {
    const auto& e = body_.axis;
    return rotation_(Vector{e[0][0] * v.x + e[0][1] * v.y + e[0][2] * v.z,
                            e[1][0] * v.x + e[1][1] * v.y + e[1][2] * v.z,
                            e[2][0] * v.x + e[2][1] * v.y + e[2][2] * v.z});
  }
  Vector times(const Vector& spin) const { return scaled(spin, body_.moment); }
  Vector solve(const Vector& momentum) const { return scaled(momentum, body_.inverse); }

 private:
  Vector scaled(const Vector& v, const double (&by)[3]) const {
    const Vector a = to_axes(v);
    return from_axes({by[0] * a.x, by[1] * a.y, by[2] * a.z});
  }
  const discretisation::RigidBody& body_;
  const Rotation& rotation_;
};

}  // namespace cleave::solver
