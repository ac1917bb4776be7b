#include "discretisation/spacetime/basis.hpp"

#include <cmath>
#include <numeric>

#include "base/assert.hpp"
#include "discretisation/spacetime/monomials.hpp"
#include "discretisation/spacetime/quadrature.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// A number and its derivative in one direction.
struct Slope {
  double v = 0.0, d = 0.0;
  Slope() = default;
  Slope(double value, double derivative = 0.0) : v(value), d(derivative) {}  // NOLINT: a constant is a Slope
  friend Slope operator+(Slope a, Slope b) { return {a.v + b.v, a.d + b.d}; }
  friend Slope operator-(Slope a, Slope b) { return {a.v - b.v, a.d - b.d}; }
  friend Slope operator*(Slope a, Slope b) { return {a.v * b.v, a.v * b.d + a.d * b.v}; }
};

constexpr int rows = largest_degree + 1;

/// Coefficients of the three-term recurrence of P_n^(alpha, 0): P_n+1 = (a x + b) P_n - c P_n-1.
struct Recurrence {
  double a, b, c;
};

Recurrence recurrence(int n, int alpha) {
  if (n == 0) return {0.5 * (alpha + 2), 0.5 * alpha, 0.0};
  const double s = 2.0 * n + alpha, scale = 2.0 * (n + 1) * (n + alpha + 1) * s;
  return {(s + 1) * (s + 2) * s / scale, (s + 1) * alpha * alpha / scale,
          2.0 * n * (n + alpha) * (s + 2) / scale};
}

/// alpha = 2 (sum of the degrees before) + level - 1; the table spares the divisions.
const Recurrence& tabulated(int n, int alpha) {
  static const auto table = [] {
    std::array<std::array<Recurrence, rows>, 2 * largest_degree + 4> t;
    for (int al = 0; al < static_cast<int>(t.size()); ++al)
      for (int k = 0; k < rows; ++k)
        t[static_cast<std::size_t>(al)][static_cast<std::size_t>(k)] = recurrence(k, al);
    return t;
  }();
  return table[static_cast<std::size_t>(alpha)][static_cast<std::size_t>(n)];
}

}  // namespace

template <int M>
template <class Real>
void Basis<M>::evaluate_raw(const std::array<Real, M + 1>& barycentric, int degree, Real* value) const {
  // factor[level][sum of the degrees before][degree]: Jacobi polynomials made homogeneous, so that they stay
  // polynomials where the collapsed coordinates are singular.
  Real factor[M][rows][rows];
  Real sum = barycentric[0];
  for (int level = 0; level < M; ++level) {
    const Real x = barycentric[static_cast<std::size_t>(level + 1)] - sum;
    sum = sum + barycentric[static_cast<std::size_t>(level + 1)];
    for (int before = 0; before <= (level == 0 ? 0 : degree); ++before) {
      Real* p = factor[level][before];
      p[0] = 1.0;
      for (int n = 0; n + before < degree; ++n) {
        const Recurrence& r = tabulated(n, 2 * before + level);
        p[n + 1] = (Real(r.a) * x + Real(r.b) * sum) * p[n];
        if (n > 0) p[n + 1] = p[n + 1] - Real(r.c) * (sum * sum) * p[n - 1];
      }
    }
  }
  const int n = polynomial_count(M, degree);
  for (int a = 0; a < n; ++a) {
    Real product = norm_[static_cast<std::size_t>(a)];
    int before = 0;
    for (int level = 0; level < M; ++level) {
      const int k = index_[static_cast<std::size_t>(a)][static_cast<std::size_t>(level)];
      product = product * factor[level][before][k];
      before += k;
    }
    value[a] = product;
  }
}

template <int M>
Basis<M>::Basis() {
  index_ = exponents<M>();
  for (const auto& k : index_) degree_.push_back(std::accumulate(k.begin(), k.end(), 0));
  norm_.assign(count, 1.0);
  const SimplexRule& rule = simplex_rule(M, largest_degree + 1);
  std::vector<double> square(count, 0.0), value(count);
  for (int q = 0; q < rule.points; ++q) {
    evaluate(&rule.barycentric[static_cast<std::size_t>(q * (M + 1))], largest_degree, value.data());
    for (std::size_t a = 0; a < value.size(); ++a)
      square[a] += rule.weight[static_cast<std::size_t>(q)] * value[a] * value[a];
  }
  for (std::size_t a = 0; a < value.size(); ++a) norm_[a] = 1.0 / std::sqrt(square[a]);

  linear_.assign((M + 1) * (M + 1), 0.0);
  for (int q = 0; q < rule.points; ++q) {
    const double* at = &rule.barycentric[static_cast<std::size_t>(q * (M + 1))];
    evaluate(at, 1, value.data());
    for (int l = 0; l <= M; ++l)
      for (int a = 0; a <= M; ++a)
        linear_[static_cast<std::size_t>(l * (M + 1) + a)] +=
            rule.weight[static_cast<std::size_t>(q)] * at[l] * value[static_cast<std::size_t>(a)];
  }

  std::vector<Slope> slope(count);
  for (int l = 1; l <= M; ++l) {
    std::vector<double>& matrix = slope_[static_cast<std::size_t>(l - 1)];
    matrix.assign(static_cast<std::size_t>(count) * count, 0.0);
    for (int q = 0; q < rule.points; ++q) {
      std::array<Slope, M + 1> at;
      for (int k = 0; k <= M; ++k)
        at[static_cast<std::size_t>(k)] = {rule.barycentric[static_cast<std::size_t>(q * (M + 1) + k)],
                                           k == l ? 1.0 : (k == 0 ? -1.0 : 0.0)};
      evaluate_raw(at, largest_degree, slope.data());
      for (int a = 0; a < count; ++a)
        for (int b = 0; b < polynomial_count(M, degree_of(a) - 1); ++b)
          matrix[static_cast<std::size_t>(a * count + b)] += rule.weight[static_cast<std::size_t>(q)] *
                                                             slope[static_cast<std::size_t>(a)].d *
                                                             slope[static_cast<std::size_t>(b)].v;
    }
    std::vector<double>& transposed = weak_[static_cast<std::size_t>(l - 1)];
    transposed.assign(matrix.size(), 0.0);
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < count; ++b)
        transposed[static_cast<std::size_t>(b * count + a)] = matrix[static_cast<std::size_t>(a * count + b)];
  }
}

template <int M>
const Basis<M>& Basis<M>::get() {
  static const Basis basis;
  return basis;
}

template <int M>
void Basis<M>::evaluate(const double* barycentric, int degree, double* value) const {
  CLEAVE_ASSERT(degree >= 0 && degree <= largest_degree, "degree out of range");
  std::array<double, M + 1> at;
  for (int k = 0; k <= M; ++k) at[static_cast<std::size_t>(k)] = barycentric[k];
  evaluate_raw(at, degree, value);
}

template class Basis<1>;
template class Basis<2>;
template class Basis<3>;
template class Basis<4>;

}  // namespace cleave::discretisation::spacetime
