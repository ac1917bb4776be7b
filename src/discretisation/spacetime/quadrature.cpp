#include "discretisation/spacetime/quadrature.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/assert.hpp"

namespace cleave::discretisation::spacetime {
namespace {

constexpr int largest_dimension = 4, largest_count = 12;

struct Value {
  long double p, slope;
};

/// Jacobi polynomial P_n^(alpha, 0) and its derivative.
Value jacobi(int n, int alpha, long double x) {
  long double before = 1.0L, p = 0.5L * (alpha + (alpha + 2) * x), before_slope = 0.0L,
              slope = 0.5L * (alpha + 2);
  if (n == 0) return {1.0L, 0.0L};
  for (int k = 1; k < n; ++k) {
    const long double s = 2.0L * k + alpha, scale = 2.0L * (k + 1) * (k + alpha + 1) * s;
    const long double a = (s + 1) * (s + 2) * s / scale, b = (s + 1) * alpha * alpha / scale;
    const long double c = 2.0L * k * (k + alpha) * (s + 2) / scale;
    const long double next = (a * x + b) * p - c * before;
    const long double next_slope = a * p + (a * x + b) * slope - c * before_slope;
    before = p, p = next, before_slope = slope, slope = next_slope;
  }
  return {p, slope};
}

struct LineRule {
  std::vector<double> x, weight;  ///< on [0, 1], weight (1 - x)^alpha, sum one
};

/// Gauss-Jacobi points by Newton's method with the roots already found divided out.
LineRule gauss_jacobi(int n, int alpha) {
  LineRule rule;
  std::vector<long double> root;
  long double sum = 0.0L;
  std::vector<long double> weight;
  for (int i = 0; i < n; ++i) {
    long double x = -std::cos(std::numbers::pi_v<long double> * (2 * i + 1) / (2 * n));
    for (int step = 0; step < 100; ++step) {
      const Value v = jacobi(n, alpha, x);
      long double pull = 0.0L;
      for (const long double r : root) pull += 1.0L / (x - r);
      const long double move = v.p / (v.slope - pull * v.p);
      x -= move;
      if (std::fabs(move) < 1e-19L) break;
    }
    root.push_back(x);
    const Value v = jacobi(n, alpha, x);
    weight.push_back(1.0L / ((1.0L - x * x) * v.slope * v.slope));
    sum += weight.back();
  }
  for (int i = 0; i < n; ++i) {
    rule.x.push_back(static_cast<double>(0.5L * (1.0L + root[static_cast<std::size_t>(i)])));
    rule.weight.push_back(static_cast<double>(weight[static_cast<std::size_t>(i)] / sum));
  }
  return rule;
}

/// The last barycentric coordinate is x of the weight (1 - x)^(dimension - 1); the others share the rest as
/// the rule of one dimension less.
SimplexRule conical(int dimension, int n) {
  SimplexRule rule{dimension, 1, {1.0}, {1.0}};
  if (dimension == 0) return rule;
  const SimplexRule base = conical(dimension - 1, n);
  const LineRule line = gauss_jacobi(n, dimension - 1);
  rule = {dimension, base.points * n, {}, {}};
  for (int i = 0; i < n; ++i)
    for (int q = 0; q < base.points; ++q) {
      const auto at = static_cast<std::size_t>(i);
      for (int k = 0; k < dimension; ++k)
        rule.barycentric.push_back((1.0 - line.x[at]) *
                                   base.barycentric[static_cast<std::size_t>(q * dimension + k)]);
      rule.barycentric.push_back(line.x[at]);
      rule.weight.push_back(line.weight[at] * base.weight[static_cast<std::size_t>(q)]);
    }
  return rule;
}

}  // namespace

const SimplexRule& simplex_rule(int dimension, int per_direction) {
  CLEAVE_ASSERT(dimension >= 0 && dimension <= largest_dimension, "no rule of this dimension");
  CLEAVE_ASSERT(per_direction >= 1 && per_direction <= largest_count, "no rule of this degree");
  static const auto table = [] {
    std::array<std::vector<SimplexRule>, largest_dimension + 1> rules;
    for (int d = 0; d <= largest_dimension; ++d)
      for (int n = 1; n <= largest_count; ++n)
        // Rules of many points in four dimensions are large and never asked for.
        rules[static_cast<std::size_t>(d)].push_back(d == 4 && n > 8 ? SimplexRule{} : conical(d, n));
    return rules;
  }();
  const SimplexRule& rule =
      table[static_cast<std::size_t>(dimension)][static_cast<std::size_t>(per_direction - 1)];
  CLEAVE_ASSERT(rule.points > 0, "rule too large");
  return rule;
}

}  // namespace cleave::discretisation::spacetime
