#pragma once
/// Which tents were solved, how long each took, and which had to be there before: for asking how the same
/// work would keep many workers busy.

#include <cstdint>
#include <vector>

#include "discretisation/spacetime/patch.hpp"

namespace cleave::discretisation::spacetime {

struct ScheduleRecord {
  struct Tent {
    Vertex pole = -1;
    double foot = 0.0, top = 0.0;   ///< [time]
    double duration = 0.0;          ///< of pitching and solving [s]
    std::int64_t first_needed = 0;  ///< into `needed`; ends where the next tent's begins
  };
  std::vector<Tent> tents;  ///< by (foot, rank): an order in which they can be solved
  std::vector<std::int32_t>
      needed;  ///< tents that must be finished before, ascending; all earlier in `tents`

  std::int64_t first_needed(std::size_t tent) const {
    return tent < tents.size() ? tents[tent].first_needed : static_cast<std::int64_t>(needed.size());
  }
};

struct Replay {
  double makespan = 0.0;    ///< [s]
  double work = 0.0;        ///< sum of the durations [s]
  double longest = 0.0;     ///< chain of dependent tents: no number of workers is faster [s]
  double efficiency = 0.0;  ///< work / (workers * makespan)
};

/// Solves the recorded tents again on ideal workers without overhead: a free worker takes, of the tents whose
/// dependencies are finished, the one with the earliest foot.
Replay replay(const ScheduleRecord& record, int workers);

}  // namespace cleave::discretisation::spacetime
