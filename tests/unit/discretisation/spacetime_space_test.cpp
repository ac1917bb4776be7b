// Building blocks of the spacetime elements: quadrature, orthonormal polynomials, dense algebra, local
// spaces.
#include "discretisation/spacetime/space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/dense.hpp"
#include "discretisation/spacetime/quadrature.hpp"
#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

/// Mean of the monomial lambda^a over a simplex: d! prod a_i! / (d + sum a_i)!.
double mean_of_monomial(const std::vector<int>& power) {
  const int d = static_cast<int>(power.size()) - 1;
  double value = std::tgamma(d + 1.0);
  int sum = d;
  for (const int p : power) value *= std::tgamma(p + 1.0), sum += p;
  return value / std::tgamma(sum + 1.0);
}

TEST(SpacetimeQuadrature, IntegratesItsDegreeExactly) {
  for (int d = 1; d <= 4; ++d)
    for (int n = 1; n <= 5; ++n) {
      const SimplexRule& rule = simplex_rule(d, n);
      std::vector<int> power(static_cast<std::size_t>(d + 1), 0);
      power[0] = n - 1, power[static_cast<std::size_t>(d)] = n;  // degree 2 n - 1
      double sum = 0.0;
      for (int q = 0; q < rule.points; ++q)
        sum += rule.weight[static_cast<std::size_t>(q)] *
               std::pow(rule.barycentric[static_cast<std::size_t>(q * (d + 1))], n - 1) *
               std::pow(rule.barycentric[static_cast<std::size_t>(q * (d + 1) + d)], n);
      EXPECT_NEAR(sum, mean_of_monomial(power), 1e-14) << d << " " << n;
    }
}

template <int M>
void expect_orthonormal(int degree) {
  const auto& basis = Basis<M>::get();
  const SimplexRule& rule = simplex_rule(M, degree + 1);
  const int n = polynomial_count(M, degree);
  std::vector<double> value(static_cast<std::size_t>(n)), gram(static_cast<std::size_t>(n * n), 0.0);
  for (int q = 0; q < rule.points; ++q) {
    basis.evaluate(&rule.barycentric[static_cast<std::size_t>(q * (M + 1))], degree, value.data());
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        gram[static_cast<std::size_t>(a * n + b)] += rule.weight[static_cast<std::size_t>(q)] *
                                                     value[static_cast<std::size_t>(a)] *
                                                     value[static_cast<std::size_t>(b)];
  }
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      EXPECT_NEAR(gram[static_cast<std::size_t>(a * n + b)], a == b ? 1.0 : 0.0, 1e-12);
}

TEST(SpacetimeBasis, IsOrthonormal) {
  expect_orthonormal<1>(6);
  expect_orthonormal<2>(6);
  expect_orthonormal<3>(6);
  expect_orthonormal<4>(5);
}

TEST(SpacetimeBasis, SlopesAreDerivatives) {
  const auto& basis = Basis<3>::get();
  const int n = polynomial_count(3, 5);
  std::vector<double> low(84), high(84), value(84);
  const double h = 1e-5;
  for (int l = 1; l <= 3; ++l) {
    double at[4] = {0.2, 0.3, 0.4, 0.1}, up[4], down[4];
    std::copy(at, at + 4, up), std::copy(at, at + 4, down);
    up[l] += h, up[0] -= h, down[l] -= h, down[0] += h;
    basis.evaluate(at, 5, value.data());
    basis.evaluate(up, 5, high.data());
    basis.evaluate(down, 5, low.data());
    for (int a = 0; a < n; ++a) {
      double slope = 0.0;
      for (int b = 0; b < n; ++b) slope += basis.slope(l, a)[b] * value[static_cast<std::size_t>(b)];
      EXPECT_NEAR(slope, (high[static_cast<std::size_t>(a)] - low[static_cast<std::size_t>(a)]) / (2 * h),
                  1e-6);
    }
  }
}

TEST(SpacetimeDense, FactorAndSolve) {
  for (const int n : {1, 7, 16, 20, 37, 50, 101}) {
    Arena arena;
    const Block a = take(arena, n, n), copy = take(arena, n, n), x = take(arena, n, 5), b = take(arena, n, 5);
    unsigned seed = 1;
    const auto random = [&] { return (seed = seed * 1664525u + 1013904223u) / 4294967296.0 - 0.5; };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) a.row(i)[j] = copy.row(i)[j] = random();
      for (int j = 0; j < 5; ++j) x.row(i)[j] = random();
    }
    multiply_add(1.0, a, x, b);
    std::vector<int> pivot(static_cast<std::size_t>(n));
    ASSERT_TRUE(factor(a, pivot.data()));
    solve(a, pivot.data(), b);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < 5; ++j) EXPECT_NEAR(b.row(i)[j], x.row(i)[j], 1e-10) << n;

    const Block gram = take(arena, n, n), upper = take(arena, n, n), inverse = take(arena, n, n);
    multiply_transposed_add(copy, copy, gram);
    for (int i = 0; i < n; ++i) gram.row(i)[i] += 1.0, std::copy_n(gram.row(i), n, upper.row(i));
    ASSERT_TRUE(cholesky(upper));
    invert_upper(upper, inverse);
    const Block half = take(arena, n, n), one = take(arena, n, n);  // U^-T (U^T U) U^-1
    multiply_add(1.0, gram, inverse, half);
    multiply_transposed_add(inverse, half, one);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) EXPECT_NEAR(one.row(i)[j], i == j ? 1.0 : 0.0, 1e-11) << n;
  }
}

