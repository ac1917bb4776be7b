/// The geometry under contact: search, closest points, overlaps.

#include <gtest/gtest.h>

#include <random>

#include "solver/contact/closest.hpp"
#include "solver/contact/gate.hpp"
#include "solver/contact/overlap.hpp"
#include "solver/contact/search.hpp"

namespace cleave::solver::test {
namespace {

std::vector<Bounds> random_boxes(std::size_t count, unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Bounds box{};
    for (int k = 0; k < 3; ++k) {
      box.low[k] = place(random);
      box.high[k] = box.low[k] + size * place(random);
    }
    boxes.push_back(box);
  }
  return boxes;
}

// Every pair that a loop over all finds, and no other.
TEST(ContactSearch, FindsWhatBruteForceFinds) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{700}}) {
    const auto boxes = random_boxes(count, 1, 0.2), queries = random_boxes(40, 2, 0.2);
    Tree tree;
    tree.build(boxes);
    for (const Bounds& query : queries) {
      std::vector<std::int32_t> found, all;
      tree.query(query, [&](std::int32_t item) { found.push_back(item); });
      std::sort(found.begin(), found.end());
      for (std::size_t i = 0; i < count; ++i)
        if (boxes[i].meets(query)) all.push_back(static_cast<std::int32_t>(i));
      EXPECT_EQ(found, all);
    }
  }
}

TEST(ContactSearch, ItemsInOnePlace) {
  std::vector<Bounds> boxes(50, Bounds{{1, 1, 1}, {1, 1, 1}});
  Tree tree;
  tree.build(boxes);
  int count = 0;
  tree.query({{0, 0, 0}, {2, 2, 2}}, [&](std::int32_t) { ++count; });
  EXPECT_EQ(count, 50);
}

const Vector square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
Face quad() {
  Face face;
  face.node = {0, 1, 2, 3};
  return face;
}

TEST(ContactClosest, InsideOnEdgesAndOnCorners) {
  const Closest in = closest_point(quad(), square, {0.3, 0.6, 0.5});
  EXPECT_TRUE(in.inside());
  EXPECT_NEAR(in.point.x, 0.3, 1e-15);
  EXPECT_NEAR(in.point.y, 0.6, 1e-15);
  const Closest edge = closest_point(quad(), square, {0.4, -0.2, 0.1});
  EXPECT_EQ(edge.edge, 0);
  EXPECT_NEAR(edge.weight[0], 0.6, 1e-15);
  const Closest last = closest_point(quad(), square, {-0.1, 0.5, 0.0});
  EXPECT_EQ(last.edge, 3);
  const Closest corner = closest_point(quad(), square, {1.4, 1.2, 0.1});
  EXPECT_EQ(corner.corner, 2);
  for (const Closest& c : {in, edge, last, corner})
    EXPECT_NEAR(c.weight[0] + c.weight[1] + c.weight[2] + c.weight[3], 1.0, 1e-15);
}

// The gate for eight faces keeps no pair that overlaps outside, and most others.
TEST(ContactGate, LetsThroughWhatOverlaps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.8, 0.8);
  int met = 0, passed = 0, all = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Vector a[4] = {{0.4, 0.1, -0.1}, {0.4, 1.1, -0.1}, {1.4, 1.1, -0.1}, {1.4, 0.1, -0.1}};
    for (Vector& x : a) x = x + 0.3 * Vector{shift(random), shift(random), shift(random)};
    if (trial % 3 == 0) a[3] = a[2];
    Gate::Corners corners;
    for (std::size_t lane = 0; lane < base::lane_count; ++lane) {
      const Vector by{shift(random), shift(random), shift(random)};
      Vector b[4];
      for (std::size_t i = 0; i < 4; ++i)
        b[i] = square[i] + by + 0.3 * Vector{shift(random), shift(random), shift(random)};
      if (lane % 3 == 1) b[3] = b[2];
      for (std::size_t i = 0; i < 4; ++i) corners.set(i, lane, b[i]);
    }
    const base::Mask may = Gate(a).open(corners);
    for (std::size_t lane = 0; lane < base::lane_count; ++lane) {
      Overlap o;
      const auto b = corners.face(lane);
      const bool overlaps = o.meet(a, b.data());
      ++all;
      met += overlaps ? 1 : 0;
      passed += may[static_cast<int>(lane)] ? 1 : 0;
      EXPECT_TRUE(!overlaps || may[static_cast<int>(lane)]) << trial << ' ' << lane;
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(passed - met, (all - met) / 3);
}

// Deleting elements one after the other leaves the same surface as deleting all at once.
TEST(ContactSurface, ErosionStepByStepIsThatAtOnce) {
  model::Model m;
  m.parts.resize(1);
  m.mesh.solids.resize(1);
  constexpr int n = 5;
  const auto at = [](int i, int j, int k) { return static_cast<Index>((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        m.mesh.nodes.id.push_back(at(i, j, k) + 1);
        for (const int x : {i, j, k}) m.mesh.nodes.position.push_back(x);
      }
  auto& hex = m.mesh.solids[0];
  for (int e = 0; e < n * n * n; ++e) {
    hex.id.push_back(e + 1);
    hex.part.push_back(0);
    const int i = e % n, j = e / n % n, k = e / n / n;
    for (const int c : {0, 1})
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        hex.node.push_back(at(i + a, j + b, k + c));
  }
  discretisation::World world;
  world.model = &m;
  deck::Diagnostics diagnostics;
  model::Contact contact;
  contact.a.parts = {0};
  Surface step_by_step(world, contact, contact.a, true, false, diagnostics);
  std::vector<model::Id> order(hex.id.begin(), hex.id.end()), gone;
  std::mt19937 random(11);
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t from = 0; from < order.size(); from += 3) {
    const std::vector<model::Id> some(
        order.begin() + static_cast<std::ptrdiff_t>(from),
        order.begin() + static_cast<std::ptrdiff_t>(std::min(from + 3, order.size())));
    gone.insert(gone.end(), some.begin(), some.end());
    step_by_step.erode(some);
    Surface at_once(world, contact, contact.a, true, false, diagnostics);
    at_once.erode(gone);
    ASSERT_EQ(step_by_step.active(), at_once.active());
    ASSERT_EQ(step_by_step.nodes(), at_once.nodes());
    for (const Index node : at_once.nodes()) {
      const auto one = step_by_step.faces_at(node), other = at_once.faces_at(node);
      ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end()));
    }
    for (const std::int32_t f : at_once.active()) {
      for (int e = 0; e < 4; ++e) ASSERT_EQ(step_by_step.neighbour(f, e), at_once.neighbour(f, e));
      ASSERT_EQ(std::count(gone.begin(), gone.end(), at_once.faces()[static_cast<std::size_t>(f)].element),
                0);
    }
  }
  EXPECT_TRUE(step_by_step.active().empty());
}

}  // namespace
}  // namespace cleave::solver::test
