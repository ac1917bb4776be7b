#pragma once
/// Everything that changes during a run, and nothing else. Copying a State is a checkpoint.

#include <cstdint>
#include <string>
#include <vector>

#include "base/array.hpp"

namespace cleave::discretisation {

/// What changes in one block. Layout of `point` and `element` is the block's own affair; lanes of eight.
struct BlockState {
  base::Array<double> point;    ///< records of integration points: stress, history, energy
  base::Array<double> element;  ///< per element values: hourglass forces, volumes
  base::Array<double> alive;    ///< [element, padded to lanes] 1 active, 0 deleted
};

/// Running sums of a part, all from the start of the run [energy].
struct PartEnergy {
  double internal = 0.0;   ///< of active elements
  double hourglass = 0.0;  ///< of active elements
  double eroded_internal = 0.0, eroded_hourglass = 0.0, eroded_kinetic = 0.0;
};

/// The energy balance of the whole model at t_n [energy]. As in the established `glstat`, `kinetic`,
/// `internal` and `hourglass` contain their eroded shares.
struct Energy {
  double kinetic = 0.0, internal = 0.0, hourglass = 0.0, damping = 0.0, wall = 0.0, sliding = 0.0;
  double external = 0.0;  ///< work of loads, prescribed motion, walls that move
  double eroded_kinetic = 0.0, eroded_internal = 0.0, eroded_hourglass = 0.0;
  double initial = 0.0;  ///< total at the start

  double total() const { return kinetic + internal + hourglass + damping + wall + sliding; }
  /// total / (initial + external work); 1 when nothing is lost.
  double ratio() const;
  double ratio_without_eroded() const;
};

/// Named memory of anything else that must survive a restart: a rigid wall, a contact, an observer's clock.
struct Memory {
  std::string name;
  base::Array<double> values;
};

struct State {
  std::int64_t cycle = 0;
  double time = 0.0;        ///< t_n, to which position belongs
  double step = 0.0;        ///< dt that led to t_n
  double next_step = 0.0;   ///< dt to be taken next
  double first_step = 0.0;  ///< dt of cycle 1, for DTMIN

  base::Array<double> position;  ///< [node][3] at t_n [length]
  base::Array<double> velocity;  ///< [node][3] at t_n - step/2 (at t = 0: the initial velocity) [length/time]
  base::Array<double> mass;      ///< [node], added mass included [mass]
  double added_mass = 0.0;       ///< by mass scaling, total [mass]

  std::vector<BlockState> blocks;
  std::vector<PartEnergy> parts;
  Energy energy;
  std::vector<Memory> memory;

  double largest_force = 0.0;  ///< largest contribution of the last step, scales the next force sum [force]
};

}  // namespace cleave::discretisation
