#pragma once
/// What every rigid wall books.

#include "solver/action.hpp"

namespace cleave::solver {

/// What the wall's motion gives is external work; what does not arrive in the nodes is lost in the wall.
/// @param along   force of the wall on the nodes along its motion [force]
/// @param before  speed of the wall in the step before t_n [length/time]
/// @param late    and in the step to come [length/time]
/// @param stops   nodes that the wall stops: `node`, and `force`, of the wall on it [force]
template <class Stops>
Halves wall_work(const Moment& now, double along, double before, double late, const Stops& stops,
                 std::span<const double> acceleration) {
  const double middle = before + (late - before) * (0.5 * now.step_before / now.interval());
  Halves sum;
  sum.before.external = 0.25 * now.step_before * along * (before + middle);
  sum.after.external = 0.25 * now.step * along * (middle + late);
  sum.before.wall = sum.before.external;
  sum.after.wall = sum.after.external;
  for (const auto& one : stops) {
    const ImpulseWork node = impulse_work(now, one.node, one.force, acceleration);
    sum.before.wall -= node.before;
    sum.after.wall -= node.after;
  }
  return sum;
}

}  // namespace cleave::solver
