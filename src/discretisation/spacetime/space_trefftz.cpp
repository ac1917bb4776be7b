#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/space.hpp"

namespace cleave::discretisation::spacetime {
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
void monomials(const std::array<double, D + 1>& x, int degree, double* value) {
  const auto& list = exponents<D + 1>();
  double power[D + 1][largest_degree + 1];
  for (int k = 0; k <= D; ++k) {
    power[k][0] = 1.0;
    for (int e = 1; e <= degree; ++e) power[k][e] = power[k][e - 1] * x[k];
  }
  const int n = polynomial_count(D + 1, degree);
  for (int a = 0; a < n; ++a) {
    double product = 1.0;
    for (int k = 0; k <= D; ++k) product *= power[k][list[static_cast<std::size_t>(a)][k]];
    value[a] = product;
  }
}

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
  displacement.assign(static_cast<std::size_t>(count) * D * static_cast<std::size_t>(n), 0.0);
  fields = take(memory, state_count<D> * below, count);
  for (int f = 0; f < count; ++f) {
    const Field<D>& u = functions[static_cast<std::size_t>(f)];
    for (int i = 0; i < D; ++i)
      for (const auto& [e, c] : u[i])
        displacement[static_cast<std::size_t>((f * D + i) * n + index.at(e))] += c;
    const double velocity = std::sqrt(material.density) * material.fastest;
    for (int i = 0; i < D; ++i)
      for (const auto& [e, c] : derivative<D>(u[i], D))
        fields.row(i * below + index.at(e))[f] += velocity * c;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        for (const auto& [e, c] : derivative<D>(u[i], j)) {
          const int component = voigt<D>(i, j);
          const double part = i == j ? c : 0.5 * c;
          for (int k = 0; k < strain_count<D>; ++k)
            fields.row((D + k) * below + index.at(e))[f] += material.to_energy[k][component] * part;
        }
  }
}

#define CLEAVE_INSTANTIATE(D)      \
  template struct TrefftzTable<D>; \
  template void monomials<D>(const std::array<double, D + 1>&, int, double*);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
