#include "discretisation/spacetime/dense.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "base/lanes.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;
using base::Lanes;

/// Calls f.template operator()<r>() for a run-time r from 1 to 8.
template <class F>
void with_rows(int r, const F& f) {
  switch (r) {
    case 1:
      return f.template operator()<1>();
    case 2:
      return f.template operator()<2>();
    case 3:
      return f.template operator()<3>();
    case 4:
      return f.template operator()<4>();
    case 5:
      return f.template operator()<5>();
    case 6:
      return f.template operator()<6>();
    case 7:
      return f.template operator()<7>();
    default:
      return f.template operator()<8>();
  }
}

/// R rows by V lanes of c = sign a b or c += sign a b, held in registers. a(i, k) = a[i * by_row + k *
/// by_column].
template <bool Add, int R, int V>
void micro(int depth, double sign, const double* a, std::ptrdiff_t by_row, std::ptrdiff_t by_column,
           const double* b, std::ptrdiff_t b_stride, double* c, std::ptrdiff_t c_stride) {
  Lanes sum[R][V];
  for (int i = 0; i < R; ++i)
    for (int v = 0; v < V; ++v) sum[i][v] = Lanes(0.0);
  for (int k = 0; k < depth; ++k) {
    Lanes right[V];
    for (int v = 0; v < V; ++v) right[v] = Lanes::load(b + k * b_stride + v * lane_count);
    for (int i = 0; i < R; ++i) {
      const Lanes left(a[i * by_row + k * by_column]);
      for (int v = 0; v < V; ++v) sum[i][v] = fma(left, right[v], sum[i][v]);
    }
  }
  for (int i = 0; i < R; ++i)
    for (int v = 0; v < V; ++v) {
      double* at = c + i * c_stride + v * lane_count;
      (Add ? fma(Lanes(sign), sum[i][v], Lanes::load(at)) : Lanes(sign) * sum[i][v]).store(at);
    }
}

template <bool Add, int V>
void row_band(int rows, int depth, double sign, const double* a, std::ptrdiff_t by_row,
              std::ptrdiff_t by_column, const double* b, std::ptrdiff_t b_stride, double* c,
              std::ptrdiff_t c_stride) {
  // As few bands as eight rows at most allow, of nearly equal height: short ones cannot hide latency.
  for (int i = 0, bands = (rows + 7) / 8; bands > 0; --bands) {
    const int height = (rows - i + bands - 1) / bands;
    with_rows(height, [&]<int R>() {
      micro<Add, R, V>(depth, sign, a + i * by_row, by_row, by_column, b, b_stride, c + i * c_stride,
                       c_stride);
    });
    i += height;
  }
}

/// c += sign a b, or c = sign a b, over whole lanes of columns; `width` is a multiple of eight.
template <bool Add = true>
void product(int rows, int width, int depth, double sign, const double* a, std::ptrdiff_t by_row,
             std::ptrdiff_t by_column, const double* b, std::ptrdiff_t b_stride, double* c,
             std::ptrdiff_t c_stride) {
  if (rows <= 0 || (Add && depth <= 0)) return;
  int j = 0;
  for (; j + 24 <= width; j += 24)
    row_band<Add, 3>(rows, depth, sign, a, by_row, by_column, b + j, b_stride, c + j, c_stride);
  for (; j + 16 <= width; j += 16)
    row_band<Add, 2>(rows, depth, sign, a, by_row, by_column, b + j, b_stride, c + j, c_stride);
  for (; j < width; j += 8)
    row_band<Add, 1>(rows, depth, sign, a, by_row, by_column, b + j, b_stride, c + j, c_stride);
}

/// V lanes of y += sum_k x_k t_k. Few lanes take several rows at a time: a chain of sums would wait.
template <int V>
void add_rows(const double* t, std::ptrdiff_t stride, int rows, const double* x, double* y) {
  constexpr int chains = V >= 6 ? 1 : (V >= 3 ? 2 : 4);
  Lanes sum[chains][V];
  for (int c = 0; c < chains; ++c)
    for (int v = 0; v < V; ++v) sum[c][v] = Lanes(0.0);
  int k = 0;
  for (; k + chains <= rows; k += chains)
    for (int c = 0; c < chains; ++c) {
      const Lanes s(x[k + c]);
      const double* row = t + (k + c) * stride;
      for (int v = 0; v < V; ++v) sum[c][v] = fma(s, Lanes::load(row + v * lane_count), sum[c][v]);
    }
  for (; k < rows; ++k)
    for (int v = 0; v < V; ++v)
      sum[0][v] = fma(Lanes(x[k]), Lanes::load(t + k * stride + v * lane_count), sum[0][v]);
  for (int v = 0; v < V; ++v) {
    Lanes all = Lanes::load(y + v * lane_count);
    for (int c = 0; c < chains; ++c) all = all + sum[c][v];
    all.store(y + v * lane_count);
  }
}

