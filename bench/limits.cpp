/// Prints what the machine can do and what one visit of the one-point hexahedron asks of it, for other
/// benchmarks. One line: FMA peak [flop/s], triad bandwidth [byte/s], operations of a visit, of one thread
/// each.

#include <cstdio>

#include "flops.hpp"
#include "machine.hpp"

int main() {
  std::printf("%.6g %.6g %ld\n", cleave::bench::fma_peak(), cleave::bench::triad_bandwidth(),
              cleave::bench::hex_operations(0.1));
  return 0;
}
