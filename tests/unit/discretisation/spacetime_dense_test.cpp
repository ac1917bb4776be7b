// Small dense algebra of the patch solver: factorisations with and without pivots, products by rows.
#include <gtest/gtest.h>

#include <cmath>

#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/dense.hpp"
#include "discretisation/spacetime/space.hpp"
#include "discretisation/spacetime/vectors.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

/// Numbers in (-1, 1) without a pattern.
double noise(int i) {
  const double x = std::sin(12.9898 * (i + 1)) * 43758.5453;
  return 2.0 * (x - std::floor(x)) - 1.0;
}

/// A unit matrix, a symmetric part of at most half of it, and a skew part several times larger.
Block definite(int n, Arena& arena) {
  const Block a = take(arena, n, n);
  for (int i = 0; i < n; ++i) {
    a.row(i)[i] = 1.0;
    for (int j = 0; j < i; ++j) {
      const double even = 0.5 / n * noise(n * i + j), odd = 4.0 / std::sqrt(n) * noise(n * j + i);
      a.row(i)[j] = even + odd, a.row(j)[i] = even - odd;
    }
  }
  return a;
}

TEST(SpacetimeDense, FactorisationsSolve) {
  for (const int n : {1, 3, 8, 9, 16, 20, 33, 47, 64, 100}) {
    for (const bool pivots : {true, false}) {
      Arena arena;
      const Block a = definite(n, arena), original = definite(n, arena), b = take(arena, n, 3);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          for (int c = 0; c < 3; ++c) b.row(i)[c] += original.row(i)[j] * noise(7 * j + c);
      std::vector<int> pivot(static_cast<std::size_t>(n));
      ASSERT_TRUE(pivots ? factor(a, pivot.data()) : factor_definite(a, pivot.data())) << n;
      solve(a, pivot.data(), b);
      for (int i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(b.row(i)[c], noise(7 * i + c), 1e-12) << n << " " << pivots;
    }
  }
}

TEST(SpacetimeDense, SaysWherePivotsAreNeeded) {
  for (const double corner : {0.0, 1e-4}) {
    for (const int n : {2, 12, 30}) {
      Arena arena;
      std::vector<int> pivot(static_cast<std::size_t>(n));
      const auto turn = [&] {  // a rotation by nearly a right angle in the last two rows
        const Block a = take(arena, n, n);
        for (int i = 0; i < n; ++i) a.row(i)[i] = i < n - 2 ? 1.0 : corner;
        a.row(n - 2)[n - 1] = 1.0, a.row(n - 1)[n - 2] = -1.0;
        return a;
      };
      EXPECT_FALSE(factor_definite(turn(), pivot.data()));
      EXPECT_TRUE(factor(turn(), pivot.data()));
    }
  }
}

TEST(SpacetimeDense, AddsRows) {
  Arena arena;
  for (const int width : {8, 24, 40, 88, 136}) {
    const Block t = take(arena, 13, width);
    double x[13];
    double* y = arena.take(static_cast<std::size_t>(width));
    for (int i = 0; i < 13; ++i) {
      x[i] = noise(i);
      for (int j = 0; j < width; ++j) t.row(i)[j] = noise(100 * i + j);
    }
    y[3] = 2.0;
    add_transposed(t, x, y);
    for (int j = 0; j < width; ++j) {
      double sum = j == 3 ? 2.0 : 0.0;
      for (int i = 0; i < 13; ++i) sum += x[i] * t.row(i)[j];
      EXPECT_NEAR(y[j], sum, 1e-14);
    }
  }
}

TEST(SpacetimeDense, SparseSumsOfTrefftzFunctions) {
  Elastic<2> isotropic, other;
  ASSERT_EQ(make_isotropic<2>(2.0, 3.0, 0.3, PlaneKind::strain, isotropic), "");
  ASSERT_EQ(make_anisotropic<2>(1.0, {{{3.0, 1.0, 0.3}, {1.0, 2.0, 0.1}, {0.3, 0.1, 1.0}}}, other), "");
  for (const Elastic<2>* m : {&isotropic, &other})
    for (const int degree : {2, 4, 6}) {
      const TrefftzTable<2> table(*m, degree);
      Arena arena;
      const int n = polynomial_count(3, degree), c = TrefftzTable<2>::components;
      double* x = arena.take(static_cast<std::size_t>(table.count));
      for (int f = 0; f < table.count; ++f) x[f] = noise(f);
      const auto scratch = static_cast<std::size_t>(c * table.spread()),
                 size = static_cast<std::size_t>(c * n);
      double *out = arena.take(size), *wide = arena.take(8 * size),
             *many = arena.take(8 * static_cast<std::size_t>(table.count));
      table.sum(x, arena.take(scratch), out, 1);
      for (int f = 0; f < table.count; ++f) many[8 * f + 3] = x[f], many[8 * f + 5] = -x[f];
      table.sum(many, nullptr, wide, 8);
      for (int i = 0; i < c; ++i)
        for (int a = 0; a < n; ++a) {
          double sum = 0.0;
          for (int f = 0; f < table.count; ++f) {
            const double* of = table.all.row(f) + a * table.columns;
            double value = i < 2 ? of[i] : of[i] / std::sqrt(m->density);
            if (i >= 4) {
              value = 0.0;
              for (std::size_t d = 0; d < 3; ++d)
                value += m->from_energy[static_cast<std::size_t>(i - 4)][d] * of[4 + d];
            }
            sum += x[f] * value;
          }
          const int at = i * n + a;
          EXPECT_NEAR(out[at], sum, 1e-11 * (1.0 + std::fabs(sum)));
          EXPECT_EQ(wide[8 * at + 3], out[at]);
          EXPECT_EQ(wide[8 * at + 5], -out[at]);
          EXPECT_EQ(wide[8 * at], 0.0);
        }
    }
}

TEST(SpacetimeDense, VectorsHaveTheSameBitsInAnyCompany) {
  for (const int columns : {1, 3, 8, 20, 25, 49, 95, 150}) {
    Arena arena;
    const int rows = 31;
    const Block t = take(arena, rows, columns);
    double *x = arena.take(8 * rows), *y = arena.take(8 * static_cast<std::size_t>(t.stride)),
           *one = arena.take(rows), *alone = arena.take(static_cast<std::size_t>(t.stride));
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) t.row(i)[j] = noise(100 * i + j);
      for (int v = 0; v < 8; ++v) x[8 * i + v] = noise(7 * i + 1000 * v);
    }
    multiply_vectors(t, x, y, 8);
    for (int v = 0; v < 8; ++v) {
      for (int i = 0; i < rows; ++i) one[i] = x[8 * i + v];
      multiply_vectors(t, one, alone, 1);
      for (int j = 0; j < columns; ++j) {
        double sum = 0.0;
        for (int i = 0; i < rows; ++i) sum += one[i] * t.row(i)[j];
        EXPECT_NEAR(alone[j], sum, 1e-13);
        EXPECT_EQ(alone[j], y[8 * j + v]) << columns << " columns, vector " << v;
      }
    }
  }
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
