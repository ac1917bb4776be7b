#include <algorithm>
#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "discretisation/spacetime/monomials.hpp"
#include "discretisation/spacetime/space.hpp"

namespace cleave::discretisation::spacetime {
using base::lane_count;

namespace {

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
  compress(material);
}

template <int D>
void TrefftzTable<D>::compress(const Elastic<D>& material) {
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
  // u / L, velocity and strain as they are. Rounding of the orthonormalisation is no term.
  const auto coefficient = [&](int f, int a, int c) {
    const double* of = all.row(f) + a * columns;
    if (c < 2 * D) return c < D ? of[c] : of[c] / std::sqrt(material.density);
    double strain = 0.0;
    for (int d = 0; d < strain_count<D>; ++d) strain += material.from_energy[c - 2 * D][d] * of[2 * D + d];
    return strain;
  };
  std::array<double, components> least{};
  for (int c = 0; c < components; ++c)
    for (int f = 0; f < count; ++f)
      for (int a = 0; a < n; ++a) least[c] = std::max(least[c], 1e-15 * std::fabs(coefficient(f, a, c)));
  const auto term_of = [&](int f, int a, int c) {
    const double value = coefficient(f, a, c);
    return std::fabs(value) < least[c] ? 0.0 : value;
  };
  std::vector<std::array<double, lane_count>> terms;
  for (int c = 0; c < components; ++c)
    for (int first = 0; first < spread_; first += lane_count) {
      Piece piece{static_cast<int>(terms.size()), 0};
      for (int f = 0; f < count; ++f) {
        std::array<double, lane_count> term{};
        bool any = false;
        for (int a = 0; a < n; ++a) {
          const int at = place_[static_cast<std::size_t>(a)] - first;
          if (at < 0 || at >= lane_count) continue;
          const double value = term_of(f, a, c);
          term[static_cast<std::size_t>(at)] = value, any = any || value != 0.0;
        }
        if (!any) continue;
        terms.push_back(term), function_.push_back(f), ++piece.count;
      }
      pieces_.push_back(piece);
    }
  terms_ = take(memory, static_cast<int>(terms.size()), lane_count);
  for (std::size_t t = 0; t < terms.size(); ++t)
    std::copy(terms[t].begin(), terms[t].end(), terms_.row(static_cast<int>(t)));
  for (int c = 0; c < components; ++c)
    for (int a = 0; a < n; ++a) {
      single_first_.push_back(static_cast<int>(singles_.size()));
      for (int f = 0; f < count; ++f)
        if (const double value = term_of(f, a, c); value != 0.0) singles_.push_back({f, value});
    }
  single_first_.push_back(static_cast<int>(singles_.size()));
}

/// Either way a sum is one chain over the functions in their order, zeros or none between: the same bits.
template <int D>
void TrefftzTable<D>::sum(const double* x, double* scratch, double* out, int width) const {
  const int n = polynomial_count(D + 1, degree);
  if (width == lane_count) {
    const Single* term = singles_.data();
    for (int s = 0; s < components * n; ++s) {
      base::Lanes sum(0.0);
      for (const Single* end = singles_.data() + single_first_[static_cast<std::size_t>(s) + 1]; term < end;
           ++term)
        sum = fma(base::Lanes(term->value), base::Lanes::load(x + term->function * lane_count), sum);
      sum.store(out + s * lane_count);
    }
    return;
  }
  double* to = scratch;
  for (const Piece& piece : pieces_) {
    base::Lanes sum(0.0);
    const double* term = terms_.row(piece.first);
    const int* function = &function_[static_cast<std::size_t>(piece.first)];
    for (int t = 0; t < piece.count; ++t, term += lane_count)
      sum = fma(base::Lanes(x[function[t]]), base::Lanes::load(term), sum);
    sum.store(to);
    to += lane_count;
  }
  for (int c = 0; c < components; ++c)
    for (int a = 0; a < n; ++a) out[c * n + a] = scratch[c * spread_ + place_[static_cast<std::size_t>(a)]];
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

template struct TrefftzTable<1>;
template struct TrefftzTable<2>;
template struct TrefftzTable<3>;

}  // namespace cleave::discretisation::spacetime
