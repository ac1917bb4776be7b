/// *PART, *SECTION_SOLID and its family, *HOURGLASS.

#include "deck/layout.hpp"
#include "model/keyword/handler.hpp"
#include "model/keyword/local_space.hpp"
#include "model/keyword/rigid_cards.hpp"

namespace cleave::model {
namespace {

void take_section(Draft& draft, const Entry& entry) {
  Section section;
  section.id = entry.id(IdKind::other, "SECID");
  if (!draft.claim(entry, "section", section.id, "SECID")) return;
  section.title = entry.title();
  section.family = entry.keyword().substr(std::string_view("SECTION_").size());
  section.place = entry.place("SECID");
  const std::int64_t form = entry.has("ELFORM") ? entry.integer("ELFORM") : 0;
  section.form = static_cast<int>(form == 0 ? 1 : form);

  // Further numbers by name; what they mean is up to the formulation.
  for (const std::string& name : entry.card().given_fields()) {
    if (name == "SECID" || name == "ELFORM" || name == "TITLE") continue;
    bool numeric = false;
    for (const auto& field : deck::fields_of(entry.keyword()))
      numeric |= field.name == name && field.type != 'A';
    if (numeric) section.numbers.emplace_back(name, entry.card().real(name));
  }
  if (changes_units(entry.transform()) && !section.numbers.empty())
    draft.refuse(entry, "", "section values inside a file with unit factors",
                 "move the section to a file without factors, in the units of the model");
  draft.sections.emplace(section.id, std::move(section));
}

/// *SECTION_SHELL_SDG, _SOLID_SDG, _BEAM_SDG: parts solved in spacetime.
void take_spacetime_section(Draft& draft, const Entry& entry) {
  take_section(draft, entry);
  const auto at = draft.sections.find(entry.id(IdKind::other, "SECID"));
  if (at == draft.sections.end() || "SECTION_" + at->second.family != entry.keyword()) return;  // given twice
  Section& section = at->second;
  const int dimension = spacetime_dimension(section);
  const std::int64_t form = entry.integer("ELFORM");
  if (dimension == 2) section.form = static_cast<int>(form == 0 ? 13 : form);
  const bool known = dimension == 1   ? section.form == 1 || section.form == 2
                     : dimension == 2 ? section.form == 12 || section.form == 13
                                      : section.form == 1;
  if (!known)
    draft.error(entry, "ELFORM", "found " + std::to_string(section.form) + ", which is no spacetime element",
                dimension == 1   ? "choose 1 (uniaxial stress: a bar) or 2 (uniaxial strain: a plane wave)"
                : dimension == 2 ? "choose 12 (plane stress) or 13 (plane strain)"
                                 : "choose 1 (tetrahedra)");
  check_local_space(draft, entry);
  if (const std::string_view across = dimension == 1 ? "A" : "T1";
      dimension < 3 && entry.card().real(across) < 0.0)
    draft.error(entry, across, "found a negative value, expected one above 0 (blank: 1)");
}

/// IHQ, QM, Q1 or Q2 blank or 0 take the value of the *CONTROL_ cards, filled in when the part is finished.
void take_hourglass(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::other, "HGID");
  if (!draft.claim(entry, "hourglass card", id, "HGID")) return;
  Hourglass h;
  h.type = static_cast<int>(entry.integer("IHQ"));
  if (h.type < 0 || h.type > 6) {
    draft.refuse(entry, "IHQ", "hourglass type " + std::to_string(h.type), "types 1 to 6 are computed");
    h.type = 0;
  }
  // VDC, the damping of type 6, stands in the column that is QB for shells.
  if (const double vdc = entry.card().real("QB"); h.type == 6 && vdc != 0.0 && vdc != 0.1)
    draft.refuse(entry, "QB", "viscous damping of hourglass type 6 (VDC)", "leave it blank");
  // Blank fields must not bring in the defaults of the card table: the control cards come first.
  const auto own = [&](std::string_view field) { return entry.given(field) ? entry.real(field, pure) : 0.0; };
  h.coefficient = own("QM");
  h.place = entry.place("QM");
  h.quadratic_bulk = own("Q1");
  h.linear_bulk = own("Q2");
  draft.hourglasses.emplace(id, h);
}

void take_part(Draft& draft, const Entry& entry) {
  Part part;
  part.id = entry.id(IdKind::part, "PID");
  if (part.id <= 0) return draft.error(entry, "PID", "a part number must be 1 or more");
  if (!draft.claim(entry, "part", part.id, "PID")) return;
  part.title = entry.title();
  part.place = entry.place("PID");
  part.material_id = entry.id(IdKind::material, "MID");
  part.state_id = entry.id(IdKind::material, "EOSID");

  const Id section = entry.id(IdKind::other, "SECID");
  if (const auto at = draft.sections.find(section); at != draft.sections.end())
    part.section = at->second;
  else
    draft.error(entry, "SECID",
                "part " + std::to_string(part.id) + " needs section " + std::to_string(section) +
                    ", which is not defined",
                "add a *SECTION_SOLID with this number");

  part.hourglass = {.type = 0, .coefficient = 0.0, .quadratic_bulk = 0.0, .linear_bulk = 0.0};
  if (const Id id = entry.id(IdKind::other, "HGID"); id != 0) {
    if (const auto at = draft.hourglasses.find(id); at != draft.hourglasses.end())
      part.hourglass = at->second;
    else
      draft.error(entry, "HGID", "hourglass card " + std::to_string(id) + " is not defined",
                  "add an *HOURGLASS");
  }
  draft.part_entries.emplace_back(entry);
  draft.model.parts.push_back(std::move(part));
}

/// *PART_INERTIA: a part whose mass properties are stated.
void take_part_inertia(Draft& draft, const Entry& entry) {
  const std::size_t count = draft.model.parts.size();
  take_part(draft, entry);
  if (draft.model.parts.size() == count) return;
  if (auto stated = read_inertia(draft, entry)) {
    draft.model.parts.back().inertia = stated;
    draft.rigid.inertia.emplace(static_cast<Index>(count), entry);
  }
}

/// *PART_CONTACT: friction for contacts with FS -1.
void take_part_contact(Draft& draft, const Entry& entry) {
  const std::size_t count = draft.model.parts.size();
  take_part(draft, entry);
  if (draft.model.parts.size() == count) return;
  for (const std::string_view field : {"FS", "FD", "DC", "VC"})
    if (entry.card().real(field) < 0.0)
      draft.error(entry, field,
                  "found " + std::to_string(entry.card().real(field)) + ", expected 0 or above");
  draft.part_friction[static_cast<Index>(count)] = {entry.real("FS", pure), entry.real("FD", pure),
                                                    entry.real("DC", {0, -1, 1}),
                                                    entry.real("VC", {1, -1, -2})};
}

/// *SECTION_SHELL: rigid shells have a thickness and a mass; shells that deform are refused with their part.
void take_shell_section(Draft& draft, const Entry& entry) {
  take_section(draft, entry);
  const double thickness = entry.real("T1", a_length);
  for (const std::string_view corner : {"T2", "T3", "T4"})
    if (const double t = entry.real(corner, a_length); t != 0.0 && t != thickness)
      draft.refuse(entry, corner, "a thickness that changes over the shell", "give T1 alone");
  if (thickness < 0.0) draft.error(entry, "T1", "a thickness must be above 0");
}

constexpr Handler handlers[] = {
    {.keyword = "SECTION_SHELL",
     .phase = Phase::definition,
     .honoured = "TITLE SECID ELFORM T1 T2 T3 T4 MAREA",
     .harmless = "SHRF NIP PROPT QR ICOMP SETYP IDOF EDGSET ANGLE",
     .take = take_shell_section,
     .remark = "rigid shells, and shells held in all directions; others are refused"},
    {.keyword = "SECTION_SOLID",
     .phase = Phase::definition,
     .honoured = "TITLE SECID ELFORM",
     .harmless = "COHOFF GASKETT AET",
     .take = take_section},
    {.keyword = "SECTION_BEAM_SDG",
     .phase = Phase::definition,
     .honoured = "TITLE SECID ELFORM A SPACE DEGREE",
     .take = take_spacetime_section,
     .remark = "bars along x, solved in spacetime"},
    {.keyword = "SECTION_SHELL_SDG",
     .phase = Phase::definition,
     .honoured = "TITLE SECID ELFORM T1 SPACE DEGREE",
     .take = take_spacetime_section,
     .remark = "triangles and quadrilaterals in the xy plane, solved in spacetime"},
    {.keyword = "SECTION_SOLID_SDG",
     .phase = Phase::definition,
     .honoured = "TITLE SECID ELFORM SPACE DEGREE",
     .take = take_spacetime_section,
     .remark = "tetrahedra, solved in spacetime"},
    {.keyword = "SECTION_*",
     .phase = Phase::definition,
     .honoured = "*",
     .take = take_section,
     .remark = "parts may name it; their elements are refused, since no formulation of it is computed",
     .policy = Account::Policy::output_only},
    {.keyword = "HOURGLASS",
     .phase = Phase::definition,
     .honoured = "TITLE HGID IHQ QM Q1 Q2",
     .harmless = "IBQ QB QW",
     .take = take_hourglass,
     .remark = "QB, QW and IBQ act on shells only"},
    {.keyword = "PART",
     .phase = Phase::part,
     .honoured = "HEADING PID SECID MID EOSID HGID",
     .harmless = "TMID",
     .take = take_part},
    {.keyword = "PART_CONTACT",
     .phase = Phase::part,
     .honoured = "HEADING PID SECID MID EOSID HGID FS FD DC VC",
     .harmless = "TMID CPARM8",
     .take = take_part_contact,
     .remark = "friction for contacts with FS -1"},
    {.keyword = "PART_INERTIA",
     .phase = Phase::part,
     .honoured =
         "HEADING PID SECID MID EOSID HGID XC YC ZC TM IRCS NODEID IXX IXY IXZ IYY IYZ IZZ VTX VTY VTZ "
         "VRX VRY VRZ XL YL ZL XLIP YLIP ZLIP CID",
     .harmless = "TMID",
     .take = take_part_inertia,
     .remark = "of rigid parts"},
};

}  // namespace

/// Fills what the parts left to the control cards.
void finish_parts(Draft& draft) {
  const Control& control = draft.model.control;
  for (Part& part : draft.model.parts) {
    Hourglass& h = part.hourglass;
    if (h.type == 0) h.type = control.hourglass.type;
    if (h.coefficient == 0.0) {
      h.coefficient = control.hourglass.coefficient;
      h.place = control.hourglass.place;
    }
    if (h.quadratic_bulk == 0.0) h.quadratic_bulk = control.viscosity.quadratic;
    if (h.linear_bulk == 0.0) h.linear_bulk = control.viscosity.linear;
  }
}

extern const Family part_cards{handlers};

}  // namespace cleave::model
