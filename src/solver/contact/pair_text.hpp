#pragma once
/// Names a pair for messages.

#include <cstdio>
#include <string>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// "node 7 of part 1 at (0, 0, 1) against part 2", or "a face of element 3 of part 1 at ...".
/// @param of_a  face on side a, or one around its node; may be null
inline std::string pair_text(const model::Model& model, const Touch& touch, const Face& face,
                             const Face* of_a, std::span<const double> position) {
  const auto part = [&](Index p) {
    return "part " + std::to_string(model.parts[static_cast<std::size_t>(p)].id);
  };
  std::string who = "node " + std::to_string(model.mesh.nodes.id[static_cast<std::size_t>(touch.a[0])]);
  if (touch.wa[0] != 1.0 && of_a) who = "a face of element " + std::to_string(of_a->element);
  if (of_a) who += " of " + part(of_a->part);
  const Vector x = vector_at(position, touch.a[0]);
  char place[96];
  std::snprintf(place, sizeof place, " at (%.6g, %.6g, %.6g)", x.x, x.y, x.z);
  return who + place + " against " + part(face.part);
}

}  // namespace cleave::solver
