/// *INITIAL_STRESS_SHELL and _SOLID, also _SET: uniform stress of elements, in spacetime parts.

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

constexpr Dimension a_stress{1, -1, -2};
constexpr std::string_view component[] = {"SIGXX", "SIGYY", "SIGZZ", "SIGXY", "SIGYZ", "SIGZX"};

/// One stress of all points of a card; nothing, with what is wrong said, where they differ or are missing.
std::optional<std::array<double, 6>> stress_of(Draft& draft, const Entry& entry, const std::string& name) {
  std::array<double, 6> stress{};
  const std::size_t rows = entry.card().row_count("SIGXX");
  if (rows == 0) {
    draft.error(entry, entry.has("NPLANE") ? "NPLANE" : "NINT", name + " is given no stress");
    return std::nullopt;
  }
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t row = 0; row < rows; ++row) {
      const double value = entry.real(component[k], a_stress, row);
      if (row == 0) stress[k] = value;
      if (value == stress[k]) continue;
      draft.refuse(entry, component[k], name + " has different stresses at its points",
                   "stresses of spacetime parts are uniform in an element: give one point");
      return std::nullopt;
    }
  }
  return stress;
}

/// Of one element, or (SET) of all elements of a set.
template <ElementKind kind, bool set>
void take_stress(Draft& draft, const Entry& entry) {
  draft.refuse_turned(entry, "an initial stress");
  std::vector<Id> elements;
  if constexpr (set) {
    if (const auto* members = draft.element_set(entry, "SID", kind)) elements = *members;
    if (elements.empty()) return;
  } else {
    elements = {entry.id(IdKind::element, "EID")};
  }
  const std::string name =
      set ? std::string(name_of(kind)) + " set " + std::to_string(entry.id(IdKind::set, "SID"))
          : "element " + std::to_string(elements.front());
  const auto stress = stress_of(draft, entry, name);
  if (!stress) return;
  for (const Id id : elements) {
    InitialStress one{.shell = kind == ElementKind::shell,
                      .element = id,
                      .stress = {},
                      .place = entry.place(set ? "SID" : "EID")};
    std::copy(stress->begin(), stress->end(), std::begin(one.stress));
    draft.model.initial_stress.push_back(one);
  }
}

constexpr std::string_view of_shells = "EID SID NPLANE NTHICK T LARGE SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX",
                           of_solids = "EID SID NINT SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX",
                           remark = "in spacetime parts, uniform in an element",
                           remark_set = "in spacetime parts, the same in all elements of a set";

constexpr Handler handlers[] = {
    {.keyword = "INITIAL_STRESS_SHELL",
     .honoured = of_shells,
     .take = take_stress<ElementKind::shell, false>,
     .remark = remark},
    {.keyword = "INITIAL_STRESS_SHELL_SET",
     .honoured = of_shells,
     .take = take_stress<ElementKind::shell, true>,
     .remark = remark_set},
    {.keyword = "INITIAL_STRESS_SOLID",
     .honoured = of_solids,
     .take = take_stress<ElementKind::solid, false>,
     .remark = remark},
    {.keyword = "INITIAL_STRESS_SOLID_SET",
     .honoured = of_solids,
     .take = take_stress<ElementKind::solid, true>,
     .remark = remark_set},
};

}  // namespace

/// Sorts the stresses by element. Elements given twice, or not solved in spacetime, are errors.
void finish_stresses(Draft& draft) {
  auto& all = draft.model.initial_stress;
  if (all.empty()) return;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::pair(a.shell, a.element) < std::pair(b.shell, b.element);
  });
  std::vector<std::tuple<bool, Id, Index>> part_of;  // shell, element, part
  for (const bool shell : {false, true})
    for (const Elements& group : shell ? draft.model.mesh.shells : draft.model.mesh.solids)
      for (std::size_t e = 0; e < group.count(); ++e) part_of.emplace_back(shell, group.id[e], group.part[e]);
  std::sort(part_of.begin(), part_of.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const InitialStress& s = all[i];
    const std::string kind = s.shell ? "SHELL" : "SOLID", keyword = "INITIAL_STRESS_" + kind,
                      name = "element " + std::to_string(s.element);
    const auto at =
        std::lower_bound(part_of.begin(), part_of.end(), std::tuple(s.shell, s.element, Index(-1)));
    const bool known = at != part_of.end() && std::get<0>(*at) == s.shell && std::get<1>(*at) == s.element;
    if (!known)
      draft.diagnostics.error(s.place, keyword, "EID", name + " is not defined",
                              "name elements of *ELEMENT_" + kind);
    else if (i > 0 && all[i - 1].shell == s.shell && all[i - 1].element == s.element)
      draft.diagnostics.error(s.place, keyword, "EID", name + " is given a stress a second time",
                              "leave one of the two out");
    else if (spacetime_dimension(draft.model.parts[static_cast<std::size_t>(std::get<2>(*at))].section) == 0)
      draft.refuse(s.place, keyword, "EID",
                   name + " is not solved in spacetime: an initial stress is not computed for it",
                   "leave the card out, or give the part *SECTION_" + kind + "_SDG");
  }
}

extern const Family stress_cards{handlers};

}  // namespace cleave::model
