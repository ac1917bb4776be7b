#pragma once
/// *MAT_ORTHOTROPIC_ELASTIC of spacetime parts.

#include <memory>

#include "model/elasticity.hpp"
#include "model/keyword/draft.hpp"

namespace cleave::model {

/// Constants and axes of the card as the part uses them. Null, with errors, where moduli, Poisson's ratios or
/// axes make no material, or the axes are given in a way that is not computed.
std::shared_ptr<const Elasticity> read_orthotropic(Draft& draft, const Entry& entry, const Part& part);

}  // namespace cleave::model
