#include "app/account.hpp"

#include <cstdio>

namespace cleave::app {

const char* word_for(model::Account::Policy policy) {
  using Policy = model::Account::Policy;
  switch (policy) {
    case Policy::honoured:
      return "honoured";
    case Policy::in_part:
      return "in part";
    case Policy::output_only:
      return "output only";
    case Policy::refused:
      return "REFUSED";
    case Policy::unknown:
      return "unknown";
  }
  return "";
}

std::string table_of(const model::Account& account) {
  if (account.entries.empty()) return {};
  std::string text = "  keyword                                   cards  defaulted  taken\n";
  for (const auto& entry : account.entries) {
    char line[160];
    std::snprintf(line, sizeof line, "  %-40.40s %6zu %10zu  %s", entry.keyword.c_str(), entry.cards,
                  entry.defaulted, word_for(entry.policy));
    text += line;
    if (!entry.ignored_fields.empty()) {
      text += "; not honoured:";
      for (const std::string& field : entry.ignored_fields) text += " " + field;
    }
    if (!entry.remark.empty()) text += "; " + entry.remark;
    text += '\n';
  }
  return text;
}

}  // namespace cleave::app
