#include "model/keyword/law_of_part.hpp"

#include <cmath>

#include "deck/layout.hpp"
#include "model/elasticity.hpp"
#include "model/keyword/handler.hpp"
#include "model/keyword/honoured.hpp"
#include "model/keyword/orthotropic.hpp"
#include "model/keyword/rigid_cards.hpp"
#include "model/material/eos.hpp"
#include "model/material/erosion.hpp"
#include "model/material/law.hpp"

namespace cleave::model {
namespace {

std::string shortest(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Ranges, required fields, and fields the law does not know. False if anything is an error.
bool check_fields(Draft& draft, Account& account, const Entry& entry, std::span<const LawField> fields,
                  std::string_view harmless = {}) {
  const std::size_t before = draft.diagnostics.count(deck::Severity::error);
  report_unused(draft, entry, account_of(account, entry.keyword()), [&](std::string_view name) {
    if (name == "MID" || name == "EOSID" || name == "RO" || name == "TITLE") return FieldUse::honoured;
    for (const LawField& f : fields)
      if (f.name == name || (entry.has(f.name) && f.name.substr(0, f.name.find('/')) == name))
        return FieldUse::honoured;
    return names(harmless, name) ? FieldUse::harmless : FieldUse::ignored;
  });
  bool readable = true;
  for (const LawField& f : fields) {
    if (!entry.has(f.name)) continue;
    if (!entry.given(f.name)) {
      readable = readable && !entry.card().unreadable(f.name);
      if (f.required)
        draft.error(entry, f.name,
                    std::string(f.name) + " [" + std::string(f.dimension) + "] is needed and blank");
      continue;
    }
    const double value = entry.card().real(f.name);
    if (value == 0.0 && !f.required) continue;  // as good as blank
    const bool low = f.low_open ? value <= f.low : value < f.low;
    const bool high = f.high_open ? value >= f.high : value > f.high;
    if (low)
      draft.error(entry, f.name,
                  "found " + shortest(value) + ", expected a value " +
                      (f.low_open ? "above " : "of at least ") + shortest(f.low));
    if (high)
      draft.error(entry, f.name,
                  "found " + shortest(value) + ", expected a value " +
                      (f.high_open ? "below " : "of at most ") + shortest(f.high));
  }
  return readable && draft.diagnostics.count(deck::Severity::error) == before;
}

class LawBuilder {
 public:
  LawBuilder(Draft& draft) : draft_(draft) {}

  void build(Part& part, const Entry& part_entry) {
    const auto material = draft_.materials.find(part.material_id);
    if (material == draft_.materials.end()) {
      draft_.error(part_entry, "MID",
                   "part " + std::to_string(part.id) + " needs material " + std::to_string(part.material_id) +
                       ", which is not defined",
                   "add a *MAT_ with this number");
      return;
    }
    const Entry& entry = material->second;
    part.material_keyword = entry.keyword();
    if (entry.has("RO")) part.density = entry.card().real("RO");

    if (spacetime_dimension(part.section) != 0 && !linear_elastic(part, part_entry, entry)) return;
    const auto [at, fresh] = laws_.try_emplace({part.material_id, part.state_id});
    if (fresh) at->second = make(part, part_entry, entry);
    part.law = at->second;
    if (entry.keyword() == "MAT_RIGID" && part.law) part.rigid = read_rigid_material(draft_, entry);
  }

 private:
  /// Spacetime parts are linear elastic: sets their constants. True if the law is to be made as well, which
  /// is done of isotropic ones; any other law is refused.
  bool linear_elastic(Part& part, const Entry& part_entry, const Entry& entry) {
    const std::string name = "part " + std::to_string(part.id);
    const bool orthotropic = entry.keyword() == "MAT_ORTHOTROPIC_ELASTIC";
    if (entry.keyword() != "MAT_ELASTIC" && !orthotropic) {
      draft_.diagnostics.error(part_entry.place("MID"), entry.keyword(), "",
                               "this law is not computed in spacetime, and " + name + " with *SECTION_" +
                                   part.section.family + " uses it",
                               "use *MAT_ELASTIC or *MAT_ORTHOTROPIC_ELASTIC, or another section");
      return false;
    }
    if (draft_.additions.contains(part.material_id)) {
      draft_.error(draft_.additions.at(part.material_id).front(), "MID",
                   name + " is solved in spacetime, where elements are not deleted",
                   "leave the card out, or choose another section");
      return false;
    }
    if (orthotropic) {
      part.elastic = read_orthotropic(draft_, entry, part);
      return false;  // no law of motion for other methods
    }
    Elasticity constants;
    constants.young = entry.card().real("E");
    constants.poisson = entry.card().real("PR");
    constants.place = entry.place("E");
    part.elastic = std::make_shared<Elasticity>(constants);
    return true;
  }

  std::shared_ptr<const Law> make(const Part& part, const Entry& part_entry, const Entry& entry) {
    const LawEntry* law = find_law(entry.keyword());
    if (!law) {
      account_of(*draft_.account, entry.keyword()).policy = Account::Policy::refused;
      draft_.diagnostics.error(entry.place(), entry.keyword(), "",
                               "this law is not computed, and part " + std::to_string(part.id) + " uses it",
                               "choose one of the laws that are");
      return nullptr;
    }
    bool good = check_fields(draft_, *draft_.account, entry, law->fields, law->harmless);
    if (!(part.density > 0.0) && good) {
      draft_.error(entry, "RO", "the density must be above 0",
                   "in the units of the deck, e.g. 7.85e-9 tonne/mm3 for steel");
      good = false;
    }

    std::unique_ptr<PressureLaw> pressure;
    if (part.state_id != 0) {
      if (!law->takes_pressure && !law->needs_pressure)
        draft_.error(part_entry, "EOSID", entry.keyword() + " takes no equation of state",
                     "leave EOSID blank");
      else
        pressure = make_pressure(part, part_entry, good);
    } else if (law->needs_pressure) {
      draft_.error(part_entry, "EOSID", entry.keyword() + " needs an equation of state",
                   "add an *EOS_ and name it in the part");
      good = false;
    }
    if (!good) return nullptr;

    const LawContext context{.curves = draft_.model.curves,
                             .tables = draft_.model.tables,
                             .pressure = pressure.get(),
                             .diagnostics = draft_.diagnostics,
                             .function_offset = id_offset(entry.transform(), IdKind::function)};
    std::unique_ptr<Law> made = law->build(entry.card(), context);
    if (made) doubt(entry, part.density, *made);
    if (made && draft_.additions.contains(part.material_id))
      made = add(std::move(made), part.material_id, context);
    return made;
  }

  /// No consistent units make these of a material: from kilometres to nanometres densities in use lie between
  /// 1e-27 and 1e15, wave speeds between 1e-6 and 1e15.
  void doubt(const Entry& entry, double density, const Law& law) {
    const double speed = std::sqrt(law.longitudinal_modulus() / density);
    if (density < 1e-28 || density > 1e16)
      draft_.warning(entry, "RO",
                     "found " + shortest(density) + ", a density that no material has in any usual units",
                     "in the units of the deck, e.g. 7.85e-9 tonne/mm3 for steel");
    else if (speed < 1e-7 || speed > 1e16)
      draft_.warning(entry, "RO",
                     "found " + shortest(density) + "; with the stiffness of this material waves travel at " +
                         shortest(speed) + ", as in no material in any usual units",
                     "use one consistent set: force = mass length / time^2");
  }

  std::unique_ptr<PressureLaw> make_pressure(const Part& part, const Entry& part_entry, bool& good) {
    const auto state = draft_.states.find(part.state_id);
    if (state == draft_.states.end()) {
      draft_.error(part_entry, "EOSID",
                   "equation of state " + std::to_string(part.state_id) + " is not defined",
                   "add an *EOS_ with this number");
      good = false;
      return nullptr;
    }
    const Entry& entry = state->second;
    const PressureEntry* law = find_pressure_law(entry.keyword());
    if (!law) {
      account_of(*draft_.account, entry.keyword()).policy = Account::Policy::refused;
      draft_.error(entry, "",
                   "this equation of state is not computed, and part " + std::to_string(part.id) + " uses it",
                   "choose *EOS_LINEAR_POLYNOMIAL or *EOS_GRUNEISEN");
      good = false;
      return nullptr;
    }
    if (!check_fields(draft_, *draft_.account, entry, law->fields) || !good) {
      good = false;
      return nullptr;
    }
    auto made = law->build(entry.card(), part.density, draft_.diagnostics);
    good = made != nullptr;
    return made;
  }

  std::unique_ptr<Law> add(std::unique_ptr<Law> law, Id material, const LawContext& context) {
    for (const Entry& entry : draft_.additions.at(material)) {
      if (!law || !check_fields(draft_, *draft_.account, entry, erosion_fields())) return nullptr;
      law = add_erosion(std::move(law), entry.card(), context);
    }
    return law;
  }

  Draft& draft_;
  std::map<std::pair<Id, Id>, std::shared_ptr<const Law>> laws_;
};

}  // namespace

void build_laws(Draft& draft) {
  LawBuilder builder(draft);
  for (std::size_t i = 0; i < draft.model.parts.size(); ++i)
    builder.build(draft.model.parts[i], draft.part_entries[i]);
}

void shift_curve_ids(MaterialCard& card, const Entry& entry) {
  for (const auto& field : deck::fields_of(entry.keyword()))
    for (auto& value : card.values)
      if (value.name == field.name && field.type == 'I' && field.name.starts_with("LC"))
        value.number = static_cast<double>(entry.offset(IdKind::function, static_cast<Id>(value.number)));
}

}  // namespace cleave::model
