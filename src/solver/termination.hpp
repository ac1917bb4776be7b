#pragma once
/// When a run ends: *CONTROL_TERMINATION, *TERMINATION_NODE, and what its user wishes.

#include <optional>

#include "solver/solver.hpp"

namespace cleave::solver {

/// Looks at a whole cycle; nothing if the run goes on. The run ends at the first t_n that is not before
/// ENDTIM: the last step is not cut.
std::optional<Ending> reason_to_end(const model::Model& model, const discretisation::State& state,
                                    const Options& options, const Wishes& wishes);

/// Physics that cannot go on although every element could: velocities that are no numbers, energy from
/// nowhere, a step that collapsed.
/// @param gross_work     sum of the absolute work done on the nodes so far [energy]
/// @param step_element   the element that controls the step
/// @param acceleration   [node][3] at t_n [length/time^2]
discretisation::StepStatus check_health(const discretisation::World& world,
                                        const discretisation::State& state, double gross_work,
                                        model::Id step_element, std::span<const double> acceleration);

}  // namespace cleave::solver
