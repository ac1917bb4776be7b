#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "discretisation/fem/hourglass_limit.hpp"
#include "eigenvalues.hpp"
#include "sample.hpp"

namespace cleave::discretisation::sample {
namespace {

Point skewed(Point x) {
  return {x.x + 0.2 * x.y + 0.1 * x.y * x.z, 0.8 * x.y - 0.1 * x.x * x.z,
          1.1 * x.z + 0.15 * x.x + 0.1 * x.x * x.y};
}

/// Stiffness of one element: internal forces of small nodal displacements, by central differences.
std::vector<double> stiffness(int type, double coefficient, const std::function<Point(Point)>& shape,
                              double poisson = 0.3) {
  Sample s = box(1, 1, 1, elastic(1.0, poisson), 1.0, shape);
  s.part().hourglass = {type, coefficient, 0.0, 0.0};
  const double step = 1e-5;
  std::vector<double> k(24 * 24);
  for (int column = 0; column < 24; ++column)
    for (const double sign : {1.0, -1.0}) {
      Body body(s);
      auto next = body.position;
      next[static_cast<std::size_t>(column)] += sign * step;
      body.move_nodes(1e8, next, 1e-6);  // slow: no viscosity to speak of
      for (int row = 0; row < 24; ++row)
        k[static_cast<std::size_t>(row * 24 + column)] -=
            sign * body.force.value(row / 3, row % 3) / (2.0 * step);
    }
  return k;
}

int zeros(const std::vector<double>& k) {
  auto symmetric = k;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 24; ++j) symmetric[i * 24 + j] = 0.5 * (k[i * 24 + j] + k[j * 24 + i]);
  const auto values = eigenvalues(symmetric, 24);
  EXPECT_GT(values.front(), -1e-7 * values.back());
  return static_cast<int>(std::ranges::count_if(values, [&](double v) { return v < 1e-6 * values.back(); }));
}

TEST(Hourglass, WithoutControlThereAreTwelveModesBesidesTheRigidOnes) {
  for (const auto& shape : {+[](Point x) { return x; }, +skewed})
    EXPECT_EQ(zeros(stiffness(4, 0.0, shape)), 18);
}

TEST(Hourglass, StiffnessFormsLeaveOnlyTheRigidModes) {
  for (const int type : {4, 5, 6})
    for (const auto& shape : {+[](Point x) { return x; }, +skewed})
      EXPECT_EQ(zeros(stiffness(type, 0.1, shape)), 6) << "type " << type;
}

/// With QM = 1 a rectangular element bends about one axis as a plate does: no stress across its thickness, no
/// strain along its width. Belytschko & Bindeman, CMAME 105 (1993) 225-260.
TEST(Hourglass, AssumedStrainFormBendsLikeAPlate) {
  const double nu = 0.3, a = 3.0, b = 1.0, c = 0.5;
  const auto k = stiffness(
      6, 1.0,
      [&](Point x) {
        return Point{a * x.x, b * x.y, c * x.z};
      },
      nu);
  const int xi[8] = {-1, 1, -1, 1, -1, 1, -1, 1}, zeta[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
  double energy = 0.0;
  for (int m = 0; m < 8; ++m)
    for (int n = 0; n < 8; ++n) energy += 0.5 * xi[m] * zeta[m] * k[(3 * m) * 24 + 3 * n] * xi[n] * zeta[n];
  // u_x = xi zeta: strain 2 zeta / a, energy 1/2 E/(1-nu^2) (2/a)^2 V/3.
  const double exact = 0.5 / (1 - nu * nu) * 4.0 / (a * a) * (a * b * c) / 3.0;
  EXPECT_NEAR(energy, exact, 1e-6 * exact);
}

TEST(Hourglass, EveryTypeLeavesLinearFieldsAlone) {
  for (const int type : {1, 2, 3, 4, 5, 6}) {
    Sample s = box(1, 1, 1, elastic(), 1.0, skewed);
    s.part().hourglass.type = type;
    s.part().hourglass.coefficient = 1.0;
    Body body(s);
    StepOutput out;
    for (int n = 1; n <= 5; ++n)
      out = body.move_to(1e-4, [&](Point x) {
        return Point{x.x + 0.01 * n * (x.x + 2 * x.y), x.y + 0.02 * n * x.z - 0.03 * n * x.x,
                     x.z - 0.01 * n * x.z};
      });
    EXPECT_GT(out.internal_energy, 1e-3);
    EXPECT_LT(out.hourglass_energy, 1e-20) << "type " << type;
  }
}

TEST(Hourglass, ViscousEnergyIsTheDampedKineticEnergy) {
  // Half a step of hourglass motion at speed 1: Q = a q, q = 8 |v|, work = a q^2 dt.
  Sample s = box(1, 1, 1, elastic(1.0, 0.0), 4.0);
  Body body(s);
  auto next = body.position;
  const double dt = 1e-4, speed = 1e-3;
  for (std::size_t n = 0; n < 8; ++n) {
    const double* x = &s.model.mesh.nodes.position[3 * n];
    next[3 * n + 2] += dt * speed * (x[0] > 0.5 ? 1 : -1) * (x[1] > 0.5 ? 1 : -1);
  }
  const auto out = body.move_nodes(dt, next, 1e-3);
  // a = QM rho V^(2/3) c / 4 with QM 0.1, rho 4, c 1/2.
  const double a = 0.1 * 4.0 * 0.5 / 4.0, q = 8.0 * speed;
  EXPECT_NEAR(out.hourglass_energy, a * q * q * dt, 1e-9 * a * q * q * dt);
  // Each node is held back by a q gamma.
  EXPECT_NEAR(std::abs(body.force_at(0).z), a * q, 1e-6 * a * q);  // the geometry has moved by 1e-7
}

/// The limit is where an hourglass mode's speed is mirrored in every step: 1 - 16 QM c dt / V^(1/3) = -1 for
/// a cube.
TEST(Hourglass, ViscousControlGrowsAboveItsLimit) {
  const double mass = 4.0 / 8.0, c = 0.5, safety = 0.9;  // rho 4, E 1, nu 0: c = 1/2, L = 1
  for (const double share : {0.98, 1.02}) {
    Sample s = box(1, 1, 1, elastic(1.0, 0.0), 4.0);
    s.model.control.step.safety = safety;
    const std::vector<Id> ids = s.solids().id;
    const PartElements elements{s.model, 0, model::Shape::hex8, ids, s.solids().node};
    const double limit = fem::viscous_hourglass_limit(elements).coefficient;
    EXPECT_NEAR(limit, 0.125 / safety, 1e-12);
    s.part().hourglass = {1, share * limit, 0.0, 0.0};
    Body body(s);
    const double dt = safety / c;
    double speed = 1e-9;
    const double first = speed;
    for (int n = 0; n < 100; ++n) {
      auto next = body.position;
      for (std::size_t i = 0; i < 8; ++i) {
        const double* x = &s.model.mesh.nodes.position[3 * i];
        next[3 * i + 2] += dt * speed * (x[0] > 0.5 ? 1 : -1) * (x[1] > 0.5 ? 1 : -1);
      }
      body.move_nodes(dt, next, 1e-6);
      speed += dt * body.force_at(0).z / mass;  // node 0 has the sign +
    }
    EXPECT_NEAR(std::abs(speed / first), std::pow(2.0 * share - 1.0, 100),
                1e-2 * std::pow(2.0 * share - 1.0, 100));
  }
}

TEST(Hourglass, ViscousControlIsWarnedOfByName) {
  const auto warnings = [](double coefficient, int type, double safety,
                           const std::function<Point(Point)>& shape) {
    Sample s = box(2, 1, 1, elastic(), 1.0, shape);
    s.model.control.step.safety = safety;
    s.part().hourglass = {type, coefficient, 0.0, 0.0};
    deck::Diagnostics diagnostics;
    const PartElements elements{s.model, 0, model::Shape::hex8, s.solids().id, s.solids().node};
    find_formulation("SOLID", 1, model::Shape::hex8)->build(elements, diagnostics);
    return diagnostics.all();
  };
  const auto cubes = [](Point x) { return Point{2.0 * x.x, x.y, x.z}; };
  for (const int type : {1, 2, 3}) {
    EXPECT_TRUE(warnings(0.138, type, 0.9, cubes).empty());
    const auto said = warnings(0.14, type, 0.9, cubes);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].severity, deck::Severity::warning);
    EXPECT_EQ(said[0].field, "QM");
    EXPECT_NE(said[0].message.find("0.139"), std::string::npos) << said[0].message;
  }
  EXPECT_TRUE(warnings(0.2, 1, 0.6, cubes).empty());  // 0.208
  EXPECT_TRUE(warnings(0.2, 4, 0.9, cubes).empty());
  // Bricks of 1 x 1 x 1/8: V^(1/3) = 1/2, L = 1/8, so four times as much.
  const auto flat = [](Point x) { return Point{2.0 * x.x, x.y, 0.125 * x.z}; };
  EXPECT_TRUE(warnings(0.55, 1, 0.9, flat).empty());
  EXPECT_EQ(warnings(0.56, 1, 0.9, flat).size(), 1u);
}

