#include "deck/layout_table.hpp"

#include <algorithm>

namespace cleave::deck::table {
namespace {
#include "deck/card_table.inc"
}  // namespace

std::span<const Keyword> keywords() {
  return keyword_table;
}
std::span<const Alias> aliases() {
  return alias_table;
}
const Op* code(std::uint16_t first) {
  return op_table + first;
}
const Item* item(std::uint16_t index) {
  return item_table + index;
}
const Option* option(std::uint16_t index) {
  return option_table + index;
}
const Field& field(const Keyword& keyword, std::size_t index) {
  return field_table[keyword.first_field + index];
}

const Keyword* find(std::string_view canonical) {
  const auto by_name = [](const Keyword& k, std::string_view name) { return k.name < name; };
  const auto* at = std::lower_bound(std::begin(keyword_table), std::end(keyword_table), canonical, by_name);
  return at != std::end(keyword_table) && at->name == canonical ? at : nullptr;
}

bool among(std::string_view list, std::string_view word, char separator) {
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t stop = std::min(list.find(separator, at), list.size());
    if (list.substr(at, stop - at) == word) return true;
    at = stop + 1;
  }
  return false;
}

std::string_view first_name(const char* name) {
  const std::string_view all(name);
  return all.substr(0, all.find('/'));
}

}  // namespace cleave::deck::table
