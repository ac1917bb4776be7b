// Patches whose matrices cannot be factored in the order of their rows are solved with pivoting instead.
#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_meshes.hpp"
#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

/// A boundary that sends back `gain` times what it receives: s* + Z v* = gain (s - Z v). Beyond 1 it feeds
/// energy in, and the symmetric part of a patch matrix need no longer be positive definite.
class Active final : public Target<1> {
 public:
  explicit Active(const double& gain) : gain_(gain) {}
  void star(const Interface<1>& facet, std::span<const Event<1>>, std::span<const Traces<1>>,
            std::span<StarMap<1>> map, std::span<Star<1>>) const override {
    const double z = facet.z_minus[0][0], half = 0.5 * (1.0 + gain_);
    map[0].map[0] = {-half * z, half, 0.0, 0.0};
    map[0].map[1] = {-(half - 1.0), (half - 1.0) / z, 0.0, 0.0};
  }

 private:
  const double& gain_;
};

/// The first entry of the matrix of a patch, and the largest below it.
struct Corner {
  double first, below;
};
Corner corner_of(PatchSolver<1>& solver, const Patch<1>& patch, std::span<const Solution<1>* const> older,
                 std::vector<Solution<1>>& out) {
  solver.keep_matrix = true;
  const PatchStatus status = solver.solve(patch, older, out);
  solver.keep_matrix = false;
  EXPECT_EQ(status, PatchStatus::solved);
  if (status != PatchStatus::solved) return {1.0, 0.0};
  const auto n = static_cast<std::size_t>(solver.unknowns());
  Corner corner{solver.matrix()[0], 0.0};
  for (std::size_t i = 1; i < n; ++i)
    corner.below = std::max(corner.below, std::fabs(solver.matrix()[i * n]));
  return corner;
}

/// A bar in the uniform state that an active right end keeps, while its left end moves along. `gain` is such
/// that the first pivot of the first patch at the right end vanishes: no factorisation without exchanges.
/// With `tune` it is looked for instead.
void first_pivot_vanishes(SpaceChoice space, double& gain, bool tune) {
  Problem<1> problem;
  problem.materials = {unit_material<1>()};
  problem.spaces = {space};
  const double z = std::sqrt(3.0);                                    // rho c
  const double v = (gain - 1.0) / (2.0 * z), s = (gain + 1.0) / 2.0;  // s - Z v = 1, s + Z v = gain
  const double size = std::fabs(v) + std::fabs(s);
  const auto exact = [=](const Event<1>& y) {
    PointState<1> state;
    state.v = {v};
    state.strain = {s / 3.0};
    state.u = {v * y[1] + s / 3.0 * y[0]};
    return state;
  };
  problem.initial = [=](Simplex, const Event<1>& y) { return exact(y); };
  SpaceMeshInput<1> input = sample::line(16);
  input.speed = {{z, z}};
  SpaceMesh<1> mesh;
  ASSERT_TRUE(mesh.build(input).ok);
  const TargetPtr<1> left = make_velocity<1>([=](const Event<1>&) { return Vector<1>{v}; });
  const Active right(gain);
  for (const auto& face : mesh.boundary())
    problem.targets.push_back(face.normal[0] < 0.0 ? left.get() : &right);
  PitchOptions options;
  options.repeat = true;
  const Pitcher<1> pitcher(mesh, options);
  ASSERT_TRUE(pitcher.repeats());
  Front<1> front = pitcher.level_front(0.0);
  PatchSolver<1> solver(problem);
  std::vector<Solution<1>> under(16);
  int met = 0;
  base::set_thread_count(1);
  const FrontStatus status =
      Scheduler<1>(pitcher, {.verify = true}).advance(front, 0.4, [&](const Patch<1>& patch) {
        std::vector<const Solution<1>*> older(patch.facets.size(), nullptr);
        bool at_right = false;
        for (std::size_t f = 0; f < older.size(); ++f) {
          const Facet<1>& facet = patch.facets[f];
          const auto& below = under[static_cast<std::size_t>(
              patch.elements[static_cast<std::size_t>(facet.element)].simplex)];
          if (facet.kind == FacetKind::inflow && below.material) older[f] = &below;
          at_right = at_right || (facet.kind == FacetKind::boundary &&
                                  mesh.boundary()[static_cast<std::size_t>(facet.boundary)].normal[0] > 0.0);
        }
        std::vector<Solution<1>> out(patch.elements.size());
        if (at_right && ++met == 1) {
          if (tune) {  // the entry is linear in the gain
            const double one = gain, two = gain - 1.0;
            const double at_one = corner_of(solver, patch, older, out).first;
            gain = two;
            const double at_two = corner_of(solver, patch, older, out).first;
            gain = one + at_one / (at_two - at_one) * (one - two);
            return Verdict{Verdict::fail};
          }
          const Corner corner = corner_of(solver, patch, older, out);
          EXPECT_LT(std::fabs(corner.first), 1e-12 * corner.below) << "the pivot is to vanish";
          EXPECT_NE(patch.shape, nullptr);
          Patch<1> alone = patch;  // without a shape, and with: from an operator
          alone.shape = nullptr;
          const PatchStatus solved = solver.solve(alone, older, out);
          EXPECT_EQ(solved, PatchStatus::solved);
          if (solved != PatchStatus::solved) return Verdict{Verdict::fail};
          Verify check;
          solver.verify(alone, older, out, check);
          EXPECT_LT(check.momentum, 1e-12);
          EXPECT_LT(check.energy, 1e-10);
          EXPECT_NEAR(out[0].at(patch.top).v[0], v, 1e-10 * size);
        }
        EXPECT_EQ(solver.solve(patch, older, out), PatchStatus::solved);
        for (const Solution<1>& one : out) {
          const PointState<1> got = one.at(patch.top), wanted = exact(patch.top);
          EXPECT_NEAR(got.v[0], wanted.v[0], 1e-9 * size);
          EXPECT_NEAR(got.strain[0], wanted.strain[0], 1e-9 * size);
          EXPECT_NEAR(got.u[0], wanted.u[0], 1e-9 * size);
        }
        for (std::size_t e = 0; e < out.size(); ++e)
          under[static_cast<std::size_t>(patch.elements[e].simplex)] = std::move(out[e]);
        return Verdict{};
      });
  EXPECT_EQ(status.ok, !tune) << status.what;
  EXPECT_GT(met, 0);
}

TEST(SpacetimePivot, PatchesWithoutFirstPivotAreSolved) {
  for (const SpaceChoice space :
       {SpaceChoice{LocalSpace::three_field, 2}, SpaceChoice{LocalSpace::three_field, 4},
        SpaceChoice{LocalSpace::one_field, 3}, SpaceChoice{LocalSpace::trefftz, 3}}) {
    double gain = 1.0;
    first_pivot_vanishes(space, gain, true);
    std::printf("space %d degree %d: gain %.6f\n", static_cast<int>(space.space), space.degree, gain);
    EXPECT_GT(std::fabs(gain), 1.0);  // a passive boundary needs no pivots
    first_pivot_vanishes(space, gain, false);
  }
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
