#pragma once
/// Monomials in spacetime, for the Trefftz functions, and the list of exponents that every basis shares.

#include <array>
#include <vector>

#include "base/lanes.hpp"
#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {

/// Exponents in M variables of every total degree up to the largest, sorted by degree, lexical within one.
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

/// Monomials of D + 1 scaled coordinates up to `degree`, sorted by degree, eight points at a time.
/// @param x     [D + 1] @param value [monomials], `stride` doubles from one to the next
template <int D>
void monomials(const base::Lanes* x, int degree, double* value, std::ptrdiff_t stride);

}  // namespace cleave::discretisation::spacetime