/// A small brick sets the step of the part; the large one bears more.
TEST(Hourglass, ViscousLimitFollowsTheSmallestElement) {
  Sample s = box(2, 1, 1, elastic(), 1.0, [](Point x) {
    return Point{x.x < 0.75 ? 0.4 * x.x : 1.2, x.y, x.z};
  });
  s.model.control.step.safety = 1.0;
  const PartElements elements{s.model, 0, model::Shape::hex8, s.solids().id, s.solids().node};
  const auto limit = fem::viscous_hourglass_limit(elements);
  EXPECT_EQ(limit.element, 1);
  EXPECT_NEAR(limit.coefficient, std::cbrt(0.2) / (8.0 * 0.2), 1e-12);
}

TEST(Hourglass, TenTurnsLeaveHourglassForcesIntact) {
  for (const int type : {4, 6}) {
    Sample s = box(1, 1, 1, elastic(), 1.0, skewed);
    s.part().hourglass.type = type;
    Body body(s);
    const auto bent = [](Point x) {
      return Point{x.x + 0.05 * x.y * x.z, x.y, x.z + 0.04 * x.x * x.y * x.z};
    };
    const double before = body.move_to(1e6, bent).hourglass_energy;
    const Point first = body.force_at(3);
    const Point axis = (1.0 / std::sqrt(14.0)) * Point{1, 2, 3};
    StepOutput out;
    for (int n = 1; n <= 100; ++n)
      out = body.move_to(1e6, [&](Point x) { return rotated(bent(x), axis, n * 0.2 * std::acos(-1.0)); });
    EXPECT_NEAR(out.hourglass_energy, before, 1e-12 * before);
    const Point last = body.force_at(3);
    EXPECT_NEAR(last.x, first.x, 1e-11 * std::abs(first.x));
    EXPECT_NEAR(last.y, first.y, 1e-11 * std::abs(first.x));
    EXPECT_NEAR(last.z, first.z, 1e-11 * std::abs(first.x));
  }
}

