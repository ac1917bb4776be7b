#include "discretisation/fem/solid_fields.hpp"

#include <cmath>

#include "base/assert.hpp"

namespace cleave::discretisation::fem {
namespace {

/// Reads element by element through the lanes.
struct Reader {
  const PointLayout& layout;
  int points, element_size;
  const BlockState& state;

  double point(std::size_t e, int p, int component) const {
    const std::size_t record =
        e / lane_count * static_cast<std::size_t>(points) + static_cast<std::size_t>(p);
    return state
        .point[(record * static_cast<std::size_t>(layout.size()) + static_cast<std::size_t>(component)) *
                   lane_count +
               e % lane_count];
  }
  double element(std::size_t e, int component) const {
    return state.element[(e / lane_count * static_cast<std::size_t>(element_size) +
                          static_cast<std::size_t>(component)) *
                             lane_count +
                         e % lane_count];
  }
  double mean(std::size_t e, int component) const {
    double sum = 0.0;
    for (int p = 0; p < points; ++p) sum += point(e, p, component);
    return sum / points;
  }
  base::Sym3<double> stress(std::size_t e) const {
    return {mean(e, 0), mean(e, 1), mean(e, 2), mean(e, 3), mean(e, 4), mean(e, 5)};
  }
};

}  // namespace

std::vector<ElementField> solid_fields(const model::Law& law) {
  std::vector<ElementField> fields{{"stress", 6},
                                   {"pressure", 1},
                                   {"von_mises", 1},
                                   {"relative_volume", 1},
                                   {"internal_energy_density", 1},
                                   {"hourglass_energy", 1}};
  if (law.plastic_strain() >= 0) fields.push_back({"effective_plastic_strain", 1});
  for (const auto& name : law.state_names())
    if (name.name != "effective_plastic_strain") fields.push_back({std::string(name.name), name.size});
  return fields;
}

void evaluate_solid_field(const model::Law& law, const PointLayout& layout, int points, int element_size,
                          std::size_t element_count, const BlockState& state, std::string_view field,
                          std::span<const std::size_t> elements, std::span<double> out) {
  const Reader read{layout, points, element_size, state};
  const auto each = [&](int size, const auto& value) {
    const auto wide = static_cast<std::size_t>(size);
    const std::size_t count = elements.empty() ? element_count : elements.size();
    CLEAVE_ASSERT(out.size() == count * wide, "one value per element and component");
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t e = elements.empty() ? k : elements[k];
      for (int i = 0; i < size; ++i) out[k * wide + static_cast<std::size_t>(i)] = value(e, i);
    }
  };
  if (field == "stress")
    return each(6, [&](std::size_t e, int i) { return read.mean(e, PointLayout::stress + i); });
  if (field == "pressure") return each(1, [&](std::size_t e, int) { return -trace(read.stress(e)) / 3.0; });
  if (field == "von_mises") return each(1, [&](std::size_t e, int) { return von_mises(read.stress(e)); });
  if (field == "relative_volume")
    return each(1, [&](std::size_t e, int) { return read.mean(e, layout.volume_ratio()); });
  if (field == "internal_energy_density")
    return each(1, [&](std::size_t e, int) { return read.mean(e, layout.energy()); });
  if (field == "hourglass_energy")
    return each(1, [&](std::size_t e, int) { return read.element(e, ElementLayout::hourglass_energy); });
  if (field == "effective_plastic_strain" && law.plastic_strain() >= 0)
    return each(1,
                [&](std::size_t e, int) { return read.mean(e, PointLayout::state + law.plastic_strain()); });
  for (const auto& name : law.state_names())
    if (name.name == field)
      return each(name.size,
                  [&](std::size_t e, int i) { return read.mean(e, PointLayout::state + name.first + i); });
  CLEAVE_ASSERT(false, "asked for a field that fields() does not list");
}

}  // namespace cleave::discretisation::fem
