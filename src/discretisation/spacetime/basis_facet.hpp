#pragma once
/// The orthonormal polynomials seen from the facets of their simplex: constant tables, the same for every
/// element.
///
/// A facet is named by the local number of the corner opposite; its own corners are the others in ascending
/// order. Functions on it are written in the orthonormal polynomials of D dimensions, "modes".

#include <array>
#include <vector>

#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
class FacetBasis {
 public:
  static const FacetBasis& get();

  /// [polynomials of degree 6 in D + 1 variables][modes of degree 6]: row a holds the modes of phi_a on the
  /// facet. Those of degree p need the first polynomial_count(D, p) columns only.
  const Block& modes(int opposite) const { return modes_[static_cast<std::size_t>(opposite)]; }
  /// [polynomials][polynomials]: mean of phi_a phi_b over the facet.
  const Block& mass(int opposite) const { return mass_[static_cast<std::size_t>(opposite)]; }
  /// [polynomials][polynomials]: Basis<D + 1>::weak, l = 1 .. D + 1.
  const Block& weak(int l) const { return weak_[static_cast<std::size_t>(l - 1)]; }
  /// [modes][modes], row c: from the modes of a function on a facet to its mode c after the corners were
  /// renumbered; corner i of the new numbering is order[i] of the old one.
  const Block& turned(const std::array<int, D + 1>& order) const {
    return turned_[static_cast<std::size_t>(place_[code(order)])];
  }

 private:
  FacetBasis();
  static std::size_t code(const std::array<int, D + 1>& order) {
    std::size_t c = 0;
    for (const int i : order) c = 4 * c + static_cast<std::size_t>(i);
    return c;
  }
  Arena memory_;
  std::array<Block, D + 2> modes_, mass_;
  std::array<Block, D + 1> weak_;
  std::vector<Block> turned_;
  std::array<int, 256> place_{};
};

}  // namespace cleave::discretisation::spacetime
