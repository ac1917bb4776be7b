/// Controls, curves, tables, sections, materials, parts.

#include <algorithm>
#include <cmath>
#include <set>

#include "deck/write.hpp"
#include "model/write/references.hpp"

namespace cleave::model {
namespace {

/// Nothing where no part is solved in spacetime.
void write_spacetime(const SpacetimeControl& c, const Model& model, DeckText& out) {
  if (std::none_of(model.parts.begin(), model.parts.end(),
                   [](const Part& part) { return spacetime_dimension(part.section) != 0; }))
    return;
  using Space = SpacetimeControl::Space;
  using Progress = SpacetimeControl::Progress;
  const int space = c.space == Space::one_field ? 1 : c.space == Space::three_field ? 2 : 3;
  const int progress = c.progress == Progress::triangle ? 1 : c.progress == Progress::subsimplex ? 2 : 3;
  out.keyword("CONTROL_SPACETIME");
  out.line({space, c.degree, c.chi, progress, c.eps, c.height_factor, c.height_cap, c.smoothing});
  out.line({c.threads, c.verify ? 1 : 0, c.subdivision, c.repeat ? 1 : 0});
}

/// RWPNAL: planar walls have it, geometric ones none.
double most_penalty(const std::vector<RigidWall>& walls) {
  for (const RigidWall& wall : walls)
    if (wall.penalty != 0.0) return wall.penalty;
  return 0.0;
}

/// *PART_CONTACT, which only contacts that ask for it remember.
PartFriction friction_of(const Model& model, std::size_t part) {
  for (const Contact& contact : model.contacts)
    if (!contact.part_friction.empty()) return contact.part_friction[part];
  return {};
}

void write_control(const Model& model, DeckText& out) {
  const Control& c = model.control;
  out.keyword("CONTROL_TERMINATION");
  out.line({c.end.time, c.end.cycles, c.end.step_fraction, c.end.energy_change, c.end.mass_change,
            c.end.no_solution_check ? 1 : 0});
  out.keyword("CONTROL_TIMESTEP");
  out.line({c.step.first, c.step.safety, 0, 0.0, c.step.mass_scaling, curve_id(model, c.step.limit_curve),
            c.step.erode ? 1 : 0, c.step.mass_scaling_first_only ? 1 : 0});
  if (c.step.mass_scaling_curve >= 0 || c.step.mass_scaling_fraction > 0.0)
    out.line({c.step.mass_scaling_fraction, curve_id(model, c.step.mass_scaling_curve)});
  out.keyword("CONTROL_BULK_VISCOSITY");
  out.line({c.viscosity.quadratic, c.viscosity.linear, c.viscosity.type});
  out.keyword("CONTROL_ENERGY");
  const auto flag = [](bool on) { return on ? 2 : 1; };
  out.line({flag(c.energy.hourglass), flag(c.energy.wall), flag(c.energy.sliding), flag(c.energy.damping)});
  out.keyword("CONTROL_HOURGLASS");
  out.line({c.hourglass.type, c.hourglass.coefficient});
  const double wall_penalty = most_penalty(model.walls);
  if (!model.contacts.empty() || wall_penalty != 0.0) {
    out.keyword("CONTROL_CONTACT");
    out.line({c.contact.stiffness, wall_penalty, 1, c.contact.shell_thickness, c.contact.penalty, 0,
              c.contact.orient});
    out.line({0});
    out.line({0.0});
    out.line({c.contact.ignore});
  }
  out.keyword("CONTROL_ACCURACY");
  out.line({0, c.invariant_node_numbering});
  out.keyword("CONTROL_SOLID");
  out.line({c.solid_sort, 0});
  write_spacetime(c.spacetime, model, out);
}

void write_curves(const Model& model, DeckText& out) {
  for (const Curve& curve : model.curves) {
    out.keyword("DEFINE_CURVE", curve.title);
    out.line({curve.id, 0, 1.0, 1.0, 0.0, 0.0});
    for (std::size_t i = 0; i < curve.x.size(); ++i) out.line({curve.x[i], curve.y[i]});
  }
  for (const Table& table : model.tables) {
    out.keyword("DEFINE_TABLE_2D", table.title);
    out.line({table.id, 1.0, 0.0});
    for (std::size_t i = 0; i < table.value.size(); ++i)
      out.line({table.value[i], curve_id(model, table.curve[i])});
  }
}

void write_card(std::string_view keyword, const std::string& title,
                const std::vector<MaterialCard::Value>& values, DeckText& out) {
  deck::CardWriter card(keyword,
                        title.empty() ? std::vector<std::string>() : std::vector<std::string>{"TITLE"});
  if (!title.empty()) card.set("TITLE", title);
  for (const auto& value : values) {
    if (!value.text.empty())
      card.set(value.name, value.text);
    else if (value.number == std::floor(value.number) && std::fabs(value.number) < 9e15)
      card.set(value.name, static_cast<Id>(value.number));
    else
      card.set(value.name, value.number);
  }
  out.lines(card.text());
}

void write_section(const Section& section, DeckText& out) {
  std::vector<MaterialCard::Value> values{{"SECID", "", static_cast<double>(section.id)},
                                          {"ELFORM", "", static_cast<double>(section.form)}};
  for (const auto& [name, number] : section.numbers) values.push_back({name, "", number});
  write_card("SECTION_" + section.family, section.title, values, out);
}

void write_parts(const Model& model, DeckText& out) {
  std::set<Id> sections;
  for (const Part& part : model.parts)
    if (sections.insert(part.section.id).second) write_section(part.section, out);
  for (const MaterialCard& card : model.materials) write_card(card.keyword, card.title, card.values, out);

  const Control& c = model.control;
  Id hourglass = 0;
  for (const Part& part : model.parts) {
    const Hourglass& h = part.hourglass;
    const bool own = h.type != c.hourglass.type || h.coefficient != c.hourglass.coefficient ||
                     h.quadratic_bulk != c.viscosity.quadratic || h.linear_bulk != c.viscosity.linear;
    if (own) {
      out.keyword("HOURGLASS");
      out.line({++hourglass, h.type, h.coefficient, 0, h.quadratic_bulk, h.linear_bulk});
    }
    const PartFriction friction = friction_of(model, static_cast<std::size_t>(&part - model.parts.data()));
    const bool rubs = friction != PartFriction{};
    out.keyword(part.inertia ? "PART_INERTIA" : rubs ? "PART_CONTACT" : "PART");
    out.text(part.title);
    out.line({part.id, part.section.id, part.material_id, part.state_id, own ? hourglass : Id(0)});
    if (part.inertia) write_inertia(*part.inertia, model, out);
    if (rubs)
      out.line({friction.static_friction, friction.dynamic_friction, friction.decay, friction.viscous_limit});
  }
}

}  // namespace

void write_definitions(const Model& model, DeckText& out) {
  out.text("*KEYWORD");
  if (!model.title.empty()) {
    out.keyword("TITLE");
    out.text(model.title);
  }
  write_control(model, out);
  write_curves(model, out);
  write_parts(model, out);
}

}  // namespace cleave::model
