#include "model/model.hpp"

namespace cleave::model {
namespace {

template <class Item>
Index index_of(const std::vector<Item>& items, Id id) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].id == id) return static_cast<Index>(i);
  return -1;
}

}  // namespace

Index Model::part_of(Id id) const {
  return index_of(parts, id);
}
Index Model::curve_of(Id id) const {
  return index_of(curves, id);
}

int spacetime_dimension(const Section& section) {
  return section.family == "BEAM_SDG"    ? 1
         : section.family == "SHELL_SDG" ? 2
         : section.family == "SOLID_SDG" ? 3
                                         : 0;
}

double spacetime_thickness(const Section& section) {
  const int dimension = spacetime_dimension(section);
  const double given = dimension == 1   ? section.number("A", 0.0)
                       : dimension == 2 ? section.number("T1", 0.0)
                                        : 0.0;
  return given == 0.0 ? 1.0 : given;
}

double Section::number(std::string_view name, double fallback) const {
  for (const auto& [key, value] : numbers)
    if (key == name) return value;
  return fallback;
}

}  // namespace cleave::model
