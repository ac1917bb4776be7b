/// Threads, stops and restarts do not change a bit; what breaks an identity stops the run.

#include <cstring>

#include "base/threads.hpp"
#include "tents_rig.hpp"

namespace cleave::solver::test {
namespace {

/// Everything of a state that a restart file holds, as bytes.
std::string bits(const discretisation::State& state) {
  std::string all;
  const auto add = [&](const auto& values) {
    all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  };
  add(std::array{state.time, state.step, state.energy.kinetic, state.energy.internal, state.energy.external});
  add(state.position);
  add(state.velocity);
  for (const auto& memory : state.memory) add(memory.values);
  return all;
}

std::string bits(const Watcher& watcher) {
  std::string all;
  for (const Seen& at : watcher.seen) {
    const auto add = [&](const auto& values) {
      all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    };
    add(at.position);
    add(at.velocity);
    add(at.acceleration);
    add(std::array{at.time, at.energy.kinetic, at.energy.internal, at.energy.external, at.motion.kinetic});
    for (const Fact& fact : at.facts) add(std::array{fact.value});
  }
  for (const auto& field : watcher.last_cells.fields)
    all.append(reinterpret_cast<const char*>(field.value.data()), field.value.size() * sizeof(double));
  return all;
}

/// A wave under gravity on a mesh without symmetry; instants closer than tents and others farther apart.
template <int D>
void make_lively(Rig<D>& rig) {
  make_standing_wave(rig);
  rig.body_force = [](const Event<D>& y) {
    Vector<D> b{};
    b[0] = 0.3 + y[D];
    return b;
  };
  rig.space = {LocalSpace::three_field, 2};
  rig.model.requests.nodout.every = 0.011;
}

class Threads {
 public:
  explicit Threads(int count) { base::set_thread_count(count); }
  ~Threads() { base::set_thread_count(0); }
};

template <int D>
void same_for_any_threads(const SpaceMeshInput<D>& mesh) {
  std::string first_seen, first_state;
  for (const int count : {1, 2, 3, 7}) {
    const Threads threads(count);
    Rig<D> rig(mesh, 0.15, 0.05);
    make_lively(rig);
    Watcher watcher;
    auto state = rig.fresh();
    const Outcome outcome = rig.run(state, watcher);
    ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
    if (count == 1) {
      first_seen = bits(watcher);
      first_state = bits(state);
    }
    EXPECT_TRUE(bits(watcher) == first_seen) << count << " threads";
    EXPECT_TRUE(bits(state) == first_state) << count << " threads";
  }
}

TEST(TentsBits, AreTheSameForAnyNumberOfThreads) {
  same_for_any_threads<1>(sample::line(12, 0.3));
  same_for_any_threads<2>(sample::grid(4, 0.3));
  same_for_any_threads<3>(sample::cube(1));
}

/// Stops at each instant and goes on from a copy of the state with everything else made anew. Of several
/// tents above each other: what the older ones exchanged with the outside is known from the state alone.
TEST(TentsBits, AreTheSameAfterStopsAtEveryInstant) {
  const auto mesh = sample::grid(3, 0.3);
  const auto make = [&] {
    auto rig = std::make_unique<Rig<2>>(mesh, 0.4, 0.2);
    make_lively(*rig);
    rig->model.requests.nodout.every = 0.041;
    return rig;
  };
  const auto whole = make();
  Watcher watcher;
  auto state = whole->fresh();
  whole->run(state, watcher);
  const std::string wanted = bits(state);

  const auto parts = make();
  auto resumed = parts->fresh();
  for (std::int64_t stop = 1; stop <= state.cycle; ++stop) {
    Watcher leg;
    const Outcome outcome = parts->run(resumed, leg, {.stop_at_cycle = stop});
    ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
    ASSERT_EQ(resumed.cycle, stop);
    // What a restarted run shows first is what was shown last.
    if (stop > 1) {
      const Seen& before = watcher.seen[static_cast<std::size_t>(stop - 1)];
      EXPECT_EQ(leg.seen.front().fact("boundary_work"), before.fact("boundary_work"));
      EXPECT_EQ(leg.seen.front().fact("x_impulse"), before.fact("x_impulse"));
    }
    const Seen& same = watcher.seen[static_cast<std::size_t>(stop)];
    EXPECT_EQ(leg.seen.back().energy.kinetic, same.energy.kinetic);
    EXPECT_EQ(leg.seen.back().energy.external, same.energy.external);
    EXPECT_TRUE(leg.seen.back().acceleration == same.acceleration);
  }
  EXPECT_TRUE(bits(resumed) == wanted);
}

/// A target that asks for the end of the run after so many calls: in the middle of the front.
template <int D>
class Impatient final : public Target<D> {
 public:
  Impatient(TargetPtr<D> inner, std::atomic<int>& calls, std::atomic<bool>& stop)
      : inner_(std::move(inner)), calls_(calls), stop_(stop) {}
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>> now,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    if (--calls_ == 0) stop_ = true;
    inner_->star(facet, at, now, map, load);
  }

