#pragma once
/// Eigenvalues and vectors of small symmetric matrices.

#include <cmath>

namespace cleave::base {

/// Cyclic Jacobi rotations until nothing is left beside the diagonal.
/// @param a        [n][n] symmetric, overwritten; the eigenvalues end on its diagonal, in no order
/// @param vectors  [n][n] columns are the eigenvectors, orthonormal
/// Source: Golub & Van Loan, Matrix Computations (2013), sec. 8.5. Fails never.
template <int n>
void symmetric_eigen(double (&a)[n][n], double (&vectors)[n][n]) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) vectors[i][j] = i == j ? 1.0 : 0.0;
  for (int sweep = 0; sweep < 60; ++sweep) {
    double rest = 0.0, whole = 0.0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) (i == j ? whole : rest) += a[i][j] * a[i][j];
    if (rest <= 1e-34 * whole) return;
    for (int p = 0; p < n - 1; ++p)
      for (int q = p + 1; q < n; ++q) {
        if (a[p][q] == 0.0) continue;
        const double tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
        const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
        for (int k = 0; k < n; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < n; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
        }
        for (int k = 0; k < n; ++k) {
          const double kp = vectors[k][p], kq = vectors[k][q];
          vectors[k][p] = c * kp - s * kq;
          vectors[k][q] = s * kp + c * kq;
        }
      }
  }
}

}  // namespace cleave::base
