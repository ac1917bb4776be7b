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
/// @return the reason for failure, empty on success
[[nodiscard]] std::string write_vtu(const std::filesystem::path& path, const solver::Frame& frame,
                                    bool doubles);

}  // namespace cleave::results
