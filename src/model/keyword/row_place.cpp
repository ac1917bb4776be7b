#include "model/keyword/row_place.hpp"

#include <algorithm>

namespace cleave::model {

std::map<Id, deck::Place> row_places(const deck::Deck& deck, std::string_view keyword, IdKind kind,
                                     const std::vector<Id>& ids) {
  std::vector<Id> wanted = ids;
  std::sort(wanted.begin(), wanted.end());
  std::map<Id, deck::Place> places;
  if (wanted.empty()) return places;
  deck::Diagnostics said_already;  // these rows have been read before
  for (const deck::Block& block : deck.blocks()) {
    if (block.keyword != keyword) continue;
    deck.rows(block, said_already, [&](const deck::Row& row) {
      const Id id = row.integer(0) + id_offset(deck.transforms()[row.transform], kind);
      if (std::binary_search(wanted.begin(), wanted.end(), id)) places.try_emplace(id, row.place(0));
    });
  }
  return places;
}

void find_rows(const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  diagnostics.find_rows([&](const deck::Diagnostic& d) {
    const IdKind kind = d.row.kind == deck::NumberedRow::Kind::node ? IdKind::node : IdKind::element;
    const auto places = row_places(deck, d.keyword, kind, {d.row.id});
    return places.empty() ? deck::Place{} : places.begin()->second;
  });
}

}  // namespace cleave::model
