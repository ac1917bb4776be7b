#pragma once
/// What the machine can do, measured the same way everywhere, and clocks that a shared machine does not
/// spoil.

namespace cleave::bench {

double wall_seconds();
double cpu_seconds();  ///< of all threads of the process

/// Fused multiply-adds of one thread at the widest lanes, best of several runs [flop/s].
double fma_peak();
/// a = b + s c over arrays larger than every cache, one thread, 24 bytes per element counted [byte/s].
double triad_bandwidth();

}  // namespace cleave::bench
