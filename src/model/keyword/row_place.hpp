#pragma once
/// Where in the deck the nodes and elements of a finished model stand.

#include <map>
#include <string_view>
#include <vector>

#include "deck/deck.hpp"
#include "model/keyword/entry.hpp"

namespace cleave::model {

/// Places of the first rows of *NODE or *ELEMENT_SOLID with these numbers, found by reading them again: for
/// the few that a diagnostic names. Numbers that stand nowhere are left out.
std::map<Id, deck::Place> row_places(const deck::Deck& deck, std::string_view keyword, IdKind kind,
                                     const std::vector<Id>& ids);

/// Gives a place to the diagnostics that name a row of *NODE or *ELEMENT_... by its number.
void find_rows(const deck::Deck& deck, deck::Diagnostics& diagnostics);

}  // namespace cleave::model
