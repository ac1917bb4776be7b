// Front and patch solver together: waves on a jiggled mesh, vertical and moving poles, any number of threads.
#include <gtest/gtest.h>

#include <mutex>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

/// The unit square, interior vertices moved off the grid.
SpaceMesh<2> jiggled(int n, const Elastic<2>& m) {
  const auto grid = box<2>({n, n}, {1.0, 1.0});
  SpaceMeshInput<2> input;
  for (std::size_t v = 0; v < grid.x.size(); ++v) {
    Point<2> x = grid.x[v];
    const bool inside = x[0] > 1e-9 && x[0] < 1 - 1e-9 && x[1] > 1e-9 && x[1] < 1 - 1e-9;
    for (std::size_t k = 0; k < 2 && inside; ++k)
      x[k] += 0.15 / n * std::sin(12.9898 * static_cast<double>(v) + 3.1 * static_cast<double>(k));
    input.vertex.push_back(x);
  }
  for (const auto& c : grid.cell) {
    const auto &a = grid.x[static_cast<std::size_t>(c[0])], &b = grid.x[static_cast<std::size_t>(c[1])],
               &d = grid.x[static_cast<std::size_t>(c[2])];
    const bool positive = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]) > 0.0;
    input.simplex.push_back(positive ? std::array<Vertex, 3>{c[0], c[1], c[2]}
                                     : std::array<Vertex, 3>{c[0], c[2], c[1]});
    input.material.push_back(0);
  }
  input.speed = {{m.fastest, 1.0}};
  SpaceMesh<2> mesh;
  const MeshFault fault = mesh.build(input);
  EXPECT_TRUE(fault.ok) << fault.what;
  return mesh;
}

struct Outcome {
  double error = 0.0, momentum = 0.0, energy = 0.0, fingerprint = 0.0;
  std::int64_t patches = 0;
};

Outcome propagate(int n, SpaceChoice space, double smoothing, double end) {
  Case<2> c;
  c.problem.materials = {unit_material<2>()};
  c.problem.spaces = {space};
  const auto list = smooth_waves<2>(6.0);
  c.problem.initial = [&](Simplex, const Event<2>& y) { return waves<2>(list, y); };
  const SpaceMesh<2> mesh = jiggled(n, c.problem.materials[0]);
  const auto target = make_velocity<2>([&](const Event<2>& y) { return waves<2>(list, y).v; });
  c.problem.targets.assign(mesh.boundary().size(), target.get());
  PitchOptions options;
  options.smoothing = smoothing;
  const Pitcher<2> pitcher(mesh, options);
  Front<2> front = pitcher.level_front(0.0);

  std::vector<Solution<2>> under(static_cast<std::size_t>(mesh.simplex_count()));
  std::mutex guard;  // of the free solvers and of the sums
  std::vector<std::unique_ptr<PatchSolver<2>>> idle;
  Outcome out;
  const auto solve = [&](const Patch<2>& patch) {
    std::unique_ptr<PatchSolver<2>> solver;
    {
      const std::lock_guard lock(guard);
      if (!idle.empty()) solver = std::move(idle.back()), idle.pop_back();
    }
    if (!solver) solver = std::make_unique<PatchSolver<2>>(c.problem);
    std::vector<const Solution<2>*> older(patch.facets.size(), nullptr);
    for (std::size_t f = 0; f < older.size(); ++f) {
      const auto s =
          static_cast<std::size_t>(patch.elements[static_cast<std::size_t>(patch.facets[f].element)].simplex);
      if (patch.facets[f].kind == FacetKind::inflow && under[s].material) older[f] = &under[s];
    }
    std::vector<Solution<2>> solution(patch.elements.size());
    const PatchStatus status = solver->solve(patch, older, solution);
    Verify check;
    solver->verify(patch, older, solution, check);
    for (std::size_t e = 0; e < solution.size(); ++e)
      under[static_cast<std::size_t>(patch.elements[e].simplex)] = std::move(solution[e]);
    const std::lock_guard lock(guard);
    idle.push_back(std::move(solver));
    out.momentum = std::max(out.momentum, check.momentum);
    out.energy = std::max(out.energy, check.energy);
    return Verdict{status == PatchStatus::solved ? Verdict::accept : Verdict::fail};
  };
  ScheduleOptions schedule;
  schedule.verify = true;
  const FrontStatus status = Scheduler<2>(pitcher, schedule).advance(front, end, solve);
  EXPECT_TRUE(status.ok) << status.what;
  out.patches = status.patches;
  for (Simplex s = 0; s < mesh.simplex_count(); ++s) {
    Event<2> y{0.0, 0.0, end};
    for (const Vertex v : mesh.simplex(s))
      for (std::size_t k = 0; k < 2; ++k) y[k] += front.position[static_cast<std::size_t>(v)][k] / 3;
    const PointState<2> a = under[static_cast<std::size_t>(s)].at(y), b = waves<2>(list, y);
    for (int i = 0; i < 2; ++i) out.error += std::pow(a.v[i] - b.v[i], 2) / mesh.simplex_count();
    out.fingerprint += a.v[0] * (1.0 + 1e-3 * s) + a.u[1];
  }
  out.error = std::sqrt(out.error);
  return out;
}

TEST(SpacetimeWave, ConvergesOnJiggledMeshes) {
  for (const SpaceChoice space :
       {SpaceChoice{LocalSpace::three_field, 2}, SpaceChoice{LocalSpace::trefftz, 3}})
    for (const double smoothing : {0.0, 0.3}) {
      const Outcome a = propagate(4, space, smoothing, 0.25), b = propagate(8, space, smoothing, 0.25);
      EXPECT_LT(std::max(a.momentum, b.momentum), 1e-12);
      EXPECT_LT(std::max(a.energy, b.energy), 1e-10);
      EXPECT_GT(std::log2(a.error / b.error), 2.5) << a.error << " " << b.error;
    }
}

TEST(SpacetimeWave, SameBitsForAnyNumberOfThreads) {
  const SpaceChoice space{LocalSpace::trefftz, 3};
  base::set_thread_count(1);
  const Outcome one = propagate(4, space, 0.3, 0.3);
  for (const int threads : {2, 3, 7}) {
    base::set_thread_count(threads);
    const Outcome many = propagate(4, space, 0.3, 0.3);
    EXPECT_EQ(many.fingerprint, one.fingerprint) << threads;
    EXPECT_EQ(many.patches, one.patches);
  }
  base::set_thread_count(1);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
