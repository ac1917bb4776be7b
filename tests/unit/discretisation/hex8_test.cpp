#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "sample.hpp"

namespace cleave::discretisation::sample {
namespace {

/// The distorted 2x2x2 cube of the verification catalogue, case A01.
Sample distorted(std::shared_ptr<const model::Law> law) {
  Noise noise;
  return box(2, 2, 2, std::move(law), 1.0, [&](Point x) {
    if (x.x == 0.5 && x.y == 0.5 && x.z == 0.5) return Point{0.59, 0.41, 0.56};
    // Edge mid nodes slide along their edge by up to 0.15.
    const int middle = (x.x == 0.5) + (x.y == 0.5) + (x.z == 0.5);
    if (middle == 1) {
      double* along = x.x == 0.5 ? &x.x : x.y == 0.5 ? &x.y : &x.z;
      *along += 0.15 * noise();
    }
    return x;
  });
}

TEST(Hex8, PatchTestGivesTheExactConstantStress) {
  for (const double nu : {0.0, 0.3, 0.4999}) {
    const Sample s = distorted(elastic(1.0, nu));
    Body body(s);
    ASSERT_TRUE(body.start.ok);
    // Displacement gradient of case A01. Imposed from half before to half after the reference geometry, so
    // that the mid-step geometry is the reference and the strain is exactly sym G.
    const double g = 1e-3;
    const auto at = [&](double t) {
      return [=](Point x) {
        return Point{x.x + t * g * (x.x + 2 * x.y + 3 * x.z), x.y + t * g * (-x.x + 2 * x.y + x.z),
                     x.z + t * g * (0.5 * x.x - 2 * x.y + x.z)};
      };
    };
    body.move_to(1.0, at(-0.5));
    body.block->initialise(
        base::Array<double>(s.model.mesh.nodes.position.begin(), s.model.mesh.nodes.position.end()),
        body.state);
    body.move_to(1e6, at(0.5), g / (1 - 2 * nu));  // slow: no viscosity to speak of

    // Stress of the strain sym G, turned by half the rotation of the step; tan(angle/2) = |w|/2.
    const double lambda = nu / ((1 + nu) * (1 - 2 * nu)), mu = 0.5 / (1 + nu);
    const double e[3][3] = {{g, 0.5 * g, 1.75 * g}, {0.5 * g, 2 * g, -0.5 * g}, {1.75 * g, -0.5 * g, g}};
    const Point w{-1.5 * g, 1.25 * g, -1.5 * g};
    const double size = std::sqrt(dot(w, w)), half = std::atan(0.5 * size);
    Point column[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (Point& c : column) c = rotated(c, (1.0 / size) * w, half);
    const auto exact = [&](int i, int j) {
      const auto part = [](const Point& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
      double sum = i == j ? lambda * 4 * g : 0.0;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum += part(column[k], i) * 2 * mu * e[k][l] * part(column[l], j);
      return sum;
    };
    const int row[6] = {0, 1, 2, 0, 1, 2}, col[6] = {0, 1, 2, 1, 2, 0};
    const auto stress = body.field("stress", 6);
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], exact(row[i % 6], col[i % 6]), 1e-12 * (lambda + 2 * mu)) << "nu " << nu;
    // Nothing pushes the interior node: the stress is in equilibrium.
    const Point f = body.force_at(13);
    for (const double c : {f.x, f.y, f.z}) EXPECT_NEAR(c, 0.0, 1e-12 * (lambda + 2 * mu));
  }
}

TEST(Hex8, TenTurnsLeaveTheStressExact) {
  const Sample s = distorted(elastic());
  Body body(s);
  const auto stretched = [](Point x) { return Point{1.01 * x.x + 0.02 * x.y, x.y - 0.01 * x.z, 0.99 * x.z}; };
  body.move_to(1e6, stretched);
  const auto before = body.field("stress", 6);
  const double energy = body.field("internal_energy_density", 1)[0];
  const Point axis = (1.0 / std::sqrt(14.0)) * Point{1, 2, 3};
  const double step = 2.0 * std::acos(-1.0) / 10.0;
  for (int n = 1; n <= 100; ++n)
    body.move_to(1e6, [&](Point x) { return rotated(stretched(x), axis, n * step); });
  const auto after = body.field("stress", 6);
  double largest = 0.0;
  for (const double v : before) largest = std::max(largest, std::abs(v));
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-12 * largest);
  EXPECT_NEAR(body.field("internal_energy_density", 1)[0], energy, 1e-12 * energy);
}

/// Jaumann rate: s12 = G sin(gamma), s11 = G (1 - cos(gamma)). Dienes, Acta Mech. 32 (1979) 217-232.
TEST(Hex8, SimpleShearFollowsTheJaumannRateToSecondOrder) {
  const double end = 2.0;
  double error[2];
  for (int level = 0; level < 2; ++level) {
    const int steps = 50 << level;
    const Sample s = box(1, 1, 1, elastic(2.6, 0.3));  // G = 1
    Body body(s);
    for (int n = 1; n <= steps; ++n)
      body.move_to(1e6, [&](Point x) { return Point{x.x + end * n / steps * x.y, x.y, x.z}; });
    const auto stress = body.field("stress", 6);
    error[level] = std::hypot(stress[3] - std::sin(end), stress[0] - (1.0 - std::cos(end)));
  }
  EXPECT_LT(error[1], 2e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1);
}

TEST(Hex8, ElementForcesCarryNoMomentum) {
  const Sample s = distorted(elastic());
  Body body(s);
  Noise noise;
  base::Array<double> next = body.position;
  for (double& v : next) v += 0.03 * noise();
  body.move_nodes(1e-3, next, 10.0);
  double torque[3] = {0, 0, 0}, size = 0.0;
  for (int i = 0; i < 3; ++i) {
    double sum = 0.0;
    for (Index n = 0; n < 27; ++n) sum += body.force.value(n, i);
    EXPECT_EQ(sum, 0.0) << "integers add up to nothing";
  }
  for (Index n = 0; n < 27; ++n) {
    const Point x{next[3 * n], next[3 * n + 1], next[3 * n + 2]}, f = body.force_at(n);
    const Point t = cross(x, f);
    torque[0] += t.x, torque[1] += t.y, torque[2] += t.z;
    size += std::sqrt(dot(f, f));
  }
  for (const double t : torque) EXPECT_NEAR(t, 0.0, 1e-13 * size);
}

TEST(Hex8, SameBitsForAnyThreads) {
  const Sample s = box(17, 13, 11, elastic());
  const auto run = [&](int threads) {
    base::set_thread_count(threads);
    Body body(s);
    Noise noise;
    base::Array<double> next = body.position, forces;
    std::vector<double> seen;
    for (int n = 0; n < 3; ++n) {
      for (double& v : next) v += 0.003 * noise();
      const auto out = body.move_nodes(1e-3, next);
      seen.insert(seen.end(), {out.internal_energy, out.hourglass_energy, out.stable_step,
                               static_cast<double>(out.stable_element), body.force.largest()});
    }
    body.force.values(forces);
    seen.insert(seen.end(), forces.begin(), forces.end());
    seen.insert(seen.end(), body.state.point.begin(), body.state.point.end());
    base::set_thread_count(1);
    return seen;
  };
  const auto one = run(1);
  for (const int threads : {2, 3, 7}) EXPECT_TRUE(one == run(threads)) << threads << " threads";
}

TEST(Hex8, StableStepIsThatOfTheThinnestWay) {
  const Sample s = box(1, 1, 1, elastic(1.0, 0.0), 4.0, [](Point x) {
    return Point{x.x, 3 * x.y, 0.5 * x.z};
  });
  Body body(s);
  const auto out = body.move_to(0.0, [](Point x) { return x; });
  EXPECT_NEAR(out.stable_step, 0.5 / std::sqrt(1.0 / 4.0), 1e-14);
  EXPECT_EQ(out.stable_element, 1);
  double step = 0.0;
  body.block->stable_steps(body.position, body.state, {&step, 1});
  EXPECT_DOUBLE_EQ(step, out.stable_step);
}

TEST(Hex8, MassIsThatOfTheVolume) {
  const Sample s = distorted(elastic());
  Body body(s);
  std::vector<double> mass(27, 0.0);
  body.block->add_mass(body.state, mass);
  double total = 0.0;
  for (const double m : mass) total += m;
  EXPECT_NEAR(total, 1.0, 1e-14);
}

TEST(Hex8, NegativeVolumeIsReportedForTheLowestElement) {
  const Sample s = box(3, 1, 1, elastic());
  Body body(s);
  const auto out = body.move_to(1.0, [](Point x) { return Point{x.x < 0.5 ? x.x : 0.9 - x.x, x.y, x.z}; });
  EXPECT_FALSE(out.status.ok);
  EXPECT_EQ(out.status.element, 2);
  EXPECT_NE(out.status.what.find("negative"), std::string::npos);
}

TEST(Hex8, AVelocityThatIsNotANumberIsReported) {
  const Sample s = box(2, 1, 1, elastic());
  Body body(s);
  base::Array<double> next = body.position;
  next[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(body.move_nodes(1.0, next).status.ok);
}

TEST(Hex8, APyramidOfRepeatedNodesCarriesConstantStress) {
  Sample s(elastic(1.0, 0.25), 3.0);
  for (const Point x : {Point{0, 0, 0}, Point{1, 0, 0}, Point{1, 1, 0}, Point{0, 1, 0}, Point{0.4, 0.5, 1}})
    s.add_node(x);
  s.add_element({0, 1, 2, 3, 4, 4, 4, 4});
  Body body(s);
  ASSERT_TRUE(body.start.ok);
  std::vector<double> mass(5, 0.0);
  body.block->add_mass(body.state, mass);
  EXPECT_NEAR(mass[0] + mass[1] + mass[2] + mass[3] + mass[4], 3.0 / 3.0, 1e-15);
  body.move_to(
      1e6,
      [](Point x) {
        return Point{x.x, x.y, 1.002 * x.z};
      },
      1e-3);
  const auto stress = body.field("stress", 6);
  EXPECT_NEAR(stress[2] / stress[0], 3.0, 1e-12);  // (1 - nu)/nu
  // Force on the tip: stress times the projected base area.
  EXPECT_NEAR(body.force_at(4).z, -stress[2] / 3.0 * 1.0, 1e-10 * stress[2]);
}

}  // namespace
}  // namespace cleave::discretisation::sample
