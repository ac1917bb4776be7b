/// The energy of two faces that overlap: its gradient, its start, and what bounds its second derivative.

#include <gtest/gtest.h>

#include <random>

#include "solver/contact/overlap.hpp"
#include "solver/contact/polygon_integrals.hpp"
#include "solver/contact/touch.hpp"

namespace cleave::solver::test {
namespace {

const Vector square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

// A square that lies parallel behind another, half over it: area 1/2, volume depth / 2, energy depth^2 / 4,
// and the shares of the corners are the integrals of the bilinear functions. Along the plane the edge of each
// is drawn away from the other by the energy of its length.
TEST(ContactOverlap, HalfCoveredSquares) {
  const Vector above[4] = {{0.5, 0, -0.1}, {0.5, 1, -0.1}, {1.5, 1, -0.1}, {1.5, 0, -0.1}};  // looks down
  Overlap o;
  Push push;
  ASSERT_TRUE(o.meet(above, square));
  ASSERT_TRUE(o.push({1.0, 1.0, 0.0}, 0.0, push));
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
    const Springs springs{0.8, 0.7, 60.0};
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

/// A square and one that lies over the last of it by a width, inclined to each other by 40 degrees along the
/// strip they share; one behind the other by 0.2 in the middle.
struct Strip {
  Vector a[4], b[4];
  explicit Strip(double width) {
    const double slope = std::tan(20.0 * M_PI / 180.0);
    const Vector above[4] = {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
    for (int i = 0; i < 4; ++i) {
      b[i] = square[i] + Vector{0, 0, slope * (square[i].y - 0.5)};
      a[i] = above[i] + Vector{1.0 - width, 0, -0.2 - slope * (above[i].y - 0.5)};
    }
  }
};

// Faces that come over each other from the side while one is deep behind the other: the energy starts with
// the square of the width they share, so the force across starts from zero. Where they share much it does not
// matter: there it grows with the area, less than proportionally.
TEST(ContactOverlap, NarrowStripsDoNotJump) {
  const auto push = [](double width) {
    const Strip strip(width);
    Overlap o;
    Push value;
    EXPECT_TRUE(o.meet(strip.a, strip.b) && o.push({1.0, 1.0, 0.0}, 0.0, value));
    return value;
  };
  EXPECT_NEAR(push(2e-4).energy / push(1e-4).energy, 4.0, 0.01);
  const Push narrow = push(1e-4), wide = push(0.9), wider = push(0.95);
  Vector across{0, 0, 0};
  for (const Vector& f : narrow.on_a) across = across + f;
  EXPECT_LT(std::abs(across.x), 1e-3 * wide.normal);
  EXPECT_NEAR(std::abs(across.x), 2.0 * narrow.energy / 1e-4, 0.01 * std::abs(across.x));
  EXPECT_GT(wider.energy, wide.energy);
  EXPECT_LT(wider.energy, 0.95 / 0.9 * wide.energy);
}

// Of a rectangle the square of the width is l^2 w^2 / (l^2 + w^2), however it lies; and it changes with each
// edge that moves outward by the integral of its change along the edge.
TEST(ContactOverlap, WidthOfPolygons) {
  const auto rectangle = [](double l, double w, double turn) {
    Polygon p;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {l, 0.0}, {l, w}, {0.0, w}})
      p.add({3.0 + x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)}, 0);
    Width width;
    width.measure(p);
    return width.square;
  };
  EXPECT_NEAR(rectangle(1.0, 1.0, 0.3), 0.5, 1e-14);
  EXPECT_NEAR(rectangle(2.0, 0.5, 0.7), 0.25 / (1.0 + 1.0 / 16.0), 1e-14);
  EXPECT_NEAR(rectangle(1.0, 1e-7, 1.1) * 1e14, 1.0, 1e-8);

