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

double Section::number(std::string_view name, double fallback) const {
  for (const auto& [key, value] : numbers)
    if (key == name) return value;
  return fallback;
}

}  // namespace cleave::model
