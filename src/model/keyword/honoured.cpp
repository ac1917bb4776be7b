#include "model/keyword/honoured.hpp"

#include <algorithm>

#include "deck/layout.hpp"

namespace cleave::model {
namespace {

/// Does every row of the field hold 0, nothing, or the documented default?
bool at_rest(const deck::Card& card, const deck::FieldLayout& field) {
  if (field.type == 'A') {
    const auto text = card.text(field.name);
    return text.empty() || text == field.default_text;
  }
  const std::size_t rows = card.row_count(field.name);
  if (const auto reals = card.reals(field.name); !reals.empty())
    return std::all_of(reals.begin(), reals.end(), [](double v) { return v == 0.0; });
  if (const auto ids = card.integers(field.name); !ids.empty())
    return std::all_of(ids.begin(), ids.end(), [](auto v) { return v == 0; });
  for (std::size_t row = 0; row < rows; ++row) {
    const double value = card.real(field.name, row);
    if (value != 0.0 && !(field.has_default && value == field.default_value)) return false;
  }
  return true;
}

}  // namespace

void report_unused(Draft& draft, const Entry& entry, Account::Entry& account,
                   const std::function<FieldUse(std::string_view)>& use) {
  for (const std::string& name : entry.card().given_fields()) {
    if (name.starts_with("-") || name == "TITLE") continue;  // a column without a meaning, or with a label
    const FieldUse how = use(name);
    if (how == FieldUse::honoured) continue;
    const auto fields = deck::fields_of(entry.keyword());
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) {
      return f.name == name || f.name.substr(0, f.name.find('/')) == name;
    });
    if (field == fields.end() || at_rest(entry.card(), *field)) continue;
    auto& ignored = account.ignored_fields;
    if (std::find(ignored.begin(), ignored.end(), name) == ignored.end()) ignored.push_back(name);
    const std::string meaning = field->meaning.empty() ? "" : " (" + std::string(field->meaning) + ")";
    if (how == FieldUse::harmless && entry.keyword().starts_with("DATABASE_"))
      draft.diagnostics.note(entry.place(name), entry.keyword(), name, "not used here" + meaning);
    else if (how == FieldUse::harmless)
      draft.warning(entry, name, "not used here" + meaning);
    else
      draft.refuse(entry, name, "not honoured" + meaning,
                   "leave it blank, or allow unsupported fields to go on without it");
  }
}

Account::Entry& account_of(Account& account, std::string_view keyword) {
  for (auto& entry : account.entries)
    if (entry.keyword == keyword) return entry;
  account.entries.push_back({});
  account.entries.back().keyword = keyword;
  return account.entries.back();
}

}  // namespace cleave::model
