#pragma once
/// What keeps the front from running into a corner: bounds on its slopes beyond causality, chosen such that
/// the lowest vertex of any simplex can always rise by an amount that depends on the mesh alone.
///
/// Derivations: docs/spacetime.md. `eps` (0, 1/2]: small values give taller tents on good meshes, large ones
/// better worst cases.

#include <array>

#include "discretisation/spacetime/front.hpp"

namespace cleave::discretisation::spacetime {

enum class Progress : std::uint8_t {
  causality,   ///< no constraint beyond causality: stalls in 2D and 3D; for demonstration
  high_mid,    ///< 2D: bounds the rise from the middle to the highest vertex of a triangle
  subsimplex,  ///< any D: a slope bound for every edge and face
  budget       ///< 2D: time budgets that survive newest-vertex bisection to any depth
};

/// One simplex of the front, as far as bounds need it.
template <int D>
struct Cell {
  std::array<Point<D>, D + 1> corner;  ///< [length]
  std::array<double, D + 1> time;      ///< [time]
  double bound = 0.0;                  ///< largest |grad time|: chi / fastest wave speed [time/length]
  Budget budget;                       ///< with Progress::budget
};

/// The budget of a triangle as a root: its longest edge is bisected first (ties: the edge opposite the lowest
/// local number). Bounds the four shapes and four edge directions that newest-vertex bisection makes of it.
Budget root_budget(const Cell<2>& cell, double eps);

/// Latest time to which corner i may rise, the others held. Both causality and progress. [time]
template <int D>
double rise_limit(const Cell<D>& cell, std::size_t i, Progress progress, double eps);

/// What corner i is sure to gain if it is no higher than the others and the cell obeys its bounds. [time]
template <int D>
double sure_gain(const Cell<D>& cell, std::size_t i, Progress progress, double eps);

/// The largest ratio of a slope (or time difference) to its bound over all bounds of the cell: at most 1, up
/// to rounding, for an admissible front.
template <int D>
double strain_on_bounds(const Cell<D>& cell, Progress progress, double eps);

}  // namespace cleave::discretisation::spacetime
