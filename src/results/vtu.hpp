#pragma once
/// One frame as a VTK unstructured grid (.vtu): XML head, appended raw binary data.

#include <filesystem>
#include <string>

#include "results/element_values.hpp"
#include "solver/solver.hpp"

namespace cleave::results {

/// Writes the elements that are still there, with their nodes, to a temporary name and renames it.
/// Cell data: part_id, element_id and the element quantities; point data: node_id, displacement, velocity,
/// acceleration. Reals are float64 if `doubles`, else float32; ids are int64.
/// A frame with cells of its own has those instead, with their fields on the points.
/// @return the reason for failure, empty on success
[[nodiscard]] std::string write_vtu(const std::filesystem::path& path, const solver::Frame& frame,
                                    bool doubles);

/// Writes cells with points of their own: point data are their fields, cell data part_id and element_id.
[[nodiscard]] std::string write_cells(const std::filesystem::path& path, const solver::CellFields& cells,
                                      const discretisation::State& state, bool doubles);

}  // namespace cleave::results
