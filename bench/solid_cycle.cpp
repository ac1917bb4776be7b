/// Cost of one element-cycle of every solid formulation, on the bar of hex_cycle cut into its shape.
///
/// usage: bench_solid_cycle [CELLS: hexahedra before they are cut, default 20000]

#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

#include "flying_bar.hpp"

namespace {

using namespace cleave;
using model::Index;

/// Hexahedra into Kuhn's six tetrahedra or two wedges; quadratic tetrahedra get straight mid nodes.
void cut(model::Model& m, model::Shape shape) {
  static constexpr int tets[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                     {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  static constexpr int wedges[2][6] = {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}};
  static constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  if (shape == model::Shape::hex8) return;
  const auto hexes = m.mesh.solids[0];
  auto& solids = m.mesh.solids[0];
  solids = {};
  solids.shape = shape;
  std::map<std::pair<Index, Index>, Index> middle;
  const auto between = [&](Index a, Index b) {
    const auto [at, is_new] =
        middle.try_emplace(std::minmax(a, b), static_cast<Index>(m.mesh.nodes.id.size()));
    if (!is_new) return at->second;
    auto& x = m.mesh.nodes.position;
    m.mesh.nodes.id.push_back(static_cast<model::Id>(m.mesh.nodes.id.size()) + 1);
    for (std::size_t i = 0; i < 3; ++i)
      x.push_back(0.5 * (x[3 * static_cast<std::size_t>(a) + i] + x[3 * static_cast<std::size_t>(b) + i]));
    return at->second;
  };
  const auto add = [&](const Index* of, const int* local, int count) {
    solids.id.push_back(static_cast<model::Id>(solids.id.size()) + 1);
    solids.part.push_back(0);
    for (int a = 0; a < count; ++a) solids.node.push_back(of[local[a]]);
    if (shape == model::Shape::tet10)
      for (const auto& edge : edges) solids.node.push_back(between(of[local[edge[0]]], of[local[edge[1]]]));
  };
  for (std::size_t e = 0; e < hexes.id.size(); ++e) {
    const Index* of = hexes.node.data() + 8 * e;
    if (shape == model::Shape::penta6)
      for (const auto& wedge : wedges) add(of, wedge, 6);
    else
      for (const auto& tet : tets) add(of, tet, 4);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double cells = argc > 1 ? std::atof(argv[1]) : 2e4;
  const auto law = bench::make_law("*MAT_PLASTIC_KINEMATIC\n1,8.93e-6,117.0,0.35,0.4,0.1,1.0\n0,0,0\n");
  std::printf("machine, one thread: %.1f GFLOP/s fused multiply-add, %.1f GB/s triad\n",
              bench::fma_peak() * 1e-9, bench::triad_bandwidth() * 1e-9);
  std::printf("%-20s %6s %10s %10s %8s %10s %10s %10s %10s\n", "formulation", "ELFORM", "elements", "nodes",
              "threads", "visit ns", "cycle ns", "wall ns", "bytes/el");
  const struct {
    int form;
    model::Shape shape;
  } forms[] = {{1, model::Shape::hex8},  {2, model::Shape::hex8},    {10, model::Shape::tet4},
               {13, model::Shape::tet4}, {15, model::Shape::penta6}, {16, model::Shape::tet10}};
  for (const auto& f : forms) {
    auto m = bench::bar(cells, law, 2);
    cut(m, f.shape);
    deck::Diagnostics diagnostics;
    const auto& solids = m.mesh.solids[0];
    const auto* entry = discretisation::find_formulation("SOLID", f.form, solids.shape);
    const auto block = entry->build({m, 0, solids.shape, solids.id, solids.node}, diagnostics);
    const double count = static_cast<double>(solids.count());
    for (const int threads : {1, 2}) {
      base::set_thread_count(threads);
      bench::Run run(m, *block);
      const auto cost = bench::measure(run, count);
      std::printf("%-20.*s %6d %10.0f %10zu %8d %10.1f %10.1f %10.1f %10.0f\n",
                  static_cast<int>(entry->name.size()), entry->name.data(), f.form, count,
                  m.mesh.nodes.count(), threads, 1e9 * cost.visit, 1e9 * cost.cycle, 1e9 * cost.wall,
                  block->bytes_per_element());
      std::fflush(stdout);
    }
  }
  return 0;
}