/// Columns factored together before the rest of the matrix is updated, and rows solved together.
constexpr int panel = 16, rows_at_once = lane_count;

/// R rows of b, solved with the unit lower triangle at l.
template <int R>
void solve_lower(const double* l, std::ptrdiff_t l_stride, double* b, std::ptrdiff_t b_stride, int width) {
  for (int j = 0; j < width; j += lane_count) {
    Lanes x[R];
    for (int i = 0; i < R; ++i) x[i] = Lanes::load(b + i * b_stride + j);
    for (int i = 1; i < R; ++i) {
      for (int k = 0; k < i; ++k) x[i] = fma(Lanes(-l[i * l_stride + k]), x[k], x[i]);
      x[i].store(b + i * b_stride + j);
    }
  }
}

/// R rows of b, solved with the upper triangle at u.
template <int R>
void solve_upper(const double* u, std::ptrdiff_t u_stride, double* b, std::ptrdiff_t b_stride, int width) {
  double inverse[R];
  for (int i = 0; i < R; ++i) inverse[i] = 1.0 / u[i * u_stride + i];
  for (int j = 0; j < width; j += lane_count) {
    Lanes x[R];
    for (int i = 0; i < R; ++i) x[i] = Lanes::load(b + i * b_stride + j);
    for (int i = R - 1; i >= 0; --i) {
      for (int k = R - 1; k > i; --k) x[i] = fma(Lanes(-u[i * u_stride + k]), x[k], x[i]);
      x[i] = x[i] * Lanes(inverse[i]);
      x[i].store(b + i * b_stride + j);
    }
  }
}

/// Rows first .. last of b, `width` columns from the lane `column` on, solved with the unit lower triangle
/// of a.
void solve_lower_rows(const Block& a, int first, int last, const Block& b, int column, int width) {
  for (int i = first; i < last; i += rows_at_once) {
    const int rows = std::min(rows_at_once, last - i);
    product(rows, width, i - first, -1.0, a.row(i) + first, a.stride, 1, b.row(first) + column, b.stride,
            b.row(i) + column, b.stride);
    with_rows(rows,
              [&]<int R>() { solve_lower<R>(a.row(i) + i, a.stride, b.row(i) + column, b.stride, width); });
  }
}

/// Factors the columns of one lane from row `first` on; false if a pivot vanishes.
bool factor_lane(const Block& a, int first, int last, int* pivot) {
  const int n = a.rows;
  int best = first;
  double largest = std::fabs(a.row(first)[first]);
  for (int i = first + 1; i < n; ++i)
    if (const double x = std::fabs(a.row(i)[first]); x > largest) largest = x, best = i;
  for (int j = first; j < last; ++j) {
    pivot[j] = best;
    if (!(largest > 0.0)) return false;
    if (best != j) std::swap_ranges(a.row(j), a.row(j) + a.stride, a.row(best));
    const double inverse = 1.0 / a.row(j)[j];
    Lanes upper = Lanes::load(a.row(j) + first);
    for (int k = first; k <= j; ++k) upper.set(k - first, 0.0);
    // The multiplier is blended in: a scalar store would stall the next load of the whole lane.
    base::Mask here{};
    here.v[j - first] = -1;
    best = j + 1, largest = -1.0;
    for (int i = j + 1; i < n; ++i) {
      double* row = a.row(i);
      const double s = row[j] * inverse;
      select(here, Lanes(s), fma(Lanes(-s), upper, Lanes::load(row + first))).store(row + first);
      if (j + 1 < last)
        if (const double x = std::fabs(row[j + 1]); x > largest) largest = x, best = i;
    }
  }
  return true;
}

/// Multipliers of a factorisation without exchanges beyond which digits are lost.
constexpr double largest_multiplier = 256.0;

