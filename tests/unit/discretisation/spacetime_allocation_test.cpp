// The patch solver asks the system for no memory once it is warm: one patch at a time, and equal ones
// together.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_meshes.hpp"
#include "spacetime_waves.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CLEAVE_COUNTS 0  // the sanitizers have a `new` of their own
#else
#define CLEAVE_COUNTS 1
#endif

namespace {
thread_local std::int64_t asked = 0;  ///< pieces of memory that this thread has asked for

[[maybe_unused]] void* ask(std::size_t size, std::size_t alignment) {
  ++asked;
  void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!p) throw std::bad_alloc();
  return p;
}
}  // namespace

#if CLEAVE_COUNTS
void* operator new(std::size_t size) {
  return ask(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size) {
  return ask(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return ask(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return ask(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
#endif

namespace cleave::discretisation::spacetime::test {
namespace {

struct Asked {
  std::int64_t patches = 0;                   ///< in the second half of the run
  std::int64_t found = 0;                     ///< of them, those that found their operator
  std::int64_t pieces = 0, pieces_first = 0;  ///< of memory; in the first half
  std::size_t together = 0;                   ///< most patches handed over at one time
};

/// A wave through a square of equal triangles up to `end`. What a patch gives is swapped into its column, as
/// in a run. Counted is the solver alone. Where operators are shared every call is made twice, and the second
/// one is counted, which makes none.
Asked wave_through(SpaceChoice space, bool repeat, std::size_t together, double end) {
  SpaceMeshInput<2> input = sample::grid(6);
  const Elastic<2> material = unit_material<2>();
  input.speed = {{material.fastest, material.fastest}};
  SpaceMesh<2> mesh;
  EXPECT_TRUE(mesh.build(input).ok);
  Problem<2> problem;
  problem.materials = {material};
  problem.spaces = {space};
  const auto list = smooth_waves<2>(6.0);
  problem.initial = [&](Simplex, const Event<2>& y) { return waves<2>(list, y); };
  const TargetPtr<2> free = make_traction<2>({});
  problem.targets.assign(mesh.boundary().size(), free.get());
  PitchOptions options;
  options.repeat = repeat;
  const Pitcher<2> pitcher(mesh, options);
  EXPECT_EQ(pitcher.repeats(), repeat);
  Front<2> front = pitcher.level_front(0.0);
  PatchSolver<2> solver(problem);
  std::vector<Solution<2>> under(input.simplex.size());
  std::vector<std::vector<Solution<2>>> out(together);
  std::vector<std::vector<const Solution<2>*>> older(together);
  std::vector<PatchJob<2>> jobs;
  Asked all;
  const auto solve = [&](std::span<const Patch<2>> patches, std::span<Verdict> verdicts) {
    jobs.clear();
    double top = end;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Patch<2>& patch = patches[k];
      top = std::min(top, patch.top[2]);
      older[k].assign(patch.facets.size(), nullptr);
      for (std::size_t f = 0; f < patch.facets.size(); ++f) {
        const auto e = static_cast<std::size_t>(patch.facets[f].element);
        const auto& below = under[static_cast<std::size_t>(patch.elements[e].simplex)];
        if (patch.facets[f].kind == FacetKind::inflow && below.material) older[k][f] = &below;
      }
      if (out[k].size() < patch.elements.size()) out[k].resize(patch.elements.size());
      jobs.push_back({.patch = &patch, .older = older[k], .out = {out[k].data(), patch.elements.size()}});
    }
    const std::int64_t before = asked;
    solver.solve(jobs);
    const std::int64_t between = asked, found = solver.reused();
    if (repeat) solver.solve(jobs);  // now the operators are there
    const std::int64_t pieces = repeat ? asked - between : between - before;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      if (jobs[k].status != PatchStatus::solved) verdicts[k].kind = Verdict::fail;
      for (std::size_t e = 0; e < patches[k].elements.size(); ++e)
        std::swap(under[static_cast<std::size_t>(patches[k].elements[e].simplex)], out[k][e]);
    }
    if (top < 0.5 * end) {
      all.pieces_first += asked - before;
      return;
    }
    all.patches += static_cast<std::int64_t>(patches.size());
    all.found += solver.reused() - found;
    all.pieces += pieces;
    all.together = std::max(all.together, patches.size());
  };
  base::set_thread_count(1);
  const FrontStatus status =
      Scheduler<2>(pitcher, {.together = static_cast<int>(together)}).advance_several(front, end, solve);
  base::set_thread_count(0);
  EXPECT_TRUE(status.ok) << status.what;
  return all;
}

TEST(SpacetimeAllocation, NoneWhenWarm) {
  if (!CLEAVE_COUNTS) GTEST_SKIP() << "the sanitizers have a `new` of their own";
  for (const SpaceChoice space :
       {SpaceChoice{LocalSpace::one_field, 2}, {LocalSpace::three_field, 1}, {LocalSpace::trefftz, 2}})
    for (const bool repeat : {false, true}) {
      const Asked all = wave_through(space, repeat, repeat ? 16 : 1, 1.4);
      std::printf(
          "space %d, repeat %d: %lld patches, %lld found, up to %zu together: %lld pieces, %lld before\n",
          static_cast<int>(space.space), repeat, static_cast<long long>(all.patches),
          static_cast<long long>(all.found), all.together, static_cast<long long>(all.pieces),
          static_cast<long long>(all.pieces_first));
      EXPECT_GT(all.patches, 100);
      EXPECT_GT(all.pieces_first, 0);  // they are counted
      EXPECT_EQ(all.pieces, 0);
      EXPECT_EQ(all.found, repeat ? all.patches : 0);
      EXPECT_GE(all.together, repeat ? 8u : 1u);
    }
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
