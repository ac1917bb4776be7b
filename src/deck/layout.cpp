#include "deck/layout.hpp"

#include <algorithm>

#include "deck/layout_table.hpp"

namespace cleave::deck {

std::vector<FieldLayout> fields_of(std::string_view canonical) {
  std::vector<FieldLayout> list;
  const table::Keyword* keyword = table::find(canonical);
  if (keyword == nullptr) return list;
  for (std::size_t i = 0; i < keyword->field_count; ++i) {
    const table::Field& f = table::field(*keyword, i);
    list.push_back(
        {table::first_name(f.name), f.offset, f.width, f.type, f.has_default, f.number, f.text, f.meaning});
  }
  return list;
}

bool steers_reading(std::string_view canonical) {
  static constexpr std::string_view all[] = {
      "KEYWORD",          "END", "COMMENT", "TITLE", "INCLUDE", "INCLUDE_PATH", "INCLUDE_PATH_RELATIVE",
      "INCLUDE_TRANSFORM"};
  return canonical.starts_with("PARAMETER") ||
         std::find(std::begin(all), std::end(all), canonical) != std::end(all);
}

}  // namespace cleave::deck
