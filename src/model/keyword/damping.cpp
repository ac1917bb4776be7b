/// *DAMPING_GLOBAL, *DAMPING_PART_MASS(_SET), *DAMPING_PART_STIFFNESS(_SET), *BOUNDARY_NON_REFLECTING.

#include <algorithm>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

/// STX, STY, STZ; all blank or 0 means 1 for each.
void factors(const Entry& entry, double (&out)[3]) {
  const double s[] = {entry.card().real("STX"), entry.card().real("STY"), entry.card().real("STZ")};
  const bool none = s[0] == 0.0 && s[1] == 0.0 && s[2] == 0.0 && entry.card().real("SRX") == 0.0 &&
                    entry.card().real("SRY") == 0.0 && entry.card().real("SRZ") == 0.0;
  for (int k = 0; k < 3; ++k) out[k] = none ? 1.0 : s[k];
}

void take_global(Draft& draft, const Entry& entry) {
  GlobalDamping damping;
  damping.curve = draft.curve(entry, "LCID", false);
  damping.value = entry.real("VALDMP", a_rate);
  factors(entry, damping.factor);
  if (entry.integer("LCID") == 0 && damping.value == 0.0)
    draft.warning(entry, "VALDMP", "no curve and value 0: nothing is damped");
  damping.place = entry.place();
  draft.model.global_damping.push_back(damping);
}

std::vector<Index> parts_of(Draft& draft, const Entry& entry) {
  if (entry.has("PSID")) {
    const auto* set = draft.part_set(entry, "PSID");
    return set ? *set : std::vector<Index>();
  }
  const Index part = draft.part(entry, "PID");
  return part < 0 ? std::vector<Index>() : std::vector<Index>{part};
}

void take_mass(Draft& draft, const Entry& entry) {
  const Index curve = draft.curve(entry, "LCID");
  if (curve < 0) return;
  for (const Index p : parts_of(draft, entry)) {
    Part& part = draft.model.parts[p];
    part.mass_damping = entry.real_or("SF", pure, 1.0);
    part.mass_damping_curve = curve;
    if (entry.integer("FLAG") == 1) factors(entry, part.mass_damping_factor);
  }
}

void take_stiffness(Draft& draft, const Entry& entry) {
  const double coefficient = entry.card().real("COEF");
  for (const Index p : parts_of(draft, entry)) draft.model.parts[p].stiffness_damping = coefficient;
}

void take_absorbing(Draft& draft, const Entry& entry) {
  const auto* set = draft.segment_set(entry, "SSID");
  if (!set) return;
  // AD and AS other than 0 switch the dilatational and the shear wave off.
  draft.model.absorbing.push_back({.segments = *set,
                                   .dilatational = entry.card().real("AD") == 0.0,
                                   .shear = entry.card().real("AS") == 0.0,
                                   .place = entry.place("SSID")});
}

constexpr std::string_view mass = "PID PSID LCID SF FLAG STX STY STZ";
constexpr std::string_view rotations = "SRX SRY SRZ STRUC";
constexpr Handler handlers[] = {
    {"DAMPING_GLOBAL", Phase::action, "LCID VALDMP STX STY STZ", rotations, take_global},
    {"DAMPING_PART_MASS", Phase::action, mass, rotations, take_mass},
    {"DAMPING_PART_MASS_SET", Phase::action, mass, rotations, take_mass},
    {"DAMPING_PART_STIFFNESS", Phase::action, "PID COEF", {}, take_stiffness},
    {"DAMPING_PART_STIFFNESS_SET", Phase::action, "PSID COEF", {}, take_stiffness},
    {"BOUNDARY_NON_REFLECTING", Phase::action, "SSID AD AS", {}, take_absorbing},
};

}  // namespace
extern const Family damping_cards{handlers};

}  // namespace cleave::model
