/// From contacts of the model to interactions: surfaces, finders, interface.

#include "solver/contact/finders.hpp"

namespace cleave::solver {

std::vector<std::unique_ptr<Interaction>> make_interactions(const discretisation::World& world,
                                                            deck::Diagnostics& diagnostics) {
  using Search = model::Contact::Search;
  std::vector<std::unique_ptr<Interaction>> list;
  const model::Model& model = *world.model;
  const model::ContactControl& control = model.control.contact;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    if (contact.tied) {  // without an offset: a constraint
      if (contact.offset) list.push_back(make_tied_faces(world, c, diagnostics));
      continue;
    }
    const bool orient = contact.automatic || control.orient == 2;
    const auto surface = [&](const model::ContactSide& side) {
      return std::make_shared<Surface>(world, contact, side, contact.eroding, orient, diagnostics);
    };
    model::ContactSide around = contact.a;  // faces around the nodes of a set: those of all parts
    if (contact.a.segments.empty())
      for (Index p = 0; p < static_cast<Index>(model.parts.size()); ++p) around.parts.push_back(p);
    const auto a = surface(around);
    const auto b = contact.search == Search::single ? a : surface(contact.b);

    const bool single = contact.search == Search::single;
    const std::vector<Index> only = contact.a.segments.empty() ? contact.a.nodes : std::vector<Index>();
    const auto by_nodes = [&](bool both) {
      std::vector<std::unique_ptr<Finder>> some;
      some.push_back(
          make_node_finder({only, a, b, false, single}, contact, control.stiffness, control.penalty));
      if (both)
        some.push_back(
            make_node_finder({{}, b, a, true, false}, contact, control.stiffness, control.penalty));
      return some;
    };
    if (a->faces().empty() || b->faces().empty()) continue;  // said already
    report_initial(model, contact, by_nodes(!single && only.empty()), diagnostics);
    std::vector<std::unique_ptr<Finder>> finders;
    if (contact.soft == 2)
      finders.push_back(make_segment_finder(a, b, contact, control.stiffness, control.penalty));
    else
      finders = by_nodes(contact.search == Search::two_way);
    double scale = 0.0, stiffest = 0.0;
    for (const Surface* one : {a.get(), b.get()})
      for (const Face& face : one->faces()) {
        scale = std::max(scale, 1e-3 * face.stiffness * face.thickness);
        stiffest = std::max(stiffest, face.stiffness);
      }
    list.push_back(make_interface(model, c, std::move(finders), scale, stiffest));
  }
  return list;
}

}  // namespace cleave::solver
