#pragma once
/// *MAT_ADD_EROSION: criteria on stress, strain and time that delete points of any law.

#include <memory>
#include <span>

#include "deck/card.hpp"
#include "model/material/law.hpp"

namespace cleave::model {

/// The law with the criteria of the card laid over it. Its state begins with the strain, summed over the
/// steps and turned with the body, then comes the state of the inner law, then what the criteria need. Null
/// after an error, which is reported.
std::unique_ptr<Law> add_erosion(std::unique_ptr<Law> inner, const deck::Card& card,
                                 const LawContext& context);

/// The honoured fields of *MAT_ADD_EROSION.
std::span<const LawField> erosion_fields();

}  // namespace cleave::model
