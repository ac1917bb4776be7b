#pragma once
/// The local spaces: what spans velocity and strain in an element, in energy-scaled fields w (elastic.hpp).
///
/// Three fields: orthonormal polynomials phi_a in each component of w, component by component; their tables
/// are the same for every element. One field: columns with orthonormal coefficients on top of the phi_a.
/// Trefftz: the functions of one table for each material and degree, on top of monomials in coordinates that
/// are centred on the element and scaled; nothing is made for the element but the values of monomials.

#include <vector>

#include "base/lanes.hpp"
#include "discretisation/spacetime/dense.hpp"
#include "discretisation/spacetime/quadrature.hpp"
#include "discretisation/spacetime/solution.hpp"

namespace cleave::discretisation::spacetime {

/// Displacement polynomials that satisfy rho u,tt = div C : grad u, as monomials in (x - x_c) / L and
/// c (t - t_c) / L; one table serves all elements of a material. c is the fastest speed. Orthonormal in
/// energy on the average over elements of usual shape, which keeps the condition numbers of patches moderate
/// without any work on the single element. Source: power series of the equation of motion in time, (3.9) of
/// the specification.
template <int D>
struct TrefftzTable {
  int degree = 0;  ///< P
  int count = 0;   ///< functions, without rigid motions
  Block fields;    ///< [state_count * monomials of degree P - 1][count], energy-scaled
  /// [function][monomials of degree P][columns]: u / L, then the energy-scaled fields, then padding.
  Block all;
  static constexpr int components = D + state_count<D>, columns = padded(components);
  Arena memory;
  TrefftzTable(const Elastic<D>& material, int degree);

  /// Coefficients of the sum of the functions times x, a vector or several side by side (multiply_vectors()):
  /// u / L, velocity and strain.
  /// @param out [components][monomials][width], overwritten @param scratch [components * spread()]
  void sum(const double* x, double* scratch, double* out, int width) const;
  int spread() const { return spread_; }

 private:
  void orthonormalise();
  void compress(const Elastic<D>& material);

  /// What functions add to eight monomials of one component. Monomials are sorted by the parity of their
  /// exponents: isotropy leaves a function one parity in each component.
  struct Piece {
    int first = 0, count = 0;  ///< among the terms
  };
  std::vector<Piece> pieces_;  ///< [component][eight places]
  std::vector<int> function_;  ///< [term]
  Block terms_;                ///< [term][8]
  std::vector<int> place_;     ///< [monomial]
  int spread_ = 0;             ///< places
  /// The same sums one by one, where lanes are vectors.
  struct Single {
    int function;
    double value;
  };
  std::vector<Single> singles_;
  std::vector<int> single_first_;  ///< [component][monomial], and the end
};

/// Points from whose values a polynomial is restored.
template <int M>
struct NodeTable {
  int count = 0;
  Block coordinate;  ///< [M + 1][nodes], barycentric
  Block restore;     ///< [nodes][polynomials]: row i holds what value i adds to each coefficient
  Arena memory;
  static const NodeTable& of(int degree);
};

/// A rule on facets, laid out for eight points at a time.
struct FacetRule {
  const SimplexRule* rule = nullptr;
  Block weighted;    ///< [point][modes], times the weight
  Block coordinate;  ///< [D + 1][points], barycentric
};

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
  Block span;  ///< [state_count * functions][unknowns], functions phi_a or monomials; no data: three fields
  Block undo;  ///< one field, [unknowns][unknowns]: from the orthonormal unknowns to the first spanning set
  Event<D> centre{};
  double length = 0.0;  ///< L of the Trefftz functions

  /// False if the element is degenerate.
  bool set(SpaceChoice choice, const Elastic<D>& material, const TrefftzTable<D>* table,
           const std::array<Event<D>, D + 2>& corner, double volume, Arena& arena);

  /// Coefficients of velocity and strain, and of the displacement without its rigid part, from the unknowns.
  /// The three-field space has no such displacement: its coefficients are zero on return.
  /// @param x [unknowns]
  void recover(const double* x, Arena& arena, Solution<D>& out) const;

  /// Trefftz: the polynomials of the scaled monomials, [monomials][polynomials] of degree P. None has a
  /// higher degree than its monomial.
  Block change_of_basis(Arena& arena) const;

  /// Modes on a facet of the functions under `span`: [functions][modes]; or their values at the points times
  /// the roots of the weights.
  Block trefftz_modes(const std::array<Event<D>, D + 1>& corner_of_facet, const FacetRule& rule,
                      bool at_points, Arena& arena) const;

  /// Local number of the corner opposite a facet, if its corners are those of the element in the same order;
  /// else -1.
  int opposite(const std::array<Event<D>, D + 1>& corner_of_facet) const;

  /// Mean derivative matrices: out[k] (a, b) = mean of phi_a d phi_b / d y_k over the element, k = 0 .. D.
  std::array<Block, D + 1> derivatives(int rows_degree, int columns_degree, Arena& arena) const;

 private:
  bool span_one_field(Arena& arena);
  void recover_trefftz(const double* x, Arena& arena, Solution<D>& out) const;
  bool orthonormalise(Arena& arena);
};

}  // namespace cleave::discretisation::spacetime
