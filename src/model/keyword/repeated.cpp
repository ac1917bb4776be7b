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

}  // namespace cleave::model
