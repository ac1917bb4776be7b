#pragma once
/// Affine maps of space and orthonormal frames, as *DEFINE_TRANSFORMATION and *DEFINE_COORDINATE build them.

#include "model/load.hpp"

namespace cleave::model {

/// x -> linear x + shift.
struct Affine {
  base::Mat3<double> linear = base::Mat3<double>::identity();
  Vector shift = {0, 0, 0};

  Vector direction(const Vector& v) const;  ///< without the shift
  Vector point(const Vector& p) const { return direction(p) + shift; }
  bool turns() const;  ///< linear part other than the identity
};

/// This map first, then `next`.
Affine followed_by(const Affine& first, const Affine& next);

double length(const Vector& v);

/// v / |v|; a vector of unit length to roundoff is returned as it is, so that writing and reading a direction
/// leaves its bits alone. The zero vector is returned as it is.
Vector unit(const Vector& v);

/// Axes from the local x axis and a vector in the local xy plane; idempotent like unit().
/// Fails (false) if the two are parallel or one is zero.
bool make_frame(const Vector& x, const Vector& in_plane, Frame& frame);

/// Components along the frame's axes to global components.
inline Vector to_global(const Frame& frame, const Vector& local) {
  return local.x * frame.axis[0] + local.y * frame.axis[1] + local.z * frame.axis[2];
}

/// Rotation by `angle` [radian] about an axis through a point (Rodrigues' formula).
Affine rotation(const Vector& axis, const Vector& through, double angle);

}  // namespace cleave::model
