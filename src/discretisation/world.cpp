#include "discretisation/world.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "discretisation/formulation.hpp"
#include "discretisation/rigid/block.hpp"
#include "model/material/law.hpp"
#include "model/solid_geometry.hpp"

namespace cleave::discretisation {

namespace {

/// What a section of this family may say for elements of this shape: "ELFORM 1 (hex8-one-point), ...".
std::string choices(std::string_view family, model::Shape shape) {
  std::string text;
  for (const FormulationEntry* entry : formulation_catalogue()) {
    if (entry->family != family || std::ranges::find(entry->shapes, shape) == entry->shapes.end()) continue;
    text += text.empty() ? "choose ELFORM " : "; ";
    for (const int form : entry->forms) text += (form == entry->forms[0] ? "" : ", ") + std::to_string(form);
    text += " (" + std::string(entry->name) + ")";
  }
  return text;
}

/// The formulation of a part for elements of a shape. Parts of hexahedra (ELFORM 1, 2) take tetrahedra and
/// wedges as ELFORM 10 and 15 in any case; with ESORT a wedge in a part of tetrahedra becomes ELFORM 15 as
/// well.
const FormulationEntry* formulation_of(const model::Model& model, const model::Section& section,
                                       model::Shape shape) {
  const auto* entry = find_formulation(section.family, section.form, shape);
  if (!entry && section.family == "SOLID" && model.control.solid_sort != 0 && shape == model::Shape::penta6)
    return find_formulation(section.family, 15, shape);
  return entry;
}

/// Shortest edge over the speed of sound [time]
double step_if_it_deformed(const model::Part& part, const PartElements& elements) {
  const auto n = static_cast<std::size_t>(model::nodes_of(elements.shape));
  std::vector<model::Corner> corner(n);
  double least = 1.0e30;
  for (std::size_t e = 0; e < elements.id.size(); ++e) {
    for (std::size_t a = 0; a < n; ++a) {
      const double* x =
          &elements.model.mesh.nodes.position[3 * static_cast<std::size_t>(elements.node[n * e + a])];
      corner[a] = {x[0], x[1], x[2]};
    }
    least = std::min(least, model::shortest_edge(elements.shape, corner));
  }
  const double speed = std::sqrt(part.law->longitudinal_modulus() / part.density);
  return std::isfinite(speed) && speed > 0.0 ? least / speed : 1.0e30;
}

/// Nodes of a body move with it, and carry what of its mass contact is to see.
void start_bodies(const World& world, State& state) {
  for (const RigidBody& body : world.bodies)
    for (std::size_t i = 0; i < body.node.size(); ++i) {
      const auto a = static_cast<std::size_t>(body.node[i]);
      const double* x = &state.position[3 * a];
      const model::Vector arm = model::Vector{x[0], x[1], x[2]} - body.whole.centre;
      const model::Vector v = body.velocity + base::cross(body.spin, arm);
      state.velocity[3 * a] = v.x;
      state.velocity[3 * a + 1] = v.y;
      state.velocity[3 * a + 2] = v.z;
      state.mass[a] = body.node_mass[i];
    }
}

}  // namespace

World build(const model::Model& model, deck::Diagnostics& diagnostics) {
  World world;
  world.model = &model;
  for (const model::Part& part : model.parts)
    if (spacetime_dimension(part.section) != 0)
      diagnostics.error(part.place, "PART", "SECID",
                        "part " + std::to_string(part.id) + " has *SECTION_" + part.section.family +
                            ", which explicit dynamics does not compute",
                        "a deck is solved in spacetime as a whole or not at all");
  // Parts in the order of the model, shapes in the order of the mesh: one pass over the elements per shape.
  std::vector<std::deque<PartElements>> by_part(model.parts.size());
  const auto collect = [&](const model::Elements& solids) {
    const auto per = static_cast<std::size_t>(model::nodes_of(solids.shape));
    std::vector<PartElements*> target(model.parts.size(), nullptr);
    std::vector<bool> met(model.parts.size(), false);
    for (const Index part : solids.part) {
      const auto p = static_cast<std::size_t>(part);
      if (met[p]) continue;
      met[p] = true;
      by_part[p].push_back({model, part, solids.shape, {}, {}});
      target[p] = &by_part[p].back();
    }
    for (std::size_t e = 0; e < solids.count(); ++e) {
      PartElements& to = *target[static_cast<std::size_t>(solids.part[e])];
      to.id.push_back(solids.id[e]);
      for (std::size_t a = 0; a < per; ++a) to.node.push_back(solids.node[e * per + a]);
    }
  };
  for (const auto& solids : model.mesh.solids) collect(solids);
  for (const auto& shells : model.mesh.shells) collect(shells);
  for (std::size_t p = 0; p < by_part.size(); ++p)
    for (const PartElements& elements : by_part[p]) {
      const model::Part& part = model.parts[p];
      const bool shell = elements.shape == model::Shape::tri3 || elements.shape == model::Shape::quad4;
      if (part.rigid || (shell && part.section.family == "SHELL")) {
        if (part.rigid) world.rigid_step = std::min(world.rigid_step, step_if_it_deformed(part, elements));
        world.blocks.push_back(make_rigid_block(elements));
        continue;
      }
      if (shell) continue;  // of spacetime, which has been said
      const auto* entry = formulation_of(model, part.section, elements.shape);
      if (!entry) {
        diagnostics.error(part.section.place, "SECTION_" + part.section.family, "ELFORM",
                          "no formulation for ELFORM " + std::to_string(part.section.form) + " with " +
                              std::string(model::name_of(elements.shape)) + " elements, which part " +
                              std::to_string(part.id) + " has",
                          choices(part.section.family, elements.shape) +
                              (part.section.family == "SOLID" && elements.shape == model::Shape::penta6
                                   ? "; or let *CONTROL_SOLID ESORT = 1 do that"
                                   : ""));
        continue;
      }
      if (auto block = entry->build(elements, diagnostics)) world.blocks.push_back(std::move(block));
    }
  world.bodies = make_bodies(model, world.blocks, diagnostics);
  if (!world.bodies.empty())
    world.body_of_node = model::body_of_nodes(model.rigid_bodies, world.node_count());
  return world;
}

StepStatus initialise(const World& world, State& state) {
  const model::Model& model = *world.model;
  state = State{};
  state.position.assign(model.mesh.nodes.position.begin(), model.mesh.nodes.position.end());
  state.velocity.assign(model.initial_velocity.begin(), model.initial_velocity.end());
  state.velocity.resize(state.position.size(), 0.0);
  state.mass.assign(world.node_count(), 0.0);
  state.blocks.resize(world.blocks.size());
  state.parts.resize(model.parts.size());

  StepStatus status;
  for (std::size_t b = 0; b < world.blocks.size(); ++b) {
    status.merge(world.blocks[b]->initialise(state.position, state.blocks[b]));
    world.blocks[b]->add_mass(state.blocks[b], state.mass);
  }

  // A first guess of the largest force: a strain of 1/1000 on the face of the largest element.
  for (const auto& block : world.blocks) {
    const model::Part& part = model.parts[static_cast<std::size_t>(block->part())];
    double heaviest = 0.0;
    for (const Index n : block->connectivity())
      heaviest = std::max(heaviest, state.mass[static_cast<std::size_t>(n)]);
    const double face = std::pow(heaviest / part.density, 2.0 / 3.0);
    if (std::isfinite(face))
      state.largest_force = std::max(state.largest_force, 1e-3 * face * part.law->longitudinal_modulus());
  }
  for (const model::PointMass& point : model.point_masses)
    state.mass[static_cast<std::size_t>(point.node)] += point.mass;
  start_bodies(world, state);
  return status;
}

}  // namespace cleave::discretisation
