#pragma once
/// When a spacetime solution is cut for output.

#include <vector>

#include "model/model.hpp"

namespace cleave::solver {

/// All instants after 0 at which the deck wants something written, and the end: ascending, those that differ
/// by rounding only once. Energies are wanted a hundred times where the deck does not say. [time]
std::vector<double> output_instants(const model::Model& model, double end_time);

/// At which of them more is wanted than nodout and elout: energies are worked out there without being asked
/// for [instant].
std::vector<char> energy_instants(const model::Model& model, const std::vector<double>& instants);

/// Instants so close together that the front passes them in one go: the last of each such group [index].
/// Depends on nothing but the instants, so that a run that was stopped in between pauses where it would have.
std::vector<std::size_t> pauses(const std::vector<double>& instants, double shortest);

}  // namespace cleave::solver
