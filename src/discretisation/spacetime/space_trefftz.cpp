#include <algorithm>
#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/space.hpp"

namespace cleave::discretisation::spacetime {
using base::lane_count;

namespace {

/// Exponents of the monomials in M variables, sorted by degree.
template <int M>
const std::vector<std::array<int, M>>& exponents() {
  static const auto list = [] {
    std::vector<std::array<int, M>> all;
    for (int degree = 0; degree <= largest_degree; ++degree) {
      std::array<int, M> k{};
      const auto visit = [&](auto&& self, int level, int left) -> void {
        if (level == M - 1) {
          k[static_cast<std::size_t>(level)] = left;
          all.push_back(k);
          return;
        }
        for (int v = left; v >= 0; --v) {
          k[static_cast<std::size_t>(level)] = v;
          self(self, level + 1, left - v);
        }
      };
      visit(visit, 0, degree);
    }
    return all;
  }();
  return list;
}

/// A polynomial in space and time, exponents to coefficient.
template <int D>
using Polynomial = std::map<std::array<int, D + 1>, double>;

template <int D>
Polynomial<D> derivative(const Polynomial<D>& p, int k) {
  Polynomial<D> out;
  for (const auto& [exponent, c] : p) {
    auto lower = exponent;
    const int power = lower[static_cast<std::size_t>(k)]--;
    if (power > 0) out[lower] += c * power;
  }
  return out;
}

template <int D>
using Field = std::array<Polynomial<D>, D>;

/// (div C : grad u) / (rho c^2), the operator of the equation of motion in scaled coordinates.
template <int D>
Field<D> acceleration(const Elastic<D>& m, const Field<D>& u) {
  Field<D> out;
  const double scale = 1.0 / (m.density * m.fastest * m.fastest);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k)
        for (int l = 0; l < D; ++l) {
          const double c = scale * m.stiffness[voigt<D>(i, j)][voigt<D>(k, l)];
          if (c == 0.0) continue;
          for (const auto& [exponent, value] : derivative<D>(derivative<D>(u[k], l), j))
            out[i][exponent] += c * value;
        }
  return out;
}

/// The solution with u = start (or, with `velocity`, u,t = start) at time zero.
template <int D>
Field<D> evolve(const Elastic<D>& m, Field<D> start, bool velocity) {
  Field<D> sum;
  double factor = 1.0;
  for (int power = velocity ? 1 : 0;; power += 2) {
    bool any = false;
    for (int i = 0; i < D; ++i)
      for (const auto& [exponent, c] : start[i]) {
        if (c == 0.0) continue;
        any = true;
        auto later = exponent;
        later[D] = power;
        sum[i][later] += factor * c;
      }
    if (!any) return sum;
    start = acceleration<D>(m, start);
    factor /= (power + 1.0) * (power + 2.0);
  }
}

}  // namespace

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

namespace {

/// Mean over elements of usual shape of the products of two monomials: equilateral simplices of unit edge
/// under a front at rest, all reflections of them and of time.
template <int D>
Block usual_mass(int degree, Arena& arena) {
  const int n = polynomial_count(D + 1, degree);
  const Block mass = take(arena, n, n), value = take(arena, n, lane_count);
  std::array<std::array<double, D>, D + 1> base{};  // corners, the pole first
  if constexpr (D == 1) base = {{{0.0}, {1.0}}};
  if constexpr (D == 2) base = {{{0.0, 0.0}, {0.9659, 0.2588}, {0.2588, 0.9659}}};
  if constexpr (D == 3)
    base = {{{0.0, 0.0, 0.0}, {0.0, 0.7071, 0.7071}, {0.7071, 0.0, 0.7071}, {0.7071, 0.7071, 0.0}}};
  std::array<std::array<double, D + 1>, D + 2> corner{};
  for (int c = 0; c < D + 2; ++c)
    for (int k = 0; k < D; ++k) corner[c][k] = base[c == D + 1 ? 0 : c][k];
  for (int c = 0; c < D + 2; ++c) corner[c][D] = c == 0 ? 0.0 : (c == D + 1 ? 0.7 : 0.35);
  std::array<double, D + 1> centre{};
  double length = 0.0;
  for (const auto& y : corner)
    for (int k = 0; k <= D; ++k) centre[k] += y[k] / (D + 2);
  for (const auto& y : corner) {
    double square = 0.0;
    for (int k = 0; k <= D; ++k) square += (y[k] - centre[k]) * (y[k] - centre[k]);
    length = std::max(length, std::sqrt(square));
  }
  const SimplexRule& rule = simplex_rule(D + 1, degree + 1);
  constexpr int images = 1 << (D + 1);
  for (int image = 0; image < images; ++image)
    for (int q = 0; q < rule.points; ++q) {
      base::Lanes x[D + 1];
      for (int k = 0; k <= D; ++k) {
        double sum = -centre[k];
        for (int c = 0; c < D + 2; ++c)
          sum += rule.barycentric[static_cast<std::size_t>(q * (D + 2) + c)] * corner[c][k];
        x[k] = base::Lanes((image >> k & 1 ? -1.0 : 1.0) * sum / length);
      }
      monomials<D>(x, degree, value.data, value.stride);
      const double w = rule.weight[static_cast<std::size_t>(q)] / images;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) mass.row(a)[b] += w * value.row(a)[0] * value.row(b)[0];
    }
  return mass;
}

}  // namespace

