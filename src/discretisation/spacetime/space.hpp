#pragma once
/// The local spaces, as subspaces of one: velocity and strain of complete degree p.
///
/// With energy-scaled fields w (elastic.hpp) and phi_a orthonormal on the element, the three-field space has
/// the unknowns of phi_a in each component of w, component by component. The other two spaces are spanned by
/// the columns of a matrix with orthonormal columns on top of that, so that every facet and volume term of
/// theirs is a restriction of the three-field one. Their displacements come with them.

#include <vector>

#include "discretisation/spacetime/dense.hpp"
#include "discretisation/spacetime/solution.hpp"

namespace cleave::discretisation::spacetime {

/// Displacement polynomials that satisfy rho u,tt = div C : grad u, as monomials in (x - x_c) / L and
/// c (t - t_c) / L; one table serves all elements of a material. c is the fastest speed.
/// Source: power series of the equation of motion in time, (3.9) of the specification.
template <int D>
struct TrefftzTable {
  int degree = 0;                    ///< P
  int count = 0;                     ///< functions, without rigid motions
  std::vector<double> displacement;  ///< [function][D][monomials of degree P], u / L
  Block fields;                      ///< [state_count * monomials of degree P - 1][count], energy-scaled
  Arena memory;
  TrefftzTable(const Elastic<D>& material, int degree);
};

/// Monomials of D + 1 scaled coordinates up to `degree`, sorted by degree.
template <int D>
void monomials(const std::array<double, D + 1>& x, int degree, double* value);

/// The space of one element, living in the arena of its patch.
template <int D>
struct ElementSpace {
  SpaceChoice choice;
  const Elastic<D>* material = nullptr;
  const TrefftzTable<D>* table = nullptr;
  std::array<Event<D>, D + 2> corner{};
  AffineMap<D> map;
  double volume = 0.0;  ///< of the element
  int degree = 0;       ///< p, of velocity and strain
  int polynomials = 0;  ///< of degree p
  int unknowns = 0;
  Block span;  ///< [state_count * polynomials][unknowns]; no data for the three-field space
  Block undo;  ///< [unknowns][unknowns], from the orthonormal unknowns to those of the first spanning set
  Event<D> centre{};
  double length = 0.0;  ///< L of the Trefftz functions

  /// False if the element is degenerate.
  bool set(SpaceChoice choice, const Elastic<D>& material, const TrefftzTable<D>* table,
           const std::array<Event<D>, D + 2>& corner, double volume, Arena& arena);

  /// Coefficients of velocity and strain, and of the displacement without its rigid part, from the unknowns.
  /// The three-field space has no such displacement: its coefficients are zero on return.
  /// @param x [unknowns]
  void recover(const double* x, Arena& arena, Solution<D>& out) const;

  /// Mean derivative matrices: out[k] (a, b) = mean of phi_a d phi_b / d y_k over the element, k = 0 .. D.
  std::array<Block, D + 1> derivatives(int rows_degree, int columns_degree, Arena& arena) const;

 private:
  bool span_one_field(Arena& arena);
  bool span_trefftz(Arena& arena);
  bool orthonormalise(Arena& arena);
};

}  // namespace cleave::discretisation::spacetime
