#include "model/keyword/handler.hpp"

#include <map>

namespace cleave::model {

#define CLEAVE_FAMILY(name) extern const Family name;
#include "model/keyword/families.inc"
#undef CLEAVE_FAMILY

std::span<const Family* const> families() {
  static const Family* const all[] = {
#define CLEAVE_FAMILY(name) &name,
#include "model/keyword/families.inc"
#undef CLEAVE_FAMILY
  };
  return all;
}

const Handler* find_handler(std::string_view keyword) {
  static const auto exact = [] {
    std::map<std::string_view, const Handler*> table;
    for (const Family* family : families())
      for (const Handler& h : *family)
        if (!h.keyword.ends_with('*')) table.emplace(h.keyword, &h);
    return table;
  }();
  if (const auto at = exact.find(keyword); at != exact.end()) return at->second;
  const Handler* best = nullptr;
  for (const Family* family : families())
    for (const Handler& h : *family) {
      if (!h.keyword.ends_with('*') || !keyword.starts_with(h.keyword.substr(0, h.keyword.size() - 1)))
        continue;
      if (!best || best->keyword.size() < h.keyword.size()) best = &h;
    }
  return best;
}

bool names(std::string_view list, std::string_view name) {
  if (list == "*") return true;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(' ', begin), list.size());
    if (list.substr(begin, end - begin) == name) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace cleave::model
