#pragma once
/// Linear elastic material of a spacetime element, and what the method derives from it.
///
/// State U = (v, E): velocity and the tensor components of the strain, in the order of the house: 11; 11 22
/// 12; 11 22 33 12 23 31. All work is done on energy-scaled fields w = A0^(1/2) U, A0 = diag(rho I, W C W)
/// with W = 1 or 2 for shear, so that |w|^2 / 2 is the energy density, A0 becomes the identity and every
/// entry of a patch matrix has the dimension 1/time whatever the units of the deck. This is the scaling that
/// keeps it well conditioned.

#include <array>
#include <string>

#include "discretisation/spacetime/patch.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
inline constexpr int strain_count = D*(D + 1) / 2;
template <int D>
inline constexpr int state_count = D + strain_count<D>;

template <int D>
using Vector = std::array<double, D>;
template <int R, int C = R>
using Matrix = std::array<std::array<double, C>, R>;
template <int D>
using Voigt = std::array<double, strain_count<D>>;

/// Component (i, j) of a symmetric tensor in its storage.
template <int D>
constexpr int voigt(int i, int j) {
  if (i == j) return i;
  if constexpr (D == 3) return i + j == 1 ? 3 : (i + j == 3 ? 4 : 5);
  return 2;
}

/// Work factor of a component: shear strains count twice.
template <int D>
constexpr double work_factor(int component) {
  return component < D ? 1.0 : 2.0;
}

template <int D>
struct Elastic {
  double density = 0.0;                 ///< [mass / length^D]
  Matrix<strain_count<D>> stiffness{};  ///< stress_I = stiffness_IJ W_J E_J, symmetric [stress]
  double fastest = 0.0;                 ///< largest phase speed over all directions [length/time]
  bool isotropic = false;
  /// Stress across the plane = across_I W_I E_I; zero in plane stress, and for D = 1 and 3. [stress]
  Voigt<D> across{};
  Matrix<strain_count<D>> to_energy{};    ///< (W C W)^(1/2), symmetric
  Matrix<strain_count<D>> from_energy{};  ///< its inverse
  /// Scaled fluxes: (flux[j] E_w)_i = sigma_ij / sqrt(rho), so that A^j becomes [[0, -flux], [-flux^T, 0]].
  std::array<Matrix<D, strain_count<D>>, D> flux{};

  Voigt<D> stress(const Voigt<D>& strain) const;
  double stress_across(const Voigt<D>& strain) const;
  /// Z = (rho Gamma)^(1/2) with the Christoffel matrix Gamma_ik = C_ijkl n_j n_l, |n| = 1.
  /// [mass / (length^(D-1) time)]
  Matrix<D> impedance(const Vector<D>& n) const;
  /// Phase speeds along n, ascending. [length/time]
  Vector<D> speeds(const Vector<D>& n) const;
};

enum class PlaneKind { strain, stress };

/// Isotropic material. D = 1: uniaxial strain, or a bar (rho c^2 = E) with PlaneKind::stress. D = 2: plane
/// strain or plane stress. D = 3 ignores `plane`, which must be strain. Fails, with the reason, if density or
/// modulus is not positive or nu is outside (-1, 1/2).
template <int D>
std::string make_isotropic(double density, double young, double poisson, PlaneKind plane, Elastic<D>& out);

/// The stress across the plane stays zero, as in plane stress: in plane strain the caller sets `across`.
/// @param stiffness symmetric, engineering: stress = stiffness (11, .., 2 E12, ..) [stress]
/// Fails, with the reason, if density is not positive or the stiffness not symmetric and positive definite.
template <int D>
std::string make_anisotropic(double density, const Matrix<strain_count<D>>& stiffness, Elastic<D>& out);

/// Square root and inverse square root of a symmetric positive definite matrix. False if it is not.
template <int N>
bool square_root(const Matrix<N>& a, Matrix<N>& root, Matrix<N>& inverse);

/// Inverse of a symmetric positive definite matrix. @throws never; a must be positive definite.
template <int N>
Matrix<N> inverse(const Matrix<N>& a);

}  // namespace cleave::discretisation::spacetime
