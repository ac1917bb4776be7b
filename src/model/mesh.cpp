#include "model/mesh.hpp"

#include <algorithm>

namespace cleave::model {

std::string_view name_of(Shape shape) {
  switch (shape) {
    case Shape::hex8:
      return "hex8";
    case Shape::penta6:
      return "penta6";
    case Shape::tet4:
      return "tet4";
    case Shape::tet10:
      return "tet10";
    case Shape::tri3:
      return "tri3";
    case Shape::quad4:
      return "quad4";
    case Shape::line2:
      return "line2";
  }
  return "";
}

void Nodes::index() {
  dense.clear();
  if (id.empty()) return;
  // Ids without gaps need no table; ids with many gaps would need too large a one.
  const std::uint64_t range =
      static_cast<std::uint64_t>(id.back()) - static_cast<std::uint64_t>(id.front()) + 1;
  if (range == id.size() || range > 4 * id.size()) return;
  dense.assign(range, -1);
  for (std::size_t i = 0; i < id.size(); ++i) dense[id[i] - id.front()] = static_cast<Index>(i);
}

Index Nodes::find(Id wanted) const {
  if (id.empty() || wanted < id.front() || wanted > id.back()) return -1;
  const std::uint64_t offset = static_cast<std::uint64_t>(wanted) - static_cast<std::uint64_t>(id.front());
  if (static_cast<std::uint64_t>(id.back()) - static_cast<std::uint64_t>(id.front()) + 1 == id.size())
    return static_cast<Index>(offset);
  if (!dense.empty()) return dense[offset];
  const auto at = std::lower_bound(id.begin(), id.end(), wanted);
  return *at == wanted ? static_cast<Index>(at - id.begin()) : -1;
}

}  // namespace cleave::model
