#pragma once
/// Small dense algebra of the patch solver: row-major blocks whose rows are padded to whole lanes.

#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include "base/lanes.hpp"

namespace cleave::discretisation::spacetime {

/// `n` rounded up to whole lanes.
constexpr int padded(int n) {
  return (n + 7) / 8 * 8;
}

/// Scratch memory that is handed out piece by piece and taken back all at once. After the first patches of
/// the largest size it asks the system for nothing.
class Arena {
 public:
  /// `count` doubles on a 64-byte boundary, all zero.
  double* take(std::size_t count);
  double* take_raw(std::size_t count);  ///< the same, not cleared: for what is written whole
  void release();                       ///< all of it
  std::size_t capacity() const { return capacity_; }

 private:
  struct Free {
    void operator()(double* p) const;
  };
  using Chunk = std::unique_ptr<double[], Free>;
  std::vector<Chunk> chunks_;
  std::size_t used_ = 0, room_ = 0, capacity_ = 0;
};

/// Loads and stores of lanes at any address.
inline base::Lanes load_any(const double* from) {
  base::Lanes r;
  std::memcpy(&r.v, from, sizeof r.v);
  return r;
}
inline void store_any(base::Lanes x, double* to) {
  std::memcpy(to, &x.v, sizeof x.v);
}
/// y += s x over whole lanes, both aligned.
inline void axpy(int width, double s, const double* x, double* y) {
  for (int j = 0; j < width; j += base::lane_count)
    fma(base::Lanes(s), base::Lanes::load(x + j), base::Lanes::load(y + j)).store(y + j);
}

/// A matrix inside an arena. Row i starts at data + i * stride; columns from `columns` to `stride` are zero.
struct Block {
  double* data = nullptr;
  int rows = 0, columns = 0, stride = 0;
  double* row(int i) const { return data + static_cast<std::ptrdiff_t>(i) * stride; }
};
Block take(Arena& arena, int rows, int columns);
/// The same, not cleared: for what is written whole. Padding may hold anything.
Block take_raw(Arena& arena, int rows, int columns);

/// c += sign a b.
void multiply_add(double sign, const Block& a, const Block& b, const Block& c);
/// c += a^T b.
void multiply_transposed_add(const Block& a, const Block& b, const Block& c);
/// c += scale a^T b.
void multiply_transposed_add(double scale, const Block& a, const Block& b, const Block& c);
/// c = a b.
void multiply(const Block& a, const Block& b, const Block& c);
/// c = a^T b.
void multiply_transposed(const Block& a, const Block& b, const Block& c);

/// y += t^T x for one vector, over `width` columns, a multiple of eight. @param t [inputs][outputs], aligned
void add_transposed(const double* t, std::ptrdiff_t stride, int inputs, int width, const double* x,
                    double* y);
/// The same over whole rows of t.
inline void add_transposed(const Block& t, const double* x, double* y) {
  add_transposed(t.data, t.stride, t.rows, t.stride, x, y);
}

/// LU with partial pivoting in place. False if a pivot vanishes. @param pivot [rows]
bool factor(const Block& a, int* pivot);
/// The same without exchanging rows, for matrices with a positive definite symmetric part: several times
/// faster where the columns of a panel are factored, since no pivot is searched for. False, with `a` spoiled,
/// if a multiplier grows large: then pivoting is needed.
bool factor_definite(const Block& a, int* pivot);
/// b <- a^-1 b for a factored a.
void solve(const Block& a, const int* pivot, const Block& b);
/// Upper Cholesky factor U, a = U^T U, in the upper triangle; the lower one is zeroed. False if a is not
/// positive definite to working precision.
bool cholesky(const Block& a);
/// out = U^-1 for an upper triangle U; out is zero on entry.
void invert_upper(const Block& u, const Block& out);

/// Eigenvalues and vectors of a symmetric matrix of at most 9 rows, Jacobi's method.
/// @param a [n][n], destroyed; @param vector [n][n], column k belongs to value[k]
void symmetric_eigen(int n, double* a, double* value, double* vector);

}  // namespace cleave::discretisation::spacetime