  Polygon p;
  for (const Point& at : {Point{0.1, 0.0}, Point{1.2, 0.3}, Point{0.9, 1.0}, Point{0.2, 0.8}}) p.add(at, 0);
  Width width;
  width.measure(p);
  for (int c = 0; c < 4; ++c)
    for (const bool along_x : {true, false}) {
      const auto moved = [&](double by) {
        Polygon other = p;
        (along_x ? other.at[c].x : other.at[c].y) += by;
        Width value;
        value.measure(other);
        return value.square;
      };
      double change = 0.0;
      for (const int i : {c, (c + 3) % 4}) {  // the two edges at the corner
        const Point &from = p.at[i], &to = p.at[p.next(i)],
                    middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
        const double density[3] = {width.change(from), width.change(middle), width.change(to)};
        Point with_from{0, 0}, with_to{0, 0};
        move_edge(from, to, density, from, to, with_from, with_to);
        const Point& with = i == c ? with_from : with_to;
        change += along_x ? with.x : with.y;
      }
      EXPECT_NEAR(change, (moved(1e-5) - moved(-1e-5)) / 2e-5, 1e-9);
    }
}

/// The largest eigenvalue of the second derivative of the energy of two faces per mass of their corners, by
/// differences of the forces and power iteration.
double fastest(const TwoFaces& faces, const Springs& springs, double mass_b, std::mt19937& random) {
  constexpr int n = 24;
  constexpr double h = 1e-6;
  std::vector<double> matrix(n * n), mass(n, 1.0);
  std::fill(mass.begin() + 12, mass.end(), mass_b);
  for (int j = 0; j < n; ++j) {
    Push side[2];
    for (const int k : {0, 1}) {
      TwoFaces moved = faces;
      Vector& at = j < 12 ? moved.a[j / 3] : moved.b[j / 3 - 4];
      (j % 3 == 0 ? at.x : j % 3 == 1 ? at.y : at.z) += k == 0 ? -h : h;
      Overlap o;
      if (!o.meet(moved.a, moved.b) || !o.push(springs, 0.0, side[k])) side[k] = Push{};
    }
    for (int i = 0; i < n; ++i) {
      const auto force = [&](const Push& push) {
        const Vector& f = i < 12 ? push.on_a[i / 3] : push.on_b[i / 3 - 4];
        return i % 3 == 0 ? f.x : i % 3 == 1 ? f.y : f.z;
      };
      matrix[static_cast<std::size_t>(n * i + j)] = (force(side[0]) - force(side[1])) / (2.0 * h);
    }
  }
  const auto at = [&](int i, int j) {
    const auto ij = static_cast<std::size_t>(n * i + j), ji = static_cast<std::size_t>(n * j + i);
    const auto of = [&](int k) { return mass[static_cast<std::size_t>(k)]; };
    return 0.5 * (matrix[ij] + matrix[ji]) / std::sqrt(of(i) * of(j));
  };
  double shift = 0.0;  // so that the largest, not the lowest, is found
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) shift += at(i, j) * at(i, j);
  shift = std::sqrt(shift);
  std::uniform_real_distribution<double> start(-1.0, 1.0);
  std::vector<double> v(n);
  for (double& x : v) x = start(random);
  double size = 0.0;
  for (int round = 0; round < 200; ++round) {
    std::vector<double> next(n);
    size = 0.0;
    for (int i = 0; i < n; ++i) {
      double& x = next[static_cast<std::size_t>(i)];
      x = shift * v[static_cast<std::size_t>(i)];
      for (int j = 0; j < n; ++j) x += at(i, j) * v[static_cast<std::size_t>(j)];
      size += x * x;
    }
    size = std::sqrt(size);
    for (int i = 0; i < n; ++i) v[static_cast<std::size_t>(i)] = next[static_cast<std::size_t>(i)] / size;
  }
  return size - shift;
}

// What the step is chosen by is above the squares of the frequencies that the faces have, with a heavy and
// with an equal partner; and not far above.
TEST(ContactOverlap, RowsBoundTheStiffness) {
  std::mt19937 random(9);
  int count = 0, over = 0;
  double share = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    TwoFaces faces(random, TwoFaces::plane, trial % 2 == 0 ? 0.3 : 2.5);
    const Springs springs{1.0, 1.0, 200.0};
    Overlap o;
    if (!o.share(faces.a, faces.b)) continue;
    const double back = o.deepest() - 0.05 * (1 + trial % 3) / 3.0;  // at most 5 % deep
    for (Vector& x : faces.a) x = x + back * o.normal();
    Push push;
    if (!o.meet(faces.a, faces.b) || !o.push(springs, 0.0, push)) continue;
    Touch touch;
    touch.faces = true;
    touch.stiffness = push.rate;
    touch.energy = push.energy;
    for (int k = 0; k < 4; ++k) {
      touch.wa[k] = push.wa[k];
      touch.wb[k] = push.wb[k];
      touch.on_a[k] = push.on_a[k];
      touch.on_b[k] = push.on_b[k];
    }
    const auto rows = half_rows(touch);
    for (const double mass : {1.0, 1e3}) {
      double bound = 0.0;
      for (std::size_t k = 0; k < 8; ++k) bound = std::max(bound, 2.0 * rows[k] / (k < 4 ? 1.0 : mass));
      const double is = fastest(faces, springs, mass, random);
      ++count;
      if (is > bound) ++over;
      share += is / bound;
    }
  }
  EXPECT_GT(count, 500);
  EXPECT_LE(over, count / 200);
  EXPECT_GT(share / count, 0.4);
}

// No resultant and no moment, to roundoff.
TEST(ContactOverlap, ForcesAndMomentsSumToZero) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const TwoFaces faces(random, static_cast<TwoFaces::Kind>(trial % 3), 2.0);
    Overlap o;
    Push push;
    if (!o.meet(faces.a, faces.b) || !o.push({1.0, 0.8, 30.0}, 0.0, push)) continue;
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
        if (!o.meet(x, square) || !o.push({1.0, 1.0, 0.0}, 0.0, push)) continue;
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
  ASSERT_TRUE(o.push({0.5, 0.5, 0.0}, 0.0, push));
  EXPECT_NEAR(o.area(), 0.5, 1e-15);
  EXPECT_NEAR(push.volume, 0.1, 1e-15);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(push.wa[i], 1.0 / 3.0, 1e-14);
  EXPECT_EQ(push.wb[3], 0.0);
}

}  // namespace
}  // namespace cleave::solver::test
