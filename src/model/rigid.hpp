#pragma once
/// Bodies that do not deform: parts of *MAT_RIGID and sets of nodes, what they are made of, and what drives
/// them. All ids are resolved to indices.

#include <memory>
#include <string>
#include <vector>

#include "deck/diagnostic.hpp"
#include "model/load.hpp"

namespace cleave::model {

/// Directions in which the centre of a body may not move or the body not turn; fixed in space.
struct RigidHold {
  unsigned directions = 0;  ///< bits 0..2 translation, 3..5 rotation
  bool local = false;       ///< directions are those of `frame`
  Frame frame;
};

/// *MAT_RIGID besides its density and elastic constants.
struct RigidMaterial {
  RigidHold hold;
  bool has_axes = false;  ///< are the body's own axes given? (LCO, or A and V)
  Frame axes;             ///< at the start; they turn with the body
};

/// Mass properties that a card states in place of those of the mesh.
struct RigidInertia {
  Vector centre = {0, 0, 0};                       ///< [length]
  Index node = -1;                                 ///< that stands at the centre, -1 none
  double mass = 0.0;                               ///< [mass]
  base::Sym3<double> tensor = {0, 0, 0, 0, 0, 0};  ///< about the centre, global axes [mass length^2]
  Vector velocity = {0, 0, 0}, spin = {0, 0, 0};   ///< at the start, global axes
};

/// A rigid body: parts, or nodes, or both.
struct RigidBody {
  Id id = 0;  ///< of its first part, or of the *CONSTRAINED_NODAL_RIGID_BODY
  std::string title;
  std::vector<Index> parts;  ///< the lead part first; none for a nodal rigid body
  std::vector<Index> nodes;  ///< every node that moves with it, ascending
  std::vector<Index> extra;  ///< those of *CONSTRAINED_EXTRA_NODES or of the set, ascending
  std::vector<Index> added;  ///< extra nodes whose mass adds to a stated inertia (IFLAG = 1), ascending
  std::shared_ptr<const RigidInertia> inertia;  ///< of a nodal rigid body; those of parts are with the parts
  RigidHold hold;
  bool has_axes = false;
  Frame axes;
  bool has_velocity = false;  ///< are these given? else the velocities of the nodes say
  Vector velocity = {0, 0, 0}, spin = {0, 0, 0};
  deck::Place place{};
};

/// Prescribed motion of a body: of its centre along a direction, or its rotation about one.
struct RigidMotion {
  Id id = 0;
  std::string title;
  Index body = -1;
  bool rotation = false;
  bool local = false;            ///< the direction turns with the body
  Vector direction = {1, 0, 0};  ///< unit, global axes at the start
  bool only_direction = true;    ///< false: motion across the direction is fixed too
  PrescribedMotion::Kind kind = PrescribedMotion::Kind::velocity;
  Index curve = -1;
  double scale = 1.0;
  double birth = 0.0, death = forever;
  deck::Place place{};
};

/// Force at the centre of a body, or moment (*LOAD_RIGID_BODY).
struct RigidLoad {
  Id id = 0;
  std::string title;
  Index body = -1;
  bool moment = false;
  Vector direction = {1, 0, 0};  ///< unit, global
  bool follower = false;         ///< along the normal of three nodes
  Index follow[3] = {-1, -1, -1};
  Index curve = -1;
  double scale = 1.0;
  deck::Place place{};
};

/// Body of each node [node], -1 for none.
std::vector<Index> body_of_nodes(const std::vector<RigidBody>& bodies, std::size_t node_count);

}  // namespace cleave::model
