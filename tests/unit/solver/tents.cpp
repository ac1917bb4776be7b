/// The spacetime solver from a body to what observers see.

#include <cstring>

#include "base/threads.hpp"
#include "tents_rig.hpp"

namespace cleave::solver::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A standing wave holds a quarter of its energy density as kinetic energy on average: exact energies are
/// cos^2 and sin^2 of pi t over 4.
template <int D>
void follow_standing_wave(SpaceMeshInput<D> mesh, SpaceChoice space, double tolerance) {
  Rig<D> rig(std::move(mesh), 0.7, 0.07);
  rig.space = space;
  make_standing_wave(rig);
  rig.thickness = 2.5;
  Watcher watcher;
  auto state = rig.fresh();
  const Outcome outcome = rig.run(state, watcher);
  ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
  EXPECT_EQ(outcome.ending, Ending::end_time);
  ASSERT_EQ(watcher.seen.size(), 11u);
  for (const Seen& at : watcher.seen) {
    const double c = std::cos(pi * at.time), s = std::sin(pi * at.time);
    EXPECT_NEAR(at.energy.kinetic, 2.5 * 0.25 * c * c, tolerance) << at.time;
    EXPECT_NEAR(at.energy.internal, 2.5 * 0.25 * s * s, tolerance) << at.time;
    EXPECT_NEAR(at.energy.external, 0.0, tolerance);
    EXPECT_NEAR(at.motion.mass, 2.5, 1e-12);
    EXPECT_NEAR(at.motion.momentum[0], 2.5 * 2.0 / pi * c, tolerance);
    EXPECT_LT(at.fact("volume_error"), 1e-13);
    for (std::size_t v = 0; v < rig.input.vertex.size(); ++v) {
      Event<D> y;
      std::copy_n(rig.input.vertex[v].begin(), D, y.begin());
      y[D] = at.time;
      const auto exact = standing_wave<D>(y);
      EXPECT_NEAR(at.position[3 * v] - y[0], exact.u[0], tolerance);
      EXPECT_NEAR(at.velocity[3 * v], exact.v[0], 10 * tolerance);
      EXPECT_NEAR(at.acceleration[3 * v], -pi * pi * exact.u[0], at.time > 0.0 ? 200 * tolerance : 1e300);
    }
  }
  // At the end the cut is the front: what it lost is what the jumps dissipated, and the impulse of the held
  // ends is the change of momentum, but for the quadrature of the initial state.
  const Seen& end = watcher.seen.back();
  const double start = 1e-3 * tolerance;
  EXPECT_GT(end.fact("dissipation"), 0.0);
  EXPECT_NEAR(end.fact("dissipation"), end.fact("dissipation_of_jumps"), start);
  EXPECT_NEAR(end.fact("x_momentum") - watcher.seen[0].fact("x_momentum"), end.fact("x_impulse"), start);
}

TEST(Tents, StandingWaveIsFollowedAtEveryInstant) {
  follow_standing_wave<1>(sample::line(10, 0.3), {LocalSpace::three_field, 3}, 2e-4);
  follow_standing_wave<2>(sample::grid(3, 0.2), {LocalSpace::trefftz, 4}, 2e-3);
  follow_standing_wave<3>(sample::cube(2), {LocalSpace::trefftz, 3}, 2e-2);
}

}  // namespace
}  // namespace cleave::solver::test
