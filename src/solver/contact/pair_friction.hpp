#pragma once
/// Friction between two faces: what the contact says, or (FS -1) what their parts say.

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// With FS -1 each coefficient is the mean of those of both parts (*PART_CONTACT); of the limits VC, of which
/// 0 is none, the mean of those there are. A node without faces leaves it to the part it meets.
inline model::PartFriction pair_friction(const model::Contact& contact, const Finder& finder,
                                         const Touch& touch) {
  if (contact.part_friction.empty())
    return {contact.static_friction, contact.dynamic_friction, contact.friction_decay, contact.viscous_limit};
  const auto of = [&](const Face& face) {
    return contact.part_friction[static_cast<std::size_t>(face.part)];
  };
  const Face* face = finder.face_of_a(touch);
  const model::PartFriction b = of(finder.face(touch.face));
  if (!face) return b;
  const model::PartFriction a = of(*face);
  const double limits = (a.viscous_limit > 0.0 ? 1.0 : 0.0) + (b.viscous_limit > 0.0 ? 1.0 : 0.0);
  return {0.5 * (a.static_friction + b.static_friction), 0.5 * (a.dynamic_friction + b.dynamic_friction),
          0.5 * (a.decay + b.decay), limits > 0.0 ? (a.viscous_limit + b.viscous_limit) / limits : 0.0};
}

}  // namespace cleave::solver
