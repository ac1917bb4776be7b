/// The solver with solid elements: what springs cannot show.

#include <gtest/gtest.h>

#include "deck/deck.hpp"
#include "model/material/law.hpp"
#include "rig.hpp"

namespace cleave::solver::test {
namespace {

/// Bar of hexahedra along z, elastic with Poisson's ratio 0, so that it is one-dimensional: E = 4, rho = 1, c
/// = 2.
struct Bar : Rig {
  int count, width;
  explicit Bar(int n, int across = 1) : count(n), width(across) {
    const int side = across + 1;
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) node(0.1 * i / across, 0.1 * j / across, double(k) / n);
    model::Elements hex;
    const auto at = [&](int i, int j, int k) { return static_cast<Index>((k * side + j) * side + i); };
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
          hex.id.push_back(static_cast<Id>(hex.id.size() + 1));
          hex.part.push_back(0);
          for (const int up : {0, 1})
            for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
              hex.node.push_back(at(i + di, j + dj, k + up));
        }
    model.mesh.solids.push_back(hex);
    model.parts[0].section.family = "SOLID";
    model.parts[0].section.form = 1;
    model.parts[0].density = 1.0;
    model.parts[0].law = law();
    model.parts[0].hourglass.quadratic_bulk = model.parts[0].hourglass.linear_bulk = 0.0;
    model.control.energy.hourglass = true;
    model.control.step.safety = 0.9;
  }
  static std::shared_ptr<const model::Law> law() {
    static const std::vector<model::Curve> curves;
    static const std::vector<model::Table> tables;
    deck::Diagnostics diagnostics;
    const auto deck =
        deck::Deck::read_text("*KEYWORD\n*MAT_ELASTIC\n1,1.0,4.0,0.0\n*END\n", "law.k", {}, diagnostics);
    for (const auto& block : deck.blocks())
      if (const auto* entry = model::find_law(block.keyword))
        return entry->build(deck.cards(block, diagnostics).at(0),
                            model::LawContext{curves, tables, nullptr, diagnostics});
    return nullptr;
  }
  void start() {
    if (world.blocks.empty()) world = discretisation::build(model, diagnostics);
    ASSERT_TRUE(discretisation::initialise(world, state).ok);
  }
  std::vector<Index> all() const {
    std::vector<Index> out;
    for (std::size_t a = 0; a < model.mesh.nodes.count(); ++a) out.push_back(static_cast<Index>(a));
    return out;
  }
  double momentum() const {
    double sum = 0.0;
    for (const Index a : all()) sum += state.mass[static_cast<std::size_t>(a)] * v(a, 2);
    return sum;
  }
};

void put_wall(Bar& bar, double speed) {
  for (const Index a : bar.all()) bar.velocity(a, {0, 0, speed});
  model::RigidWall wall;
  wall.nodes = bar.all();
  wall.origin = {0, 0, 0};
  wall.normal = {0, 0, 1};
  bar.model.walls.push_back(wall);
}

// An elastic bar against a wall: impulse and momentum agree to roundoff, contact lasts 2 L / c, energy is
// kept.
TEST(SolidBody, BarRebounds) {
  Bar bar(40);
  put_wall(bar, -2e-3);
  bar.start();
  const double before = bar.momentum();
  double impulse = 0.0, last_contact = 0.0;
  bar.advance(1.5, {}, [&](const Frame& frame) {
    impulse += frame.walls[0].normal * 0.5 * (frame.state.step + frame.state.next_step);
    if (frame.walls[0].normal > 1e-5) last_contact = frame.state.time;
    EXPECT_NEAR(frame.state.energy.ratio(), 1.0, 0.01);
  });
  EXPECT_NEAR(bar.momentum() - before, impulse, 1e-12 * impulse);
  EXPECT_NEAR(last_contact, 1.0, 0.1);  // the wave is there and back
  EXPECT_NEAR(bar.momentum(), -before, 0.05 * std::abs(before));
}

