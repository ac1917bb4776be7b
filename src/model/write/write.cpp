/// The model as a deck: what build() reads back to the same model.

#include "model/write/references.hpp"

namespace cleave::model {

void write_requests(const Model& model, DeckText& out) {
  const Requests& r = model.requests;
  const std::pair<std::string_view, const Interval*> files[] = {
      {"GLSTAT", &r.glstat}, {"MATSUM", &r.matsum},   {"NODOUT", &r.nodout}, {"ELOUT", &r.elout},
      {"RWFORC", &r.rwforc}, {"SPCFORC", &r.spcforc}, {"RCFORC", &r.rcforc}, {"SLEOUT", &r.sleout},
      {"NCFORC", &r.ncforc}, {"RBDOUT", &r.rbdout}};
  for (const auto& [name, interval] : files) {
    if (!interval->active()) continue;
    out.keyword("DATABASE_" + std::string(name));
    out.line({interval->every, 0, curve_id(model, interval->curve)});
  }
  if (r.field.active()) {
    out.keyword("DATABASE_BINARY_D3PLOT");
    out.line({r.field.every, curve_id(model, r.field.curve)});
  }
  if (r.restart_cycles > 0) {
    out.keyword("DATABASE_BINARY_D3DUMP");
    out.line({r.restart_cycles, 0});
  }
  if (r.running_restart_cycles > 0) {
    out.keyword("DATABASE_BINARY_RUNRSF");
    out.line({r.running_restart_cycles, 0});
  }
  if (!r.history_nodes.empty()) {
    out.keyword("DATABASE_HISTORY_NODE");
    out.ids(r.history_nodes, [&](Index i) { return model.mesh.nodes.id[i]; });
  }
  if (!r.history_node_titles.empty()) {
    out.keyword("DATABASE_HISTORY_NODE_ID");
    for (const auto& [id, title] : r.history_node_titles) out.id_line(id, title);
  }
  const std::pair<std::string_view, const std::vector<Id>*> elements[] = {
      {"SOLID", &r.history_solids}, {"SHELL", &r.history_shells}, {"BEAM", &r.history_beams}};
  for (const auto& [kind, ids] : elements) {
    if (ids->empty()) continue;
    out.keyword("DATABASE_HISTORY_" + std::string(kind));
    out.ids(*ids, [](Id id) { return id; });
  }
  if (!model.control.end.nodes.empty()) {
    out.keyword("TERMINATION_NODE");
    for (const auto& bound : model.control.end.nodes)
      out.line({model.mesh.nodes.id[bound.node], bound.stop, bound.maximum, bound.minimum});
  }
}

std::string write(const Model& model) {
  DeckText out;
  write_definitions(model, out);
  write_mesh(model, out);
  write_actions(model, out);
  write_requests(model, out);
  out.text("*END");
  return out.take();
}

}  // namespace cleave::model