TEST(SpacetimeElastic, RefusesWhatIsNotElastic) {
  Elastic<2> m;
  EXPECT_NE(make_isotropic<2>(0.0, 1.0, 0.3, PlaneKind::strain, m), "");
  EXPECT_NE(make_isotropic<2>(1.0, -1.0, 0.3, PlaneKind::strain, m), "");
  EXPECT_NE(make_isotropic<2>(1.0, 1.0, 0.5, PlaneKind::strain, m), "");
  EXPECT_NE(make_anisotropic<2>(1.0, {{{1.0, 2.0, 0.0}, {2.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}, m), "");
  EXPECT_NE(make_anisotropic<2>(1.0, {{{1.0, 0.2, 0.0}, {0.1, 1.0, 0.0}, {0.0, 0.0, 1.0}}}, m), "");
}

TEST(SpacetimeElastic, WaveSpeedsOfIsotropicMaterials) {
  // lambda = mu = rho = 1 in plane strain; plane stress has lambda 2/3; a bar has rho c^2 = E.
  Elastic<1> bar;
  Elastic<2> strain, stress;
  Elastic<3> solid;
  ASSERT_EQ(make_isotropic<1>(2.0, 8.0, 0.3, PlaneKind::stress, bar), "");
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::strain, strain), "");
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::stress, stress), "");
  ASSERT_EQ(make_isotropic<3>(1.0, 2.5, 0.25, PlaneKind::strain, solid), "");
  EXPECT_NEAR(bar.fastest, 2.0, 1e-12);
  EXPECT_NEAR(strain.fastest, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(stress.fastest, std::sqrt(8.0 / 3.0), 1e-12);
  EXPECT_NEAR(solid.fastest, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(solid.speeds({0.6, 0.0, 0.8})[0], 1.0, 1e-12);
  // The general square root gives the closed form of the isotropic impedance.
  Elastic<3> general;
  ASSERT_EQ(make_anisotropic<3>(1.0, solid.stiffness, general), "");
  const Vector<3> n{2.0 / 3, -2.0 / 3, 1.0 / 3};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(general.impedance(n)[i][j], solid.impedance(n)[i][j], 1e-12);
}

/// Condition number in the 2-norm by power iteration on K^T K and on its inverse.
double condition(const std::vector<double>& k, int n) {
  Arena arena;
  const Block a = take(arena, n, n), t = take(arena, n, n), fa = take(arena, n, n), ft = take(arena, n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double value = k[static_cast<std::size_t>(i * n + j)];
      a.row(i)[j] = fa.row(i)[j] = value, t.row(j)[i] = ft.row(j)[i] = value;
    }
  std::vector<int> pa(static_cast<std::size_t>(n)), pt(static_cast<std::size_t>(n));
  EXPECT_TRUE(factor(fa, pa.data()) && factor(ft, pt.data()));
  double largest = 0.0, inverse = 0.0;
  for (const bool back : {false, true}) {
    const Block x = take(arena, n, 1);
    for (int i = 0; i < n; ++i) x.row(i)[0] = 1.0 + 0.3 * std::sin(7.0 * i);
    for (int step = 0; step < 60; ++step) {
      double norm = 0.0;
      for (int i = 0; i < n; ++i) norm += x.row(i)[0] * x.row(i)[0];
      for (int i = 0; i < n; ++i) x.row(i)[0] /= std::sqrt(norm);
      if (back) {
        solve(fa, pa.data(), x);
        solve(ft, pt.data(), x);
      } else {
        const Block y = take(arena, n, 1), z = take(arena, n, 1);
        multiply_add(1.0, a, x, y);
        multiply_add(1.0, t, y, z);
        for (int i = 0; i < n; ++i) x.row(i)[0] = z.row(i)[0];
      }
      norm = 0.0;
      for (int i = 0; i < n; ++i) norm += x.row(i)[0] * x.row(i)[0];
      (back ? inverse : largest) = std::sqrt(std::sqrt(norm));
    }
  }
  return largest * inverse;
}

/// Section 3.4 of the specification: 8, 16, 31 for p = 1, 2, 3 with orthonormal polynomials and energy
/// scaling; raw monomials give 6e4, 4e8, 3e12. Trefftz functions are orthonormal on elements of usual shape
/// only, which costs two digits and no work. The units of a steel plate in metres and pascals change nothing.
TEST(SpacetimeSpace, PatchMatricesAreWellConditioned) {
  for (const double young : {2.5, 2.1e11})
    for (const SpaceChoice space :
         {SpaceChoice{LocalSpace::three_field, 1}, SpaceChoice{LocalSpace::three_field, 2},
          SpaceChoice{LocalSpace::three_field, 3}, SpaceChoice{LocalSpace::trefftz, 4}}) {
      Case<2> c;
      c.problem.materials.resize(1);
      ASSERT_EQ(make_isotropic<2>(young > 3.0 ? 7800.0 : 1.0, young, 0.25, PlaneKind::strain,
                                  c.problem.materials[0]),
                "");
      c.problem.spaces = {space};
      c.everywhere(make_traction<2>({}));
      March<2> run(box<2>({2, 2}, {1.0, 1.0}), c.problem);
      run.solver().keep_matrix = true;
      int largest = 0;
      double worst = 0.0;
      for (int step = 1; step <= 4; ++step) {
        run.march(0.3 * step / c.problem.materials[0].fastest);
        const int n = run.solver().unknowns();
        worst = std::max(worst, condition(run.solver().matrix(), n));
        largest = std::max(largest, n);
      }
      std::printf("space %d degree %d: %d unknowns, condition %.1f\n", static_cast<int>(space.space),
                  space.degree, largest, worst);
      EXPECT_LT(worst, space.space == LocalSpace::trefftz ? 1e4 : 40.0 * space.degree);
    }
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