/// Work of the internal force over a closed loop of an elastic element returns to the second order.
TEST(Hourglass, EnergyFollowsTheWorkToSecondOrder) {
  for (const int type : {4, 6}) {
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const int steps = 40 << level;
      Sample s = box(1, 1, 1, elastic(), 1.0, skewed);
      s.part().hourglass = {type, 0.5, 0.0, 0.0};
      Body body(s);
      double work = 0.0, stored = 0.0;
      std::vector<double> before(24, 0.0);
      for (int n = 1; n <= steps; ++n) {
        const double t = double(n) / steps;
        const auto from = body.position;
        const auto out = body.move_to(1e6, [&](Point x) {
          const Point bent{x.x + 0.1 * t * x.y * x.z + 0.1 * t * x.x, x.y + 0.2 * t * t * x.x,
                           x.z + 0.1 * t * x.x * x.y};
          return rotated(bent, {0, 0, 1}, t);
        });
        for (int i = 0; i < 24; ++i) {
          const double now = body.force.value(i / 3, i % 3);
          work -= 0.5 * (now + before[i]) * (body.position[i] - from[i]);
          before[i] = now;
        }
        stored = out.internal_energy + out.hourglass_energy;
      }
      error[level] = std::abs(work - stored) / stored;
    }
    EXPECT_LT(error[1], 3e-4);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.2) << "type " << type;
  }
}

}  // namespace
}  // namespace cleave::discretisation::sample