 private:
  TargetPtr<D> inner_;
  std::atomic<int>& calls_;
  std::atomic<bool>& stop_;
};

TEST(TentsBits, AreTheSameAfterStopsInTheMiddleOfTheFront) {
  const auto mesh = sample::grid(3, 0.3);
  std::string wanted;
  for (const int calls : {0, 40, 200, 333}) {
    Rig<2> rig(mesh, 0.1, 0.05);
    make_lively(rig);
    Wishes wishes;
    std::atomic<int> left{calls};
    rig.target = [&](const BoundaryFace<2>& face) {
      return std::make_unique<const Impatient<2>>(standing_wave_target<2>(face), left, wishes.stop);
    };
    auto state = rig.fresh();
    for (int leg = 0; state.time < 0.1 && leg < 3; ++leg) {
      Watcher watcher;
      wishes.stop = false;
      const Outcome outcome = rig.run(state, watcher, wishes);
      ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
      EXPECT_EQ(outcome.ending, calls > 0 && leg == 0 ? Ending::switched_off : Ending::end_time);
    }
    if (calls == 0) wanted = bits(state);
    EXPECT_TRUE(bits(state) == wanted) << calls;
  }
}

/// A target that never says the same twice.
template <int D>
class Fickle final : public Target<D> {
 public:
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>> now,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    inner_->star(facet, at, now, map, load);
    for (Star<D>& s : load) s.s[0] += 1e-6 * ++calls_;
  }

 private:
  TargetPtr<D> inner_ = make_traction<D>({});
  mutable std::atomic<int> calls_{0};
};

TEST(TentsVerify, StopsAtATargetThatDoesNotRepeatItself) {
  Rig<2> rig(sample::grid(2), 0.2, 0.1);
  make_standing_wave(rig);
  rig.space = {LocalSpace::three_field, 1};
  rig.target = [](const BoundaryFace<2>&) { return std::make_unique<const Fickle<2>>(); };
  Watcher watcher;
  auto state = rig.fresh();
  const Outcome outcome = rig.run(state, watcher);
  EXPECT_EQ(outcome.ending, Ending::physics);
  EXPECT_NE(outcome.status.what.find("momentum is not balanced"), std::string::npos) << outcome.status.what;
  EXPECT_NE(outcome.status.what.find("at node "), std::string::npos);
  EXPECT_GT(outcome.status.element, 0);

  rig.verify = false;  // not asked for: not found
  auto again = rig.fresh();
  EXPECT_EQ(rig.run(again, watcher).ending, Ending::end_time);
}

/// Work of a boundary traction, known at any instant whether tents straddle it or not: a bar pulled at its
/// free end by t; until the wave comes back v = t there (unit impedance), so that the work is t^3 / 3.
TEST(TentsEnergies, WorkOfATractionIsKnownAtEveryInstant) {
  Rig<1> rig(sample::line(8, 0.2), 0.9, 0.05);
  rig.target = [](const BoundaryFace<1>& face) -> TargetPtr<1> {
    if (face.normal[0] < 0.0) return make_velocity<1>({});
    return make_traction<1>([](const Event<1>& y) { return Vector<1>{y[1]}; });
  };
  rig.space = {LocalSpace::trefftz, 4};
  rig.thickness = 3.0;
  Watcher watcher;
  auto state = rig.fresh();
  const Outcome outcome = rig.run(state, watcher);
  ASSERT_TRUE(outcome.status.ok) << outcome.status.what;
  for (const Seen& at : watcher.seen) {
    EXPECT_NEAR(at.energy.external, at.time * at.time * at.time, 2e-4) << at.time;
    EXPECT_NEAR(at.energy.kinetic + at.energy.internal, at.energy.external, 2e-4) << at.time;
    EXPECT_NEAR(at.motion.momentum[0], 1.5 * at.time * at.time, 1e-3);
  }
}

/// The same bar: the wave meets the held end at t = 1 and is doubled there; the support pulls the body back.
TEST(TentsEnergies, ReactionOfAHeldEnd) {
  Rig<1> rig(sample::line(8, 0.2), 1.5, 0.1);
  rig.target = [](const BoundaryFace<1>& face) -> TargetPtr<1> {
    if (face.normal[0] < 0.0) return make_velocity<1>({});
    return make_traction<1>([](const Event<1>& y) { return Vector<1>{y[1]}; });
  };
  rig.space = {LocalSpace::trefftz, 4};
  rig.thickness = 3.0;
  rig.model.fixed.emplace_back();
  rig.model.fixed[0].nodes = {0};
  rig.model.fixed[0].directions = 1;
  Watcher watcher;
  auto state = rig.fresh();
  ASSERT_TRUE(rig.run(state, watcher).status.ok);
  for (const Seen& at : watcher.seen) {
    EXPECT_NEAR(at.reaction[0], -3.0 * 2.0 * std::max(0.0, at.time - 1.0), 0.1)
        << at.time;  // the kink at t = 1
    for (std::size_t k = 1; k < at.reaction.size(); ++k) EXPECT_EQ(at.reaction[k], 0.0);
  }
  EXPECT_NEAR(watcher.seen.back().reaction[0], -3.0, 1e-3);
}

}  // namespace
}  // namespace cleave::solver::test
