/// *NODE: coordinates and the constraint codes TC and RC.

#include <algorithm>
#include <numeric>

#include "model/keyword/handler.hpp"
#include "model/keyword/repeated.hpp"

namespace cleave::model {
namespace {

std::size_t take_nodes(Draft& draft, const deck::Block& block) {
  Nodes& nodes = draft.model.mesh.nodes;
  nodes.id.reserve(nodes.id.size() + draft.deck.line_count(block));
  nodes.position.reserve(3 * nodes.id.capacity());
  Capped bad_id, bad_code;
  std::size_t count = 0;

  draft.deck.rows(block, draft.diagnostics, [&](const deck::Row& row) {
    ++count;
    const auto& transform = draft.deck.transforms()[row.transform];
    const Id written = row.integer(0);
    if (written <= 0) {
      if (bad_id.take())
        draft.diagnostics.error(row.place(0), block.keyword, "NID", "a node number must be 1 or more");
      return;
    }
    const Id id = written + transform.node_offset;
    Vector p = {row.real(1), row.real(2), row.real(3)};
    if (row.transform != 0) p = draft.motion(row.transform).point(transform.length * p);
    nodes.id.push_back(id);
    nodes.position.insert(nodes.position.end(), {p.x, p.y, p.z});

    if (row.given(4) || row.given(5)) {
      const auto tc = row.integer(4), rc = row.integer(5);
      if (tc < 0 || tc > 7 || rc < 0 || rc > 7) {
        if (bad_code.take())
          draft.diagnostics.error(row.place(4), block.keyword, tc < 0 || tc > 7 ? "TC" : "RC",
                                  "constraint codes are 0 to 7",
                                  "columns 57-64 and 65-72; are the coordinates shifted?");
      } else if (tc != 0 || rc != 0) {
        draft.node_codes[{static_cast<int>(tc), static_cast<int>(rc)}].push_back(id);
      }
    }
  });
  return count;
}

}  // namespace

/// Sorts nodes by id and merges repeated ones; repeated with different coordinates is an error.
void finish_nodes(Draft& draft) {
  Nodes& nodes = draft.model.mesh.nodes;
  const std::size_t count = nodes.id.size();
  const bool ascending =
      std::adjacent_find(nodes.id.begin(), nodes.id.end(), std::greater_equal<>()) == nodes.id.end();
  if (!ascending) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return nodes.id[a] < nodes.id[b]; });
    std::vector<Id> id;
    std::vector<double> position;
    id.reserve(count);
    position.reserve(3 * count);
    std::vector<Id> conflicts;
    for (const Index i : order) {
      const double* p = nodes.position.data() + 3 * static_cast<std::size_t>(i);
      if (!id.empty() && id.back() == nodes.id[i]) {
        const bool equal = std::equal(p, p + 3, position.data() + position.size() - 3);
        if (!equal && (conflicts.empty() || conflicts.back() != id.back())) conflicts.push_back(id.back());
        continue;
      }
      id.push_back(nodes.id[i]);
      position.insert(position.end(), p, p + 3);
    }
    if (!conflicts.empty())
      report_repeated(draft, "NODE", IdKind::node, "NID", conflicts, [](Id n) {
        return "node " + std::to_string(n) + " is given twice, with different coordinates";
      });
    nodes.id = std::move(id);
    nodes.position = std::move(position);
  }
  nodes.id.shrink_to_fit();
  nodes.position.shrink_to_fit();
  nodes.index();

  // Codes become constraints, one entry per pair of codes.
  for (auto& [codes, ids] : draft.node_codes) {
    FixedNodes fixed;
    fixed.directions = direction_bits(codes.first) | direction_bits(codes.second) << 3;
    for (const Id id : ids) fixed.nodes.push_back(nodes.find(id));
    std::sort(fixed.nodes.begin(), fixed.nodes.end());
    fixed.nodes.erase(std::unique(fixed.nodes.begin(), fixed.nodes.end()), fixed.nodes.end());
    draft.model.fixed.push_back(std::move(fixed));
  }
}

namespace {
constexpr Handler handlers[] = {
    {.keyword = "NODE", .phase = Phase::node, .honoured = "*", .stream = take_nodes},
};
}  // namespace
extern const Family node_cards{handlers};

}  // namespace cleave::model
