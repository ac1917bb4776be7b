/// *BOUNDARY_SPC_NODE and _SET, with _BIRTH_DEATH and a local system.

#include <algorithm>

#include "model/keyword/handler.hpp"
#include "model/keyword/over_time.hpp"

namespace cleave::model {
namespace {

bool same_axes(const Frame& a, const Frame& b) {
  for (int i = 0; i < 3; ++i)
    if (a.axis[i].x != b.axis[i].x || a.axis[i].y != b.axis[i].y || a.axis[i].z != b.axis[i].z) return false;
  return true;
}

void take_spc(Draft& draft, const Entry& entry) {
  FixedNodes fixed;
  fixed.id = entry.own_id();
  fixed.title = entry.title();
  const bool by_set = entry.keyword().starts_with("BOUNDARY_SPC_SET");
  fixed.place = entry.place(by_set ? "NSID" : "NID");
  if (by_set) {
    const auto* set = draft.node_set(entry, "NSID");
    if (!set) return;
    fixed.nodes = *set;
  } else {
    const Index node = draft.node(entry, "NID");
    if (node < 0) return;
    fixed.nodes = {node};
  }
  static constexpr std::string_view flags[] = {"DOFX", "DOFY", "DOFZ", "DOFRX", "DOFRY", "DOFRZ"};
  for (unsigned k = 0; k < 6; ++k) {
    const auto flag = entry.integer(flags[k]);
    if (flag != 0 && flag != 1)
      draft.error(entry, flags[k], "found " + std::to_string(flag) + ", expected 0 (free) or 1 (fixed)");
    if (flag == 1) fixed.directions |= 1u << k;
  }
  if (entry.integer("CID") != 0) {
    const Frame* frame = draft.frame(entry, "CID");
    if (!frame) return;
    fixed.local = true;
    std::copy(std::begin(frame->axis), std::end(frame->axis), std::begin(fixed.frame.axis));
  }
  if (entry.has("BIRTH")) {
    fixed.birth = entry.real("BIRTH", a_time);
    fixed.death = death_time(entry, "DEATH");
  }
  if (fixed.directions == 0) draft.warning(entry, "DOFX", "no direction is fixed");

  // Rows that differ only in their node are one constraint.
  auto& all = draft.model.fixed;
  if (!by_set && !draft.first_of_block && fixed.id == 0 && fixed.title.empty() && !all.empty()) {
    FixedNodes& last = all.back();
    if (last.id == 0 && last.title.empty() && last.directions == fixed.directions &&
        last.local == fixed.local && same_axes(last.frame, fixed.frame) && last.birth == fixed.birth &&
        last.death == fixed.death) {
      last.nodes.push_back(fixed.nodes[0]);
      return;
    }
  }
  all.push_back(std::move(fixed));
}

constexpr std::string_view fields = "ID HEADING NID NSID CID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ BIRTH DEATH";
constexpr Handler handlers[] = {
    {.keyword = "BOUNDARY_SPC_NODE", .honoured = fields, .take = take_spc},
    {.keyword = "BOUNDARY_SPC_SET", .honoured = fields, .take = take_spc},
    {.keyword = "BOUNDARY_SPC_NODE_BIRTH_DEATH", .honoured = fields, .take = take_spc},
    {.keyword = "BOUNDARY_SPC_SET_BIRTH_DEATH", .honoured = fields, .take = take_spc},
};

}  // namespace
extern const Family spc_cards{handlers};

}  // namespace cleave::model
