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

// A square that lies parallel behind another, half over it: area 1/2, volume depth / 2, energy depth^2 / 4,
// and the shares of the corners are the integrals of the bilinear functions. Along the plane the edge of each
// is drawn away from the other by the energy of its length.
TEST(ContactOverlap, HalfCoveredSquares) {
  const Vector above[4] = {{0.5, 0, -0.1}, {0.5, 1, -0.1}, {1.5, 1, -0.1}, {1.5, 0, -0.1}};  // looks down
  Overlap o;
  Push push;
  ASSERT_TRUE(o.meet(above, square));
  ASSERT_TRUE(o.push({1.0, 1.0, 0.0, 0.0}, 0.0, push));
  EXPECT_NEAR(o.facing(), 1.0, 1e-15);
  EXPECT_NEAR(o.area(), 0.5, 1e-15);
  EXPECT_NEAR(o.deepest(), 0.1, 1e-15);
  EXPECT_NEAR(push.deep_area, 0.5, 1e-15);
  EXPECT_NEAR(push.volume, 0.05, 1e-15);
  EXPECT_NEAR(push.energy, 0.0025, 1e-15);
  EXPECT_NEAR(push.normal, 0.05, 1e-15);
  EXPECT_NEAR(push.wb[0], 0.125, 1e-14);  // the far corners of b: mean of 1 - x over the right half, halved
  EXPECT_NEAR(push.wb[1], 0.375, 1e-14);
  EXPECT_NEAR(push.wa[0], 0.375, 1e-14);
  EXPECT_NEAR(push.wa[3], 0.125, 1e-14);
  Vector sum{0, 0, 0};
  for (const Vector& f : push.on_a) sum = sum + f;
  EXPECT_NEAR(sum.x, 0.005, 1e-15);  // 0.1^2 / 2 over a length of 1
  EXPECT_NEAR(sum.y, 0.0, 1e-15);
  EXPECT_NEAR(sum.z, 0.05, 1e-15);
  const Vector clear[4] = {{0.5, 0, 0.1}, {0.5, 1, 0.1}, {1.5, 1, 0.1}, {1.5, 0, 0.1}};
  EXPECT_FALSE(o.meet(clear, square));
  const Vector up[4] = {{0.5, 0, -0.1}, {1.5, 0, -0.1}, {1.5, 1, -0.1}, {0.5, 1, -0.1}};  // looks away
  EXPECT_FALSE(o.meet(up, square));
}

/// Two faces at random angles that may overlap.
struct TwoFaces {
  Vector a[4], b[4];
  enum Kind { plane, triangles, warped };
  TwoFaces(std::mt19937& random, Kind kind, double tilt) {
    std::uniform_real_distribution<double> shift(-0.15, 0.15), far(-0.6, 0.6);
    const Vector by{far(random), far(random), 0.1 + shift(random)};
    const double u = tilt * far(random), v = tilt * far(random), s = far(random), t = far(random);
    const Vector flat[4] = {{0, 0, -0.1}, {0, 1, -0.1}, {1, 1, -0.1}, {1, 0, -0.1}};
    const double warp = kind == warped ? 0.3 : 0.0;
    for (int i = 0; i < 4; ++i) {
      const Vector p = flat[i] + Vector{shift(random), shift(random), 0.0};
      const Vector q = square[i] + Vector{shift(random), shift(random), 0.0};
      a[i] = p + by + Vector{0, 0, u * (p.x - 0.5) + v * (p.y - 0.5) + warp * shift(random)};
      b[i] = q + Vector{0, 0, s * (q.x - 0.5) + t * (q.y - 0.5) + warp * shift(random)};
    }
    if (kind == triangles) a[3] = a[2], b[3] = b[2];
  }
};

// The forces are the gradient of the energy, against differences, with and without an offset, for faces
// parallel and inclined, cut by each other's edges and by the depth: for each corner of triangles; for
// motions of plane quadrilaterals as rigid bodies, and for each of their corners and those of warped ones to
// the order of the quadrature.
TEST(ContactOverlap, ForcesAreTheGradientOfTheEnergy) {
  std::mt19937 random(3);
  int met = 0, tilted = 0, kinks = 0, all = 0;
  double worst[3] = {0.0, 0.0, 0.0}, sum = 0.0;
  int warped = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const auto kind = static_cast<TwoFaces::Kind>(trial % 3);
    TwoFaces faces(random, kind, trial % 2 == 0 ? 0.3 : 2.5);
    const double offset = trial % 5 == 0 ? 0.02 : 0.0;
    const Springs springs{0.8, 0.7, 30.0, 100.0};
    Overlap o;
    Push push;
    if (!o.meet(faces.a, faces.b) || !o.push(springs, offset, push)) continue;
    ++met;
    if (o.facing() < 0.9) ++tilted;
    double largest = 0.0;
    for (int i = 0; i < 4; ++i) largest = std::max({largest, norm(push.on_a[i]), norm(push.on_b[i])});
    /// Energy after a motion of one face; the difference quotient against minus the work of the forces.
    const auto compare = [&](bool of_a, const Vector way[4]) {
      const auto at = [&](double by) {
        TwoFaces moved = faces;
        for (int i = 0; i < 4; ++i)
          (of_a ? moved.a : moved.b)[i] = (of_a ? faces.a : faces.b)[i] + by * way[i];
        Overlap other;
        Push value;
        return other.meet(moved.a, moved.b) && other.push(springs, offset, value) ? value.energy : 0.0;
      };
      const auto slope = [&](double h) {  // fourth order
        return (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
      };
      double work = 0.0;
      for (int i = 0; i < 4; ++i) work += base::dot(of_a ? push.on_a[i] : push.on_b[i], way[i]);
      const double wide = slope(1e-5), narrow = slope(2e-6);
      ++all;
      if (std::abs(wide - narrow) > 1e-7 * largest) {  // a corner passes an edge in between
        ++kinks;
        return 0.0;
      }
      return std::abs(work + wide) / largest;
    };
    const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const bool of_a : {true, false})
      for (const Vector& axis : axes) {
        const Vector* x = of_a ? faces.a : faces.b;
        for (int i = 0; i < (kind == TwoFaces::triangles ? 3 : 4); ++i) {
          Vector way[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
          way[i] = axis;
          if (kind == TwoFaces::triangles) way[3] = way[2];
          const double error = compare(of_a, way);
          worst[kind] = std::max(worst[kind], error);
          if (kind == TwoFaces::warped) sum += error, ++warped;
          if (kind == TwoFaces::triangles) {
            EXPECT_LT(error, 1e-6) << trial;
          }
        }
        if (kind != TwoFaces::plane) continue;
        const Vector shift[4] = {axis, axis, axis, axis};
        EXPECT_LT(compare(of_a, shift), 1e-6) << trial;
        Vector turn[4];
        for (int i = 0; i < 4; ++i) turn[i] = base::cross(axis, x[i]);
        EXPECT_LT(compare(of_a, turn), 1e-6) << trial;
      }
  }
  EXPECT_LT(worst[TwoFaces::plane], 0.03);
  EXPECT_LT(sum / warped, 0.01);
  EXPECT_GT(met, 300);
  EXPECT_GT(tilted, 60);
  EXPECT_LT(kinks, all / 50);
}

