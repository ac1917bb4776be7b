/// *ELEMENT_MASS, _NODE_SET, _PART, _PART_SET: mass added to nodes.

#include <algorithm>
#include <array>

#include "model/keyword/handler.hpp"
#include "model/solid_geometry.hpp"

namespace cleave::model {
namespace {

std::size_t take_masses(Draft& draft, const deck::Block& block) {
  Capped missing;
  std::size_t count = 0;
  draft.deck.rows(block, draft.diagnostics, [&](const deck::Row& row) {
    ++count;
    const auto& transform = draft.deck.transforms()[row.transform];
    const Id node = row.integer(1) + transform.node_offset;
    PointMass mass{.id = row.integer(0) ? row.integer(0) + transform.element_offset : 0,
                   .node = draft.model.mesh.nodes.find(node),
                   .mass = row.real(2) * unit_factor(transform, a_mass),
                   .place = row.place(0)};
    if (mass.node < 0) {
      if (missing.take())
        draft.diagnostics.error(row.place(1), block.keyword, "NID",
                                "node " + std::to_string(node) + " is not defined");
      return;
    }
    if (mass.mass < 0.0)
      draft.diagnostics.error(row.place(2), block.keyword, "MASS", "a mass cannot be negative");
    draft.model.point_masses.push_back(mass);
  });
  return count;
}

/// The mass goes to every node of the set.
void take_node_set(Draft& draft, const Entry& entry) {
  const auto* set = draft.node_set(entry, "NSID");
  if (!set) return;
  const double mass = entry.real("MASS", a_mass);
  if (mass < 0.0) return draft.error(entry, "MASS", "a mass cannot be negative");
  for (const Index node : *set)
    draft.model.point_masses.push_back(
        {.id = entry.id(IdKind::element, "EID"), .node = node, .mass = mass, .place = entry.place("NSID")});
}

/// Mass of the elements of some parts, lumped to nodes: [node] [mass].
std::vector<double> nodal_mass(const Draft& draft, const std::vector<Index>& parts) {
  std::vector<double> mass(draft.model.mesh.nodes.count(), 0.0);
  std::array<Corner, 10> x;
  for (const Elements& group : draft.model.mesh.solids) {
    const int n = nodes_of(group.shape);
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (std::find(parts.begin(), parts.end(), group.part[e]) == parts.end()) continue;
      for (int a = 0; a < n; ++a) x[a] = draft.position(group.node[e * n + a]);
      const double share = volume(group.shape, {x.data(), static_cast<std::size_t>(n)}) *
                           draft.model.parts[group.part[e]].density / n;
      for (int a = 0; a < n; ++a) mass[group.node[e * n + a]] += share;
    }
  }
  return mass;
}

/// ADDMASS in all, or as much as brings the part to FINMASS, spread over the nodes in proportion to their own
/// mass (MWD = 0 on a part set: in equal shares).
void take_part(Draft& draft, const Entry& entry) {
  const bool by_set = entry.has("PSID");
  for (std::size_t row = 0; row < entry.card().row_count("ADDMASS"); ++row) {
    std::vector<Index> parts;
    if (by_set) {
      const auto* set = draft.part_sets.find(draft, entry.id(IdKind::set, "PSID", row));
      if (!set) {
        draft.error(entry, "PSID",
                    "part set " + std::to_string(entry.integer("PSID", row)) + " is not defined");
        continue;
      }
      parts = *set;
    } else {
      const Index part = draft.part(entry, "PID", row);
      if (part < 0) continue;
      parts = {part};
    }
    const double add = entry.real("ADDMASS", a_mass, row), final_mass = entry.real("FINMASS", a_mass, row);
    const bool equal = by_set && entry.integer("MWD", row) == 0;
    // Densities are known once the materials have been looked up, after all actions.
    draft.when_laws_known.push_back([&draft, entry, parts, add, final_mass, equal] {
      const std::vector<double> own = nodal_mass(draft, parts);
      double sum = 0.0;
      std::size_t count = 0;
      for (const double m : own) sum += m, count += m > 0.0;
      const double total = final_mass > 0.0 ? final_mass - sum : add;
      if (count == 0 || total < 0.0)
        return draft.error(
            entry, final_mass > 0.0 ? "FINMASS" : "ADDMASS",
            count == 0 ? "the part has no mass to add to" : "the mass to be added is negative");
      for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i] > 0.0)
          draft.model.point_masses.push_back(
              {.id = 0,
               .node = static_cast<Index>(i),
               .mass = equal ? total / static_cast<double>(count) : total * (own[i] / sum)});
    });
  }
}

constexpr Handler handlers[] = {
    {.keyword = "ELEMENT_MASS", .honoured = "*", .stream = take_masses},
    {.keyword = "ELEMENT_MASS_NODE_SET",
     .honoured = "EID NSID MASS",
     .harmless = "PID",
     .take = take_node_set},
    {.keyword = "ELEMENT_MASS_PART", .honoured = "PID ADDMASS FINMASS", .take = take_part},
    {.keyword = "ELEMENT_MASS_PART_SET", .honoured = "PSID ADDMASS FINMASS MWD", .take = take_part},
};

}  // namespace
extern const Family mass_cards{handlers};

}  // namespace cleave::model
