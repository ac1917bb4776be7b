/// What observers are shown beside the motion: openings of cracks, stresses across the plane, and that what
/// nobody asks for is not worked out.

#include "model/elasticity.hpp"
#include "tents_rig.hpp"

namespace cleave::solver::test {
namespace {

/// Asks for nothing, or for some things only; keeps what it sees.
struct Bystander final : Observer {
  struct At {
    double time, kinetic, x, v;
    double unwatched;  ///< x of the node after it
    bool due;
    std::vector<CrackOpening> cracks;
  };
  std::vector<At> seen;
  CellFields first_cells;
  discretisation::Id node = 0;
  unsigned asks = 0;  ///< bits of Wanted

  void begin(const Frame& frame) override {
    first_cells = frame.cells->cells();
    after_step(frame);
  }
  void after_step(const Frame& f) override {
    f.evaluate(asks);
    seen.push_back({f.state.time,
                    f.state.energy.kinetic,
                    f.state.position[3 * static_cast<std::size_t>(node)],
                    f.state.velocity[3 * static_cast<std::size_t>(node)],
                    f.state.position[3 * static_cast<std::size_t>(node + 1)],
                    f.energies_due,
                    {f.cracks.begin(), f.cracks.end()}});
  }
  void finish(const Frame& frame, Ending, const discretisation::StepStatus&) override { frame.save(); }
};

template <int D>
Outcome observe(const Rig<D>& rig, Bystander& who, discretisation::State& state) {
  Wishes wishes;
  Observer* const observers[] = {&who};
  return make_tents<D>(rig.world, rig.body(), {})->advance(state, observers, wishes);
}

/// Two halves of a body, cut through across the last axis, fly apart without strain: the opening is velocity
/// times time across the cut, the sliding along it.
template <int D>
void fly_apart(SpaceMeshInput<D> mesh) {
  for (std::size_t s = 0; s < mesh.simplex.size(); ++s)
    for (std::size_t i = 0; i <= D; ++i) {  // faces with all corners in the middle
      std::array<Vertex, D> face;
      std::size_t n = 0;
      bool inside = true;
      double side = 0.0;
      for (std::size_t c = 0; c <= D; ++c) {
        const double x = mesh.vertex[static_cast<std::size_t>(mesh.simplex[s][c])][D - 1];
        if (c == i) {
          side = x;
        } else {
          face[n++] = mesh.simplex[s][c];
          inside = inside && std::abs(x - 0.5) < 1e-12;
        }
      }
      if (inside && side > 0.5) mesh.crack.push_back(face);
    }
  ASSERT_FALSE(mesh.crack.empty());
  Rig<D> rig(std::move(mesh), 0.3, 0.05);
  rig.space = {LocalSpace::three_field, 1};
  rig.initial = [](Simplex, const Event<D>& y) {
    PointState<D> s;
    if (y[D - 1] < 0.5) return s;
    s.v[0] = D > 1 ? 0.3 : 0.0;
    s.v[D - 1] = 0.7;
    return s;
  };
  rig.model.precracks.emplace_back();
  for (std::size_t v = 0; v < rig.input.vertex.size(); ++v)
    if (std::abs(rig.input.vertex[v][D - 1] - 0.5) < 1e-12)
      rig.model.requests.history_nodes.push_back(static_cast<model::Index>(v));
  rig.model.requests.history_nodes.push_back(0);  // on no crack
  Bystander who;
  auto state = rig.fresh();
  ASSERT_TRUE(observe(rig, who, state).status.ok);
  for (const auto& at : who.seen) {
    ASSERT_EQ(at.cracks.size(), rig.model.requests.history_nodes.size() - 1);
    for (const CrackOpening& crack : at.cracks) {
      EXPECT_EQ(crack.side, 2);
      EXPECT_NEAR(crack.opening, 0.7 * at.time, 1e-12);
      EXPECT_NEAR(crack.sliding, D == 1 ? 0.0 : D == 2 ? -0.3 * at.time : 0.3 * at.time, 1e-12);
      EXPECT_NEAR(std::abs(crack.normal[D - 1]), 1.0, 1e-14);
    }
  }
}

TEST(TentsCrack, OpeningOfTwoHalvesThatFlyApart) {
  fly_apart<1>(sample::line(4));
  fly_apart<2>(sample::grid(4));
  fly_apart<3>(sample::cube(2));
}

/// Plane strain: no strain across the plane asks for nu times the sum of the stresses in it.
TEST(TentsCells, StressAcrossThePlane) {
  Rig<2> rig(sample::grid(2), 0.01, 0.01);
  rig.initial = [](Simplex, const Event<2>&) {
    PointState<2> s;
    s.strain = {0.01, 0.02, 0.005};
    return s;
  };
  Bystander who;
  auto state = rig.fresh();
  ASSERT_TRUE(observe(rig, who, state).status.ok);
  const auto field = [&](std::string_view name) {
    for (const auto& f : who.first_cells.fields)
      if (f.name == name) return f.value;
    ADD_FAILURE() << name;
    return std::vector<double>(3, 0.0);
  };
  const double s11 = 0.05 / 3.0, s22 = 0.07 / 3.0, s12 = 0.01 / 3.0;  // lambda = mu = 1/3
  const double s33 = 0.25 * (s11 + s22);
  EXPECT_NEAR(field("stress")[0], s11, 1e-15);
  EXPECT_NEAR(field("stress_across")[0], s33, 1e-15);
  EXPECT_NEAR(field("max_shear_stress")[0], std::hypot(0.5 * (s11 - s22), s12), 1e-15);
  const double mises = std::sqrt(
      0.5 * (std::pow(s11 - s22, 2) + std::pow(s22 - s33, 2) + std::pow(s33 - s11, 2)) + 3.0 * s12 * s12);
  EXPECT_NEAR(field("von_mises")[0], mises, 1e-15);

  Elastic<2> plate;
  ASSERT_EQ(make_isotropic<2>(1.0, 5.0 / 6.0, 0.25, PlaneKind::stress, plate), "");
  EXPECT_EQ(plate.stress_across({0.01, 0.02, 0.005}), 0.0);
}

/// What a node shows is the mean over the simplices around it by their size: with a velocity of its own in
/// each simplex at the start.
TEST(TentsNodes, AreMeansBySize) {
  Rig<2> rig(sample::grid(3, 0.25), 0.01, 0.01);
  rig.initial = [](Simplex s, const Event<2>&) {
    PointState<2> state;
    state.v[0] = 1.0 + s * s;
    return state;
  };
  Watcher watcher;
  auto state = rig.fresh();
  ASSERT_TRUE(rig.run(state, watcher).status.ok);
  std::vector<double> sum(rig.input.vertex.size(), 0.0), size(sum);
  for (std::size_t s = 0; s < rig.input.simplex.size(); ++s) {
    std::array<Point<2>, 3> corner;
    for (std::size_t c = 0; c < 3; ++c)
      corner[c] = rig.input.vertex[static_cast<std::size_t>(rig.input.simplex[s][c])];
    const double area = std::fabs(signed_volume<2>(corner));
    for (const Vertex v : rig.input.simplex[s]) {
      sum[static_cast<std::size_t>(v)] += area * (1.0 + static_cast<double>(s * s));
      size[static_cast<std::size_t>(v)] += area;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    EXPECT_NEAR(watcher.seen[0].velocity[3 * v], sum[v] / size[v], 1e-10) << v;
}

/// Between instants of energies a run that is only asked for nodes evaluates those alone, and comes to the
/// same bits.
TEST(TentsInstants, OnlyWhatIsAskedForIsEvaluated) {
  const auto make = [] {
    auto rig = std::make_unique<Rig<2>>(sample::grid(3, 0.2), 0.2, 0.1);
    make_standing_wave(*rig);
    rig->model.requests.nodout.every = 0.005;
    rig->model.requests.history_nodes = {5};
    return rig;
  };
  const auto all = make(), few = make();
  Watcher watcher;
  auto state = all->fresh();
  all->run(state, watcher);
  Bystander who;
  who.node = 5;
  auto other = few->fresh();
  ASSERT_TRUE(observe(*few, who, other).status.ok);

  ASSERT_EQ(who.seen.size(), watcher.seen.size());
  std::size_t due = 0, current = 0;
  for (std::size_t k = 0; k < who.seen.size(); ++k) {
    EXPECT_EQ(who.seen[k].x, watcher.seen[k].position[15]);
    EXPECT_EQ(who.seen[k].v, watcher.seen[k].velocity[15]);
    const bool same = who.seen[k].kinetic == watcher.seen[k].energy.kinetic;
    EXPECT_TRUE(same || !who.seen[k].due) << who.seen[k].time;
    due += who.seen[k].due;
    current += same;
  }
  EXPECT_EQ(due, 3u);
  EXPECT_EQ(current, 3u);
  EXPECT_TRUE(other.position == state.position);
  EXPECT_TRUE(other.velocity == state.velocity);
  EXPECT_EQ(other.energy.internal, state.energy.internal);
  ASSERT_EQ(other.memory.size(), state.memory.size());
  EXPECT_TRUE(other.memory[0].values == state.memory[0].values);

  // Who asks for one thing gets it at every instant, and the other one no more often than before.
  for (const unsigned asks : {every_node, energies}) {
    Bystander asking;
    asking.node = 5, asking.asks = asks;
    auto third = few->fresh();
    ASSERT_TRUE(observe(*few, asking, third).status.ok);
    std::size_t nodes = 0, sums = 0;
    for (std::size_t k = 0; k < asking.seen.size(); ++k) {
      const Seen& exact = watcher.seen[k];
      nodes += asking.seen[k].unwatched == exact.position[18];
      sums += asking.seen[k].kinetic == exact.energy.kinetic;
    }
    EXPECT_EQ(asks == every_node ? nodes : sums, asking.seen.size());
    EXPECT_LT(asks == every_node ? sums : nodes, asking.seen.size() / 2);
  }
}

/// Stresses of single elements are those of the wave in their middles, in the order of the requests, at the
/// instants of elout, where energies are not due. An element of two triangles has the mean of both.
template <int D>
void elements_of_standing_wave(SpaceMeshInput<D> mesh, SpaceChoice space, int per_element, double tolerance) {
  Rig<D> rig(std::move(mesh), 0.6, 0.3);
  rig.space = space;
  make_standing_wave(rig);
  rig.simplices_per_element = per_element;
  const std::vector<model::Id> wanted = {3, 1, 2};
  (D == 1   ? rig.model.requests.history_beams
   : D == 2 ? rig.model.requests.history_shells
            : rig.model.requests.history_solids) = wanted;
  rig.model.requests.elout.every = 0.2;
  rig.model.parts[0].section.form = D == 1 ? 2 : 0;
  const auto elastic = std::make_shared<model::Elasticity>();
  elastic->poisson = 0.25;
  rig.model.parts[0].elastic = elastic;
  struct Probe final : Observer {
    std::vector<std::pair<double, bool>> seen;
    std::function<void(const Frame&)> check;
    void begin(const Frame& frame) override { after_step(frame); }
    void after_step(const Frame& frame) override {
      seen.emplace_back(frame.state.time, frame.energies_due);
      check(frame);
    }
    void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}
  } probe;
  probe.check = [&](const Frame& frame) {
    const std::vector<ElementStress> stresses = frame.cells->stresses();
    ASSERT_EQ(stresses.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_EQ(stresses[k].element, wanted[k]);
      EXPECT_EQ(stresses[k].part, 0);
      double strain = 0.0, volume = 0.0;
      for (int s = 0; s < per_element; ++s) {
        const auto& corners = rig.input.simplex[static_cast<std::size_t>((wanted[k] - 1) * per_element + s)];
        std::array<Point<D>, D + 1> corner;
        Event<D> middle{};
        for (std::size_t c = 0; c <= D; ++c) {
          corner[c] = rig.input.vertex[static_cast<std::size_t>(corners[c])];
          middle[0] += corner[c][0] / (D + 1);
        }
        middle[D] = frame.state.time;
        const double size = std::fabs(signed_volume<static_cast<std::size_t>(D)>(corner));
        strain += size * standing_wave<D>(middle).strain[0];
        volume += size;
      }
      strain /= volume;
      // lambda + 2 mu = 1, lambda = 1/3: the same across the plane and across a bar.
      const double exact[] = {strain, strain / 3, strain / 3, 0.0, 0.0, 0.0};
      for (int c = 0; c < 6; ++c)
        EXPECT_NEAR(stresses[k].stress[c], exact[c], tolerance) << D << "D, component " << c;
    }
  };
  Wishes wishes;
  Observer* const observers[] = {&probe};
  auto state = rig.fresh();
  ASSERT_TRUE(make_tents<D>(rig.world, rig.body(), {})->advance(state, observers, wishes).status.ok);
  ASSERT_EQ(probe.seen.size(), 5u);
  const double times[] = {0.0, 0.2, 0.3, 0.4, 0.6};
  const bool due[] = {true, false, true, false, true};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(probe.seen[k].first, times[k], 1e-12);
    EXPECT_EQ(probe.seen[k].second, due[k]) << times[k];
  }
}

TEST(TentsElements, StressesOfAStandingWave) {
  elements_of_standing_wave<1>(sample::line(8, 0.2), {LocalSpace::trefftz, 4}, 1, 1e-4);
  elements_of_standing_wave<2>(sample::grid(3, 0.2), {LocalSpace::trefftz, 4}, 2, 4e-3);
  elements_of_standing_wave<3>(sample::cube(2), {LocalSpace::trefftz, 3}, 1, 3e-2);
}

}  // namespace
}  // namespace cleave::solver::test
