#pragma once
/// SPACE and DEGREE, which *CONTROL_SPACETIME and the sections of spacetime parts have in common.

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// SPACE 1 one field, 2 three fields, 3 Trefftz; DEGREE 1 to 6; 0 leaves it to the control card. False, with
/// errors, if either is anything else.
bool check_local_space(Draft& draft, const Entry& entry);

}  // namespace cleave::model