// A plane pulse in the bar leaves through its end: less than 1 % of the amplitude stays.
TEST(SolidBody, AbsorbingEndOfABar) {
  Bar bar(60);
  for (const Index a : bar.all()) {
    const double s = (bar.model.mesh.nodes.position[3 * static_cast<std::size_t>(a) + 2] - 0.5) / 0.1;
    bar.velocity(a, {0, 0, 1e-4 * std::exp(-s * s)});
  }
  model::AbsorbingFaces faces;
  const Index first = static_cast<Index>(4 * 60);
  faces.segments.push_back({{first, first + 1, first + 3, first + 2}});
  bar.model.absorbing.push_back(faces);
  bar.start();
  bar.advance(1.2);
  EXPECT_FALSE(bar.diagnostics.failed());
  const auto& energy = bar.state.energy;
  EXPECT_LT(energy.kinetic + energy.internal, 1e-4 * energy.initial);
}

// Mass scaling of elements: the step asked for is taken, and the mass is what the stable step says.
TEST(SolidBody, MassScalingReachesItsStep) {
  Bar bar(10);
  bar.start();
  bar.advance(1e-9);
  const double stable = bar.state.next_step / 0.9;
  bar.model.control.step.mass_scaling = -1.5 * stable;
  bar.start();
  double mass = 0.0;
  for (const double m : bar.state.mass) mass += m;
  bar.advance(20.0 * stable);
  EXPECT_NEAR(bar.state.next_step, 0.9 * 1.5 * stable, 1e-12 * stable);
  EXPECT_NEAR(bar.state.added_mass, (1.5 * 1.5 - 1.0) * mass, 1e-9 * mass);
}

// Restart from a copy and other thread counts, with hourglass forces and viscosity in play: the same bits.
TEST(SolidBody, SameBitsAfterRestartAndOnThreads) {
  const auto run = [](int threads, std::int64_t stop) {
    base::set_thread_count(threads);
    Bar bar(60, 5);
    bar.model.parts[0].hourglass = {};
    put_wall(bar, -0.3);
    bar.model.walls[0].friction = 0.3;
    for (std::size_t a = 0; a < bar.model.mesh.nodes.count(); ++a)
      bar.model.initial_velocity[3 * a] = 0.05 * std::sin(3.0 * static_cast<double>(a));
    bar.start();
    if (stop > 0) bar.advance(0.3, Options{stop});
    State copy = bar.state;
    bar.state = State{};
    bar.state = copy;
    EXPECT_EQ(bar.advance(0.3).ending, Ending::end_time);
    base::set_thread_count(0);
    return bar.state;
  };
  const State whole = run(1, 0);
  ASSERT_GT(whole.cycle, 20);
  for (const auto& [threads, stop] : {std::pair<int, std::int64_t>{1, 1}, {1, 17}, {2, 0}, {3, 5}, {7, 0}}) {
    const State other = run(threads, stop);
    EXPECT_EQ(other.cycle, whole.cycle);
    EXPECT_TRUE(other.position == whole.position) << threads << " " << stop;
    EXPECT_TRUE(other.velocity == whole.velocity);
    EXPECT_TRUE(other.blocks[0].point == whole.blocks[0].point);
    EXPECT_EQ(other.energy.total(), whole.energy.total());
    EXPECT_EQ(other.energy.external, whole.energy.external);
  }
}

// A crushed element stops the run by name, and the last frame is seen.
TEST(SolidBody, InvertedElementIsNamed) {
  Bar bar(4);
  put_wall(bar, -40.0);
  bar.start();
  const Outcome outcome = bar.advance(1.0);
  EXPECT_EQ(outcome.ending, Ending::physics);
  EXPECT_GT(outcome.status.element, 0);
  EXPECT_FALSE(outcome.status.what.empty());
  EXPECT_FALSE(outcome.status.likely_cause.empty());
}

}  // namespace
}  // namespace cleave::solver::test
