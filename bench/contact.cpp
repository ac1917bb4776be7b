/// Cost of contact per face: sorting, and finding touches between two sorts, for surfaces of 10^4 to 10^6
/// faces.
///
/// Two layers of elements whose faces lie on each other, unlike meshes, one sliding over the other.
/// usage: bench_contact [LARGEST: faces of both sides, default 1e6]

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/threads.hpp"
#include "machine.hpp"
#include "solver/contact/finders.hpp"

namespace {

using namespace cleave;
using model::Index;

/// A layer of n x n elements over the unit square.
void layer(model::Model& m, int n, double low, Index part) {
  const double h = 1.0 / n;
  const auto first = static_cast<Index>(m.mesh.nodes.id.size());
  const auto at = [&](int i, int j, int k) {
    return first + static_cast<Index>((k * (n + 1) + j) * (n + 1) + i);
  };
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        m.mesh.nodes.id.push_back(static_cast<model::Id>(m.mesh.nodes.id.size()) + 1);
        for (const double x : {h * i, h * j, low + h * k}) m.mesh.nodes.position.push_back(x);
      }
  auto& hex = m.mesh.solids[0];
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      hex.id.push_back(static_cast<model::Id>(hex.id.size()) + 1);
      hex.part.push_back(part);
      for (int k = 0; k < 2; ++k)
        for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
          hex.node.push_back(at(i + a, j + b, k));
    }
}

}  // namespace

int main(int argc, char** argv) {
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  std::printf("%-10s %10s %8s %14s %14s %10s\n", "method", "faces", "threads", "sort ns/face", "find ns/face",
              "touches");
  for (double faces = 1e4; faces <= 1.001 * largest; faces *= 10.0) {
    // Each layer has faces above and below, n * n each; the rims are few.
    const int n = static_cast<int>(std::sqrt(faces / 4.0));
    model::Model m;
    m.parts.resize(2);
    m.mesh.solids.resize(1);
    layer(m, n, 0.0, 0);
    layer(m, n - 1, 1.0 / n - 0.01 / n, 1);
    discretisation::World world;
    world.model = &m;
    deck::Diagnostics diagnostics;
    model::Contact contact;
    contact.a.parts = {0};
    contact.b.parts = {1};
    const auto a = std::make_shared<solver::Surface>(world, contact, contact.a, false, true, diagnostics);
    const auto b = std::make_shared<solver::Surface>(world, contact, contact.b, false, true, diagnostics);
    const double count = static_cast<double>(a->faces().size() + b->faces().size());
    std::vector<double> velocity(m.mesh.nodes.position.size(), 0.0), mass(m.mesh.nodes.count(), 1.0);
    for (std::size_t i = velocity.size() / 2; i < velocity.size(); i += 3) velocity[i - i % 3] = 0.01;
    const solver::Moment now{0.0, 1e-3 / n, 1e-3 / n, m.mesh.nodes.position, velocity, mass};
    for (const bool segments : {false, true})
      for (const int threads : {1, 2}) {
        base::set_thread_count(threads);
        const auto finder = segments ? solver::make_segment_finder(a, b, contact, 0.1, 1)
                                     : solver::make_node_finder({{}, a, b, false, false}, contact, 0.1, 1);
        std::vector<solver::Touch> touches;
        const double start = bench::wall_seconds();
        finder->find(now, solver::Past({}), touches);
        const double sorted = bench::wall_seconds();
        // The next step knows these pairs, and that they met from outside.
        std::vector<double> memory(touches.size() * sizeof(solver::Remembered) / sizeof(double), 0.0);
        auto* remembered = reinterpret_cast<solver::Remembered*>(memory.data());
        for (std::size_t i = 0; i < touches.size(); ++i)
          remembered[i] = {{static_cast<double>(touches[i].key[0]), static_cast<double>(touches[i].key[1])},
                           {0, 0, 0},
                           0.0,
                           touches[i].depth};
        touches.clear();
        const double again = bench::wall_seconds();
        finder->find(now, solver::Past(memory), touches);
        const double found = bench::wall_seconds() - again;
        std::printf("%-10s %10.0f %8d %14.1f %14.1f %10zu\n", segments ? "segments" : "nodes", count, threads,
                    1e9 * (sorted - start - found) / count, 1e9 * found / count, touches.size());
        std::fflush(stdout);
      }
  }
  return 0;
}
