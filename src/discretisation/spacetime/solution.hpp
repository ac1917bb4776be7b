#pragma once
/// What a spacetime element knows after its patch was solved: polynomials of displacement, velocity and
/// strain.

#include <span>
#include <vector>

#include "discretisation/spacetime/elastic.hpp"

namespace cleave::discretisation::spacetime {

enum class LocalSpace : std::uint8_t {
  one_field,    ///< displacement of degree P; velocity and strain are its derivatives
  three_field,  ///< displacement, velocity and strain each of degree p
  trefftz       ///< displacements of degree P that satisfy the equation of motion exactly
};

/// A local space with its degree: p of the three-field space, P of the others. 1 to 6.
struct SpaceChoice {
  LocalSpace space = LocalSpace::three_field;
  int degree = 2;
  friend bool operator==(const SpaceChoice&, const SpaceChoice&) = default;
};

/// Degree of velocity and strain.
constexpr int field_degree(SpaceChoice c) {
  return c.space == LocalSpace::three_field ? c.degree : c.degree - 1;
}
/// Infinitesimal rigid motions.
template <int D>
inline constexpr int rigid_count = D*(D + 1) / 2;
/// Coupled unknowns of an element: those of velocity and strain. The rigid motions of the displacement, and
/// the displacement of the three-field space, follow one by one.
template <int D>
int unknown_count(SpaceChoice c);

/// The fields at one event.
template <int D>
struct PointState {
  Vector<D> u{}, v{};
  Voigt<D> strain{};
};

/// From spacetime to the barycentric coordinates of a simplex.
template <int D>
struct AffineMap {
  Event<D> origin{};
  Matrix<D + 1> gradient{};  ///< gradient[l - 1][k] = d lambda_l / d y_k, l = 1 .. D + 1
  /// False if the simplex is degenerate.
  bool set(const std::array<Event<D>, D + 2>& corner);
  std::array<double, D + 2> operator()(const Event<D>& y) const;
};

/// The solution in one element. Move it, or reuse it for another element: its memory is kept.
template <int D>
struct Solution {
  AffineMap<D> map;
  SpaceChoice space;
  const Elastic<D>* material = nullptr;
  int degree = 0;  ///< of velocity and strain
  int displacement_degree = 0;
  std::vector<double> fields;        ///< [state_count][polynomials], coefficients in Basis<D + 1>
  std::vector<double> displacement;  ///< [D][polynomials]
  /// Modes on the outflow facet of u, v and strain, as many as `degree` has, [D + state_count][modes], where
  /// the solver had them at hand; else empty. They follow from the coefficients, to the bit.
  std::vector<double> above;

  /// The polynomials at any event; it should lie in the element or on its boundary.
  PointState<D> at(const Event<D>& y) const;
  void at(std::span<const Event<D>> events, std::span<PointState<D>> states) const;
  Voigt<D> stress(const Event<D>& y) const { return material->stress(at(y).strain); }
};

}  // namespace cleave::discretisation::spacetime
