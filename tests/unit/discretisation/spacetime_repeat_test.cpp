// Patches over tents that repeat share an operator: the same solution, the same bits in any order.
#include <gtest/gtest.h>

#include <mutex>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

/// The unit square in n x n squares of two triangles; coordinates that are no binary fractions.
SpaceMesh<2> grid(int n, const Elastic<2>& m, double jiggle = 0.0) {
  SpaceMeshInput<2> input;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inside = i > 0 && j > 0 && i < n && j < n;
      const double off = inside ? jiggle / n * std::sin(12.9898 * i + 78.233 * j) : 0.0;
      input.vertex.push_back({0.7 * (i / double(n) + off), 0.7 * (j / double(n) - off)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vertex a = j * (n + 1) + i;
      input.simplex.push_back({a, a + 1, a + n + 2}), input.simplex.push_back({a, a + n + 2, a + n + 1});
    }
  input.material.assign(input.simplex.size(), 0);
  input.speed = {{m.fastest, 0.5 * m.fastest}};
  SpaceMesh<2> mesh;
  const MeshFault fault = mesh.build(input);
  EXPECT_TRUE(fault.ok) << fault.what;
  return mesh;
}

struct Advance {
  std::int64_t patches = 0, reused = 0;
  std::size_t together = 0;  ///< most patches handed over at one time
  double momentum = 0.0, energy = 0.0;
  double difference = 0.0;           ///< to each patch solved alone, relative
  std::vector<double> coefficients;  ///< at the end
};

Advance advance(const SpaceMesh<2>& mesh, const Elastic<2>& m, SpaceChoice space, double end, bool alone,
                int together = 1) {
  Problem<2> problem;
  problem.materials = {m};
  problem.spaces = {space};
  const auto list = smooth_waves<2>(6.0);
  problem.initial = [&](Simplex, const Event<2>& y) { return waves<2>(list, y); };
  const auto velocity = make_velocity<2>([&](const Event<2>& y) { return waves<2>(list, y).v; });
  const auto free = make_traction<2>({});
  for (const auto& face : mesh.boundary())
    problem.targets.push_back(face.normal[0] > 0.5 ? free.get() : velocity.get());
  PitchOptions options;
  options.repeat = true;
  const Pitcher<2> pitcher(mesh, options);
  Front<2> front = pitcher.level_front(0.0);
  std::vector<Solution<2>> under(static_cast<std::size_t>(mesh.simplex_count()));
  std::mutex guard;
  std::vector<std::unique_ptr<PatchSolver<2>>> idle;
  Advance run;
  const auto solve = [&](std::span<const Patch<2>> patches, std::span<Verdict> verdicts) {
    std::unique_ptr<PatchSolver<2>> solver;
    {
      const std::lock_guard lock(guard);
      if (!idle.empty()) solver = std::move(idle.back()), idle.pop_back();
    }
    if (!solver) solver = std::make_unique<PatchSolver<2>>(problem);
    std::vector<std::vector<const Solution<2>*>> older(patches.size());
    std::vector<std::vector<Solution<2>>> out(patches.size());
    std::vector<PatchJob<2>> jobs;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Patch<2>& patch = patches[k];
      older[k].assign(patch.facets.size(), nullptr);
      for (std::size_t f = 0; f < older[k].size(); ++f) {
        const auto e = static_cast<std::size_t>(patch.facets[f].element);
        const auto& below = under[static_cast<std::size_t>(patch.elements[e].simplex)];
        if (patch.facets[f].kind == FacetKind::inflow && below.material) older[k][f] = &below;
      }
      out[k].resize(patch.elements.size());
      jobs.push_back({.patch = &patch, .older = older[k], .out = out[k]});
    }
    solver->solve(jobs);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Patch<2>& patch = patches[k];
      if (jobs[k].status != PatchStatus::solved) verdicts[k].kind = Verdict::fail;
      Verify check;
      solver->verify(patch, older[k], out[k], check);
      double difference = 0.0, size = 0.0;
      if (alone) {
        Patch<2> same = patch;
        same.shape = nullptr;
        std::vector<Solution<2>> other(patch.elements.size());
        EXPECT_EQ(solver->solve(same, older[k], other), PatchStatus::solved);
        for (std::size_t e = 0; e < out[k].size(); ++e) {
          const Solution<2>& here = out[k][e];
          for (std::size_t a = 0; a < here.fields.size(); ++a) {
            difference = std::max(difference, std::fabs(here.fields[a] - other[e].fields[a]));
            size = std::max(size, std::fabs(other[e].fields[a]));
          }
          for (std::size_t a = 0; a < here.displacement.size(); ++a)
            difference = std::max(difference, std::fabs(here.displacement[a] - other[e].displacement[a]));
        }
      }
      for (std::size_t e = 0; e < out[k].size(); ++e)
        under[static_cast<std::size_t>(patch.elements[e].simplex)] = std::move(out[k][e]);
      const std::lock_guard lock(guard);
      run.momentum = std::max(run.momentum, check.momentum);
      run.energy = std::max(run.energy, check.energy);
      run.together = std::max(run.together, patches.size());
      if (alone) run.difference = std::max(run.difference, difference / size);
    }
    const std::lock_guard lock(guard);
    idle.push_back(std::move(solver));
  };
  const FrontStatus status =
      Scheduler<2>(pitcher, {.verify = true, .together = together}).advance_several(front, end, solve);
  EXPECT_TRUE(status.ok) << status.what;
  run.patches = status.patches;
  for (const auto& solver : idle) run.reused += solver->reused();
  for (const auto& u : under) {
    run.coefficients.insert(run.coefficients.end(), u.fields.begin(), u.fields.end());
    run.coefficients.insert(run.coefficients.end(), u.displacement.begin(), u.displacement.end());
  }
  return run;
}

