#include "discretisation/spacetime/space.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "discretisation/spacetime/basis.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
bool ElementSpace<D>::set(SpaceChoice c, const Elastic<D>& m, const TrefftzTable<D>* trefftz,
                          const std::array<Event<D>, D + 2>& corners, double size, Arena& arena) {
  choice = c, material = &m, table = trefftz, corner = corners, volume = size;
  span = {}, undo = {};
  degree = field_degree(c);
  polynomials = polynomial_count(D + 1, degree);
  unknowns = unknown_count<D>(c);
  CLEAVE_ASSERT(c.degree >= 1 && c.degree <= largest_degree, "degree of a local space");
  if (!map.set(corner) || !(volume > 0.0)) return false;
  centre = {};
  for (const auto& y : corner)
    for (int k = 0; k <= D; ++k) centre[k] += y[k] / (D + 2);
  length = 0.0;
  for (const auto& y : corner) {
    const double ct = m.fastest * (y[D] - centre[D]);
    double square = ct * ct;
    for (int k = 0; k < D; ++k) square += (y[k] - centre[k]) * (y[k] - centre[k]);
    length = std::max(length, square);
  }
  length = std::sqrt(length);
  switch (c.space) {
    case LocalSpace::three_field:
      return true;
    case LocalSpace::one_field:
      return span_one_field(arena);
    case LocalSpace::trefftz:
      span = table->fields;
      return true;
  }
  return false;
}

template <int D>
int ElementSpace<D>::opposite(const std::array<Event<D>, D + 1>& facet) const {
  int missing = -1;
  for (int i = 0, at = 0; i < D + 2; ++i) {
    if (at <= D && corner[static_cast<std::size_t>(i)] == facet[static_cast<std::size_t>(at)]) {
      ++at;
    } else {
      if (missing >= 0) return -1;
      missing = i;
    }
  }
  return missing;
}

template <int D>
std::array<Block, D + 1> ElementSpace<D>::derivatives(int rows_degree, int columns_degree,
                                                      Arena& arena) const {
  const auto& basis = Basis<D + 1>::get();
  std::array<Block, D + 1> out;
  const int rows = polynomial_count(D + 1, rows_degree), columns = polynomial_count(D + 1, columns_degree);
  for (int k = 0; k <= D; ++k) {
    out[k] = take(arena, rows, columns);
    for (int l = 0; l <= D; ++l)
      for (int a = 0; a < rows; ++a) {
        const double* weak = basis.weak(l + 1, a);
        for (int b = 0; b < columns; ++b) out[k].row(a)[b] += map.gradient[l][k] * weak[b];
      }
  }
  return out;
}

template <int D>
bool ElementSpace<D>::span_one_field(Arena& arena) {
  constexpr int linear = D + 2;  // polynomials of degree 1
  const int n = polynomials, high = polynomial_count(D + 1, choice.degree) - linear;
  span = take(arena, state_count<D> * n, unknowns);
  const auto derivative = derivatives(degree, choice.degree, arena);
  const Block strain = take(arena, strain_count<D> * n, unknowns);
  const double root = std::sqrt(material->density);
  int column = 0;
  for (int i = 0; i < D; ++i) span.row(i * n)[column++] = root;                 // t e_i
  for (int c = 0; c < strain_count<D>; ++c) strain.row(c * n)[column++] = 1.0;  // symmetric gradients
  for (int i = 0; i < D; ++i, column += high)                                   // phi_a e_i, degree >= 2
    for (int b = 0; b < n; ++b) {
      for (int a = 0; a < high; ++a)
        span.row(i * n + b)[column + a] = root * derivative[D].row(b)[linear + a];
      for (int j = 0; j < D; ++j)
        for (int a = 0; a < high; ++a)
          strain.row(voigt<D>(i, j) * n + b)[column + a] +=
              (i == j ? 1.0 : 0.5) * derivative[j].row(b)[linear + a];
    }
  for (int c = 0; c < strain_count<D>; ++c)
    for (int d = 0; d < strain_count<D>; ++d) {
      const double s = material->to_energy[c][d];
      if (s == 0.0) continue;
      for (int b = 0; b < n; ++b)
        for (int k = 0; k < unknowns; ++k) span.row((D + c) * n + b)[k] += s * strain.row(d * n + b)[k];
    }
  return orthonormalise(arena);
}