/// The columns of one lane from row `first` on without exchanges: the block on the diagonal, then the rows
/// below times the inverse of its upper triangle.
bool factor_block(const Block& a, int first, int last) {
  const int m = last - first;
  // In registers; a block of fewer rows is completed to a unit matrix.
  Lanes x[lane_count], right[lane_count];
  double inverse[lane_count];
  for (int i = 0; i < lane_count; ++i) {
    right[i] = Lanes(0.0);
    right[i].set(i, 1.0);
    x[i] = i < m ? Lanes::load(a.row(first + i) + first) : right[i];
    for (int k = m; i < m && k < lane_count; ++k) x[i].set(k, 0.0);
  }
  bool fine = true;
#pragma GCC unroll 8
  for (int j = 0; j < lane_count; ++j) {
    base::Mask here{};
    here.v[j] = -1;
    fine = fine && std::fabs(x[j][j]) > 0.0;
    inverse[j] = 1.0 / x[j][j];
    Lanes upper = x[j];
#pragma GCC unroll 8
    for (int k = 0; k <= j; ++k) upper.set(k, 0.0);
#pragma GCC unroll 8
    for (int i = j + 1; i < lane_count; ++i) {
      const double s = x[i][j] * inverse[j];
      fine = fine && std::fabs(s) <= largest_multiplier;
      x[i] = select(here, Lanes(s), fma(Lanes(-s), upper, x[i]));
    }
  }
  if (!fine) return false;
  for (int i = 0; i < m; ++i) x[i].store(a.row(first + i) + first);
    // The inverse of the upper triangle.
#pragma GCC unroll 8
  for (int k = lane_count - 1; k >= 0; --k) {
#pragma GCC unroll 8
    for (int l = k + 1; l < lane_count; ++l) right[k] = fma(Lanes(-x[k][l]), right[l], right[k]);
    right[k] = right[k] * Lanes(inverse[k]);
  }
  Lanes worst(0.0);
  const auto rows = [&]<int R>(int i) {
    Lanes sum[R];
    for (int r = 0; r < R; ++r) sum[r] = Lanes(0.0);
    for (int k = 0; k < m; ++k)
      for (int r = 0; r < R; ++r) sum[r] = fma(Lanes(a.row(i + r)[first + k]), right[k], sum[r]);
    for (int r = 0; r < R; ++r) {
      worst = max(worst, max(sum[r], -sum[r]));
      sum[r].store(a.row(i + r) + first);
    }
  };
  int i = last;
  for (; i + 8 <= a.rows; i += 8) rows.template operator()<8>(i);
  for (; i + 2 <= a.rows; i += 2) rows.template operator()<2>(i);
  for (; i < a.rows; ++i) rows.template operator()<1>(i);
  for (int k = 0; k < m; ++k)
    if (!(worst[k] <= largest_multiplier)) return false;
  return true;
}

}  // namespace

void Arena::Free::operator()(double* p) const {
  ::operator delete[](p, std::align_val_t{64});
}

double* Arena::take(std::size_t count) {
  double* at = take_raw(count);
  std::memset(at, 0, count * sizeof(double));
  return at;
}

double* Arena::take_raw(std::size_t count) {
  count = (count + 7) / 8 * 8;
  if (used_ + count > room_) {
    room_ = std::max<std::size_t>(count, std::max<std::size_t>(capacity_, 4096));
    chunks_.emplace_back(
        static_cast<double*>(::operator new[](room_ * sizeof(double), std::align_val_t{64})));
    capacity_ += room_;
    used_ = 0;
  }
  double* at = chunks_.back().get() + used_;
  used_ += count;
  return at;
}

void Arena::release() {
  if (chunks_.size() > 1) {  // one piece of the whole size from now on
    chunks_.clear();
    room_ = capacity_;
    chunks_.emplace_back(
        static_cast<double*>(::operator new[](room_ * sizeof(double), std::align_val_t{64})));
  }
  used_ = 0;
}

Block take(Arena& arena, int rows, int columns) {
  const int stride = padded(columns);
  return {arena.take(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride)), rows, columns,
          stride};
}

Block take_raw(Arena& arena, int rows, int columns) {
  const int stride = padded(columns);
  return {arena.take_raw(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride)), rows, columns,
          stride};
}

void multiply_add(double sign, const Block& a, const Block& b, const Block& c) {
  product(c.rows, c.stride, a.columns, sign, a.data, a.stride, 1, b.data, b.stride, c.data, c.stride);
}

