#pragma once
/// The spacetime solver for a body that is made already.

#include "discretisation/spacetime/body.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

/// As make_tents(world, ...) of solver.hpp; the body must be that of the world's model.
template <int D>
std::unique_ptr<Solver> make_tents(const discretisation::World& world,
                                   std::unique_ptr<const discretisation::spacetime::Body<D>> body,
                                   const Options& options);

}  // namespace cleave::solver
