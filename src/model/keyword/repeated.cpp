#include "model/keyword/repeated.hpp"

#include <algorithm>

namespace cleave::model {

void report_repeated(Draft& draft, std::string_view keyword, IdKind kind, std::string_view field,
                     const std::vector<Id>& ids, const std::function<std::string(Id)>& message) {
  std::vector<char> seen(ids.size(), 0);
  Capped shown;
  deck::Diagnostics said_already;  // these rows have been read before
  deck::Place last;
  for (const deck::Block& block : draft.deck.blocks()) {
    if (block.keyword != keyword) continue;
    draft.deck.rows(block, said_already, [&](const deck::Row& row) {
      const Id id = row.integer(0) + id_offset(draft.deck.transforms()[row.transform], kind);
      const auto at = std::lower_bound(ids.begin(), ids.end(), id);
      if (at == ids.end() || *at != id) return;
      if (!seen[at - ids.begin()]) {
        seen[at - ids.begin()] = 1;
        return;
      }
      last = row.place(0);
      if (shown.take())
        draft.diagnostics.error(last, block.keyword, std::string(field), message(id),
                                "number each file apart, e.g. by the offsets of *INCLUDE_TRANSFORM");
    });
  }
  if (const auto rest = shown.rest(); !rest.empty())
    draft.diagnostics.error(last, std::string(keyword), std::string(field), rest + " numbers given twice");
}

void finish_elements(Draft& draft, std::vector<Elements>& groups, std::string_view keyword) {
  std::sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.shape < b.shape; });
  // One group in ascending order, the usual case, needs no sorting.
  if (groups.size() == 1 && std::adjacent_find(groups[0].id.begin(), groups[0].id.end(),
                                               std::greater_equal<>()) == groups[0].id.end())
    return;
  std::vector<Id> all, repeated;
  for (const Elements& group : groups) all.insert(all.end(), group.id.begin(), group.id.end());
  std::sort(all.begin(), all.end());
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i] == all[i - 1] && (repeated.empty() || repeated.back() != all[i])) repeated.push_back(all[i]);
  if (!repeated.empty())
    report_repeated(draft, keyword, IdKind::element, "EID", repeated,
                    [](Id id) { return "element " + std::to_string(id) + " is given a second time"; });
}

}  // namespace cleave::model
