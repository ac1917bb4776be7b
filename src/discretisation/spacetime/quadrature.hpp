#pragma once
/// Quadrature on simplices of any dimension.

#include <vector>

namespace cleave::discretisation::spacetime {

/// A rule in barycentric coordinates. Weights sum to one, so that sums are means over the simplex.
struct SimplexRule {
  int dimension = 0;
  int points = 0;
  std::vector<double> barycentric;  ///< [point][dimension + 1]
  std::vector<double> weight;       ///< [point]
};

/// Conical product of Gauss-Jacobi rules with `per_direction` points each, exact for polynomials of total
/// degree 2 per_direction - 1. Built once, then shared; `dimension` 0 to 4, `per_direction` 1 to 12. Source:
/// Stroud, Approximate Calculation of Multiple Integrals (1971), section 2.5.
const SimplexRule& simplex_rule(int dimension, int per_direction);

}  // namespace cleave::discretisation::spacetime
