#pragma once
/// Samples of every shape: boxes of hexahedra cut into tetrahedra or wedges.

#include <algorithm>
#include <map>
#include <ostream>

#include "sample.hpp"

namespace cleave::discretisation::sample {

struct Form {
  const char* name;
  int form;
  model::Shape shape;
};
inline std::ostream& operator<<(std::ostream& out, const Form& form) {
  return out << form.name;
}

/// The hexahedra of a box cut into the shape: Kuhn's six tetrahedra, or two wedges; tet10 gets mid nodes.
inline Sample cut(const Sample& hexes, const Form& form) {
  static constexpr int tets[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                     {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  static constexpr int wedges[2][6] = {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};
  static constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  Sample s(hexes.model.parts[0].law, hexes.model.parts[0].density);
  s.part() = hexes.model.parts[0];
  s.part().section.form = form.form;
  s.model.mesh.nodes = hexes.model.mesh.nodes;
  auto& solids = s.solids();
  solids.shape = form.shape;
  std::map<std::pair<Index, Index>, Index> middle;
  const auto add = [&](std::vector<Index> nodes) {
    if (form.shape == model::Shape::tet10)
      for (const auto& edge : edges) {
        const auto key =
            std::minmax(nodes[static_cast<std::size_t>(edge[0])], nodes[static_cast<std::size_t>(edge[1])]);
        auto [at, isnew] = middle.try_emplace(key, static_cast<Index>(s.node_count()));
        if (isnew) {
          const auto& x = s.model.mesh.nodes.position;
          const std::size_t a = 3 * static_cast<std::size_t>(key.first),
                            b = 3 * static_cast<std::size_t>(key.second);
          s.add_node({0.5 * (x[a] + x[b]), 0.5 * (x[a + 1] + x[b + 1]), 0.5 * (x[a + 2] + x[b + 2])});
        }
        nodes.push_back(at->second);
      }
    solids.id.push_back(static_cast<Id>(solids.count()) + 1);
    solids.part.push_back(0);
    solids.node.insert(solids.node.end(), nodes.begin(), nodes.end());
  };
  const auto& from = hexes.model.mesh.solids[0];
  for (std::size_t e = 0; e < from.count(); ++e) {
    const Index* n = from.node.data() + 8 * e;
    if (form.shape == model::Shape::hex8) add({n, n + 8});
    if (form.shape == model::Shape::penta6)
      for (const auto& w : wedges) add({n[w[0]], n[w[1]], n[w[2]], n[w[3]], n[w[4]], n[w[5]]});
    if (form.shape == model::Shape::tet4 || form.shape == model::Shape::tet10)
      for (const auto& t : tets) add({n[t[0]], n[t[1]], n[t[2]], n[t[3]]});
  }
  return s;
}

/// The unit cube in cells^3 cells with inner nodes moved, cut into the shape.
inline Sample distorted(const Form& form, std::shared_ptr<const model::Law> law, int cells = 2) {
  Noise noise;
  return cut(box(cells, cells, cells, std::move(law), 1.0,
                 [&](Point x) {
                   const auto inside = [](double c) { return c > 0.0 && c < 1.0; };
                   if (inside(x.x)) x.x += 0.1 * noise() / cells;
                   if (inside(x.y)) x.y += 0.1 * noise() / cells;
                   if (inside(x.z)) x.z += 0.1 * noise() / cells;
                   return x;
                 }),
             form);
}

}  // namespace cleave::discretisation::sample
