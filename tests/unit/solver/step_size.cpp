/// The time step, mass scaling, erosion and the ways a run ends.

#include "solver/step_size.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "rig.hpp"

namespace cleave::solver::test {
namespace {

/// Two springs between three nodes: natural steps 1 and 0.25.
struct Pair : Rig {
  Index a = node(0), b = node(10), c = node(20);
  Pair() { springs({{{a, b}, 1.0, 1.0}, {{b, c}, 4.0, 0.25}}); }
  double mass() const { return state.mass[0] + state.mass[1] + state.mass[2]; }
};

TEST(StepSize, SafetyFirstStepAndCurve) {
  Pair rig;
  rig.model.control.step.safety = 0.8;
  rig.model.control.step.first = 0.01;
  rig.model.control.step.limit_curve = rig.curve({0, 0.5, 0.5, 9}, {1, 1, 0.1, 0.1});
  rig.run(1.0, [&](const Frame& frame) {
    const double t = frame.state.time;
    EXPECT_DOUBLE_EQ(frame.state.next_step, t == 0.0 ? 0.01 : t < 0.5 ? 0.2 : 0.1);
    EXPECT_EQ(frame.step_element, 2);
  });
}

// Springs that add w_c to elements of w_e = 2 / dt: 0.99 * 2 / sqrt(w_e^2 + w_c^2). Once they are gone the
// step grows by 1 % each time until it is what was asked for, and then contact has no memory of it.
TEST(StepSize, ContactLimitsAndLetsGoSlowly) {
  double last = 0.0;
  EXPECT_EQ(limit_step(0.9, 1.0, 0.0, 0.0, last), 0.9);
  EXPECT_EQ(last, 0.0);
  EXPECT_DOUBLE_EQ(limit_step(0.9, 1.0, 12.0, 0.0, last), 0.99 * 0.5);
  EXPECT_DOUBLE_EQ(limit_step(0.9, 1.0, 12.0, 0.75, last), 0.99 * 0.25);  // sqrt(1 + z^2) - z
  double step = 0.99 * 0.25;
  int count = 0;
  while (step < 0.9) {
    const double next = limit_step(0.9, 1.0, 0.0, 0.0, last);
    EXPECT_DOUBLE_EQ(next, std::min(1.01 * step, 0.9));
    step = next;
    ++count;
  }
  EXPECT_EQ(count, 130);  // log(0.9 / 0.2475) / log(1.01)
  EXPECT_EQ(last, 0.0);
}

// DT2MS < 0: the small element gets (0.5/0.25)^2 times its mass, the other none; the step is TSSFAC |DT2MS|.
TEST(MassScaling, NegativeLiftsSmallElementsOnly) {
  Pair rig;
  rig.model.control.step.safety = 0.9;
  rig.model.control.step.mass_scaling = -0.5;
  rig.run(3.0, [&](const Frame& frame) { EXPECT_DOUBLE_EQ(frame.state.next_step, 0.45); });
  EXPECT_DOUBLE_EQ(rig.state.added_mass, 0.75);
  EXPECT_DOUBLE_EQ(rig.mass(), 2.0);
  EXPECT_DOUBLE_EQ(rig.state.mass[2], 0.5);
}

// A fraction of the first step means the same as DT2MS = -that: the smallest element alone has a step of
// 0.25.
TEST(MassScaling, FractionOfTheFirstStep) {
  Pair rig;
  rig.model.control.step.safety = 0.9;
  rig.model.control.step.mass_scaling_fraction = 2.0;
  rig.run(3.0, [&](const Frame& frame) { EXPECT_DOUBLE_EQ(frame.state.next_step, 0.45); });
  EXPECT_DOUBLE_EQ(rig.state.added_mass, 0.75);
}

TEST(MassScaling, PositiveMakesAllElementsEqual) {
  Pair rig;
  rig.model.control.step.mass_scaling = 0.5;
  rig.run(3.0, [&](const Frame& frame) { EXPECT_DOUBLE_EQ(frame.state.next_step, 0.5); });
  EXPECT_DOUBLE_EQ(rig.state.mass[0], 0.125);  // (0.5/1)^2 of 0.5
  EXPECT_DOUBLE_EQ(rig.state.mass[2], 0.5);
  EXPECT_DOUBLE_EQ(rig.state.added_mass, 0.75 - 0.75);
}

TEST(MassScaling, CurveIncreasesItUnlessFirstOnly) {
  for (const bool first_only : {false, true}) {
    Pair rig;
    rig.model.control.step.mass_scaling = -0.5;
    rig.model.control.step.mass_scaling_curve = rig.curve({0, 1, 1, 9}, {0.1, 0.1, 1.0, 1.0});
    rig.model.control.step.mass_scaling_first_only = first_only;
    rig.run(3.0);
    EXPECT_DOUBLE_EQ(rig.state.next_step, first_only ? 0.5 : 1.0);
    EXPECT_DOUBLE_EQ(rig.state.added_mass, first_only ? 0.75 : 3.75);
  }
}

TEST(MassScaling, EndsWhenTooMuchMassIsAdded) {
  for (const double limit : {59.0, 61.0}) {  // 0.75 added to 1.25 is 60 %
    Pair rig;
    rig.model.control.step.mass_scaling = -0.5;
    rig.model.control.end.mass_change = limit;
    EXPECT_EQ(rig.run(3.0).ending, limit < 60.0 ? Ending::mass_limit : Ending::end_time);
  }
}

// A broken spring: its energy moves to the eroded share, and the node that has lost it leaves with its own.
TEST(Erosion, KeepsTheBalance) {
  Rig rig;
  const Index a = rig.node(0), b = rig.node(10), c = rig.particle(0.5, {20, 0, 0});
  rig.springs({{{a, b}, 1.0, 1.0, 2.0}, {{b, c}, 1.0, 1.0}});
  rig.velocity(a, {-5, 0, 0});
  rig.model.control.step.safety = 0.01;
  std::vector<Id> gone;
  double cycles = 0.0;
  const Outcome outcome = rig.run(4.0, [&](const Frame& frame) {
    gone.insert(gone.end(), frame.eroded.begin(), frame.eroded.end());
    cycles += frame.state.cycle > 0 ? (gone.empty() || !frame.eroded.empty() ? 2.0 : 1.0) : 0.0;
    EXPECT_NEAR(frame.state.energy.total(), frame.state.energy.initial,
                0.05);  // order dt: half a step's work of the force that vanishes
  });
  EXPECT_EQ(gone, std::vector<Id>{1});
  EXPECT_EQ(outcome.element_cycles, cycles);
  EXPECT_EQ(rig.state.mass[0], 0.0);
  EXPECT_EQ(rig.state.mass[1], 1.0);  // keeps the mass of both springs
  EXPECT_GT(rig.state.energy.eroded_internal, 2.0 - 1e-9);
  EXPECT_GT(rig.state.energy.eroded_kinetic, 0.1);
  EXPECT_DOUBLE_EQ(rig.state.parts[0].eroded_internal, rig.state.energy.eroded_internal);
  EXPECT_DOUBLE_EQ(rig.state.parts[0].eroded_kinetic, rig.state.energy.eroded_kinetic);
}

TEST(Termination, EachCriterion) {
  const auto ending = [](auto&& prepare) {
    Pair rig;
    rig.velocity(rig.c, {1e-3, 0, 0});
    prepare(rig);
    return rig.run(10.0).ending;
  };
  EXPECT_EQ(ending([](Pair&) {}), Ending::end_time);
  EXPECT_EQ(ending([](Pair& rig) { rig.model.control.end.cycles = 3; }), Ending::cycle_limit);
  EXPECT_EQ(ending([](Pair& rig) { rig.model.control.end.energy_change = 1e-6; }), Ending::energy_limit);
  EXPECT_EQ(ending([](Pair& rig) {
              rig.model.control.end.step_fraction = 0.9;
              rig.model.control.step.limit_curve = rig.curve({0, 1, 9}, {1, 1, 0.1});
            }),
            Ending::step_too_small);
  EXPECT_EQ(ending([](Pair& rig) {
              rig.model.control.end.nodes.push_back({rig.c, 1, 20.0005, -1e9});
            }),
            Ending::node_bound);
}

// ENDTIM: the run stops at the first time that is not before it; roundoff in the sum of steps is no reason to
// go on.
TEST(Termination, StopsAtTheFirstTimeNotBeforeTheEnd) {
  Rig rig;
  rig.particle(1.0, {0, 0, 0});
  rig.fixed_step(0.1);
  rig.run(1.0);
  EXPECT_EQ(rig.state.cycle, 10);
  rig.run(1.05);
  EXPECT_EQ(rig.state.cycle, 11);
}

// The end says who asked for it: a switch, or a signal.
TEST(Termination, WishToStop) {
  for (const bool signal : {false, true}) {
    Pair rig;
    rig.initialise();
    rig.model.control.end.time = 1e9;
    Wishes wishes;
    Watch watch([&](const Frame& frame) {
      if (frame.state.cycle < 7) return;
      wishes.signal = signal;
      wishes.stop = true;
    });
    Observer* const observers[] = {&watch};
    const Outcome outcome =
        make_explicit(rig.world, {}, rig.diagnostics)->advance(rig.state, observers, wishes);
    EXPECT_EQ(outcome.ending, signal ? Ending::signal : Ending::switched_off);
    EXPECT_EQ(rig.state.cycle, 7);
    EXPECT_EQ(watch.last_cycle, 7);
  }
}

// Physics that fails names the element, and observers get a last frame.
TEST(Termination, PhysicsFailures) {
  Rig rig;
  const Index a = rig.node(0), b = rig.node(10);
  rig.springs({{{a, b}, 1.0, 1.0, 1e300, 0.5}});
  rig.velocity(b, {1, 0, 0});
  rig.model.control.step.safety = 0.1;
  rig.model.control.end.time = 10.0;
  rig.initialise();
  Watch watch([](const Frame&) {});
  Observer* const observers[] = {&watch};
  Wishes wishes;
  const Outcome outcome =
      make_explicit(rig.world, {}, rig.diagnostics)->advance(rig.state, observers, wishes);
  EXPECT_EQ(outcome.ending, Ending::physics);
  EXPECT_EQ(outcome.status.element, 1);
  EXPECT_EQ(outcome.status.what, "spring failed");
  EXPECT_EQ(watch.ending, Ending::physics);
  EXPECT_EQ(watch.status.element, 1);
  EXPECT_EQ(watch.last_cycle, rig.state.cycle);

  // A load that is no number is caught at its node.
  Pair pair;
  model::NodeLoad load;
  load.nodes = {pair.c};
  load.curve = pair.constant(std::numeric_limits<double>::quiet_NaN());
  pair.model.node_loads.push_back(load);
  const Outcome bad = pair.run(1.0);
  EXPECT_EQ(bad.ending, Ending::physics);
  EXPECT_EQ(bad.status.element, 2);
  EXPECT_NE(bad.status.what.find("node 3"), std::string::npos);
}

}  // namespace
}  // namespace cleave::solver::test
