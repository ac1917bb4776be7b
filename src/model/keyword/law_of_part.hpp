#pragma once
/// From *MAT_, *EOS_ and *MAT_ADD_ cards to the law of each part.

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// Builds the law of every part, one per pair of material and equation of state; sets density and keyword
/// too. Errors: no such material, refused law, fields out of range, missing or unwanted equation of state.
void build_laws(Draft& draft);

/// Load-curve numbers of a kept card (integer fields LC...) as the model numbers them.
void shift_curve_ids(MaterialCard& card, const Entry& entry);

}  // namespace cleave::model