template <int D>
TrefftzTable<D>::TrefftzTable(const Elastic<D>& material, int p) : degree(p) {
  std::vector<Field<D>> functions;
  const auto& list = exponents<D + 1>();
  for (const auto& e : list) {
    int total = 0;
    for (int k = 0; k < D; ++k) total += e[k];
    if (e[D] != 0 || total > p) continue;
    for (int i = 0; i < D; ++i) {
      Field<D> start;
      start[i][e] = 1.0;
      if (total < p) functions.push_back(evolve<D>(material, start, true));
      if (total == 0) continue;  // translations are rigid
      if (total == 1) {          // of the gradients x_j e_i only the symmetric ones are not rotations
        int j = 0;
        while (e[j] == 0) ++j;
        if (j < i) continue;
        std::array<int, D + 1> other{};
        other[i] = 1;
        if (j != i) start[j][other] = 1.0;
      }
      functions.push_back(evolve<D>(material, start, false));
    }
  }
  count = static_cast<int>(functions.size());
  CLEAVE_ASSERT(count == unknown_count<D>({LocalSpace::trefftz, p}), "size of the Trefftz space");

  std::map<std::array<int, D + 1>, int> index;
  for (std::size_t a = 0; a < list.size(); ++a) index[list[a]] = static_cast<int>(a);
  const int n = polynomial_count(D + 1, p), below = polynomial_count(D + 1, p - 1);
  fields = take(memory, state_count<D> * below, count);
  all = take(memory, count, n * columns);
  const auto entry = [&](int f, int monomial, int column) -> double& {
    return all.row(f)[monomial * columns + column];
  };
  for (int f = 0; f < count; ++f) {
    const Field<D>& u = functions[static_cast<std::size_t>(f)];
    for (int i = 0; i < D; ++i)
      for (const auto& [e, c] : u[i]) entry(f, index.at(e), i) += c;
    const double velocity = std::sqrt(material.density) * material.fastest;
    for (int i = 0; i < D; ++i)
      for (const auto& [e, c] : derivative<D>(u[i], D)) entry(f, index.at(e), D + i) += velocity * c;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        for (const auto& [e, c] : derivative<D>(u[i], j)) {
          const int component = voigt<D>(i, j);
          const double part = i == j ? c : 0.5 * c;
          for (int k = 0; k < strain_count<D>; ++k)
            entry(f, index.at(e), 2 * D + k) += material.to_energy[k][component] * part;
        }
  }
  orthonormalise();
  for (int f = 0; f < count; ++f)
    for (int c = 0; c < state_count<D>; ++c)
      for (int a = 0; a < below; ++a) fields.row(c * below + a)[f] = entry(f, a, D + c);
  compress();
}

template <int D>
void TrefftzTable<D>::compress() {
  const int n = polynomial_count(D + 1, degree);
  const auto& list = exponents<D + 1>();
  place_.assign(static_cast<std::size_t>(n), 0);
  for (int parity = 0; parity < 1 << (D + 1); ++parity) {
    for (int a = 0; a < n; ++a) {
      int own = 0;
      for (int k = 0; k <= D; ++k)
        own |= (list[static_cast<std::size_t>(a)][static_cast<std::size_t>(k)] & 1) << k;
      if (own == parity) place_[static_cast<std::size_t>(a)] = spread_++;
    }
    spread_ = padded(spread_);
  }
  // Rounding of the orthonormalisation is no term.
  double largest = 0.0;
  for (int i = 0; i < count * all.stride; ++i) largest = std::max(largest, std::fabs(all.data[i]));
  std::vector<std::array<double, lane_count>> terms;
  for (int c = 0; c < components; ++c)
    for (int first = 0; first < spread_; first += lane_count) {
      Piece piece{static_cast<int>(terms.size()), 0};
      for (int f = 0; f < count; ++f) {
        std::array<double, lane_count> term{};
        bool any = false;
        for (int a = 0; a < n; ++a) {
          const int at = place_[static_cast<std::size_t>(a)] - first;
          const double value = all.row(f)[a * columns + c];
          if (at < 0 || at >= lane_count || std::fabs(value) < 1e-15 * largest) continue;
          term[static_cast<std::size_t>(at)] = value, any = true;
        }
        if (!any) continue;
        terms.push_back(term), function_.push_back(f), ++piece.count;
      }
      pieces_.push_back(piece);
    }
  terms_ = take(memory, static_cast<int>(terms.size()), lane_count);
  for (std::size_t t = 0; t < terms.size(); ++t)
    std::copy(terms[t].begin(), terms[t].end(), terms_.row(static_cast<int>(t)));
}

