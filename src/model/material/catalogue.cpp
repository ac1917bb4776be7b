#include "model/material/law.hpp"

namespace cleave::model {

#define CLEAVE_LAW(name) extern const LawEntry name;
#include "model/material/catalogue.inc"
#undef CLEAVE_LAW

std::span<const LawEntry* const> law_catalogue() {
  static const LawEntry* const entries[] = {
#define CLEAVE_LAW(name) &name,
#include "model/material/catalogue.inc"
#undef CLEAVE_LAW
  };
  return entries;
}

const LawEntry* find_law(std::string_view keyword) {
  for (const LawEntry* entry : law_catalogue())
    if (entry->keyword == keyword) return entry;
  return nullptr;
}

const Curve* LawContext::curve(Id id) const {
  for (const Curve& c : curves)
    if (c.id == id + function_offset) return &c;
  return nullptr;
}

const Table* LawContext::table(Id id) const {
  for (const Table& t : tables)
    if (t.id == id + function_offset) return &t;
  return nullptr;
}

}  // namespace cleave::model
