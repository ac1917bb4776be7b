/// The same bits after a restart at any cycle, and on any number of threads.

#include <gtest/gtest.h>

#include <cstring>

#include "../base/same_bits.hpp"
#include "rig.hpp"

namespace cleave::solver::test {
namespace {

/// A chain with everything at once: supports, motions, walls with friction and mass, loads, damping, mass
/// scaling and a spring that breaks. Many nodes, so that several ranges run in parallel.
struct Everything : Rig {
  explicit Everything(int count) {
    std::vector<Springs::Spring> list;
    std::vector<Index> all;
    for (int a = 0; a <= count; ++a) all.push_back(node(a, 0.3 * std::sin(a), 0.5 * std::sin(0.7 * a)));
    for (Index e = 0; e < count; ++e)
      list.push_back({{e, e + 1}, 1.0 + 0.5 * std::sin(e), 1.0, e == 11 ? 0.05 : 1e300});
    springs(std::move(list));
    for (const Index a : all) velocity(a, {0.1 * std::cos(a), 0.2, -0.5});

    fix({0}, 5);
    model.fixed[0].birth = 1.3;
    model::PrescribedMotion motion;
    motion.nodes = {static_cast<Index>(count)};
    motion.kind = model::PrescribedMotion::Kind::displacement;
    motion.curve = curve({0, 50}, {0, 10});
    motion.birth = 0.7;
    model.motions.push_back(motion);

    model::RigidWall floor;
    floor.nodes = all;
    floor.origin = {0, 0, -0.8};
    floor.normal = {0, 0, 1};
    floor.friction = 0.2;
    model.walls.push_back(floor);
    floor.origin = {0, 0, -1.0};
    floor.mass = 20.0;
    floor.speed = 0.3;
    floor.soft_cycles = 3;
    model.walls.push_back(floor);
    floor = model.walls[0];
    floor.origin = {0, 0.5, 0};
    floor.normal = {0, -1, 0};
    floor.friction = 3.0;
    model.walls.push_back(floor);

    model.body_loads.push_back({{0, 0, 1}, false, {0, 0, 0}, constant(0.4), 1.0, {}});
    model::GlobalDamping damping;
    damping.value = 0.05;
    model.global_damping.push_back(damping);
    model.control.step.mass_scaling = -1.0;
    model.control.step.safety = 0.8;
  }
};

void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.cycle, b.cycle);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.next_step, b.next_step);
  EXPECT_TRUE(base::test::same_bits(a.position, b.position));
  EXPECT_TRUE(base::test::same_bits(a.velocity, b.velocity));
  EXPECT_TRUE(base::test::same_bits(a.mass, b.mass));
  EXPECT_EQ(std::memcmp(&a.energy, &b.energy, sizeof a.energy), 0);
  ASSERT_EQ(a.memory.size(), b.memory.size());
  for (std::size_t m = 0; m < a.memory.size(); ++m)
    EXPECT_TRUE(base::test::same_bits(a.memory[m].values, b.memory[m].values)) << a.memory[m].name;
  for (std::size_t k = 0; k < a.blocks.size(); ++k)
    EXPECT_TRUE(base::test::same_bits(a.blocks[k].alive, b.blocks[k].alive));
}

TEST(Restart, SameBitsFromAnyCycle) {
  Everything rig(40);
  rig.run(12.0);
  const State whole = rig.state;
  EXPECT_GT(whole.energy.eroded_internal, 0.0);
  EXPECT_GT(whole.energy.wall, 0.0);
  ASSERT_GT(whole.cycle, 10);
  for (std::int64_t stop = 1; stop < whole.cycle; ++stop) {
    rig.initialise();
    Options options;
    options.stop_at_cycle = stop;
    EXPECT_EQ(rig.advance(12.0, options).ending, Ending::cycle_limit);
    const State copy = rig.state;
    // What observers see first is what they saw last.
    std::vector<double> seen;
    rig.state = copy;
    bool first = true;
    rig.advance(12.0, {}, [&](const Frame& frame) {
      if (!first) return;
      first = false;
      EXPECT_EQ(frame.state.cycle, stop);
    });
    expect_same(rig.state, whole);
  }
}

// A restarted run shows the same frame again: velocities, reactions, walls.
TEST(Restart, FirstFrameIsTheLastOne) {
  Everything rig(40);
  rig.initialise();
  Options options;
  options.stop_at_cycle = 9;
  struct Seen {
    std::vector<double> velocity, reaction, wall;
    Id element = 0;
    bool operator==(const Seen&) const = default;
  } last, first;
  const auto look = [](const Frame& frame, Seen& seen) {
    seen.velocity.clear();
    for (std::size_t i = 0; i < frame.velocity.size(); ++i) seen.velocity.push_back(frame.velocity[i]);
    seen.reaction.assign(frame.reaction.begin(), frame.reaction.end());
    seen.wall.clear();
    for (const WallForce& wall : frame.walls)
      seen.wall.insert(seen.wall.end(), {wall.normal, wall.force[0], wall.position, wall.velocity});
    seen.element = frame.step_element;
  };
  rig.advance(12.0, options, [&](const Frame& frame) { look(frame, last); });
  bool begun = false;
  rig.advance(12.0, {}, [&](const Frame& frame) {
    if (!begun) look(frame, first);
    begun = true;
  });
  EXPECT_TRUE(first == last);
}

TEST(Threads, SameBitsForAnyNumber) {
  State one;
  for (const int threads : {1, 2, 3, 7}) {
    base::set_thread_count(threads);
    Everything rig(6000);
    rig.run(4.0);
    if (threads == 1)
      one = rig.state;
    else
      expect_same(rig.state, one);
  }
  base::set_thread_count(0);
}

}  // namespace
}  // namespace cleave::solver::test
