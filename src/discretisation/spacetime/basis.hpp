#pragma once
/// Orthonormal polynomials on a simplex.
///
/// Every spacetime element is an affine image of one reference simplex, and an affine map keeps
/// orthogonality. So the polynomials of Proriol, Koornwinder and Dubiner, written in barycentric coordinates,
/// are orthonormal on every element: no mass matrix is factorised, and derivatives are constant matrices.
/// Source: Dubiner, J. Sci. Comput. 6 (1991) 345; Sherwin & Karniadakis, Int. J. Numer. Meth. Eng. 38 (1995)
/// 3775.

#include <array>
#include <vector>

namespace cleave::discretisation::spacetime {

inline constexpr int largest_degree = 6;

/// Dimension of the polynomials of total degree <= `degree` in `dimension` variables.
constexpr int polynomial_count(int dimension, int degree) {
  int count = 1;
  for (int k = 1; k <= dimension; ++k) count = count * (degree + k) / k;
  return degree < 0 ? 0 : count;
}

/// The polynomials on the simplex of M dimensions up to degree 6, sorted by degree: the first
/// polynomial_count(M, p) span those of degree p. The mean of phi_a phi_b over the simplex is delta_ab.
template <int M>
class Basis {
 public:
  static const Basis& get();

  /// @param barycentric [M + 1], sum one
  /// @param value       [polynomial_count(M, degree)], overwritten
  void evaluate(const double* barycentric, int degree, double* value) const;

  /// Row a of the derivative with respect to barycentric coordinate l = 1..M (coordinate 0 = one minus the
  /// rest): d phi_a / d lambda_l = sum_b slope(l, a)[b] phi_b, b < polynomial_count(M, degree of a - 1).
  const double* slope(int l, int a) const {
    return slope_[static_cast<std::size_t>(l - 1)].data() + static_cast<std::size_t>(a * count);
  }
  /// Row a of the same numbers by test function: weak(l, a)[b] = mean of phi_a d phi_b / d lambda_l.
  const double* weak(int l, int a) const {
    return weak_[static_cast<std::size_t>(l - 1)].data() + static_cast<std::size_t>(a * count);
  }
  /// Coefficients of barycentric coordinate l = 0..M in the first M + 1 polynomials.
  const double* linear(int l) const { return linear_.data() + static_cast<std::size_t>(l * (M + 1)); }
  int degree_of(int a) const { return degree_[static_cast<std::size_t>(a)]; }

  static constexpr int count = polynomial_count(M, largest_degree);

 private:
  Basis();
  template <class Real>
  void evaluate_raw(const std::array<Real, M + 1>& barycentric, int degree, Real* value) const;

  std::vector<std::array<int, M>> index_;  ///< degree in each collapsed direction
  std::vector<int> degree_;
  std::vector<double> norm_;
  std::array<std::vector<double>, M> slope_, weak_;
  std::vector<double> linear_;
};

}  // namespace cleave::discretisation::spacetime
