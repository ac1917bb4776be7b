/// What every isoparametric solid must do, form by form.

#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "eigenvalues.hpp"
#include "forms.hpp"

namespace cleave::discretisation::sample {
namespace {

class SolidForm : public testing::TestWithParam<Form> {};

/// A linear field that only stretches along fixed axes: stress = Hooke's law of the strain sym G, no
/// rotation.
TEST_P(SolidForm, PatchTestGivesTheExactConstantStress) {
  for (const double nu : {0.0, 0.3, 0.4999}) {
    const Sample s = distorted(GetParam(), elastic(1.0, nu));
    Body body(s, GetParam().form);
    ASSERT_TRUE(body.start.ok) << body.start.what;
    const double g = 1e-3;
    const double e[6] = {g, -2 * g, 3 * g, 0.5 * g, -0.7 * g, 1.1 * g};
    const auto at = [&](double t) {
      return [=](Point x) {
        return Point{x.x + t * (e[0] * x.x + e[3] * x.y + e[5] * x.z),
                     x.y + t * (e[3] * x.x + e[1] * x.y + e[4] * x.z),
                     x.z + t * (e[5] * x.x + e[4] * x.y + e[2] * x.z)};
      };
    };
    // From half before to half after the reference geometry: its mid-step geometry is the reference.
    body.move_to(1.0, at(-0.5));
    const auto& reference = s.model.mesh.nodes.position;
    body.block->initialise(base::Array<double>(reference.begin(), reference.end()), body.state);
    body.move_to(1e7, at(0.5), g / (1 - 2 * nu));
    const double lambda = nu / ((1 + nu) * (1 - 2 * nu)), mu = 0.5 / (1 + nu), size = lambda + 2 * mu;
    const auto stress = body.field("stress", 6);
    for (std::size_t i = 0; i < stress.size(); ++i) {
      const std::size_t c = i % 6;
      EXPECT_NEAR(stress[i], 2 * mu * e[c] + (c < 3 ? lambda * (e[0] + e[1] + e[2]) : 0.0), 1e-12 * size)
          << nu;
    }
    for (std::size_t n = 0; n < s.node_count(); ++n) {
      bool inside = true;
      for (int k = 0; k < 3; ++k)
        inside = inside && reference[3 * n + k] > 1e-9 && reference[3 * n + k] < 1 - 1e-9;
      const Point f = body.force_at(static_cast<Index>(n));
      const double largest = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
      if (inside) {
        EXPECT_NEAR(largest, 0.0, 1e-12 * size);
      }
    }
  }
}

TEST_P(SolidForm, TenTurnsLeaveTheStressExact) {
  const Sample s = distorted(GetParam(), elastic());
  Body body(s, GetParam().form);
  const auto stretched = [](Point x) { return Point{1.01 * x.x + 0.02 * x.y, x.y - 0.01 * x.z, 0.99 * x.z}; };
  body.move_to(1e6, stretched);
  const auto before = body.field("stress", 6);
  const Point axis = (1.0 / std::sqrt(14.0)) * Point{1, 2, 3};
  for (int n = 1; n <= 100; ++n)
    body.move_to(1e6, [&](Point x) { return rotated(stretched(x), axis, n * 0.2 * std::acos(-1.0)); });
  const auto after = body.field("stress", 6);
  double largest = 0.0;
  for (const double v : before) largest = std::max(largest, std::abs(v));
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-12 * largest);
}

TEST_P(SolidForm, ElementForcesCarryNoMomentum) {
  const Sample s = distorted(GetParam(), elastic());
  Body body(s, GetParam().form);
  Noise noise;
  auto next = body.position;
  for (double& v : next) v += 0.01 * noise();
  body.move_nodes(1e-3, next, 10.0);
  Point torque{0, 0, 0};
  double size = 0.0;
  for (int i = 0; i < 3; ++i) {
    double sum = 0.0;
    for (std::size_t n = 0; n < s.node_count(); ++n) sum += body.force.value(static_cast<Index>(n), i);
    EXPECT_EQ(sum, 0.0);
  }
  for (std::size_t n = 0; n < s.node_count(); ++n) {
    const Point f = body.force_at(static_cast<Index>(n));
    torque = torque + cross(Point{next[3 * n], next[3 * n + 1], next[3 * n + 2]}, f);
    size += std::sqrt(dot(f, f));
  }
  for (const double t : {torque.x, torque.y, torque.z}) EXPECT_NEAR(t, 0.0, 1e-13 * size);
}

TEST_P(SolidForm, SameBitsForAnyThreads) {
  const Sample s = distorted(GetParam(), elastic(), 7);
  std::vector<double> first;
  for (const int threads : {1, 2, 3, 7}) {
    base::set_thread_count(threads);
    Body body(s, GetParam().form);
    Noise noise;
    for (int step = 0; step < 3; ++step) {
      auto next = body.position;
      for (double& v : next) v += 0.001 * noise();
      body.move_nodes(1e-3, next, 10.0);
    }
    base::Array<double> force;
    body.force.values(force);
    std::vector<double> all(force.begin(), force.end());
    all.insert(all.end(), body.state.point.begin(), body.state.point.end());
    if (first.empty()) first = all;
    EXPECT_EQ(all, first) << threads << " threads";
  }
  base::set_thread_count(0);
}

TEST_P(SolidForm, MassIsThatOfTheVolume) {
  const Sample s = distorted(GetParam(), elastic());
  Body body(s, GetParam().form);
  std::vector<double> mass(s.node_count());
  body.block->add_mass(body.state, mass);
  double sum = 0.0;
  for (const double m : mass) {
    EXPECT_GT(m, 0.0);
    sum += m;
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
}

TEST_P(SolidForm, DeformationGradientIsThatOfALinearField) {
  // Mooney-Rivlin is a function of F alone: its stress in a rotated and stretched state is that of one
  // element.
  const auto rubber = law("*MAT_MOONEY-RIVLIN_RUBBER\n1,1.0,0.49,1.0,0.25\n");
  const Sample s = distorted(GetParam(), rubber);
  Body body(s, GetParam().form);
  const auto stretched = [](Point x) {
    return Point{1.3 * x.x + 0.1 * x.y, 0.9 * x.y - 0.2 * x.z, 0.85 * x.z};
  };
  body.move_to(1e6, stretched);
  const auto stress = body.field("stress", 6);
  for (std::size_t i = 6; i < stress.size(); ++i) EXPECT_NEAR(stress[i], stress[i % 6], 1e-11);
  EXPECT_GT(std::abs(stress[0] - stress[1]), 0.1);
}

/// Stiffness of the first element alone, from its nodal forces, and 2/omega of its lumped mass.
struct OneElement {
  std::vector<double> stiffness_eigenvalues, mass_eigenvalues;
  double stable_step = 0.0;
};
OneElement one_element(const Form& form, double poisson, std::uint64_t seed) {
  Noise noise;
  for (std::uint64_t i = 0; i < 24 * seed; ++i) noise();
  const Sample hexes = box(1, 1, 1, elastic(1.0, poisson), 1.0, [&](Point x) {
    return Point{x.x + 0.15 * noise(), 0.7 * x.y + 0.15 * noise(), x.z + 0.15 * noise()};
  });
  Sample all = cut(hexes, form), s(all.part().law, 1.0);
  s.part() = all.part();
  s.part().hourglass.quadratic_bulk = s.part().hourglass.linear_bulk = 0.0;
  const int count = model::nodes_of(form.shape), size = 3 * count;
  s.solids().shape = form.shape;
  s.solids().id = {1};
  s.solids().part = {0};
  for (int a = 0; a < count; ++a) {
    const std::size_t n = 3 * static_cast<std::size_t>(all.solids().node[static_cast<std::size_t>(a)]);
    const auto& x = all.model.mesh.nodes.position;
    s.add_node({x[n], x[n + 1], x[n + 2]});
    s.solids().node.push_back(a);
  }
  const auto at = [size](int i, int j) { return static_cast<std::size_t>(i * size + j); };
  std::vector<double> k(at(size, 0)), mass(static_cast<std::size_t>(count));
  const double step = 1e-5;
  for (int column = 0; column < size; ++column)
    for (const double sign : {1.0, -1.0}) {
      Body body(s, form.form);
      auto next = body.position;
      next[static_cast<std::size_t>(column)] += sign * step;
      body.move_nodes(1e8, next, 1e-6);
      for (int row = 0; row < size; ++row)
        k[at(row, column)] -= sign * body.force.value(row / 3, row % 3) / (2.0 * step);
    }
  const Body body(s, form.form);
  body.block->add_mass(body.state, mass);
  auto symmetric = k, scaled = k;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      symmetric[at(i, j)] = 0.5 * (k[at(i, j)] + k[at(j, i)]);
      scaled[at(i, j)] = symmetric[at(i, j)] / std::sqrt(mass[static_cast<std::size_t>(i / 3)] *
                                                         mass[static_cast<std::size_t>(j / 3)]);
    }
  double steps[1];
  body.block->stable_steps(body.position, body.state, steps);
  return {eigenvalues(symmetric, size), eigenvalues(scaled, size), steps[0]};
}

TEST_P(SolidForm, HasSixZeroModesAndNoMore) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto values = one_element(GetParam(), 0.3, seed).stiffness_eigenvalues;
    const auto zeros =
        std::ranges::count_if(values, [&](double v) { return std::abs(v) < 1e-6 * values.back(); });
    EXPECT_EQ(zeros, 6);
    EXPECT_GT(values.front(), -1e-7 * values.back());
  }
}

