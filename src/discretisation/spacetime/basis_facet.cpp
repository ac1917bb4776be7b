#include "discretisation/spacetime/basis_facet.hpp"

#include <algorithm>

#include "discretisation/spacetime/quadrature.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
FacetBasis<D>::FacetBasis() {
  constexpr int all = Basis<D + 1>::count, on_facet = Basis<D>::count;
  const SimplexRule& rule = simplex_rule(D, largest_degree + 1);
  const auto barycentric = [&](int q, int c) {
    return rule.barycentric[static_cast<std::size_t>(q * (D + 1) + c)];
  };
  Arena scratch;
  const Block weighted = take(scratch, rule.points, on_facet);
  for (int q = 0; q < rule.points; ++q) {
    Basis<D>::get().evaluate(&rule.barycentric[static_cast<std::size_t>(q * (D + 1))], largest_degree,
                             weighted.row(q));
    for (int c = 0; c < on_facet; ++c) weighted.row(q)[c] *= rule.weight[static_cast<std::size_t>(q)];
  }
  for (int opposite = 0; opposite < D + 2; ++opposite) {
    const auto k = static_cast<std::size_t>(opposite);
    const Block value = take(scratch, rule.points, all), transposed = take(scratch, on_facet, all);
    for (int q = 0; q < rule.points; ++q) {
      double lambda[D + 2] = {};
      for (int i = 0, from = 0; i < D + 2; ++i)
        if (i != opposite) lambda[i] = barycentric(q, from++);
      Basis<D + 1>::get().evaluate(lambda, largest_degree, value.row(q));
    }
    modes_[k] = take(memory_, all, on_facet);
    mass_[k] = take(memory_, all, all);
    multiply_transposed(value, weighted, modes_[k]);
    // Modes beyond the degree of a polynomial vanish; rounding would leave traces of them.
    for (int a = 0; a < all; ++a) {
      const int first = polynomial_count(D, Basis<D + 1>::get().degree_of(a));
      std::fill(modes_[k].row(a) + first, modes_[k].row(a) + modes_[k].stride, 0.0);
    }
    for (int a = 0; a < all; ++a)
      for (int c = 0; c < on_facet; ++c) transposed.row(c)[a] = modes_[k].row(a)[c];
    multiply(modes_[k], transposed, mass_[k]);
  }
  for (int l = 1; l <= D + 1; ++l) {
    Block& w = weak_[static_cast<std::size_t>(l - 1)];
    w = take(memory_, all, all);
    for (int a = 0; a < all; ++a) std::copy_n(Basis<D + 1>::get().weak(l, a), all, w.row(a));
  }
  std::array<int, D + 1> order{};
  for (int i = 0; i <= D; ++i) order[static_cast<std::size_t>(i)] = i;
  do {
    // The function of the old modes at a point whose new coordinate i is the old coordinate order[i].
    const Block value = take(scratch, rule.points, on_facet);
    for (int q = 0; q < rule.points; ++q) {
      double old[D + 1];
      for (int i = 0; i <= D; ++i) old[order[static_cast<std::size_t>(i)]] = barycentric(q, i);
      Basis<D>::get().evaluate(old, largest_degree, value.row(q));
    }
    place_[code(order)] = static_cast<int>(turned_.size());
    turned_.push_back(take(memory_, on_facet, on_facet));
    multiply_transposed(weighted, value, turned_.back());
  } while (std::next_permutation(order.begin(), order.end()));
}

template <int D>
const FacetBasis<D>& FacetBasis<D>::get() {
  static const FacetBasis basis;
  return basis;
}

template class FacetBasis<1>;
template class FacetBasis<2>;
template class FacetBasis<3>;

}  // namespace cleave::discretisation::spacetime
