#include <algorithm>

#include "discretisation/formulation.hpp"

namespace cleave::discretisation {

#define CLEAVE_FORMULATION(name) extern const FormulationEntry name;
#include "discretisation/catalogue.inc"
#undef CLEAVE_FORMULATION

std::span<const FormulationEntry* const> formulation_catalogue() {
  static const FormulationEntry* const entries[] = {
#define CLEAVE_FORMULATION(name) &name,
#include "discretisation/catalogue.inc"
#undef CLEAVE_FORMULATION
  };
  return entries;
}

const FormulationEntry* find_formulation(std::string_view family, int form, model::Shape shape) {
  for (const FormulationEntry* entry : formulation_catalogue())
    if (entry->family == family && std::ranges::find(entry->forms, form) != entry->forms.end() &&
        std::ranges::find(entry->shapes, shape) != entry->shapes.end())
      return entry;
  return nullptr;
}

}  // namespace cleave::discretisation
