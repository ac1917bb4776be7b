#pragma once
/// First pass over a deck: keywords, includes, parameters, formats. Cards are read later, on demand.

#include "deck/deck_data.hpp"

namespace cleave::deck {

/// Reads the main file, already added as file 0 of `data`, and everything it includes.
void read_blocks(const std::shared_ptr<Deck::Data>& data, const ReadOptions& options,
                 Diagnostics& diagnostics);

}  // namespace cleave::deck