/// One volume constraint per element is all that nearly incompressible material may ask of form 2.
TEST(Hex8Selective, OneEigenvalueGrowsWithTheBulkModulus) {
  const Form form{"hex8", 2, model::Shape::hex8};
  const auto soft = one_element(form, 0.49, 1).stiffness_eigenvalues,
             hard = one_element(form, 0.4999, 1).stiffness_eigenvalues;
  int growing = 0;
  for (std::size_t i = 0; i < soft.size(); ++i)
    growing += hard[i] > 10.0 * std::abs(soft[i]) && hard[i] > 1.0;
  EXPECT_EQ(growing, 1);
}

/// The tetrahedra promise a step below the critical one of every element, whatever its shape.
TEST_P(SolidForm, StableStepOfTetrahedraIsBelowTheCriticalOne) {
  if (GetParam().shape != model::Shape::tet4 && GetParam().shape != model::Shape::tet10) GTEST_SKIP();
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    for (const double nu : {0.0, 0.3, 0.4999}) {
      const auto element = one_element(GetParam(), nu, seed);
      const double critical = 2.0 / std::sqrt(element.mass_eigenvalues.back());
      EXPECT_LE(element.stable_step, critical * (1 + 1e-6)) << "nu " << nu << " seed " << seed;
      EXPECT_GE(element.stable_step, 0.5 * critical) << "not needlessly small";
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, SolidForm,
                         testing::Values(Form{"hex8_selective", 2, model::Shape::hex8},
                                         Form{"tet4", 10, model::Shape::tet4},
                                         Form{"tet4_nodal_pressure", 13, model::Shape::tet4},
                                         Form{"penta6", 15, model::Shape::penta6},
                                         Form{"tet10", 16, model::Shape::tet10}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cleave::discretisation::sample
