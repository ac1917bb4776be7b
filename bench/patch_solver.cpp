// The patch solver of the spacetime wing: one interior tent of six tetrahedra (2D x time), all spaces and
// degrees.
#include "discretisation/spacetime/patch_solver.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "machine.hpp"

namespace {

using namespace cleave::discretisation::spacetime;

/// Area vector of a triangle in spacetime, away from `opposite`.
Event<2> area_vector(const std::array<Event<2>, 3>& y, const Event<2>& opposite) {
  Event<2> a, b, n;
  for (int k = 0; k < 3; ++k) a[k] = y[1][k] - y[0][k], b[k] = y[2][k] - y[0][k];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = 0.5 * (a[i] * b[j] - a[j] * b[i]);
  }
  double side = 0.0;
  for (int k = 0; k < 3; ++k) side += n[k] * (opposite[k] - y[0][k]);
  if (side > 0.0)
    for (double& x : n) x = -x;
  return n;
}

/// A regular hexagon of unit edge, its centre pitched to `height`.
Patch<2> hexagon(double height) {
  Patch<2> p;
  p.foot = {0.0, 0.0, 0.0}, p.top = {0.0, 0.0, height};
  const auto rim = [](int i) {
    const double a = i % 6 * std::acos(-1.0) / 3.0;
    return Event<2>{std::cos(a), std::sin(a), 0.0};
  };
  for (int e = 0; e < 6; ++e) {
    PatchElement<2> element;
    element.simplex = e;
    element.corner = {p.foot, rim(e), rim(e + 1), p.top};
    element.volume = height * std::sqrt(3.0) / 4.0 / 3.0;
    p.elements.push_back(element);
    const auto add = [&](FacetKind kind, int opposite, int neighbour) {
      Facet<2> f;
      f.kind = kind, f.element = e, f.neighbour = neighbour;
      for (int i = 0, at = 0; i < 4; ++i)
        if (i != opposite)
          f.corner[static_cast<std::size_t>(at++)] = element.corner[static_cast<std::size_t>(i)];
      f.normal = area_vector(f.corner, element.corner[static_cast<std::size_t>(opposite)]);
      p.facets.push_back(f);
    };
    add(FacetKind::inflow, 3, -1);
    add(FacetKind::outflow, 0, -1);
    if (e < 5) add(FacetKind::interior, 1, e + 1);
    if (e == 0) add(FacetKind::interior, 2, 5);
  }
  return p;
}

}  // namespace

/// Program [SPACE [DEGREE]]: 0 one field, 1 three fields, 2 Trefftz; all without.
int main(int words, char** word) {
  const int only = words > 1 ? std::atoi(word[1]) : -1, only_degree = words > 2 ? std::atoi(word[2]) : -1;
  using cleave::bench::cpu_seconds;
  const double peak = cleave::bench::fma_peak();
  std::printf("FMA peak of one thread %.1f Gflop/s\n", peak * 1e-9);
  std::printf(
      "space        degree  unknowns  us/patch  Munknowns/s  elimination: Mflop  flop/B scratch  Gflop/s of "
      "whole patch  of peak\n");
  const char* names[] = {"one field", "three fields", "Trefftz"};
  const Patch<2> patch = hexagon(0.6);
  for (const LocalSpace space : {LocalSpace::three_field, LocalSpace::one_field, LocalSpace::trefftz})
    for (int p = 1; p <= 4; ++p) {
      if ((only >= 0 && static_cast<int>(space) != only) || (only_degree >= 0 && p != only_degree)) continue;
      // Equal degree p of velocity and strain.
      Problem<2> problem;
      problem.materials.resize(1);
      if (!make_isotropic<2>(1.0, 2.5 / 3.0, 0.25, PlaneKind::strain, problem.materials[0]).empty()) return 1;
      problem.spaces = {{space, space == LocalSpace::three_field ? p : p + 1}};
      PatchSolver<2> solver(problem);
      std::vector<Solution<2>> below(6), out(6);
      std::vector<const Solution<2>*> older(patch.facets.size(), nullptr);
      if (solver.solve(patch, older, below) != PatchStatus::solved) return 1;
      for (std::size_t f = 0; f < older.size(); ++f)
        if (patch.facets[f].kind == FacetKind::inflow)
          older[f] = &below[static_cast<std::size_t>(patch.facets[f].element)];
      solver.solve(patch, older, out);
      double best = 1e300;
      for (int trial = 0; trial < 5; ++trial) {
        int count = 0;
        const double start = cpu_seconds();
        double now = start;
        do {
          for (int k = 0; k < 4; ++k, ++count) solver.solve(patch, older, out);
          now = cpu_seconds();
        } while (now - start < 0.04);
        best = std::min(best, (now - start) / count);
      }
      std::printf("%-12s %4d %10d %10.1f %10.2f %16.2f %14.1f %16.2f %14.1f %%\n",
                  names[static_cast<int>(space)], problem.spaces[0].degree, solver.unknowns(), best * 1e6,
                  solver.unknowns() / best * 1e-6, solver.flops() * 1e-6,
                  solver.flops() / (8.0 * static_cast<double>(solver.scratch())),
                  solver.flops() / best * 1e-9, 100.0 * solver.flops() / best / peak);
    }
}
