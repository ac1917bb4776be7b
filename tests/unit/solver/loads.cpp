/// Loads against closed forms.

#include <gtest/gtest.h>

#include "rig.hpp"
#include "solver/face.hpp"

namespace cleave::solver::test {
namespace {

// A mass under F sin-like ramp: u = F t^3 / 6 m for F = t, by central differences u (1 + dt^2/..): order two.
TEST(Loads, NodeForceAndItsWork) {
  double error[2];
  for (const int level : {0, 1}) {
    Rig rig;
    const Index a = rig.particle(2.0, {0, 0, 0});
    model::NodeLoad load;
    load.nodes = {a};
    load.direction = {0, 0, 1};
    load.curve = rig.curve({0, 10}, {0, 10});
    load.scale = 3.0;
    rig.model.node_loads.push_back(load);
    rig.fixed_step(level == 0 ? 0.125 : 0.0625);
    rig.run(2.0);
    error[level] = std::abs(rig.x(a, 2) - 3.0 * 8.0 / 6.0 / 2.0);
    EXPECT_NEAR(rig.state.energy.ratio(), 1.0, 0.01);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.05);
}

// Three nodes of a rigid triangle that turns: the follower pushes along its present normal.
TEST(Loads, FollowerTurnsWithItsNodes) {
  Rig rig;
  const Index m1 = rig.node(0, 0, 0), m2 = rig.node(1, 0, 0), m3 = rig.node(0, 1, 0);
  const Index a = rig.particle(1.0, {0, 0, 5});
  // m2 and m3 move so that the normal, (0,0,1) at first, is (0,-1,0) at t = 1: m3 goes to (0,0,1).
  model::PrescribedMotion down, up;
  down.nodes = up.nodes = {m3};
  down.kind = up.kind = model::PrescribedMotion::Kind::displacement;
  down.direction = {0, 1, 0};
  up.direction = {0, 0, 1};
  down.curve = rig.curve({0, 1, 9}, {0, -1, -1});
  up.curve = rig.curve({0, 1, 9}, {0, 1, 1});
  rig.model.motions = {down, up};
  model::NodeLoad load;
  load.nodes = {a};
  load.follower = true;
  load.follow[0] = m1;
  load.follow[1] = m2;
  load.follow[2] = m3;
  load.curve = rig.constant(6.0);
  rig.model.node_loads.push_back(load);
  rig.fixed_step(0.0625);
  Vector first{}, last{};
  rig.run(1.5, [&](const Frame& frame) {
    const double* f = &frame.acceleration[3 * static_cast<std::size_t>(a)];
    if (frame.state.cycle == 0) first = {f[0], f[1], f[2]};
    last = {f[0], f[1], f[2]};
  });
  EXPECT_NEAR(first.z, 6.0, 1e-14);
  EXPECT_NEAR(last.y, -6.0, 1e-12);
  EXPECT_NEAR(last.z, 0.0, 1e-12);
}

/// Corners of a hexahedron, distorted so that its faces are warped, and its faces counter-clockwise from
/// outside.
struct Box : Rig {
  std::vector<model::Segment> faces{{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}},
                                    {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}};
  explicit Box(double warp) {
    const double x[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int a = 0; a < 8; ++a)
      particle(1.0, {x[a][0] + warp * std::sin(3.0 * a), x[a][1] + warp * std::cos(5.0 * a + 1.0),
                     x[a][2] + warp * std::sin(7.0 * a + 2.0)});
  }
};

TEST(Loads, PressureOnAClosedSurfaceHasNoResultant) {
  Box rig(0.2);
  // One face as two triangles, to have both kinds.
  const model::Segment quad = rig.faces.back();
  rig.faces.back() = {{quad.node[0], quad.node[1], quad.node[2], quad.node[2]}};
  rig.faces.push_back({{quad.node[0], quad.node[2], quad.node[3], quad.node[3]}});
  Vector sum{0, 0, 0}, torque{0, 0, 0};
  double largest = 0.0;
  for (const auto& face : rig.faces) {
    const auto vectors = face_vectors(face, rig.model.mesh.nodes.position);
    for (std::size_t a = 0; a < 4; ++a) {
      const double* x = &rig.model.mesh.nodes.position[3 * static_cast<std::size_t>(face.node[a])];
      sum = sum + vectors[a];
      torque = torque + base::cross(Vector{x[0], x[1], x[2]}, vectors[a]);
      largest = std::max(largest, std::sqrt(base::dot(vectors[a], vectors[a])));
    }
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(std::sqrt(base::dot(sum, sum)), 1e-15);
  EXPECT_LT(std::sqrt(base::dot(torque, torque)), 1e-15);
}

/// Integral of N_a n dA by 4 x 4 Gauss points, apart from the closed form of face.cpp.
std::array<Vector, 4> integrated(const Rig& rig, const model::Segment& face) {
  const double point[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  const double weight[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  constexpr double xi_of[4] = {-1, 1, 1, -1}, eta_of[4] = {-1, -1, 1, 1};
  std::array<Vector, 4> out{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Vector along_xi{}, along_eta{};
      for (int a = 0; a < 4; ++a) {
        const double* p = &rig.model.mesh.nodes.position[3 * static_cast<std::size_t>(face.node[a])];
        const Vector x{p[0], p[1], p[2]};
        along_xi = along_xi + (0.25 * xi_of[a] * (1.0 + eta_of[a] * point[j])) * x;
        along_eta = along_eta + (0.25 * eta_of[a] * (1.0 + xi_of[a] * point[i])) * x;
      }
      for (std::size_t a = 0; a < 4; ++a)
        out[a] = out[a] +
                 (weight[i] * weight[j] * 0.25 * (1.0 + xi_of[a] * point[i]) * (1.0 + eta_of[a] * point[j])) *
                     base::cross(along_xi, along_eta);
    }
  return out;
}

TEST(Loads, FaceVectorsAreTheIntegralsOfTheShapeFunctions) {
  Box rig(0.3);
  for (const auto& face : rig.faces) {
    const auto vectors = face_vectors(face, rig.model.mesh.nodes.position);
    const auto expected = integrated(rig, face);
    for (std::size_t a = 0; a < 4; ++a) {
      const Vector difference = vectors[a] - expected[a];
      EXPECT_LT(std::sqrt(base::dot(difference, difference)), 1e-15);
    }
  }
}

// Corners of a parallelogram share alike to the bit: a homogeneous state is not disturbed by rounding.
TEST(Loads, ParallelogramSharesToTheBit) {
  Rig rig;
  const double w = std::exp(0.123), d = std::sqrt(0.7), h = 1.0 / 3.0;
  for (const auto& x : {Vector{0, 0, h}, Vector{w, 0, h}, Vector{w, d, h}, Vector{0, d, h}})
    rig.node(x.x, x.y, x.z);
  const auto vectors = face_vectors(model::Segment{{0, 1, 2, 3}}, rig.model.mesh.nodes.position);
  for (const Vector& v : vectors) {
    EXPECT_EQ(v.x, 0.0);
    EXPECT_EQ(v.y, 0.0);
    EXPECT_EQ(v.z, vectors[0].z);
  }
  EXPECT_DOUBLE_EQ(vectors[0].z, 0.25 * w * d);
}

TEST(Loads, PressurePushesInwardsWithItsAreaAfterArrival) {
  Box rig(0.0);
  model::SegmentLoad load;
  load.segments = {rig.faces[1]};  // top, z = 1
  load.curve = rig.curve({0, 100}, {12, 12});
  load.arrival = 0.5;
  rig.model.segment_loads.push_back(load);
  rig.fixed_step(0.25);
  rig.run(1.0, [&](const Frame& frame) {
    const double f = frame.state.time < 0.5 ? 0.0 : -3.0;
    for (std::size_t a = 4; a < 8; ++a) EXPECT_NEAR(frame.acceleration[3 * a + 2], f, 1e-13);
    for (std::size_t a = 0; a < 4; ++a) EXPECT_EQ(frame.acceleration[3 * a + 2], 0.0);
  });
  // A load that jumps leaves m a^2 dt^2 / 8 per node between the trapezoidal work and the kinetic energy.
  EXPECT_NEAR(rig.state.energy.total() - rig.state.energy.external, 4.0 * 9.0 * 0.0625 / 8.0, 1e-12);
}

// Centrifugal acceleration w^2 r away from the axis: r = r0 cosh(w t) in the turning frame.
TEST(Loads, RotationThrowsOutwards) {
  double error[2];
  for (const int level : {0, 1}) {
    Rig rig;
    const Index a = rig.particle(1.0, {2.0, 1.0, 3.0});
    rig.model.body_loads.push_back({{0, 0, 1}, true, {1.0, 1.0, 0.0}, rig.constant(2.0), 1.0, {}});
    rig.fixed_step(level == 0 ? 0.02 : 0.01);
    rig.run(1.0);
    error[level] = std::abs(rig.x(a) - 1.0 - std::cosh(2.0 * rig.state.time));
    EXPECT_EQ(rig.x(a, 1), 1.0);
    EXPECT_EQ(rig.x(a, 2), 3.0);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.05);
}

TEST(Loads, BodyForceOnSomeNodes) {
  Rig rig;
  const Index a = rig.particle(1.0, {0, 0, 0}), b = rig.particle(1.0, {1, 0, 0});
  rig.model.body_loads.push_back({{0, 1, 0}, false, {0, 0, 0}, rig.constant(2.0), 1.5, {false, true}});
  rig.fixed_step(0.25);
  rig.run(1.0);
  EXPECT_EQ(rig.x(a, 1), 0.0);
  EXPECT_DOUBLE_EQ(rig.x(b, 1), -1.5);
}

// A particle at rest, seen from a base that turns faster and faster, w = w0 + g t: it runs around backwards
// by the angle that the base has turned. Centrifugal, Coriolis and Euler accelerations are all needed, in
// second order.
TEST(Loads, RotatingBaseIsOnlyAPointOfView) {
  using Angular = model::BodyLoad::Angular;
  double error[2];
  for (const int level : {0, 1}) {
    Rig rig;
    const double first = 0.5, growth = 0.3;
    const Index a = rig.particle(2.0, {3, 1, 0.25}, {0, -2.0 * first, 0}),
                other = rig.particle(1.0, {9, 9, 9});
    const Index rate = rig.constant(growth),
                speed = rig.curve({0, 10}, {2 * first, 2 * (first + 10 * growth)});
    for (const Angular angular : {Angular::centrifugal, Angular::coriolis, Angular::euler}) {
      model::BodyLoad load;
      load.generalized = load.rotation = true;
      load.angular = angular;
      load.direction = {0, 0, angular == Angular::euler ? 1.0 : 0.5};  // factors that are not 1
      load.centre = {1, 1, 0};
      load.curve = angular == Angular::euler ? rate : speed;
      load.nodes = {true, false};
      rig.model.body_loads.push_back(load);
    }
    rig.fixed_step(level == 0 ? 0.01 : 0.005);
    rig.run(4.0);
    const double t = rig.state.time, turned = first * t + 0.5 * growth * t * t;
    error[level] = std::hypot(rig.x(a, 0) - 1 - 2 * std::cos(turned), rig.x(a, 1) - 1 + 2 * std::sin(turned));
    EXPECT_EQ(rig.x(a, 2), 0.25);
    EXPECT_EQ(rig.x(other, 0), 9.0);
  }
  EXPECT_LT(error[1], 1e-3);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1);
}

// The Coriolis acceleration alone bends the path to a circle of radius v / 2 w, without work.
TEST(Loads, CoriolisBendsAPathToACircle) {
  Rig rig;
  const double w = 2.0, v = 3.0;
  const Index a = rig.particle(1.0, {0, 0, 0}, {v, 0, 0});
  model::BodyLoad load;
  load.generalized = load.rotation = true;
  load.angular = model::BodyLoad::Angular::coriolis;
  load.direction = {0, 0, w};
  load.curve = rig.constant(1.0);
  rig.model.body_loads.push_back(load);
  rig.fixed_step(1e-3);
  const double radius = v / (2 * w);
  rig.run(10.0, [&](const Frame& frame) {
    EXPECT_NEAR(std::hypot(frame.state.position[0], frame.state.position[1] + radius), radius, 1e-4 * radius);
  });
  EXPECT_NEAR(std::hypot(rig.v(a, 0), rig.v(a, 1)), v, 1e-5 * v);
  EXPECT_NEAR(rig.state.energy.external, 0.0, 1e-4);
}

// Pressure on all six-node faces of a ten-node tetrahedron with curved edges: no net force, no moment, and
// the virtual work of a uniform growth is the growth of its volume. A flat face loads its mid nodes alone.
TEST(Loads, PressureOnCurvedFacesWithMidNodes) {
  const std::vector<Vector> x = {{0, 0, 0},       {2, 0, 0},        {0, 2, 0},      {0, 0, 2},
                                 {1, -0.2, 0.1},  {1.1, 1.2, -0.3}, {0.1, 1, 0.05}, {-0.1, 0, 1},
                                 {1.2, 0.1, 1.1}, {0, 1.1, 0.9}};
  std::vector<double> position;
  for (const Vector& p : x) position.insert(position.end(), {p.x, p.y, p.z});
  // Corners counter-clockwise from outside, mid nodes amid 12 23 31 14 24 34 of the element.
  const std::array<Index, 6> faces[] = {
      {0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}};
  std::vector<Vector> force(10, {0, 0, 0});
  for (const auto& face : faces) {
    const auto part = face_vectors(face, position);
    for (std::size_t a = 0; a < 6; ++a)
      force[static_cast<std::size_t>(face[a])] = force[static_cast<std::size_t>(face[a])] + part[a];
  }
  Vector sum{0, 0, 0}, moment{0, 0, 0};
  double growth = 0.0;
  for (std::size_t a = 0; a < 10; ++a) {
    sum = sum + force[a];
    moment = moment + base::cross(x[a], force[a]);
    growth += base::dot(x[a], force[a]);
  }
  for (const Vector& v : {sum, moment}) EXPECT_NEAR(std::hypot(std::hypot(v.x, v.y), v.z), 0.0, 1e-14);

  // Volume of the element itself by Gauss quadrature of its Jacobian (a cubic, so four points in each
  // direction of the collapsed cube are exact).
  constexpr double at[4] = {0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263};
  constexpr double weight[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                0.17392742256872693};
  double volume = 0.0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        const double r = at[i], s = at[j] * (1 - r), t = at[k] * (1 - r - s);
        const double l[4] = {1 - r - s - t, r, s, t};
        constexpr int edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
        Vector column[3];
        for (int c = 0; c < 3; ++c) {
          column[c] = (4 * l[c + 1] - 1) * x[static_cast<std::size_t>(c + 1)] - (4 * l[0] - 1) * x[0];
          for (std::size_t e = 0; e < 6; ++e) {
            const int p = edge[e][0], q = edge[e][1];
            const double dp = p == 0       ? -1.0
                              : p == c + 1 ? 1.0
                                           : 0.0,
                         dq = q == 0       ? -1.0
                              : q == c + 1 ? 1.0
                                           : 0.0;
            column[c] = column[c] + (4 * (dp * l[q] + l[p] * dq)) * x[4 + e];
          }
        }
        volume += weight[i] * weight[j] * weight[k] * (1 - r) * (1 - r - s) *
                  base::dot(column[0], base::cross(column[1], column[2]));
      }
  EXPECT_NEAR(growth, 3.0 * volume, 1e-13);

  const std::vector<double> flat = {0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const auto part = face_vectors(std::array<Index, 6>{0, 1, 2, 3, 4, 5}, flat);
  for (std::size_t a = 0; a < 6; ++a) EXPECT_NEAR(part[a].z, a < 3 ? 0.0 : 2.0 / 3.0, 1e-15);
}

}  // namespace
}  // namespace cleave::solver::test