TEST(SpacetimeRepeat, SharedOperatorsSolveThePatch) {
  Elastic<2> m;
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::strain, m), "");
  const SpaceMesh<2> mesh = grid(7, m);
  base::set_thread_count(1);  // every solver makes operators for itself
  for (const SpaceChoice space :
       {SpaceChoice{LocalSpace::one_field, 3}, {LocalSpace::three_field, 2}, {LocalSpace::trefftz, 3}}) {
    const Advance run = advance(mesh, m, space, 0.6, true);
    std::printf("space %d: %lld patches, %lld found their operator, differences to patches alone %.1e\n",
                static_cast<int>(space.space), static_cast<long long>(run.patches),
                static_cast<long long>(run.reused), run.difference);
    EXPECT_GT(run.reused, run.patches / 3);
    EXPECT_LT(run.difference, 1e-11);
    EXPECT_LT(run.momentum, 3e-14);
    EXPECT_LT(run.energy, 3e-14);
  }
}

/// Alone or with equal ones, on any thread.
TEST(SpacetimeRepeat, SameBitsInAnyCompany) {
  Elastic<2> m;
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::strain, m), "");
  const SpaceMesh<2> mesh = grid(7, m);
  for (const SpaceChoice space :
       {SpaceChoice{LocalSpace::one_field, 2}, {LocalSpace::three_field, 2}, {LocalSpace::trefftz, 3}}) {
    base::set_thread_count(1);
    const Advance alone = advance(mesh, m, space, 0.4, false);
    EXPECT_EQ(alone.together, 1u);
    for (const int threads : {1, 2, 3, 7}) {
      base::set_thread_count(threads);
      const Advance run = advance(mesh, m, space, 0.4, false, 16);
      base::set_thread_count(1);
      EXPECT_EQ(run.patches, alone.patches);
      EXPECT_EQ(run.coefficients, alone.coefficients) << threads << " threads";
      if (threads == 1) {
        EXPECT_EQ(run.together, 16u);
      }
    }
  }
}

TEST(SpacetimeRepeat, MeshesWithoutPatternShareNothing) {
  Elastic<2> m;
  ASSERT_EQ(make_isotropic<2>(1.0, 2.5, 0.25, PlaneKind::strain, m), "");
  EXPECT_TRUE(StarShapes<2>(grid(7, m)).repeating());
  EXPECT_FALSE(StarShapes<2>(grid(7, m)).graded());
  const Advance run = advance(grid(7, m, 0.1), m, {LocalSpace::trefftz, 2}, 0.2, false);
  EXPECT_EQ(run.reused, 0);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
