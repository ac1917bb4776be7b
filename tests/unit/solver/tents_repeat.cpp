/// Equal tents over a regular mesh share matrices only where their boundaries do the same.

#include "tents_rig.hpp"

namespace cleave::solver::test {
namespace {

/// A square flies down; the left half of its lower edge is held, the right half is free: tents of one shape
/// stand over both. Every patch is held to its balances, which know the boundary it really has.
TEST(TentsRepeat, EqualTentsUnderDifferentTargets) {
  std::vector<double> velocity[2];
  for (const bool repeat : {false, true}) {
    Rig<2> rig(sample::grid(6), 0.4, 0.2);
    rig.repeat = repeat;
    rig.space = {LocalSpace::trefftz, 3};
    rig.initial = [](Simplex, const Event<2>&) {
      PointState<2> state;
      state.v[1] = -1.0;
      return state;
    };
    rig.target = [&](const BoundaryFace<2>& face) -> TargetPtr<2> {
      const double middle = 0.5 * (rig.input.vertex[static_cast<std::size_t>(face.vertex[0])][0] +
                                   rig.input.vertex[static_cast<std::size_t>(face.vertex[1])][0]);
      if (face.normal[1] < -0.5 && middle < 0.5) return make_velocity<2>({});
      return make_traction<2>({});
    };
    Watcher watcher;
    auto state = rig.fresh();
    const Outcome outcome = rig.run(state, watcher);
    ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
    velocity[repeat].assign(state.velocity.begin(), state.velocity.end());
    // The held edge has pushed the body up, the more the longer; two thirds of it stand still by now.
    EXPECT_NEAR(watcher.seen.back().fact("y_impulse"), watcher.seen.back().fact("y_momentum") + 1.0, 1e-10);
    EXPECT_GT(watcher.seen.back().fact("y_impulse"), 0.15);
  }
  for (std::size_t k = 0; k < velocity[0].size(); ++k) EXPECT_NEAR(velocity[0][k], velocity[1][k], 0.15) << k;
}

}  // namespace
}  // namespace cleave::solver::test
