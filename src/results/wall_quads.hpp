#pragma once
/// Rigid walls as faces to be drawn.

#include <array>
#include <vector>

#include "model/load.hpp"

namespace cleave::results {

/// A wall where it stands now.
struct StandingWall {
  const model::RigidWall* wall = nullptr;
  model::Vector shift{0, 0, 0};               ///< since the start [length]
  model::Vector low{0, 0, 0}, high{0, 0, 0};  ///< box around the nodes that may meet it [length]
};

/// Four corners, counter-clockwise seen from where the bodies are.
using WallQuad = std::array<model::Vector, 4>;

/// The part of a wall that lies near the nodes that may meet it: planes are cut off a sixth of the diagonal
/// of their box beyond it, round walls three quarters of the diagonal from the place next to its middle.
/// Empty where the wall is farther away than that.
std::vector<WallQuad> wall_quads(const StandingWall& standing);

}  // namespace cleave::results
