/// *LOAD_BODY_GENERALIZED, _SET_NODE and _SET_PART: motion of the base as some of the nodes feel it.

#include <algorithm>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

/// Nodes by number from N1 to N2, of a node set, or of the parts of a set; nothing after an error.
std::optional<std::vector<bool>> loaded_nodes(Draft& draft, const Entry& entry) {
  const auto& ids = draft.model.mesh.nodes.id;
  std::vector<bool> flags(ids.size(), false);
  if (entry.has("NSID")) {
    const auto* set = draft.node_set(entry, "NSID");
    if (!set) return std::nullopt;
    for (const Index i : *set) flags[static_cast<std::size_t>(i)] = true;
  } else if (entry.has("PSID")) {
    const auto* parts = draft.part_set(entry, "PSID");
    if (!parts) return std::nullopt;
    for (const Index i : draft.nodes_of_parts(*parts)) flags[static_cast<std::size_t>(i)] = true;
  } else {
    const Id first = entry.id(IdKind::node, "N1"), last = entry.id(IdKind::node, "N2");
    if (last < first) {
      draft.error(
          entry, "N2",
          "found " + std::to_string(last) + ", expected a number from N1 = " + std::to_string(first) + " on");
      return std::nullopt;
    }
    for (std::size_t i = 0; i < ids.size(); ++i) flags[i] = ids[i] >= first && ids[i] <= last;
    if (std::find(flags.begin(), flags.end(), true) == flags.end()) {
      draft.error(entry, "N1",
                  "no node has a number from " + std::to_string(first) + " to " + std::to_string(last));
      return std::nullopt;
    }
  }
  return flags;
}

void take_generalized(Draft& draft, const Entry& entry) {
  BodyLoad load;
  load.generalized = true;
  load.place = entry.place("LCID");
  load.curve = draft.curve(entry, "LCID");
  const Frame* frame = draft.frame(entry, "CID");
  auto nodes = loaded_nodes(draft, entry);
  if (load.curve < 0 || !frame || !nodes) return;
  load.nodes = std::move(*nodes);
  if (entry.integer("DRLCID") != 0)
    draft.warning(entry, "DRLCID", "there is no dynamic relaxation phase; this curve is not used");

  // With CID the centre lies in that frame, and the components are those along its axes.
  if (entry.integer("CID") != 0)
    load.centre = frame->origin + to_global(*frame, {entry.real("XC", a_length), entry.real("YC", a_length),
                                                     entry.real("ZC", a_length)});
  else
    load.centre = entry.point("XC", "YC", "ZC");
  const auto components = [&](std::string_view x, std::string_view y, std::string_view z) {
    return to_global(*frame, {entry.card().real(x), entry.card().real(y), entry.card().real(z)});
  };
  const std::string_view type = entry.card().text("ANGTYP");
  if (type.empty() || type == "CENT") {
    load.angular = BodyLoad::Angular::centrifugal;
  } else if (type == "CORI") {
    load.angular = BodyLoad::Angular::coriolis;
  } else if (type == "ROTA") {
    load.angular = BodyLoad::Angular::euler;
  } else {
    return draft.error(entry, "ANGTYP", "found '" + std::string(type) + "', expected CENT, CORI or ROTA");
  }

  // Translation and rotation of the base are a load each.
  BodyLoad straight = load;
  straight.angular = BodyLoad::Angular::centrifugal;
  straight.centre = {0, 0, 0};
  straight.direction = components("AX", "AY", "AZ");
  load.direction = components("OMX", "OMY", "OMZ");
  load.rotation = true;
  const bool moves = length(straight.direction) > 0.0, turns = length(load.direction) > 0.0;
  if (!moves && !turns) draft.warning(entry, "AX", "all factors are 0: this load does nothing");
  if (moves) draft.model.body_loads.push_back(std::move(straight));
  if (turns) draft.model.body_loads.push_back(std::move(load));
}

constexpr std::string_view fields = "N1 N2 NSID PSID LCID DRLCID XC YC ZC AX AY AZ OMX OMY OMZ CID ANGTYP";
constexpr Handler handlers[] = {
    {.keyword = "LOAD_BODY_GENERALIZED", .honoured = fields, .take = take_generalized},
    {.keyword = "LOAD_BODY_GENERALIZED_SET_NODE", .honoured = fields, .take = take_generalized},
    {.keyword = "LOAD_BODY_GENERALIZED_SET_PART", .honoured = fields, .take = take_generalized},
};

}  // namespace
extern const Family generalized_load_cards{handlers};

}  // namespace cleave::model
