#pragma once
/// Surfaces of cells that have points of their own: neighbours meet at places, not at points.

#include "results/surface.hpp"
#include "solver/solver.hpp"

namespace cleave::results {

/// Outer faces where cells whose corners lie at the same places, bit by bit, count as neighbours. Shells are
/// faces themselves. The faces keep the points of their own cells.
/// @param position  [point][3] [length]
Surface outer_faces_by_place(std::span<const SolidCells> cells, std::span<const double> position);

/// What a picture of field cells shows. Cells on a line become a strip along it.
struct CellSurface {
  Surface surface;
  std::vector<double> position;         ///< [point][3] [length]
  std::vector<std::uint32_t> point_of;  ///< [point] in the fields
};
CellSurface surface_of(const solver::CellFields& cells);

}  // namespace cleave::results
