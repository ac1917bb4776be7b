#pragma once
/// A bar that flies into its own still half, and the smallest explicit loop around its block: what the
/// element benchmarks run.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/threads.hpp"
#include "deck/deck.hpp"
#include "discretisation/formulation.hpp"
#include "machine.hpp"
#include "model/material/law.hpp"

namespace cleave::bench {

using discretisation::BlockState;
using discretisation::ForceSum;
using model::Index;

inline std::shared_ptr<const model::Law> make_law(const std::string& block) {
  static const std::vector<model::Curve> curves;
  static const std::vector<model::Table> tables;
  deck::Diagnostics diagnostics;
  auto deck = deck::Deck::read_text("*KEYWORD\n" + block + "*END\n", "bench.k", {}, diagnostics);
  for (const auto& b : deck.blocks())
    if (const auto* entry = model::find_law(b.keyword))
      return entry->build(deck.cards(b, diagnostics).at(0),
                          model::LawContext{curves, tables, nullptr, diagnostics});
  std::fputs("no law\n", stderr);
  std::exit(1);
}

/// A square bar 1 : 1 : 5 of about `wanted` elements.
inline model::Model bar(double wanted, std::shared_ptr<const model::Law> law, int hourglass) {
  model::Model m;
  model::Part part;
  part.id = 1;
  part.section.family = "SOLID";
  part.law = std::move(law);
  part.density = 8.93e-6;
  part.hourglass.type = hourglass;
  m.parts.push_back(part);
  m.mesh.solids.push_back({});
  auto& solids = m.mesh.solids[0];
  const int n = static_cast<int>(std::lround(std::cbrt(wanted / 5.0))), length = 5 * n;
  const auto node = [&](int i, int j, int k) { return static_cast<Index>((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= length; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        m.mesh.nodes.id.push_back(static_cast<model::Id>(m.mesh.nodes.id.size()) + 1);
        for (const int c : {i, j, k}) m.mesh.nodes.position.push_back(6.4 * c / n);
      }
  for (int k = 0; k < length; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        solids.id.push_back(static_cast<model::Id>(solids.count()) + 1);
        solids.part.push_back(0);
        for (const Index a :
             {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
              node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)})
          solids.node.push_back(a);
      }
  return m;
}

/// The smallest explicit loop around a block.
struct Run {
  const model::Model& model;
  const discretisation::Block& block;
  BlockState state;
  ForceSum force;
  base::Array<double> position, velocity, mass;
  double dt = 0.0, time = 0.0, visit_seconds = 0.0;

  Run(const model::Model& m, const discretisation::Block& b)
      : model(m), block(b), force(m.mesh.nodes.count()) {
    position.assign(m.mesh.nodes.position.begin(), m.mesh.nodes.position.end());
    velocity.assign(position.size(), 0.0);
    mass.assign(m.mesh.nodes.count(), 0.0);
    block.initialise(position, state);
    block.add_mass(state, mass);
    for (std::size_t n = 0; n < mass.size(); ++n)
      velocity[3 * n + 2] = position[3 * n + 2] > 16.0 ? -227.0 : 0.0;
    force.begin(1.0);
    dt = 0.5 * block.add_force({0.0, 0.0, position.data(), velocity.data(), 0.0}, state, force).stable_step;
  }

  void cycle() {
    const double unit = dt;
    base::for_each_range(mass.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        for (int i = 0; i < 3; ++i) {
          velocity[3 * n + i] += unit * force.value(static_cast<std::int32_t>(n), i) / mass[n];
          position[3 * n + i] += unit * velocity[3 * n + i];
        }
    });
    time += dt;
    force.begin(force.largest());
    const double start = cpu_seconds();
    const auto out = block.add_force({time, dt, position.data(), velocity.data(), 0.0}, state, force);
    visit_seconds += cpu_seconds() - start;
    if (!out.status.ok) {
      std::fprintf(stderr, "element %ld: %s\n", static_cast<long>(out.status.element),
                   out.status.what.c_str());
      std::exit(1);
    }
    dt = std::min(dt, 0.8 * out.stable_step);
  }
};

/// Best times of several stretches of a run. [seconds per element and cycle]
struct Cost {
  double visit = 1e300, cycle = 1e300, wall = 1e300;
};
inline Cost measure(Run& run, double element_count) {
  const int stretch = std::max(1, static_cast<int>(4e5 / element_count));
  Cost best;
  for (int r = 0; r < 15; ++r) {
    run.visit_seconds = 0.0;
    const double cpu = cpu_seconds(), clock = wall_seconds();
    for (int i = 0; i < stretch; ++i) run.cycle();
    const double per = 1.0 / (element_count * stretch);
    best.cycle = std::min(best.cycle, (cpu_seconds() - cpu) * per);
    best.wall = std::min(best.wall, (wall_seconds() - clock) * per);
    best.visit = std::min(best.visit, run.visit_seconds * per);
  }
  return best;
}

}  // namespace cleave::bench
