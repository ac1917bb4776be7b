#pragma once
/// Element values of solid blocks for output.

#include <span>
#include <string_view>

#include "discretisation/block.hpp"
#include "discretisation/fem/point_record.hpp"

namespace cleave::discretisation::fem {

/// stress (6), pressure, von_mises, relative_volume, internal_energy_density, hourglass_energy,
/// effective_plastic_strain if the law has it, and every history variable of the law by its own name.
std::vector<ElementField> solid_fields(const model::Law& law);

/// Mean over the points of an element, [element][size], of all elements or those listed. Asserts on an
/// unknown name.
void evaluate_solid_field(const model::Law& law, const PointLayout& layout, int points, int element_size,
                          std::size_t element_count, const BlockState& state, std::string_view field,
                          std::span<const std::size_t> elements, std::span<double> out);

}  // namespace cleave::discretisation::fem
