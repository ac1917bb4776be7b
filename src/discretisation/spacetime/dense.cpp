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
  int i = 0;
  for (; i + 8 <= rows; i += 8)
    micro<Add, 8, V>(depth, sign, a + i * by_row, by_row, by_column, b, b_stride, c + i * c_stride, c_stride);
  const auto rest = [&]<int R>() {
    micro<Add, R, V>(depth, sign, a + i * by_row, by_row, by_column, b, b_stride, c + i * c_stride, c_stride);
  };
  switch (rows - i) {
    case 1:
      return rest.template operator()<1>();
    case 2:
      return rest.template operator()<2>();
    case 3:
      return rest.template operator()<3>();
    case 4:
      return rest.template operator()<4>();
    case 5:
      return rest.template operator()<5>();
    case 6:
      return rest.template operator()<6>();
    case 7:
      return rest.template operator()<7>();
    default:
      return;
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

constexpr int panel = 16;

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

bool factor(const Block& a, int* pivot) {
  const int n = a.rows;
  for (int first = 0; first < n; first += panel) {
    const int last = std::min(first + panel, n), wide = std::min(first + panel, a.stride);
    for (int j = first; j < last; ++j) {
      int best = j;
      for (int i = j + 1; i < n; ++i)
        if (std::fabs(a.row(i)[j]) > std::fabs(a.row(best)[j])) best = i;
      pivot[j] = best;
      if (!(std::fabs(a.row(best)[j]) > 0.0)) return false;
      if (best != j) std::swap_ranges(a.row(j), a.row(j) + a.stride, a.row(best));
      const double inverse = 1.0 / a.row(j)[j];
      // Only the columns of the panel are updated now; those left of j in the same lane keep their factors.
      const int lane = j / lane_count * lane_count;
      for (int i = j + 1; i < n; ++i) {
        double* row = a.row(i);
        const double s = row[j] * inverse;
        for (int k = j + 1; k < std::min(lane + lane_count, wide); ++k) row[k] -= s * a.row(j)[k];
        for (int k = lane + lane_count; k < wide; k += lane_count)
          axpy(lane_count, -s, a.row(j) + k, row + k);
        row[j] = s;
      }
    }
    if (last >= a.stride) continue;
    const int right = a.stride - wide;
    for (int i = first + 1; i < last; ++i)
      for (int k = first; k < i; ++k) axpy(right, -a.row(i)[k], a.row(k) + wide, a.row(i) + wide);
    product(n - last, right, last - first, -1.0, a.row(last) + first, a.stride, 1, a.row(first) + wide,
            a.stride, a.row(last) + wide, a.stride);
  }
  return true;
}

void solve(const Block& a, const int* pivot, const Block& b) {
  const int n = a.rows;
  for (int i = 0; i < n; ++i)
    if (pivot[i] != i) std::swap_ranges(b.row(i), b.row(i) + b.stride, b.row(pivot[i]));
  for (int first = 0; first < n; first += panel) {
    const int last = std::min(first + panel, n);
    for (int i = first + 1; i < last; ++i)
      for (int k = first; k < i; ++k) axpy(b.stride, -a.row(i)[k], b.row(k), b.row(i));
    product(n - last, b.stride, last - first, -1.0, a.row(last) + first, a.stride, 1, b.row(first), b.stride,
            b.row(last), b.stride);
  }
  for (int first = (n - 1) / panel * panel; first >= 0; first -= panel) {
    const int last = std::min(first + panel, n);
    for (int i = last - 1; i >= first; --i) {
      for (int k = i + 1; k < last; ++k) axpy(b.stride, -a.row(i)[k], b.row(k), b.row(i));
      const Lanes inverse(1.0 / a.row(i)[i]);
      for (int j = 0; j < b.stride; j += lane_count)
        (Lanes::load(b.row(i) + j) * inverse).store(b.row(i) + j);
    }
    product(first, b.stride, last - first, -1.0, a.data + first, a.stride, 1, b.row(first), b.stride, b.data,
            b.stride);
  }
}

bool cholesky(const Block& a) {
  const int n = a.rows;
  for (int k = 0; k < n; ++k) {
    double* pivot = a.row(k);
    if (!(pivot[k] > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(pivot[k]);
    for (int j = 0; j < k; ++j) pivot[j] = 0.0;
    for (int j = k / lane_count * lane_count; j < a.stride; j += lane_count)
      (Lanes::load(pivot + j) * Lanes(inverse)).store(pivot + j);
    for (int i = k + 1; i < n; ++i) {
      const int from = i / lane_count * lane_count;
      axpy(a.stride - from, -pivot[i], pivot + from, a.row(i) + from);
    }
  }
  return true;
}

void invert_upper(const Block& u, const Block& out) {
  for (int i = u.rows - 1; i >= 0; --i) {
    double* row = out.row(i);
    row[i] = 1.0;
    for (int k = i + 1; k < u.rows; ++k) {
      const int from = k / lane_count * lane_count;
      axpy(u.stride - from, -u.row(i)[k], out.row(k) + from, row + from);
    }
    const double inverse = 1.0 / u.row(i)[i];
    for (int j = 0; j < u.stride; ++j) row[j] *= inverse;
  }
}

void symmetric_eigen(int n, double* a, double* value, double* vector) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) vector[i * n + j] = i == j ? 1.0 : 0.0;
  for (int sweep = 0; sweep < 60; ++sweep) {
    double off = 0.0, all = 0.0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) (i == j ? all : off) += a[i * n + j] * a[i * n + j];
    if (off <= 1e-34 * all || off == 0.0) break;
    for (int p = 0; p < n; ++p)
      for (int q = p + 1; q < n; ++q) {
        if (a[p * n + q] == 0.0) continue;
        const double theta = (a[q * n + q] - a[p * n + p]) / (2.0 * a[p * n + q]);
        const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (int k = 0; k < n; ++k) {
          const double x = a[k * n + p], y = a[k * n + q];
          a[k * n + p] = c * x - s * y, a[k * n + q] = s * x + c * y;
        }
        for (int k = 0; k < n; ++k) {
          const double x = a[p * n + k], y = a[q * n + k];
          a[p * n + k] = c * x - s * y, a[q * n + k] = s * x + c * y;
        }
        for (int k = 0; k < n; ++k) {
          const double x = vector[k * n + p], y = vector[k * n + q];
          vector[k * n + p] = c * x - s * y, vector[k * n + q] = s * x + c * y;
        }
      }
  }
  for (int i = 0; i < n; ++i) value[i] = a[i * n + i];
}

}  // namespace cleave::discretisation::spacetime
