#pragma once
/// Finding the lines on which a number is given a second time, by reading the rows again.

#include <functional>
#include <string>

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// Reports the second and later rows of `keyword` that give one of the (sorted) ids in their first field.
/// @param message text for one id
void report_repeated(Draft& draft, std::string_view keyword, IdKind kind, std::string_view field,
                     const std::vector<Id>& ids, const std::function<std::string(Id)>& message);

}  // namespace cleave::model