template <int D>
void TrefftzTable<D>::sum(const double* x, double* scratch, const Block& out) const {
  double* to = scratch;
  for (const Piece& piece : pieces_) {
    base::Lanes even(0.0), odd(0.0);
    const double* term = terms_.row(piece.first);
    const int* function = &function_[static_cast<std::size_t>(piece.first)];
    int t = 0;
    for (; t + 2 <= piece.count; t += 2, term += 2 * lane_count) {
      even = fma(base::Lanes(x[function[t]]), base::Lanes::load(term), even);
      odd = fma(base::Lanes(x[function[t + 1]]), base::Lanes::load(term + lane_count), odd);
    }
    if (t < piece.count) even = fma(base::Lanes(x[function[t]]), base::Lanes::load(term), even);
    (even + odd).store(to);
    to += lane_count;
  }
  for (int c = 0; c < components; ++c)
    for (int a = 0; a < out.columns; ++a)
      out.row(c)[a] = scratch[c * spread_ + place_[static_cast<std::size_t>(a)]];
}

/// Cholesky on the mean energy product, twice: the first round leaves the error of its own conditioning.
template <int D>
void TrefftzTable<D>::orthonormalise() {
  Arena arena;
  const int below = polynomial_count(D + 1, degree - 1);
  const Block mass = usual_mass<D>(degree - 1, arena);
  for (int round = 0; round < 2; ++round) {
    const Block gram = take(arena, count, count), step = take(arena, count, count);
    for (int c = 0; c < state_count<D>; ++c) {
      const Block part = take(arena, below, count), product = take(arena, below, count);
      for (int a = 0; a < below; ++a)
        for (int f = 0; f < count; ++f) part.row(a)[f] = all.row(f)[a * columns + D + c];
      multiply_add(1.0, mass, part, product);
      multiply_transposed_add(part, product, gram);
    }
    const bool ok = cholesky(gram);
    CLEAVE_ASSERT(ok, "Trefftz functions are independent");
    invert_upper(gram, step);
    const Block next = take(arena, count, all.columns);
    multiply_transposed_add(step, all, next);
    std::copy_n(next.data, static_cast<std::size_t>(next.rows) * static_cast<std::size_t>(next.stride),
                all.data);
  }
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
  const Block monomial = take_raw(arena, components, nu), u = take_raw(arena, D, nu),
              w = take_raw(arena, state_count<D>, n);
  table->sum(x, arena.take_raw(static_cast<std::size_t>(components * table->spread())), monomial);
  const Block of_u{monomial.data, D, nu, monomial.stride},
      of_w{monomial.row(D), state_count<D>, n, monomial.stride};  // one degree less
  if (change.data) {
    multiply(of_u, change, u);
    multiply(of_w, {change.data, n, n, change.stride}, w);
  } else {
    const auto& nodes = NodeTable<D + 1>::of(choice.degree);
    const Block value = monomials_at<D>(*this, corner.data(), D + 2, nodes.coordinate, choice.degree, arena),
                u_at = take_raw(arena, D, nu), w_at = take_raw(arena, state_count<D>, nu);
    multiply(of_u, value, u_at);
    multiply(of_w, {value.data, n, nu, value.stride}, w_at);
    multiply(u_at, nodes.restore, u);
    multiply(w_at, nodes.restore, w);
  }
  const double scale = 1.0 / std::sqrt(volume), root = 1.0 / std::sqrt(material->density);
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < nu; ++a)
      out.displacement[static_cast<std::size_t>(i * nu + a)] = scale * length * u.row(i)[a];
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < n; ++a) out.fields[static_cast<std::size_t>(i * n + a)] = scale * root * w.row(i)[a];
  for (int c = 0; c < strain_count<D>; ++c) {
    double* to = out.fields.data() + static_cast<std::ptrdiff_t>((D + c) * n);
    for (int d = 0; d < strain_count<D>; ++d) {
      const double s = scale * material->from_energy[c][d];
      if (s == 0.0) continue;
      for (int a = 0; a < n; ++a) to[a] += s * w.row(D + d)[a];
    }
  }
}

#define CLEAVE_INSTANTIATE(D)                                                                               \
  template struct TrefftzTable<D>;                                                                          \
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
