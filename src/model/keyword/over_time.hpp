#pragma once
/// What cards of things that act in time have in common.

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// A time of death: none where the field is blank, 0, or so large that it means never (1e20, in any units).
inline double death_time(const Entry& entry, std::string_view field) {
  const double death = entry.real(field, a_time);
  return death == 0.0 || entry.card().real(field) >= 1e20 ? forever : death;
}

/// VAD 0 to 2: what a curve over time prescribes; false for any other number.
inline bool kind_over_time(std::int64_t vad, PrescribedMotion::Kind& kind) {
  using Kind = PrescribedMotion::Kind;
  if (vad < 0 || vad > 2) return false;
  kind = vad == 0 ? Kind::velocity : vad == 1 ? Kind::acceleration : Kind::displacement;
  return true;
}

/// LCID, SF, BIRTH and DEATH of a prescribed motion; false with an error.
template <class Motion>
bool read_over_time(Draft& draft, const Entry& entry, Motion& motion) {
  motion.curve = draft.curve(entry, "LCID");
  if (motion.curve < 0) return false;
  motion.scale = entry.real_or("SF", pure, 1.0);
  motion.birth = entry.real("BIRTH", a_time);
  motion.death = death_time(entry, "DEATH");
  return true;
}

}  // namespace cleave::model
