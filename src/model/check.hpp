#pragma once
/// Checks of a finished model: what reads well but cannot be computed, or is probably not meant.

#include "deck/diagnostic.hpp"
#include "model/model.hpp"

namespace cleave::model {

/// Errors: elements inside out, a loaded or moved node without mass. Warnings: parts without elements, nodes
/// of no element, curves that end before the run does, parts in different units.
void check(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics);

/// The error of a deck that says nowhere when its run ends.
void check_end_time(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics);

}  // namespace cleave::model
