#include "machine.hpp"

#include <time.h>

#include <algorithm>

#include "base/array.hpp"
#include "base/lanes.hpp"

namespace cleave::bench {
namespace {

double seconds(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Shortest of `runs` timings of one thread [s].
template <class Body>
double best(int runs, const Body& body) {
  double least = 1e300;
  for (int r = 0; r < runs; ++r) {
    const double start = cpu_seconds();
    body();
    least = std::min(least, cpu_seconds() - start);
  }
  return least;
}

volatile double sink;

}  // namespace

double wall_seconds() {
  return seconds(CLOCK_MONOTONIC);
}
double cpu_seconds() {
  return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double fma_peak() {
  using base::Lanes;
  constexpr int chains = 12, count = 4000000;  // enough chains to hide the latency
  const double time = best(5, [] {
    Lanes a[chains];
    for (int i = 0; i < chains; ++i) a[i] = Lanes(1e-9 * i);
    const Lanes b(0.999999999), c(1e-9);
    for (int n = 0; n < count; ++n) {
#pragma GCC unroll 12
      for (int i = 0; i < chains; ++i) a[i] = fma(a[i], b, c);
    }
    double sum = 0.0;
    for (const Lanes& x : a) sum += base::sum(x);
    sink = sum;
  });
  return 2.0 * base::lane_count * chains * count / time;
}

double triad_bandwidth() {
  using base::Lanes;
  const std::size_t count = std::size_t{16} << 20;
  base::Array<double> a(count, 0.0), b(count, 1.0), c(count, 2.0);
  const double time = best(5, [&] {
    for (std::size_t i = 0; i < count; i += base::lane_count)
      (Lanes::load(&b[i]) + Lanes(3.0) * Lanes::load(&c[i])).store(&a[i]);
    sink = a[count / 2];
  });
  return 24.0 * static_cast<double>(count) / time;
}

}  // namespace cleave::bench
