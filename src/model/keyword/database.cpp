/// *DATABASE_*: what is to be written and how often; *TERMINATION_NODE.

#include <algorithm>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

/// DT and LCUR of the ASCII histories; DT = 0 without a curve is no output.
void take_history_file(Draft& draft, const Entry& entry) {
  Requests& r = draft.model.requests;
  const std::pair<std::string_view, Interval*> files[] = {
      {"DATABASE_GLSTAT", &r.glstat}, {"DATABASE_MATSUM", &r.matsum}, {"DATABASE_NODOUT", &r.nodout},
      {"DATABASE_ELOUT", &r.elout},   {"DATABASE_RWFORC", &r.rwforc}, {"DATABASE_SPCFORC", &r.spcforc},
      {"DATABASE_RCFORC", &r.rcforc}, {"DATABASE_SLEOUT", &r.sleout}, {"DATABASE_NCFORC", &r.ncforc},
      {"DATABASE_RBDOUT", &r.rbdout}};
  for (const auto& [keyword, interval] : files) {
    if (keyword != entry.keyword()) continue;
    interval->every = entry.real("DT", a_time);
    interval->curve = draft.curve(entry, "LCUR", false);
    if (interval->every < 0.0) draft.error(entry, "DT", "an interval cannot be negative");
    if (!interval->active()) draft.warning(entry, "DT", "interval 0 and no curve: nothing is written");
  }
}

void take_plot(Draft& draft, const Entry& entry) {
  Interval& field = draft.model.requests.field;
  field.every = entry.real("DT", a_time);
  field.curve = draft.curve(entry, "LCDT", false);
  // NPLTC is a number of frames over the whole run and goes before DT.
  if (const auto frames = entry.integer("NPLTC"); frames > 0)
    field.every = draft.model.control.end.time / static_cast<double>(frames);
  if (field.every < 0.0) draft.error(entry, "DT", "an interval cannot be negative");
}

/// Restart files: the number counts cycles.
void take_dump(Draft& draft, const Entry& entry) {
  const std::int64_t cycles = entry.integer("DT");
  if (cycles < 0) draft.error(entry, "DT", "a number of cycles cannot be negative");
  draft.model.requests.restart_cycles = cycles;
}

void take_running_dump(Draft& draft, const Entry& entry) {
  const std::int64_t cycles = entry.integer("CYCL");
  if (cycles < 0) draft.error(entry, "CYCL", "a number of cycles cannot be negative");
  draft.model.requests.running_restart_cycles = cycles;
}

template <class Take>
void each_id(const Entry& entry, const Take& take) {
  for (int k = 1; k <= 8; ++k) {
    const std::string field = "ID" + std::to_string(k);
    if (!entry.has(field)) continue;
    for (std::size_t row = 0; row < entry.card().row_count(field); ++row)
      if (entry.integer(field, row) != 0) take(field, row);
  }
}

