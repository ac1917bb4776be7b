/// What averaging at nodes adds to the linear tetrahedron: solid_forms_test.cpp has the rest.

#include <gtest/gtest.h>

#include <set>

#include "eigenvalues.hpp"
#include "forms.hpp"

namespace cleave::discretisation::sample {
namespace {

const Form averaged{"tet4_nodal_pressure", 13, model::Shape::tet4};
const Form plain{"tet4", 10, model::Shape::tet4};

Sample without_viscosity(Sample s) {
  s.part().hourglass.quadratic_bulk = s.part().hourglass.linear_bulk = 0.0;
  return s;
}

/// Stiffness of a body from its nodal forces, by central differences, not made symmetric.
std::vector<double> stiffness(const Sample& s, int form) {
  const std::size_t size = 3 * s.node_count();
  std::vector<double> k(size * size, 0.0);
  const double step = 1e-5;
  for (std::size_t column = 0; column < size; ++column)
    for (const double sign : {1.0, -1.0}) {
      Body body(s, form);
      auto next = body.position;
      next[column] += sign * step;
      body.move_nodes(1e8, next, 1e-2);
      for (std::size_t row = 0; row < size; ++row)
        k[row * size + column] -=
            sign * body.force.value(static_cast<std::int32_t>(row / 3), static_cast<int>(row % 3)) /
            (2.0 * step);
    }
  return k;
}

/// How many eigenvalues grow with the bulk modulus: what incompressibility asks of 81 degrees of freedom.
int constraint_count(const Form& form) {
  const auto values = [&](double nu) {
    const auto k = stiffness(without_viscosity(distorted(form, elastic(1.0, nu))), form.form);
    return eigenvalues(k, 81);
  };
  const auto soft = values(0.4999), hard = values(0.499999);
  int count = 0;
  for (std::size_t i = 0; i < soft.size(); ++i) count += hard[i] > 30.0 * std::abs(soft[i]) && hard[i] > 0.1;
  return count;
}

TEST(Tet4NodalPressure, ConstraintsAreOnePerNodeNotOnePerElement) {
  EXPECT_GE(constraint_count(plain), 45) << "48 elements";
  const int count = constraint_count(averaged);
  EXPECT_LE(count, 27) << "nodes";
  EXPECT_GE(count, 8) << "it is not soft";
}

/// Pressures go back through the adjoint of the averaging of volumes: the stiffness is symmetric. Averaging
/// never adds energy, so the step of the plain tetrahedron is a bound for it too.
TEST(Tet4NodalPressure, StiffnessIsSymmetricAndBelowThatOfThePlainTetrahedron) {
  for (const double nu : {0.0, 0.3, 0.4999}) {
    const auto law = elastic(1.0, nu);
    const auto k = stiffness(without_viscosity(distorted(averaged, law)), 13),
               above = stiffness(without_viscosity(distorted(plain, law)), 10);
    std::vector<double> difference(k.size());
    double largest = 0.0;
    for (const double v : k) largest = std::max(largest, std::abs(v));
    for (std::size_t i = 0; i < 81; ++i)
      for (std::size_t j = 0; j < 81; ++j) {
        EXPECT_NEAR(k[i * 81 + j], k[j * 81 + i], 1e-7 * largest);
        difference[i * 81 + j] =
            0.5 * (above[i * 81 + j] - k[i * 81 + j] + above[j * 81 + i] - k[j * 81 + i]);
      }
    EXPECT_GT(eigenvalues(difference, 81).front(), -1e-7 * largest);
    const auto values = eigenvalues(k, 81);
    EXPECT_EQ(std::ranges::count_if(values, [&](double v) { return std::abs(v) < 1e-6 * largest; }), 6);
  }
}

/// Work of the nodal forces along a path that bends, turns and compresses, against the stored energy.
TEST(Tet4NodalPressure, WorkIsStoredEnergyToSecondOrder) {
  const Sample s = without_viscosity(distorted(averaged, elastic(1.0, 0.45)));
  const auto at = [](double t) {
    return [t](Point x) {
      const Point bent{x.x - 0.2 * t * x.x * x.y, x.y + 0.15 * t * x.x * x.x,
                       x.z - 0.1 * t * x.z * x.x * x.y};
      return rotated(bent, {0, 0, 1}, 0.8 * t);
    };
  };
  std::vector<double> errors;
  for (const int steps : {10, 20, 40, 80}) {
    Body body(s, 13);
    base::Array<double> before, after, x = body.position;
    body.move_to(0.0, at(0.0));
    body.force.values(before);
    double work = 0.0, energy = 0.0;
    for (int n = 1; n <= steps; ++n) {
      energy = body.move_to(1e6, at(double(n) / steps), 1e-2).internal_energy;
      body.force.values(after);
      for (std::size_t i = 0; i < x.size(); ++i)
        work -= 0.5 * (before[i] + after[i]) * (body.position[i] - x[i]);
      x = body.position;
      before = after;
    }
    errors.push_back(std::abs(work / energy - 1.0));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2.0, 0.2) << errors[i - 1] << " " << errors[i];
}

/// A field whose volume change varies: the averaged change inside converges one order faster than that of the
/// elements, and so does the pressure, which follows it.
TEST(Tet4NodalPressure, PressureIsSmooth) {
  const auto error = [](const Form& form, int cells) {
    const Sample s = cut(box(cells, cells, cells, elastic(3.0 * (1 - 2 * 0.4999), 0.4999)), form);
    Body body(s, form.form);
    const double size = 1e-6;
    // The bulk modulus is 1.
    body.move_to(
        1e8,
        [&](Point x) {
          return Point{x.x + size * std::sin(x.x + 0.3) * std::cos(x.y), x.y + size * std::cos(x.y + x.z),
                       x.z + size * std::sin(2 * x.z) * x.x};
        },
        1e-6);
    const auto pressure = body.field("pressure", 1);
    const auto nodes = body.block->connectivity();
    const auto& at = s.model.mesh.nodes.position;
    double sum = 0.0;
    int count = 0;
    for (std::size_t e = 0; e < pressure.size(); ++e) {
      double c[3] = {0, 0, 0};
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t i = 0; i < 3; ++i)
          c[i] += 0.25 * at[3 * static_cast<std::size_t>(nodes[4 * e + a]) + i];
      if (std::ranges::any_of(c, [](double v) { return v < 0.25 || v > 0.75; })) continue;
      const double exact =
          -(std::cos(c[0] + 0.3) * std::cos(c[1]) - std::sin(c[1] + c[2]) + 2 * std::cos(2 * c[2]) * c[0]);
      sum += std::pow(pressure[e] / size - exact, 2);
      ++count;
    }
    return std::sqrt(sum / count);
  };
  for (const int cells : {8, 16}) {
    const double rough = error(plain, cells), smooth = error(averaged, cells);
    EXPECT_LT(smooth, 0.4 * rough) << cells;
    EXPECT_NEAR(std::log2(error(plain, cells / 2) / rough), 1.0, 0.3) << cells;
    EXPECT_NEAR(std::log2(error(averaged, cells / 2) / smooth), 2.0, 0.3) << cells;
  }
}

/// Deleted elements leave the averages: the rest behaves as if they had never been there, forces included.
TEST(Tet4NodalPressure, DeletedElementsLeaveTheAverages) {
  // The lower layer of cells is thin, so its elements have the smaller steps.
  const auto law = elastic(1.0, 0.45);
  const Sample all = cut(box(2, 3, 2, law, 1.0,
                             [](Point x) {
                               return Point{x.x, x.y, x.z < 0.5 ? 0.1 * x.z : x.z - 0.45};
                             }),
                         averaged);
  Body body(all, 13);
  std::vector<double> steps(all.model.mesh.solids[0].count());
  body.block->stable_steps(body.position, body.state, steps);
  const double limit = 0.5 * (*std::ranges::min_element(steps) + *std::ranges::max_element(steps));
  body.force.begin(1.0);
  const auto out = body.block->add_force({0.0, 0.0, body.position.data(), body.velocity.data(), limit},
                                         body.state, body.force);
  ASSERT_EQ(out.eroded.size(), 36u);

  Sample rest = all;
  auto& solids = rest.solids();
  const std::set<Id> gone(out.eroded.begin(), out.eroded.end());
  solids = {};
  solids.shape = model::Shape::tet4;
  const auto& from = all.model.mesh.solids[0];
  for (std::size_t e = 0; e < from.count(); ++e) {
    if (gone.contains(from.id[e])) continue;
    solids.id.push_back(from.id[e]);
    solids.part.push_back(0);
    solids.node.insert(solids.node.end(), &from.node[4 * e], &from.node[4 * e] + 4);
  }
  Body twin(rest, 13);
  Noise noise;
  auto next = body.position;
  for (int n = 0; n < 3; ++n) {
    for (double& v : next) v += 0.005 * noise();
    body.move_nodes(1e-3, next, 1.0);
    twin.move_nodes(1e-3, next, 1.0);
  }
  double largest = 0.0;
  for (std::size_t n = 0; n < 3 * all.node_count(); ++n)
    largest =
        std::max(largest, std::abs(twin.force.value(static_cast<Index>(n / 3), static_cast<int>(n % 3))));
  for (std::size_t n = 0; n < 3 * all.node_count(); ++n)
    EXPECT_NEAR(body.force.value(static_cast<Index>(n / 3), static_cast<int>(n % 3)),
                twin.force.value(static_cast<Index>(n / 3), static_cast<int>(n % 3)), 1e-13 * largest);
}

}  // namespace
}  // namespace cleave::discretisation::sample
