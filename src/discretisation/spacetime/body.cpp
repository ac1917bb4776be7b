#include "discretisation/spacetime/body.hpp"

#include <algorithm>

#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {
namespace {

PitchOptions pitch_options(const model::SpacetimeControl& control) {
  using Asked = model::SpacetimeControl::Progress;
  PitchOptions options;
  options.chi = control.chi;
  options.progress = control.progress == Asked::triangle     ? Progress::high_mid
                     : control.progress == Asked::subsimplex ? Progress::subsimplex
                                                             : Progress::budget;
  options.eps = control.eps;
  options.height_factor = control.height_factor;
  if (control.height_cap > 0.0) options.height_cap = control.height_cap;
  options.smoothing = control.smoothing;
  options.repeat = control.repeat;
  return options;
}

/// Parts of other dimensions, and parts that are not solved in spacetime.
void refuse_other_parts(const model::Model& model, int dimension, deck::Diagnostics& diagnostics) {
  const auto first = std::find_if(model.parts.begin(), model.parts.end(), [&](const model::Part& part) {
    return spacetime_dimension(part.section) == dimension;
  });
  for (const model::Part& part : model.parts) {
    const int own = spacetime_dimension(part.section);
    if (own == dimension) continue;
    diagnostics.error(part.place, "PART", "SECID",
                      "part " + std::to_string(part.id) + " has *SECTION_" + part.section.family + ", part " +
                          std::to_string(first->id) + " has *SECTION_" + first->section.family,
                      own == 0 ? "a deck is solved in spacetime as a whole or not at all"
                               : "parts solved in spacetime must have the same number of dimensions");
  }
}

/// At the row of its first node, else of its first element; the part of the element where no row is found.
template <int D>
void report(const MeshFault& fault, const model::Model& model, deck::Diagnostics& diagnostics) {
  deck::Diagnostic d{.severity = deck::Severity::error,
                     .place = {},
                     .keyword = D == 1   ? "ELEMENT_BEAM"
                                : D == 2 ? "ELEMENT_SHELL"
                                         : "ELEMENT_SOLID",
                     .field = "EID",
                     .message = fault.what,
                     .hint = fault.likely_cause};
  if (!fault.element.empty()) {
    d.row = {deck::NumberedRow::Kind::element, fault.element.front()};
    for (const auto* groups : {&model.mesh.solids, &model.mesh.shells, &model.mesh.beams})
      for (const model::Elements& group : *groups)
        if (const auto at = std::find(group.id.begin(), group.id.end(), fault.element.front());
            at != group.id.end())
          d.place = model
                        .parts[static_cast<std::size_t>(
                            group.part[static_cast<std::size_t>(at - group.id.begin())])]
                        .place;
  }
  if (!fault.vertex.empty()) {
    d.keyword = "NODE", d.field = "NID";
    d.row = {deck::NumberedRow::Kind::node, fault.vertex.front()};
  }
  diagnostics.add(std::move(d));
}

}  // namespace

int dimension_of(const model::Model& model) {
  for (const model::Part& part : model.parts)
    if (const int dimension = spacetime_dimension(part.section)) return dimension;
  return 0;
}

template <int D>
std::unique_ptr<const Body<D>> make_body(const model::Model& model, deck::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count(deck::Severity::error);
  const auto failed = [&] { return diagnostics.count(deck::Severity::error) > before; };
  refuse_other_parts(model, D, diagnostics);
  refuse_unsupported(model, diagnostics);
  if (failed()) return nullptr;

  auto body = std::make_unique<Body<D>>();
  body->end_time = model.control.end.time;
  body->verify = model.control.spacetime.verify;
  body->pitch = pitch_options(model.control.spacetime);
  if (const std::string wrong = complaint<D>(body->pitch); !wrong.empty())
    diagnostics.error(model.control.spacetime.place, "CONTROL_SPACETIME", "", wrong);

  SpaceMeshInput<D> input;
  std::vector<Vertex> vertex_of_node;
  gather_parts(model, *body, diagnostics);
  gather_elements(model, input, *body, vertex_of_node, diagnostics);
  if (failed()) return nullptr;
  gather_cracks(model, input, diagnostics);
  BoundaryConditions<D> conditions(model, input, vertex_of_node, diagnostics);
  if (failed()) return nullptr;

  if (const MeshFault fault = body->mesh.build(input); !fault.ok) {
    report<D>(fault, model, diagnostics);
    return nullptr;
  }
  for (auto v = static_cast<Vertex>(body->node_of_vertex.size()); v < body->mesh.vertex_count(); ++v)
    body->node_of_vertex.push_back(body->node_of_vertex[static_cast<std::size_t>(body->mesh.origin(v))]);
  conditions.make_targets(*body);
  set_initial_state(model, *body, diagnostics);
  set_body_force(model, *body, diagnostics);
  if (failed()) return nullptr;
  return body;
}

template std::unique_ptr<const Body<1>> make_body<1>(const model::Model&, deck::Diagnostics&);
template std::unique_ptr<const Body<2>> make_body<2>(const model::Model&, deck::Diagnostics&);
template std::unique_ptr<const Body<3>> make_body<3>(const model::Model&, deck::Diagnostics&);

}  // namespace cleave::discretisation::spacetime
