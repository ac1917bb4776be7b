#pragma once
/// Pieces that several cards of rigid bodies have in common.

#include "model/keyword/draft.hpp"
#include "model/rigid.hpp"

namespace cleave::model {

/// Centre, mass, tensor and velocities of *PART_INERTIA and *CONSTRAINED_NODAL_RIGID_BODY_INERTIA; null with
/// an error, also where the tensor is not positive definite. Products are components of the tensor:
/// IXY = - integral of x y dm.
std::shared_ptr<RigidInertia> read_inertia(Draft& draft, const Entry& entry);

/// CMO, CON1, CON2; false with an error.
bool read_hold(Draft& draft, const Entry& entry, RigidHold& hold);

/// *MAT_RIGID besides its law; null with an error.
std::shared_ptr<const RigidMaterial> read_rigid_material(Draft& draft, const Entry& entry);

}  // namespace cleave::model
