#include "discretisation/spacetime/vectors.hpp"

#include <array>
#include <utility>

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;
using base::Lanes;

/// Outputs held in registers: with a lane of inputs and a few to spare, what AVX-512 has.
constexpr int most_outputs = 24;

/// R outputs of a lane of vectors. Sums stay in registers only if the loops over them are unrolled.
template <int R>
void outputs(const double* t, std::ptrdiff_t stride, int inputs, const double* x, double* y) {
  Lanes sum[R];
#pragma GCC unroll 24
  for (int r = 0; r < R; ++r) sum[r] = Lanes(0.0);
  for (int k = 0; k < inputs; ++k) {
    const Lanes in = Lanes::load(x + k * lane_count);
    const double* row = t + k * stride;
#pragma GCC unroll 24
    for (int r = 0; r < R; ++r) sum[r] = fma(Lanes(row[r]), in, sum[r]);
  }
#pragma GCC unroll 24
  for (int r = 0; r < R; ++r) sum[r].store(y + r * lane_count);
}

using Outputs = void (*)(const double*, std::ptrdiff_t, int, const double*, double*);
template <int... R>
constexpr std::array<Outputs, sizeof...(R)> outputs_table(std::integer_sequence<int, R...>) {
  return {outputs<R + 1>...};
}
constexpr auto some_outputs = outputs_table(std::make_integer_sequence<int, most_outputs>{});

/// V lanes of outputs of one vector.
template <int V>
void lanes(const double* t, std::ptrdiff_t stride, int inputs, const double* x, double* y) {
  Lanes sum[V];
#pragma GCC unroll 16
  for (int v = 0; v < V; ++v) sum[v] = Lanes(0.0);
  for (int k = 0; k < inputs; ++k) {
    const Lanes in(x[k]);
    const double* row = t + k * stride;
#pragma GCC unroll 16
    for (int v = 0; v < V; ++v) sum[v] = fma(in, Lanes::load(row + v * lane_count), sum[v]);
  }
#pragma GCC unroll 16
  for (int v = 0; v < V; ++v) sum[v].store(y + v * lane_count);
}

template <int... V>
constexpr std::array<Outputs, sizeof...(V)> lanes_table(std::integer_sequence<int, V...>) {
  return {lanes<V + 1>...};
}
constexpr int most_lanes = 16;
constexpr auto some_lanes = lanes_table(std::make_integer_sequence<int, most_lanes>{});

}  // namespace

void multiply_vectors(const Block& t, const double* x, double* y, int width) {
  // Pieces of nearly equal size: short ones cannot hide the latency of a sum.
  if (width == 1) {
    const int all = padded(t.columns) / lane_count, pieces = (all + most_lanes - 1) / most_lanes;
    for (int p = 0, at = 0; p < pieces; ++p) {
      const int size = (all - at + pieces - p - 1) / (pieces - p);
      some_lanes[static_cast<std::size_t>(size - 1)](t.data + at * lane_count, t.stride, t.rows, x,
                                                     y + at * lane_count);
      at += size;
    }
    return;
  }
  const int pieces = (t.columns + most_outputs - 1) / most_outputs;
  for (int p = 0, at = 0; p < pieces; ++p) {
    const int size = (t.columns - at + pieces - p - 1) / (pieces - p);
    some_outputs[static_cast<std::size_t>(size - 1)](t.data + at, t.stride, t.rows, x, y + at * lane_count);
    at += size;
  }
}

}  // namespace cleave::discretisation::spacetime
