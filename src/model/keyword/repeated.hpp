#pragma once
/// Numbers given a second time: which, and on which lines, by reading the rows again.

#include <functional>
#include <string>

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// Reports the second and later rows of `keyword` that give one of the (sorted) ids in their first field.
/// @param message text for one id
void report_repeated(Draft& draft, std::string_view keyword, IdKind kind, std::string_view field,
                     const std::vector<Id>& ids, const std::function<std::string(Id)>& message);

/// Orders the groups of elements that `keyword` gave by shape, and reports numbers given a second time.
void finish_elements(Draft& draft, std::vector<Elements>& groups, std::string_view keyword);

}  // namespace cleave::model