// No resultant and no moment, to roundoff.
TEST(ContactOverlap, ForcesAndMomentsSumToZero) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const TwoFaces faces(random, static_cast<TwoFaces::Kind>(trial % 3), 2.0);
    Overlap o;
    Push push;
    if (!o.meet(faces.a, faces.b) || !o.push({1.0, 0.8, 10.0, 30.0}, 0.0, push)) continue;
    Vector sum{0, 0, 0}, moment{0, 0, 0};
    double size = 0.0;
    for (int i = 0; i < 4; ++i) {
      sum = sum + push.on_a[i] + push.on_b[i];
      moment = moment + base::cross(faces.a[i], push.on_a[i]) + base::cross(faces.b[i], push.on_b[i]);
      size += norm(push.on_a[i]) + norm(push.on_b[i]);
    }
    EXPECT_LT(norm(sum), 1e-13 * size);
    EXPECT_LT(norm(moment), 1e-13 * size);
  }
}

// The corner of a cube goes around a closed path in and over the edge of a face, and turns: no work is left.
TEST(ContactOverlap, ClosedPathGivesNoWork) {
  const Vector cube[3][4] = {
      {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},  // the three faces around the origin
      {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}};
  const auto place = [](double t, const Vector& x) {
    const double c1 = std::cos(0.7 + 0.2 * std::cos(t)), s1 = std::sin(0.7 + 0.2 * std::cos(t));
    const double c2 = std::cos(0.6 + 0.15 * std::sin(2 * t)), s2 = std::sin(0.6 + 0.15 * std::sin(2 * t));
    const Vector u{x.x, c1 * x.y - s1 * x.z, s1 * x.y + c1 * x.z};
    const Vector v{c2 * u.x + s2 * u.z, u.y, -s2 * u.x + c2 * u.z};
    return v + Vector{0.8 + 0.3 * std::cos(t), 0.4 + 0.1 * std::sin(t), -0.05 + 0.07 * std::sin(t)};
  };
  double left[2] = {0.0, 0.0}, most = 0.0;
  for (int fine = 0; fine < 2; ++fine) {
    const int steps = fine ? 4000 : 1000;
    double work = 0.0;
    for (int step = 0; step < steps; ++step) {
      const double d = 2 * M_PI / steps, t = (step + 0.5) * d;
      for (const auto& face : cube) {
        Vector x[4];
        for (int i = 0; i < 4; ++i) x[i] = place(t, face[i]);
        Overlap o;
        Push push;
        if (!o.meet(x, square) || !o.push({1.0, 1.0, 0.0, 0.0}, 0.0, push)) continue;
        for (int i = 0; i < 4; ++i)
          work += base::dot(push.on_a[i], place(t + 0.5 * d, face[i]) - place(t - 0.5 * d, face[i]));
        most = std::max(most, push.energy);
      }
    }
    left[fine] = std::abs(work);
  }
  EXPECT_GT(most, 1e-5);
  EXPECT_LT(left[0], 1e-3 * most);
  EXPECT_LT(left[1], 1e-4 * most);
}

TEST(ContactOverlap, Triangles) {
  const Vector one[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  const Vector other[4] = {{0, 0, -0.2}, {0, 1, -0.2}, {1, 0, -0.2}, {1, 0, -0.2}};
  Overlap o;
  Push push;
  ASSERT_TRUE(o.meet(other, one));
  ASSERT_TRUE(o.push({0.5, 0.5, 0.0, 0.0}, 0.0, push));
  EXPECT_NEAR(o.area(), 0.5, 1e-15);
  EXPECT_NEAR(push.volume, 0.1, 1e-15);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(push.wa[i], 1.0 / 3.0, 1e-14);
  EXPECT_EQ(push.wb[3], 0.0);
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
