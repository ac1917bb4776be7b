#pragma once
/// What the deck wants written: *DATABASE_* with intervals resolved.

#include <string>
#include <vector>

#include "model/mesh.hpp"

namespace cleave::model {

/// When to write one kind of result. Interval 0 and no curve: not at all.
struct Interval {
  double every = 0.0;  ///< [time]
  Index curve = -1;    ///< interval over time
  bool active() const { return every > 0.0 || curve >= 0; }
};

struct Requests {
  std::string title;
  Interval field;  ///< d3plot-like frames
  Interval glstat, matsum, nodout, elout, rwforc, spcforc, rcforc, sleout, ncforc, rbdout;
  std::int64_t restart_cycles = 0;          ///< *DATABASE_BINARY_D3DUMP: write a restart every so many cycles
  std::int64_t running_restart_cycles = 0;  ///< RUNRSF: the same file overwritten
  std::vector<Index> history_nodes;         ///< *DATABASE_HISTORY_NODE(_SET)
  std::vector<std::pair<Id, std::string>> history_node_titles;
  /// Element ids, *DATABASE_HISTORY_SOLID(_SET), _SHELL, _BEAM.
  std::vector<Id> history_solids, history_shells, history_beams;

  bool any_element() const {
    return !history_solids.empty() || !history_shells.empty() || !history_beams.empty();
  }
};

}  // namespace cleave::model
