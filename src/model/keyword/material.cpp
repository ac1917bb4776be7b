/// *MAT_*, *EOS_* and *MAT_ADD_*: kept by number, then made into the law of each part.

#include "deck/layout.hpp"
#include "model/keyword/handler.hpp"
#include "model/keyword/law_of_part.hpp"

namespace cleave::model {
namespace {

/// The card's own values, blanks left out, so that it can be written back.
MaterialCard keep(const Entry& entry, Id id) {
  MaterialCard kept{.id = id, .keyword = entry.keyword(), .title = entry.title(), .values = {}};
  for (const auto& field : deck::fields_of(entry.keyword())) {
    if (field.name == "TITLE" || field.name.starts_with("-") || !entry.given(field.name)) continue;
    MaterialCard::Value value;
    value.name = field.name;
    if (field.type == 'A')
      value.text = entry.card().text(field.name);
    else
      value.number = entry.card().real(field.name);
    kept.values.push_back(std::move(value));
  }
  return kept;
}

void refuse_units(Draft& draft, const Entry& entry) {
  const auto& t = entry.transform();
  if (changes_units(t) || t.temperature_factor != 1.0 || t.temperature_shift != 0.0)
    draft.refuse(entry, "", "a material inside a file with unit factors (FCTMAS, FCTTIM, FCTLEN, FCTTEM)",
                 "move the material to a file without factors, in the units of the model");
}

void take(Draft& draft, const Entry& entry, std::string_view id_field, std::string_view space,
          std::map<Id, Entry>& into) {
  const Id id = entry.id(IdKind::material, id_field);
  if (id <= 0) return draft.error(entry, id_field, std::string(space) + " numbers must be 1 or more");
  if (!draft.claim(entry, space, id, id_field)) return;
  refuse_units(draft, entry);
  MaterialCard card = keep(entry, id);
  // Ids are written back as the model knows them.
  for (auto& value : card.values)
    if (value.name == id_field) value.number = static_cast<double>(id);
  shift_curve_ids(card, entry);
  draft.model.materials.push_back(std::move(card));
  into.emplace(id, entry);
}

void take_material(Draft& draft, const Entry& entry) {
  take(draft, entry, "MID", "material", draft.materials);
}
void take_state(Draft& draft, const Entry& entry) {
  take(draft, entry, "EOSID", "equation of state", draft.states);
}

/// Additions share the number of the material they add to, and may be several.
void take_addition(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::material, "MID");
  refuse_units(draft, entry);
  MaterialCard card = keep(entry, id);
  for (auto& value : card.values)
    if (value.name == "MID") value.number = static_cast<double>(id);
  draft.model.materials.push_back(std::move(card));
  draft.additions[id].push_back(entry);
}

// Which fields count is for the law to say: its fields are checked when a part uses it.
constexpr Handler handlers[] = {
    {.keyword = "MAT_ADD_EROSION", .phase = Phase::material, .honoured = "*", .take = take_addition},
    // Not laws of motion; how they are treated stands with the unhandled keywords.
    {.keyword = "MAT_ADD_*", .honoured = ""},
    {.keyword = "MAT_NONLOCAL", .honoured = ""},
    {.keyword = "MAT_THERMAL_*", .honoured = ""},
    {.keyword = "MAT_ORTHOTROPIC_ELASTIC",
     .phase = Phase::material,
     .honoured = "*",
     .take = take_material,
     .remark =
         "in spacetime parts only: AOPT 2 and below 0, in the plane also 0 and 3; not G SIGF MACF IHIS REF"},
    {.keyword = "MAT_*", .phase = Phase::material, .honoured = "*", .take = take_material},
    {.keyword = "EOS_*", .phase = Phase::material, .honoured = "*", .take = take_state},
};

}  // namespace
extern const Family material_cards{handlers};

}  // namespace cleave::model
