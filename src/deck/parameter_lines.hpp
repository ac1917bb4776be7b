#pragma once
/// Rows of *PARAMETER, *PARAMETER_LOCAL and *PARAMETER_EXPRESSION.

#include "deck/lexer.hpp"
#include "deck/parameter.hpp"

namespace cleave::deck {

/// Reads the definitions of one block into `parameters`; each may use those before it.
/// @param expressions name in the first field, an expression behind it, continued by lines with a blank name
/// @param local known in `body.file` and the files it includes only
void read_parameters(const Body& body, bool expressions, bool local, const ValueContext& context,
                     Parameters& parameters);

}  // namespace cleave::deck
