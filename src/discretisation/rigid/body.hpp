#pragma once
/// Rigid bodies made computable: mass properties, and what of their mass each node carries.

#include <vector>

#include "discretisation/block.hpp"
#include "discretisation/rigid/mass.hpp"

namespace cleave::discretisation {

struct RigidBody {
  std::vector<Index> node;         ///< ascending
  std::vector<double> node_mass;   ///< [node] see make_bodies [mass]
  RigidMass whole;                 ///< at the start
  double axis[3][3];               ///< columns: principal axes of inertia at the start
  double moment[3];                ///< principal moments [mass length^2]
  double inverse[3];               ///< their inverses; 0 where there is no inertia
  model::Vector velocity, spin;    ///< at the start
  std::vector<Index> part;         ///< its parts
  std::vector<RigidMass> of_part;  ///< [its part]
};

/// The bodies of a model.
///
/// Mass and inertia are the exact integrals over the rigid elements, or what *PART_INERTIA states, and the
/// masses of deformable elements and point masses at the nodes (with a stated inertia: of nodes with IFLAG 1
/// only). The velocity at the start, where no card gives it, is the one with the linear and angular momentum
/// of the nodes.
///
/// `node_mass` is what contact and its step see: the lumped mass of the elements, scaled down until no motion
/// of the body has less kinetic energy than the nodes alone would have; so no spring on the nodes swings
/// faster than the nodes' masses let it. Nodes without elements get a like share.
/// Errors: a body without mass; a body of nodes in a line or a point is allowed.
std::vector<RigidBody> make_bodies(const model::Model& model,
                                   const std::vector<std::unique_ptr<const Block>>& blocks,
                                   deck::Diagnostics& diagnostics);

}  // namespace cleave::discretisation
