#pragma once
/// What a run in spacetime will take, told before it: for `check`.

#include <string>

#include "model/model.hpp"

namespace cleave::discretisation::spacetime {

struct TentEstimate {
  double lowest = 0.0;             ///< height of the lowest first tent [time]
  double highest = 0.0;            ///< of the highest [time]
  model::Id lowest_at = 0;         ///< node under the lowest
  double position[3] = {0, 0, 0};  ///< of that node [length]
  double patches = 0.0;  ///< about how many tents there will be until the end; 0 without an end time
};

/// First tents over the level front at time 0, and how many there will be until the end: what was counted in
/// examples is between 0.8 and 1.1 of the estimate. Zeros when the model is not one of spacetime parts or was
/// refused.
TentEstimate estimate_tents(const model::Model& model);

}  // namespace cleave::discretisation::spacetime
