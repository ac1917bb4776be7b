/// *ELEMENT_SOLID in all its forms: hexahedra, wedges, linear and quadratic tetrahedra.

#include <algorithm>

#include "model/keyword/handler.hpp"
#include "model/keyword/repeated.hpp"
#include "model/solid_shape.hpp"

namespace cleave::model {
namespace {

/// Sorts the rows of one block into groups of one shape.
class Collector {
 public:
  Collector(Draft& draft, const deck::Block& block) : draft_(draft), block_(block) {}

  void take(const deck::Row& row) {
    const auto& transform = draft_.deck.transforms()[row.transform];
    const std::size_t errors = draft_.diagnostics.count(deck::Severity::error);
    std::array<Id, 10> id{};
    const int columns = std::min(row.field_count(), 12);
    for (int a = 0; a + 2 < columns; ++a)
      if (const Id written = row.integer(a + 2)) id[a] = written + transform.node_offset;
    const Id element = row.integer(0) + transform.element_offset;

    const Id part_id = row.integer(1) + transform.part_offset;

    // A number that could not be read has been reported; what follows from it is not said again.
    if (draft_.diagnostics.count(deck::Severity::error) != errors) return;
    const Classified solid = classify(id);
    if (row.integer(0) <= 0) {
      complain(row, 0, "EID", "an element number must be 1 or more");
    } else if (!solid.ok) {
      complain(row, 2, "N1",
               "the nodes of element " + std::to_string(element) + " make no solid: " + list(id),
               "a solid has 8 nodes (hexahedron), 6 (N5 = N6, N7 = N8), 5 (N5 = ... = N8), 4 (N4 = ... = N8) "
               "or 10");
    } else if (const Index part = part_of(part_id, row); part >= 0) {
      append(element, part, solid, row, id);
    }
  }

  ~Collector() {
    if (const auto rest = complaints_.rest(); !rest.empty())
      draft_.diagnostics.error(block_.place, block_.keyword, "", rest + " elements with such mistakes");
  }

 private:
  void append(Id element, Index part, const Classified& solid, const deck::Row& row,
              const std::array<Id, 10>& id) {
    std::array<Index, 10> index;
    for (int a = 0; a < solid.node_count; ++a) {
      index[a] = draft_.model.mesh.nodes.find(solid.node[a]);
      if (index[a] < 0) {
        const int column = static_cast<int>(std::find(id.begin(), id.end(), solid.node[a]) - id.begin());
        complain(row, column + 2, "N" + std::to_string(column + 1),
                 "element " + std::to_string(element) + " uses node " + std::to_string(solid.node[a]) +
                     ", which is not defined");
        return;
      }
    }
    Elements& group = group_of(solid.shape);
    group.id.push_back(element);
    group.part.push_back(part);
    group.node.insert(group.node.end(), index.begin(), index.begin() + solid.node_count);
  }

  Elements& group_of(Shape shape) {
    auto& solids = draft_.model.mesh.solids;
    for (Elements& group : solids)
      if (group.shape == shape) return group;
    solids.push_back({.shape = shape, .id = {}, .part = {}, .node = {}});
    solids.back().id.reserve(draft_.deck.line_count(block_));
    solids.back().part.reserve(solids.back().id.capacity());
    solids.back().node.reserve(solids.back().id.capacity() * static_cast<std::size_t>(nodes_of(shape)));
    return solids.back();
  }

  Index part_of(Id id, const deck::Row& row) {
    if (id == last_id_) return last_part_;
    last_id_ = id;
    last_part_ = draft_.model.part_of(id);
    if (last_part_ < 0)
      draft_.diagnostics.error(row.place(1), block_.keyword, "PID",
                               "part " + std::to_string(id) + " is not defined",
                               "add a *PART, or check the columns of this line");
    return last_part_;
  }

  void complain(const deck::Row& row, int column, std::string field, std::string message,
                std::string hint = {}) {
    if (complaints_.take())
      draft_.diagnostics.error(row.place(column), block_.keyword, std::move(field), std::move(message),
                               std::move(hint));
  }

  static std::string list(const std::array<Id, 10>& id) {
    std::string text;
    for (const Id n : id)
      if (n != 0) text += (text.empty() ? "" : " ") + std::to_string(n);
    return text.empty() ? "none given" : text;
  }

  Draft& draft_;
  const deck::Block& block_;
  Capped complaints_;
  Id last_id_ = -1;
  Index last_part_ = -1;
};

std::size_t take_solids(Draft& draft, const deck::Block& block) {
  Collector collector(draft, block);
  std::size_t count = 0;
  draft.deck.rows(block, draft.diagnostics, [&](const deck::Row& row) {
    collector.take(row);
    ++count;
  });
  return count;
}

}  // namespace

void finish_solids(Draft& draft) {
  finish_elements(draft, draft.model.mesh.solids, "ELEMENT_SOLID");
}

namespace {
constexpr Handler handlers[] = {
    {.keyword = "ELEMENT_SOLID", .phase = Phase::element, .honoured = "*", .stream = take_solids},
};
}  // namespace
extern const Family solid_cards{handlers};

}  // namespace cleave::model
