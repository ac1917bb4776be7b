#pragma once
/// Keyword names: number forms, synonyms, and options in any order.

#include <string>
#include <string_view>
#include <vector>

#include "deck/layout_table.hpp"

namespace cleave::deck {

struct KeywordMatch {
  const table::Keyword* keyword = nullptr;  ///< nullptr: not in the table
  std::vector<std::string> options;
};

/// Upper case, without the leading `*`.
std::string normal_name(std::string_view written);

/// Finds the longest known keyword whose words stand in the name in this order; the words left over must
/// be options of that keyword, wherever they stand. `MAT_24` and `MAT_024` are the same.
/// @param name as normal_name() gives it
KeywordMatch match_keyword(std::string_view name);

}  // namespace cleave::deck
