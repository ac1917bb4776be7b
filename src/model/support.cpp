#include "model/support.hpp"

#include <algorithm>

#include "deck/layout.hpp"
#include "model/keyword/handler.hpp"
#include "model/material/eos.hpp"
#include "model/material/erosion.hpp"
#include "model/material/law.hpp"

namespace cleave::model {
namespace {

/// Honoured fields of a law, an equation of state or the erosion criteria; empty for other keywords.
std::span<const LawField> law_fields(std::string_view keyword, std::string& source) {
  if (const LawEntry* law = find_law(keyword)) {
    source = law->source;
    return law->fields;
  }
  if (const PressureEntry* law = find_pressure_law(keyword)) {
    source = law->source;
    return law->fields;
  }
  if (keyword == "MAT_ADD_EROSION") return erosion_fields();
  return {};
}

std::string_view law_harmless(std::string_view keyword) {
  const LawEntry* law = find_law(keyword);
  return law ? law->harmless : std::string_view();
}

}  // namespace

KeywordSupport support_of(std::string_view keyword) {
  KeywordSupport support;
  if (deck::canonical_keyword(keyword).empty()) return support;
  if (deck::steers_reading(keyword)) {
    support.policy = Account::Policy::honoured;
    support.remark = "used when the deck is read";
    return support;
  }
  const Handler* handler = find_handler(keyword);
  if (handler && !handler->take && !handler->stream) handler = nullptr;
  const auto laws = law_fields(keyword, support.source);
  const bool material = keyword.starts_with("MAT_") || keyword.starts_with("EOS_");
  // A material that a handler names, rather than by its family, serves parts without a law: spacetime ones.
  const bool named = handler && !handler->keyword.ends_with('*');
  if (!handler || (material && laws.empty() && !named)) {
    const Unhandled rule = unhandled(keyword);
    support.policy = rule.policy;
    support.remark = rule.remark;
    return support;
  }

  support.remark = handler->remark;
  if (handler->policy != Account::Policy::honoured) {
    support.policy = handler->policy;
    return support;
  }
  if (material && laws.empty()) {
    support.policy = Account::Policy::in_part;
    return support;
  }
  bool whole = true;
  for (const auto& layout : deck::fields_of(keyword)) {
    if (layout.name.starts_with("-")) continue;
    FieldSupport field;
    field.name = layout.name;
    const std::string_view first = layout.name.substr(0, layout.name.find('/'));
    const auto in = [&](std::string_view list) { return names(list, layout.name) || names(list, first); };
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const LawField& f) {
      return f.name == layout.name || f.name == first;
    });
    if (law != laws.end()) {
      field.use = FieldSupport::Use::honoured;
      field.dimension = law->dimension;
      field.low = law->low;
      field.high = law->high;
      field.required = law->required;
    } else if (first == "TITLE" || (material ? in("MID EOSID RO") : in(handler->honoured))) {
      field.use = FieldSupport::Use::honoured;
    } else if (in(material ? law_harmless(keyword) : handler->harmless)) {
      field.use = FieldSupport::Use::harmless;
    }
    whole = whole && field.use == FieldSupport::Use::honoured;
    support.fields.push_back(std::move(field));
  }
  support.policy = whole ? Account::Policy::honoured : Account::Policy::in_part;
  return support;
}

}  // namespace cleave::model
