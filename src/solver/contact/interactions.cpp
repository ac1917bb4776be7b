/// From contacts of the model to interactions: surfaces, finders, interface.

#include "solver/contact/finders.hpp"

namespace cleave::solver {
namespace {

using Search = model::Contact::Search;

/// The surfaces of one contact, and finders between them.
struct Sides {
  const model::Model& model;
  const model::Contact& contact;
  std::shared_ptr<Surface> a, b;
  std::vector<Index> only;  ///< nodes of a set; empty: all of surface a

  Sides(const discretisation::World& world, const model::Contact& of, deck::Diagnostics& diagnostics)
      : model(*world.model), contact(of) {
    const bool orient = contact.automatic || model.control.contact.orient == 2;
    const auto surface = [&](const model::ContactSide& side) {
      return std::make_shared<Surface>(world, contact, side, contact.eroding, orient, diagnostics);
    };
    model::ContactSide around = contact.a;  // faces around the nodes of a set: those of all parts
    if (contact.a.segments.empty()) {
      only = contact.a.nodes;
      for (Index p = 0; p < static_cast<Index>(model.parts.size()); ++p) around.parts.push_back(p);
    }
    a = surface(around);
    b = single() ? a : surface(contact.b);
  }
  bool single() const { return contact.search == Search::single; }
  bool empty() const { return a->faces().empty() || b->faces().empty(); }

  /// Nodes of side A against faces of side B; with `both` also the other way round.
  std::vector<std::unique_ptr<Gauge>> by_nodes(bool both) const {
    const model::ContactControl& control = model.control.contact;
    std::vector<std::unique_ptr<Gauge>> some;
    some.push_back(
        make_node_finder({only, a, b, false, single()}, contact, control.stiffness, control.penalty));
    if (both && !single() && only.empty())
      some.push_back(make_node_finder({{}, b, a, true, false}, contact, control.stiffness, control.penalty));
    return some;
  }
};

}  // namespace

void move_apart(model::Model& model, deck::Diagnostics& diagnostics) {
  discretisation::World world;  // the surfaces ask it for no more than the mesh
  world.model = &model;
  for (const model::Contact& contact : model.contacts) {
    if (contact.tied || contact.ignore != 0 || contact.birth > 0.0) continue;
    deck::Diagnostics said_later;
    const Sides sides(world, contact, said_later);
    if (!said_later.failed() && !sides.empty()) move_out(model, contact, sides.by_nodes(true), diagnostics);
  }
}

std::vector<std::unique_ptr<Interaction>> make_interactions(const discretisation::World& world,
                                                            deck::Diagnostics& diagnostics) {
  std::vector<std::unique_ptr<Interaction>> list;
  const model::Model& model = *world.model;
  const model::ContactControl& control = model.control.contact;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    if (contact.tied) {  // without an offset: a constraint
      if (!contact.offset) continue;
      if (auto tie = make_tied_faces(world, c, diagnostics)) list.push_back(std::move(tie));
      continue;
    }
    const Sides sides(world, contact, diagnostics);
    if (sides.empty()) continue;  // said already
    auto gauges = sides.by_nodes(true);
    report_initial(model, contact, gauges, diagnostics);
    std::vector<std::unique_ptr<Finder>> finders;
    if (contact.soft == 2)
      finders.push_back(make_segment_finder(sides.a, sides.b, contact, control.stiffness, control.penalty));
    else
      for (auto& finder : sides.by_nodes(contact.search == Search::two_way))
        finders.push_back(std::move(finder));
    double scale = 0.0, stiffest = 0.0;
    for (const Surface* one : {sides.a.get(), sides.b.get()})
      for (const Face& face : one->faces()) {
        scale = std::max(scale, 1e-3 * face.stiffness * face.thickness);
        stiffest = std::max(stiffest, face.stiffness);
      }
    list.push_back(make_interface(model, c, std::move(finders), std::move(gauges), scale, stiffest));
  }
  return list;
}

}  // namespace cleave::solver
