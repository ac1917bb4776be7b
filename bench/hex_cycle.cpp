/// Cost of one element-cycle of the one-point hexahedron: strain, von Mises law, hourglass control, force.
///
/// A copper bar of N elements flies into its own still half, so that plasticity, compression and hourglass
/// modes are all at work. Times are per element and cycle, of the element visit alone and of the whole cycle
/// with the nodal update, in CPU time of the best of several stretches.
///
/// usage: bench_hex_cycle [HOURGLASS_TYPE [KEYWORD: elastic | plastic]]

#include <cstdio>
#include <cstdlib>
#include <string>

#include "flying_bar.hpp"

using namespace cleave;

int main(int argc, char** argv) {
  const int hourglass = argc > 1 ? std::atoi(argv[1]) : 2;
  const bool plastic = argc < 3 || std::string(argv[2]) == "plastic";
  const double largest = argc > 3 ? std::atof(argv[3]) : 1e6;
  const auto law =
      bench::make_law(plastic ? "*MAT_PLASTIC_KINEMATIC\n1,8.93e-6,117.0,0.35,0.4,0.1,1.0\n0,0,0\n"
                              : "*MAT_ELASTIC\n1,8.93e-6,117.0,0.35\n");
  const double peak = bench::fma_peak(), triad = bench::triad_bandwidth();
  std::printf("machine, one thread: %.1f GFLOP/s fused multiply-add, %.1f GB/s triad\n", peak * 1e-9,
              triad * 1e-9);
  std::printf("hourglass type %d, %s\n", hourglass, plastic ? "MAT_PLASTIC_KINEMATIC" : "MAT_ELASTIC");
  std::printf("%10s %8s %12s %12s %12s %10s %12s\n", "elements", "threads", "visit ns", "cycle ns", "wall ns",
              "bytes/el", "of triad");
  for (const double wanted : {2e4, 5e4, 2e5, 1e6}) {
    if (wanted > largest) break;
    const auto m = bench::bar(wanted, law, hourglass);
    deck::Diagnostics diagnostics;
    const auto& solids = m.mesh.solids[0];
    const auto* entry = discretisation::find_formulation("SOLID", 1, solids.shape);
    const auto block = entry->build({m, 0, solids.shape, solids.id, solids.node}, diagnostics);
    const double count = static_cast<double>(solids.count());
    // Records of the points are read and written, the rest read: what a cycle must move from memory at least.
    const double moved = 2.0 * 8.0 * (9.0 + law->state_size()) + 8.0 * 5.0 + 16.0 + 1.1 * 9.0 * 8.0;
    for (const int threads : {1, 2}) {
      base::set_thread_count(threads);
      bench::Run run(m, *block);
      const auto cost = bench::measure(run, count);
      std::printf("%10.0f %8d %12.1f %12.1f %12.1f %10.0f %11.0f%%\n", count, threads, 1e9 * cost.visit,
                  1e9 * cost.cycle, 1e9 * cost.wall, block->bytes_per_element(),
                  100.0 * moved / cost.visit / triad);
      std::fflush(stdout);
    }
  }
  return 0;
}
