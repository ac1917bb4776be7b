/// Nodes, elements, sets.

#include "model/write/references.hpp"

namespace cleave::model {
namespace {

void write_elements(const Model& model, const Elements& group, DeckText& out) {
  if (group.count() == 0) return;
  out.keyword(group.shape == Shape::line2                                 ? "ELEMENT_BEAM"
              : group.shape == Shape::tri3 || group.shape == Shape::quad4 ? "ELEMENT_SHELL"
                                                                          : "ELEMENT_SOLID");
  const int n = nodes_of(group.shape);
  for (std::size_t e = 0; e < group.count(); ++e) {
    const Id part = model.parts[group.part[e]].id;
    const auto id = [&](int a) { return model.mesh.nodes.id[group.node[e * n + a]]; };
    switch (group.shape) {
      case Shape::hex8:
        out.line({group.id[e], part, id(0), id(1), id(2), id(3), id(4), id(5), id(6), id(7)});
        break;
      case Shape::penta6:  // folded back into N1 N2 N3 N4 N5=N6 N7=N8
        out.line({group.id[e], part, id(0), id(2), id(5), id(3), id(1), id(1), id(4), id(4)});
        break;
      case Shape::tet4:
        out.line({group.id[e], part, id(0), id(1), id(2), id(3), id(3), id(3), id(3), id(3)});
        break;
      case Shape::tet10:
        out.line({group.id[e], part});
        out.line({id(0), id(1), id(2), id(3), id(4), id(5), id(6), id(7), id(8), id(9)});
        break;
      case Shape::tri3:
        out.line({group.id[e], part, id(0), id(1), id(2), id(2)});
        break;
      case Shape::quad4:
        out.line({group.id[e], part, id(0), id(1), id(2), id(3)});
        break;
      case Shape::line2:
        out.line({group.id[e], part, id(0), id(1)});
        break;
    }
  }
}

}  // namespace

void write_mesh(const Model& model, DeckText& out) {
  const Nodes& nodes = model.mesh.nodes;
  out.keyword("NODE");
  for (std::size_t i = 0; i < nodes.count(); ++i) {
    const double* p = nodes.position.data() + 3 * i;
    out.line({nodes.id[i], p[0], p[1], p[2]});
  }
  for (const auto* groups : {&model.mesh.solids, &model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups) write_elements(model, group, out);

  for (const auto& set : model.node_sets) {
    out.keyword("SET_NODE_LIST", set.title);
    out.line({set.id, 0.0});
    out.ids(set.members, [&](Index i) { return nodes.id[i]; });
  }
  for (const auto& set : model.part_sets) {
    out.keyword("SET_PART_LIST", set.title);
    out.line({set.id, 0.0});
    out.ids(set.members, [&](Index i) { return model.parts[i].id; });
  }
  const std::pair<std::string_view, const std::vector<Set<Id>>*> sets_of_elements[] = {
      {"SET_SOLID", &model.solid_sets},
      {"SET_SHELL_LIST", &model.shell_sets},
      {"SET_BEAM", &model.beam_sets}};
  for (const auto& [keyword, sets] : sets_of_elements)
    for (const auto& set : *sets) {
      out.keyword(std::string(keyword), set.title);
      if (keyword == "SET_SOLID")
        out.line({set.id, ""});
      else
        out.line({set.id});
      out.ids(set.members, [](Id id) { return id; });
    }
  for (const auto& set : model.segment_sets) {
    out.keyword("SET_SEGMENT", set.title);
    out.line({set.id, 0.0});
    for (const Segment& s : set.members)
      out.line({nodes.id[s.node[0]], nodes.id[s.node[1]], nodes.id[s.node[2]], nodes.id[s.node[3]]});
  }
}

}  // namespace cleave::model