void add_node(Draft& draft, Index node) {
  auto& nodes = draft.model.requests.history_nodes;
  if (node >= 0 && std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
}

void take_history_node(Draft& draft, const Entry& entry) {
  each_id(entry,
          [&](const std::string& field, std::size_t row) { add_node(draft, draft.node(entry, field, row)); });
}

void take_history_node_id(Draft& draft, const Entry& entry) {
  for (std::size_t row = 0; row < entry.card().row_count("ID1"); ++row) {
    const Index node = draft.node(entry, "ID1", row);
    add_node(draft, node);
    if (node >= 0)
      draft.model.requests.history_node_titles.emplace_back(draft.model.mesh.nodes.id[node],
                                                            std::string(entry.card().text("HEADING", row)));
  }
}

void take_history_node_set(Draft& draft, const Entry& entry) {
  each_id(entry, [&](const std::string& field, std::size_t row) {
    if (row > 0) return draft.error(entry, field, "one row of set numbers a card");
    if (const auto* set = draft.node_set(entry, field))
      for (const Index node : *set) add_node(draft, node);
  });
}

std::vector<Id>& history_elements(Draft& draft, ElementKind kind) {
  Requests& r = draft.model.requests;
  return kind == ElementKind::solid   ? r.history_solids
         : kind == ElementKind::shell ? r.history_shells
                                      : r.history_beams;
}

/// Stresses of an element are wanted. Shells that are read but not solved in spacetime are rigid.
void add_element(Draft& draft, const Entry& entry, std::string_view field, ElementKind kind, Id id) {
  if (kind != ElementKind::solid) {
    const Draft::ElementPlace at = *draft.element(id, kind);
    const Index part = draft.model.mesh.elements(kind)[at.group].part[at.index];
    if (spacetime_dimension(draft.model.parts[static_cast<std::size_t>(part)].section) == 0)
      return draft.warning(
          entry, field,
          std::string(name_of(kind)) + " " + std::to_string(id) + " is rigid: no stresses are written");
  }
  auto& elements = history_elements(draft, kind);
  if (std::find(elements.begin(), elements.end(), id) == elements.end()) elements.push_back(id);
}

/// Elements of a kind of which nothing is computed are not read: their histories are left out.
bool none_computed(Draft& draft, const Entry& entry, ElementKind kind) {
  if (kind == ElementKind::solid || !draft.model.mesh.elements(kind).empty()) return false;
  draft.warning(entry, "ID1",
                "there are no " + std::string(name_of(kind)) + "s that are computed: nothing is written");
  return true;
}

template <ElementKind kind>
void take_history_elements(Draft& draft, const Entry& entry) {
  if (none_computed(draft, entry, kind)) return;
  each_id(entry, [&](const std::string& field, std::size_t row) {
    const Id id = entry.id(IdKind::element, field, row);
    if (!draft.element(id, kind))
      return draft.error(entry, field, "element " + std::to_string(id) + " is not defined");
    add_element(draft, entry, field, kind, id);
  });
}

template <ElementKind kind>
void take_history_sets(Draft& draft, const Entry& entry) {
  if (none_computed(draft, entry, kind)) return;
  each_id(entry, [&](const std::string& field, std::size_t row) {
    if (row > 0) return draft.error(entry, field, "one row of set numbers a card");
    if (const auto* set = draft.element_set(entry, field, kind))
      for (const Id id : *set) add_element(draft, entry, field, kind, id);
  });
}

/// Bounds on one coordinate of a node; a blank bound is none.
void take_termination_node(Draft& draft, const Entry& entry) {
  for (std::size_t row = 0; row < entry.card().row_count("NID"); ++row) {
    Termination::NodeBound bound{};
    bound.node = draft.node(entry, "NID", row);
    bound.stop = static_cast<int>(entry.integer("STOP", row));
    if (bound.stop < 1 || bound.stop > 3) {
      draft.refuse(entry, "STOP", "found " + std::to_string(bound.stop) + ", expected 1, 2 or 3 (x, y, z)");
      continue;
    }
    bound.maximum = entry.given("MAXC", row) ? entry.real("MAXC", a_length, row) : 1e21;
    bound.minimum = entry.given("MINC", row) ? entry.real("MINC", a_length, row) : -1e21;
    if (bound.node >= 0) draft.model.control.end.nodes.push_back(bound);
  }
}

constexpr std::string_view interval = "DT LCUR";
constexpr std::string_view form = "BINARY IOOPT OPTION1 OPTION2 OPTION3 OPTION4";
constexpr std::string_view planar = "of spacetime parts";
constexpr std::string_view eight = "ID1 ID2 ID3 ID4 ID5 ID6 ID7 ID8";

constexpr Handler handlers[] = {
    {"DATABASE_GLSTAT", Phase::action, interval, form, take_history_file},
    {"DATABASE_MATSUM", Phase::action, interval, form, take_history_file},
    {"DATABASE_NODOUT", Phase::action, interval, form, take_history_file},
    {"DATABASE_ELOUT", Phase::action, interval, form, take_history_file},
    {"DATABASE_RWFORC", Phase::action, interval, form, take_history_file},
    {"DATABASE_SPCFORC", Phase::action, interval, form, take_history_file},
    {"DATABASE_RCFORC", Phase::action, interval, form, take_history_file},
    {"DATABASE_SLEOUT", Phase::action, interval, form, take_history_file},
    {"DATABASE_NCFORC", Phase::action, interval, form, take_history_file},
    {"DATABASE_RBDOUT", Phase::action, interval, form, take_history_file},
    {"DATABASE_BINARY_D3PLOT", Phase::action, "DT LCDT NPLTC",
     "BEAM PSETID IOOPT RATE CUTOFF WINDOW TYPE PSET", take_plot},
    {"DATABASE_BINARY_D3DUMP", Phase::action, "DT", "LCDT BEAM NPLTC PSETID CID NSKIP IOOPT", take_dump},
    {"DATABASE_BINARY_RUNRSF", Phase::action, "CYCL", "NR BEAM NPLTC PSETID NSKIP", take_running_dump},
    {"DATABASE_HISTORY_NODE", Phase::action, eight, {}, take_history_node},
    {"DATABASE_HISTORY_NODE_ID", Phase::action, "ID1 HEADING", {}, take_history_node_id},
    {"DATABASE_HISTORY_NODE_SET", Phase::action, eight, {}, take_history_node_set},
    {"DATABASE_HISTORY_SOLID", Phase::action, eight, {}, take_history_elements<ElementKind::solid>},
    {"DATABASE_HISTORY_SOLID_SET", Phase::action, eight, {}, take_history_sets<ElementKind::solid>},
    {"DATABASE_HISTORY_SHELL",
     Phase::action,
     eight,
     {},
     take_history_elements<ElementKind::shell>,
     nullptr,
     planar},
    {"DATABASE_HISTORY_SHELL_SET",
     Phase::action,
     eight,
     {},
     take_history_sets<ElementKind::shell>,
     nullptr,
     planar},
    {"DATABASE_HISTORY_BEAM",
     Phase::action,
     eight,
     {},
     take_history_elements<ElementKind::beam>,
     nullptr,
     planar},
    {"DATABASE_HISTORY_BEAM_SET",
     Phase::action,
     eight,
     {},
     take_history_sets<ElementKind::beam>,
     nullptr,
     planar},
    {"TERMINATION_NODE", Phase::action, "NID STOP MAXC MINC", {}, take_termination_node},
};

}  // namespace
extern const Family database_cards{handlers};

}  // namespace cleave::model