/// Cholesky on the energy product. The assembly never relies on exact orthonormality, only the conditioning
/// does: a second round is needed where the first lost half of the digits.
template <int D>
bool ElementSpace<D>::orthonormalise(Arena& arena) {
  for (int round = 0; round < 2; ++round) {
    const Block gram = take(arena, unknowns, unknowns), step = take(arena, unknowns, unknowns);
    multiply_transposed_add(span, span, gram);
    if (!cholesky(gram)) return false;
    invert_upper(gram, step);
    double least = gram.row(0)[0], largest = least;
    for (int k = 1; k < unknowns; ++k)
      least = std::min(least, gram.row(k)[k]), largest = std::max(largest, gram.row(k)[k]);
    const Block next = take(arena, span.rows, unknowns);
    multiply_add(1.0, span, step, next);
    span = next;
    if (round == 0) {
      undo = step;
    } else {
      const Block both = take(arena, unknowns, unknowns);
      multiply_add(1.0, undo, step, both);
      undo = both;
    }
    if (least > 1e-4 * largest) return true;
  }
  return true;
}

template <int D>
void ElementSpace<D>::recover(const double* x, Arena& arena, Solution<D>& out) const {
  const int n = polynomials, pu = choice.degree, nu = polynomial_count(D + 1, pu);
  out.map = map, out.space = choice, out.material = material;
  out.degree = degree, out.displacement_degree = pu;
  out.fields.assign(static_cast<std::size_t>(state_count<D> * n), 0.0);
  out.displacement.assign(static_cast<std::size_t>(D * nu), 0.0);
  out.above.clear();

  if (choice.space == LocalSpace::trefftz) return recover_trefftz(x, arena, out);
  // Energy-scaled coefficients, then velocity and strain.
  const double scale = 1.0 / std::sqrt(volume);
  double* w = arena.take(static_cast<std::size_t>(state_count<D> * n));
  for (int r = 0; r < state_count<D> * n; ++r) {
    double sum = span.data ? 0.0 : x[r];
    if (span.data)
      for (int k = 0; k < unknowns; ++k) sum += span.row(r)[k] * x[k];
    w[r] = sum * scale;
  }
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < n; ++a)
      out.fields[static_cast<std::size_t>(i * n + a)] = w[i * n + a] / std::sqrt(material->density);
  for (int c = 0; c < strain_count<D>; ++c)
    for (int d = 0; d < strain_count<D>; ++d)
      for (int a = 0; a < n; ++a)
        out.fields[static_cast<std::size_t>((D + c) * n + a)] +=
            material->from_energy[c][d] * w[(D + d) * n + a];
  if (choice.space == LocalSpace::three_field) return;

  double* first = arena.take(static_cast<std::size_t>(unknowns));  // in the first spanning set
  for (int k = 0; k < unknowns; ++k)
    for (int j = k; j < unknowns; ++j) first[k] += undo.row(k)[j] * x[j] * scale;
  double* u = out.displacement.data();
  const auto& basis = Basis<D + 1>::get();
  // Coefficients of the centred coordinates, then the functions of span_one_field in their order.
  double coordinate[D + 1][D + 2] = {};
  for (int k = 0; k <= D; ++k)
    for (int l = 0; l < D + 2; ++l)
      for (int a = 0; a < D + 2; ++a) coordinate[k][a] += (corner[l][k] - centre[k]) * basis.linear(l)[a];
  int column = 0;
  for (int i = 0; i < D; ++i, ++column)
    for (int a = 0; a < D + 2; ++a) u[i * nu + a] += first[column] * coordinate[D][a];
  for (int c = 0; c < strain_count<D>; ++c, ++column)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        if (voigt<D>(i, j) == c)
          for (int a = 0; a < D + 2; ++a) u[i * nu + a] += first[column] * coordinate[j][a];
  for (int i = 0; i < D; ++i)
    for (int a = D + 2; a < nu; ++a) u[i * nu + a] += first[column++];
}

template struct ElementSpace<1>;
template struct ElementSpace<2>;
template struct ElementSpace<3>;

}  // namespace cleave::discretisation::spacetime
