#include "model/material/eos.hpp"

namespace cleave::model {

#define CLEAVE_EOS(name) extern const PressureEntry name;
#include "model/material/eos_catalogue.inc"
#undef CLEAVE_EOS

std::span<const PressureEntry* const> pressure_catalogue() {
  static const PressureEntry* const entries[] = {
#define CLEAVE_EOS(name) &name,
#include "model/material/eos_catalogue.inc"
#undef CLEAVE_EOS
  };
  return entries;
}

const PressureEntry* find_pressure_law(std::string_view keyword) {
  for (const PressureEntry* entry : pressure_catalogue())
    if (entry->keyword == keyword) return entry;
  return nullptr;
}

double PressureLaw::bulk_modulus() const {
  const auto at = line(initial_volume);
  const double pressure = at.cold + at.thermal * initial_energy;
  return -initial_volume * (at.cold_slope + at.thermal_slope * initial_energy - at.thermal * pressure);
}

}  // namespace cleave::model
