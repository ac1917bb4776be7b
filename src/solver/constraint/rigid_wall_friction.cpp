#include "solver/constraint/rigid_wall_friction.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::solver {
namespace {

using Vector = model::Vector;

/// Nearest point of the ellipse (x / a)^2 + (y / b)^2 <= 1 to a point outside it: x_i = a_i^2 s_i / (a_i^2 +
/// t), t the root of a convex falling function, which Newton's method reaches from the left without fail.
void nearest_of_ellipse(const double (&half)[2], const double (&s)[2], double (&out)[2]) {
  const double square[2] = {half[0] * half[0], half[1] * half[1]};
  double t = 0.0;
  for (int round = 0; round < 60; ++round) {
    double value = -1.0, slope = 0.0;
    for (int k = 0; k < 2; ++k) {
      if (half[k] == 0.0) continue;
      const double part = half[k] * s[k] / (square[k] + t);
      value += part * part;
      slope -= 2.0 * part * part / (square[k] + t);
    }
    if (!(value > 0.0) || slope == 0.0) break;
    const double next = t - value / slope;
    if (!(next > t)) break;
    t = next;
  }
  for (int k = 0; k < 2; ++k) out[k] = half[k] == 0.0 ? 0.0 : square[k] * s[k] / (square[k] + t);
}

}  // namespace

Vector friction_change(const model::RigidWall& wall, const Vector& sliding, double speed, double gain,
                       const Vector& normal, std::span<const double> position) {
  const double trial = std::sqrt(base::dot(sliding, sliding));
  if (trial == 0.0) return {0, 0, 0};
  if (wall.friction == 1.0 || wall.friction == 3.0) return -1.0 * sliding;
  if (wall.friction == 2.0) return {0, 0, 0};
  if (!wall.orthotropic) return -std::min(1.0, wall.friction * std::max(gain, 0.0) / trial) * sliding;

  Vector first = wall.friction_axis;
  if (wall.friction_node[0] >= 0) {
    const double* tail = &position[3 * static_cast<std::size_t>(wall.friction_node[0])];
    const double* head = &position[3 * static_cast<std::size_t>(wall.friction_node[1])];
    first = {head[0] - tail[0], head[1] - tail[1], head[2] - tail[2]};
  }
  first = first - base::dot(first, normal) * normal;
  const double size = std::sqrt(base::dot(first, first));
  // Nodes that have turned into the normal of the wall give no direction any more: the slide does.
  first = size > 0.0 ? (1.0 / size) * first : (1.0 / trial) * sliding;
  const Vector second = base::cross(normal, first);

  const double along[2] = {base::dot(sliding, first), base::dot(sliding, second)};
  double half[2], taken[2];
  for (int k = 0; k < 2; ++k) {
    const double more = wall.static_friction[k] - wall.dynamic_friction[k];
    half[k] =
        std::max(gain, 0.0) * (wall.dynamic_friction[k] + more * std::exp(-wall.friction_decay[k] * speed));
  }
  nearest_of_ellipse(half, along, taken);
  return (-taken[0]) * first - taken[1] * second;
}

}  // namespace cleave::solver