void multiply_transposed_add(const Block& a, const Block& b, const Block& c) {
  product(c.rows, c.stride, a.rows, 1.0, a.data, 1, a.stride, b.data, b.stride, c.data, c.stride);
}

void multiply_transposed_add(double scale, const Block& a, const Block& b, const Block& c) {
  product(c.rows, c.stride, a.rows, scale, a.data, 1, a.stride, b.data, b.stride, c.data, c.stride);
}

void multiply(const Block& a, const Block& b, const Block& c) {
  product<false>(c.rows, c.stride, a.columns, 1.0, a.data, a.stride, 1, b.data, b.stride, c.data, c.stride);
}

void multiply_transposed(const Block& a, const Block& b, const Block& c) {
  product<false>(c.rows, c.stride, a.rows, 1.0, a.data, 1, a.stride, b.data, b.stride, c.data, c.stride);
}

void add_transposed(const double* t, std::ptrdiff_t stride, int inputs, int width, const double* x,
                    double* y) {
  int j = 0;
  const auto widths = [&]<int V>() {
    for (; j + V * lane_count <= width; j += V * lane_count) add_rows<V>(t + j, stride, inputs, x, y + j);
  };
  widths.operator()<10>();
  widths.operator()<8>();
  widths.operator()<6>();
  widths.operator()<5>();
  widths.operator()<4>();
  widths.operator()<3>();
  widths.operator()<2>();
  widths.operator()<1>();
}

bool factor_definite(const Block& a, int* pivot) {
  const int n = a.rows;
  for (int i = 0; i < n; ++i) pivot[i] = i;
  for (int first = 0; first < n; first += panel) {
    const int middle = std::min(first + lane_count, n), last = std::min(first + panel, n);
    if (!factor_block(a, first, middle)) return false;
    if (last > middle) {
      solve_lower_rows(a, first, middle, a, middle, lane_count);
      product(n - middle, lane_count, middle - first, -1.0, a.row(middle) + first, a.stride, 1,
              a.row(first) + middle, a.stride, a.row(middle) + middle, a.stride);
      if (!factor_block(a, middle, last)) return false;
    }
    const int right = a.stride - first - panel;
    if (right <= 0) continue;
    solve_lower_rows(a, first, last, a, first + panel, right);
    product(n - last, right, last - first, -1.0, a.row(last) + first, a.stride, 1,
            a.row(first) + first + panel, a.stride, a.row(last) + first + panel, a.stride);
  }
  return true;
}

bool factor(const Block& a, int* pivot) {
  const int n = a.rows;
  for (int first = 0; first < n; first += panel) {
    const int middle = std::min(first + lane_count, n), last = std::min(first + panel, n);
    if (!factor_lane(a, first, middle, pivot)) return false;
    if (last > middle) {
      solve_lower_rows(a, first, middle, a, middle, lane_count);
      product(n - middle, lane_count, middle - first, -1.0, a.row(middle) + first, a.stride, 1,
              a.row(first) + middle, a.stride, a.row(middle) + middle, a.stride);
      if (!factor_lane(a, middle, last, pivot)) return false;
    }
    const int right = a.stride - first - panel;
    if (right <= 0) continue;
    solve_lower_rows(a, first, last, a, first + panel, right);
    product(n - last, right, last - first, -1.0, a.row(last) + first, a.stride, 1,
            a.row(first) + first + panel, a.stride, a.row(last) + first + panel, a.stride);
  }
  return true;
}

void solve(const Block& a, const int* pivot, const Block& b) {
  const int n = a.rows;
  for (int i = 0; i < n; ++i)
    if (pivot[i] != i) std::swap_ranges(b.row(i), b.row(i) + b.stride, b.row(pivot[i]));
  solve_lower_rows(a, 0, n, b, 0, b.stride);
  for (int first = (n - 1) / rows_at_once * rows_at_once; first >= 0; first -= rows_at_once) {
    const int last = std::min(first + rows_at_once, n);
    if (last < n)
      product(last - first, b.stride, n - last, -1.0, a.row(first) + last, a.stride, 1, b.row(last), b.stride,
              b.row(first), b.stride);
    with_rows(last - first, [&]<int R>() {
      solve_upper<R>(a.row(first) + first, a.stride, b.row(first), b.stride, b.stride);
    });
  }
}

}  // namespace cleave::discretisation::spacetime
