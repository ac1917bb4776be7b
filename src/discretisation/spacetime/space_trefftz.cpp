#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "discretisation/spacetime/monomials.hpp"
#include "discretisation/spacetime/space.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
void monomials(const base::Lanes* x, int degree, double* value, std::ptrdiff_t stride) {
  /// Each monomial is one of lower degree times a coordinate.
  struct Parent {
    int monomial, coordinate;
  };
  static const auto parents = [] {
    const auto& list = exponents<D + 1>();
    std::vector<Parent> all(list.size());
    for (std::size_t a = 1; a < list.size(); ++a) {
      auto lower = list[a];
      int k = 0;
      while (lower[static_cast<std::size_t>(k)] == 0) ++k;
      --lower[static_cast<std::size_t>(k)];
      all[a] = {static_cast<int>(std::find(list.begin(), list.end(), lower) - list.begin()), k};
    }
    return all;
  }();
  base::Lanes(1.0).store(value);
  const int n = polynomial_count(D + 1, degree);
  for (int a = 1; a < n; ++a) {
    const Parent& p = parents[static_cast<std::size_t>(a)];
    (base::Lanes::load(value + p.monomial * stride) * x[p.coordinate]).store(value + a * stride);
  }
}

template <int M>
const NodeTable<M>& NodeTable<M>::of(int degree) {
  static const auto tables = [] {
    std::array<NodeTable, largest_degree + 1> all;
    for (int p = 1; p <= largest_degree; ++p) {
      NodeTable& t = all[static_cast<std::size_t>(p)];
      t.count = polynomial_count(M, p);
      t.coordinate = take(t.memory, M + 1, t.count);
      t.restore = take(t.memory, t.count, t.count);
      Arena scratch;
      const Block value = take(scratch, t.count, t.count);  // [polynomial][node]: its inverse restores
      for (int i = 0; i < t.count; ++i) {                   // the monomials of degree <= p number a lattice
        const auto& k = exponents<M>()[static_cast<std::size_t>(i)];
        double lambda[M + 1], rest = 1.0, phi[Basis<M>::count];
        for (int l = 0; l < M; ++l) rest -= lambda[l + 1] = double(k[static_cast<std::size_t>(l)]) / p;
        lambda[0] = rest;
        Basis<M>::get().evaluate(lambda, p, phi);
        for (int a = 0; a < t.count; ++a) value.row(a)[i] = phi[a];
        for (int l = 0; l <= M; ++l) t.coordinate.row(l)[i] = lambda[l];
        t.restore.row(i)[i] = 1.0;
      }
      // values = phi(node)^T coefficients: row i of the inverse of [polynomial][node].
      std::vector<int> pivot(static_cast<std::size_t>(t.count));
      const bool ok = factor(value, pivot.data());
      CLEAVE_ASSERT(ok, "lattice nodes determine a polynomial");
      solve(value, pivot.data(), t.restore);
    }
    return all;
  }();
  return tables[static_cast<std::size_t>(degree)];
}

/// Monomials at eight points of scaled coordinates after eight points.
/// @param coordinate barycentric, of a simplex with `corners` corners
template <int D>
static Block monomials_at(const ElementSpace<D>& space, const Event<D>* corner, int corners,
                          const Block& coordinate, int degree, Arena& arena) {
  const int n = polynomial_count(D + 1, degree);
  const Block value = take_raw(arena, n, coordinate.columns);
  double scaled[D + 2][D + 1];
  for (int c = 0; c < corners; ++c)
    for (int k = 0; k <= D; ++k)
      scaled[c][k] =
          (corner[c][k] - space.centre[k]) / space.length * (k == D ? space.material->fastest : 1.0);
  for (int q = 0; q < value.stride; q += base::lane_count) {
    base::Lanes x[D + 1];
    for (int k = 0; k <= D; ++k) {
      x[k] = base::Lanes(0.0);
      for (int c = 0; c < corners; ++c)
        x[k] = fma(base::Lanes(scaled[c][k]), base::Lanes::load(coordinate.row(c) + q), x[k]);
    }
    monomials<D>(x, degree, value.data + q, value.stride);
  }
  return value;
}

template <int D>
Block ElementSpace<D>::trefftz_modes(const std::array<Event<D>, D + 1>& corners, const FacetRule& rule,
                                     bool at_points, Arena& arena) const {
  const Block value = monomials_at<D>(*this, corners.data(), D + 1, rule.coordinate, degree, arena);
  if (at_points) {
    for (int a = 0; a < value.rows; ++a)
      for (int q = 0; q < rule.rule->points; ++q)
        value.row(a)[q] *= std::sqrt(rule.rule->weight[static_cast<std::size_t>(q)]);
    return {value.data, value.rows, rule.rule->points, value.stride};
  }
  const Block modes = take_raw(arena, polynomials, polynomial_count(D, degree));
  multiply({value.data, value.rows, rule.rule->points, value.stride}, rule.weighted, modes);
  return modes;
}

template <int D>
Block ElementSpace<D>::change_of_basis(Arena& arena) const {
  const auto& nodes = NodeTable<D + 1>::of(choice.degree);
  const Block value = monomials_at<D>(*this, corner.data(), D + 2, nodes.coordinate, choice.degree, arena);
  const Block out = take_raw(arena, value.rows, value.rows);
  multiply(value, nodes.restore, out);
  return out;
}

/// Sums the table to monomials, evaluates those at nodes, restores the coefficients from the values.
template <int D>
void ElementSpace<D>::recover_trefftz(const double* x, Arena& arena, Solution<D>& out) const {
  constexpr int components = TrefftzTable<D>::components;
  const int n = polynomials, nu = polynomial_count(D + 1, choice.degree);
  const Block u = take_raw(arena, D, nu), w = take_raw(arena, state_count<D>, n);
  double* monomial = arena.take_raw(static_cast<std::size_t>(components * nu));
  table->sum(x, arena.take_raw(static_cast<std::size_t>(components * table->spread())), monomial, 1);
  const Block of_u{monomial, D, nu, nu}, of_w{monomial + D * nu, state_count<D>, n, nu};  // one degree less
  const auto& nodes = NodeTable<D + 1>::of(choice.degree);
  const Block value = monomials_at<D>(*this, corner.data(), D + 2, nodes.coordinate, choice.degree, arena),
              u_at = take_raw(arena, D, nu), w_at = take_raw(arena, state_count<D>, nu);
  multiply(of_u, value, u_at);
  multiply(of_w, {value.data, n, nu, value.stride}, w_at);
  multiply(u_at, nodes.restore, u);
  multiply(w_at, nodes.restore, w);
  const double scale = 1.0 / std::sqrt(volume);
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < nu; ++a)
      out.displacement[static_cast<std::size_t>(i * nu + a)] = scale * length * u.row(i)[a];
  for (int i = 0; i < state_count<D>; ++i)
    for (int a = 0; a < n; ++a) out.fields[static_cast<std::size_t>(i * n + a)] = scale * w.row(i)[a];
}

#define CLEAVE_INSTANTIATE(D)                                                                               \
  template void monomials<D>(const base::Lanes*, int, double*, std::ptrdiff_t);                             \
  template struct NodeTable<D + 1>;                                                                         \
  template Block ElementSpace<D>::trefftz_modes(const std::array<Event<D>, D + 1>&, const FacetRule&, bool, \
                                                Arena&) const;                                              \
  template Block ElementSpace<D>::change_of_basis(Arena&) const;                                            \
  template void ElementSpace<D>::recover_trefftz(const double*, Arena&, Solution<D>&) const;
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
