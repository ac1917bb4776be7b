/// *ELEMENT_SHELL of spacetime parts and of parts that do not deform, *ELEMENT_BEAM of spacetime parts.
///
/// A deck without a section that could use them has these elements refused as a whole, unread. Which shells
/// of *SECTION_SHELL are computed is known once the materials and supports are (finish_rigid).

#include <algorithm>

#include "model/keyword/handler.hpp"
#include "model/keyword/honoured.hpp"
#include "model/keyword/repeated.hpp"

namespace cleave::model {
namespace {

constexpr std::string_view instead =
    "rigid shells are computed (*MAT_RIGID), and shells and beams in spacetime: *SECTION_SHELL_SDG, "
    "_BEAM_SDG";

bool takes(const Section& section, int dimension) {
  return spacetime_dimension(section) == dimension || (dimension == 2 && section.family == "SHELL");
}

bool has_section(const Draft& draft, int dimension) {
  return std::any_of(draft.sections.begin(), draft.sections.end(),
                     [&](const auto& item) { return takes(item.second, dimension); });
}

class Collector {
 public:
  Collector(Draft& draft, const deck::Block& block, int dimension)
      : draft_(draft), block_(block), dimension_(dimension) {}

  void take(const deck::Row& row) {
    const auto& transform = draft_.deck.transforms()[row.transform];
    if (row.integer(0) <= 0) return complain(row, 0, "EID", "an element number must be 1 or more");
    const Id element = row.integer(0) + transform.element_offset;
    const Index part = part_of(row.integer(1) + transform.part_offset, row);
    if (part < 0) return;
    if (!takes(draft_.model.parts[part].section, dimension_)) {
      if (!refused_)
        draft_.refuse(row.place(1), block_.keyword, "PID",
                      "not computed here: part " + std::to_string(draft_.model.parts[part].id) +
                          " has *SECTION_" + draft_.model.parts[part].section.family,
                      std::string(instead));
      refused_ = true;
      return;
    }
    const Shape shape = shape_of(row);
    if (!supported(row, element, shape)) return;
    std::array<Index, 4> index;
    for (int a = 0; a < nodes_of(shape); ++a) {
      const Id node = row.integer(a + 2) + transform.node_offset;
      index[a] = draft_.model.mesh.nodes.find(node);
      if (index[a] < 0 || row.integer(a + 2) == 0)
        return complain(row, a + 2, "N" + std::to_string(a + 1),
                        "element " + std::to_string(element) + " uses node " + std::to_string(node) +
                            ", which is not defined");
    }
    Elements& group = group_of(shape);
    group.id.push_back(element);
    group.part.push_back(part);
    group.node.insert(group.node.end(), index.begin(), index.begin() + nodes_of(shape));
  }

  ~Collector() {
    if (const auto rest = complaints_.rest(); !rest.empty())
      draft_.diagnostics.error(block_.place, block_.keyword, "", rest + " elements with such mistakes");
  }

 private:
  Shape shape_of(const deck::Row& row) const {
    if (dimension_ == 1) return Shape::line2;
    return row.integer(5) == 0 || row.integer(5) == row.integer(4) ? Shape::tri3 : Shape::quad4;
  }

  /// Mid nodes of shells, releases of beams: not silently dropped.
  bool supported(const deck::Row& row, Id element, Shape shape) {
    const int first = shape == Shape::line2 ? 5 : 6, last = shape == Shape::line2 ? 8 : 9;
    for (int column = first; column <= std::min(last, row.field_count() - 1); ++column)
      if (row.integer(column) != 0) {
        complain(row, column, shape == Shape::line2 ? "RT1" : "N5",
                 "element " + std::to_string(element) +
                     (shape == Shape::line2 ? " has released ends, which a bar has not" : " has mid nodes"),
                 shape == Shape::line2 ? "leave the columns from RT1 on blank" : "give 3 or 4 corner nodes");
        return false;
      }
    return true;
  }

  Elements& group_of(Shape shape) {
    auto& groups = dimension_ == 1 ? draft_.model.mesh.beams : draft_.model.mesh.shells;
    for (Elements& group : groups)
      if (group.shape == shape) return group;
    groups.push_back({.shape = shape, .id = {}, .part = {}, .node = {}});
    return groups.back();
  }

  Index part_of(Id id, const deck::Row& row) {
    const Index part = draft_.model.part_of(id);
    if (part < 0)
      complain(row, 1, "PID", "part " + std::to_string(id) + " is not defined",
               "add a *PART, or check the columns of this line");
    return part;
  }

  void complain(const deck::Row& row, int column, std::string field, std::string message,
                std::string hint = {}) {
    if (complaints_.take())
      draft_.diagnostics.error(row.place(column), block_.keyword, std::move(field), std::move(message),
                               std::move(hint));
  }

  Draft& draft_;
  const deck::Block& block_;
  int dimension_;
  bool refused_ = false;
  Capped complaints_;
};

template <int dimension>
std::size_t take_elements(Draft& draft, const deck::Block& block) {
  if (!has_section(draft, dimension)) {
    account_of(*draft.account, block.keyword).policy = Account::Policy::refused;
    draft.refuse(block.place, block.keyword, "", "not computed here", std::string(instead));
    return 1;
  }
  Collector collector(draft, block, dimension);
  std::size_t count = 0;
  draft.deck.rows(block, draft.diagnostics, [&](const deck::Row& row) {
    collector.take(row);
    ++count;
  });
  return count;
}

}  // namespace

void finish_shells(Draft& draft) {
  finish_elements(draft, draft.model.mesh.shells, "ELEMENT_SHELL");
  finish_elements(draft, draft.model.mesh.beams, "ELEMENT_BEAM");
}

namespace {
constexpr Handler handlers[] = {
    {.keyword = "ELEMENT_BEAM",
     .phase = Phase::element,
     .honoured = "EID PID N1 N2",
     .harmless = "N3 LOCAL",
     .stream = take_elements<1>,
     .remark = "bars of spacetime parts (*SECTION_BEAM_SDG); others are refused"},
    {.keyword = "ELEMENT_SHELL",
     .phase = Phase::element,
     .honoured = "EID PID N1 N2 N3 N4",
     .stream = take_elements<2>,
     .remark = "of parts that do not deform and of spacetime parts (*SECTION_SHELL_SDG); others are refused"},
};
}  // namespace
extern const Family shell_cards{handlers};

}  // namespace cleave::model
