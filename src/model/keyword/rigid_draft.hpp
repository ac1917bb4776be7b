#pragma once
/// What the deck says about rigid bodies, kept until every part has its law and the bodies can be made.

#include <map>
#include <vector>

#include "model/keyword/entry.hpp"
#include "model/rigid.hpp"

namespace cleave::model {

struct RigidDraft {
  std::map<Index, Entry> inertia;  ///< *PART_INERTIA by part
  std::vector<Entry> merges, extra, nodal, motions, loads, velocities;
  /// IRIGID of *INITIAL_VELOCITY: velocities stated with the inertia give way to those of the nodes.
  bool reset_parts = false, reset_nodal = false;
};

}  // namespace cleave::model
