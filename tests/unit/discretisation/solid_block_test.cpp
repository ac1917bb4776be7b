#include "discretisation/fem/solid_block.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "discretisation/fem/hex8_one_point.hpp"
#include "discretisation/fem/hourglass_stiffness.hpp"
#include "sample.hpp"

namespace cleave::discretisation::sample {
namespace {

using base::lane_count;
using base::Lanes;
using fem::Record;

/// The same bits from eight lanes and from eight single elements, before and after the law.
template <class Hourglass>
void check_scalar_twin() {
  using Element = fem::HexOnePoint<Hourglass>;
  const Element element{{0.1}, true};
  const fem::SolidOptions options{2.0, 0.4, 1, true, {1.5, 0.06}, {0.1}};
  fem::PointLayout layout;
  layout.state_size = 7;
  const int element_size = fem::ElementLayout{1}.own() + element.own_size();
  Noise noise;

  // Eight skewed cubes with velocities, stresses and hourglass forces of their own.
  fem::Vec3<Lanes> x[8], v[8];
  for (int a = 0; a < 8; ++a) {
    const double corner[3] = {double((a + 1) / 2 % 2), double(a / 2 % 2), double(a / 4)};
    for (int lane = 0; lane < lane_count; ++lane) {
      x[a].x.set(lane, corner[0] + 0.2 * noise()), v[a].x.set(lane, 10 * noise());
      x[a].y.set(lane, corner[1] + 0.2 * noise()), v[a].y.set(lane, 10 * noise());
      x[a].z.set(lane, corner[2] + 0.2 * noise()), v[a].z.set(lane, 10 * noise());
    }
  }
  base::Array<double> point(static_cast<std::size_t>(layout.size()) * lane_count), own;
  own.resize(static_cast<std::size_t>(element_size) * lane_count);
  for (double& p : point) p = noise();
  for (double& p : own) p = 0.1 * noise();
  const Record<Lanes> record{point.data()}, element_record{own.data()};
  record.set(layout.volume_ratio(), Lanes(1.0));
  record.set(layout.modulus(), Lanes(1.3));
  Lanes volume;
  element.reference(x, &volume, element_record.from(3));
  element_record.set(fem::ElementLayout::reference_volume, volume);
  element_record.set(fem::ElementLayout::reference_size, Lanes(1.0));
  auto point_twin = point, own_twin = own;

  const double dt = 0.01;
  const base::Mask everyone = Lanes(1.0) > Lanes(0.0);
  fem::Kept<Lanes, Element> kept;
  fem::PointScratch<Lanes> scratch{};
  fem::strain_pass(element, options, layout, x, v, dt, {record, element_record}, everyone, kept, &scratch);
  scratch.modulus = Lanes(1.3);
  fem::Vec3<Lanes> f[8];
  fem::ForceAnswer<Lanes> answer;
  fem::force_pass(element, options, layout, dt, {record, element_record}, kept, &scratch, f, answer);

  for (int lane = 0; lane < lane_count; ++lane) {
    fem::Vec3<double> xs[8], vs[8], fs[8];
    for (int a = 0; a < 8; ++a) {
      xs[a] = {x[a].x[lane], x[a].y[lane], x[a].z[lane]};
      vs[a] = {v[a].x[lane], v[a].y[lane], v[a].z[lane]};
    }
    fem::Kept<double, Element> kept_twin;
    fem::PointScratch<double> scratch_twin{};
    const fem::BatchRecords<double> records{{point_twin.data() + lane}, {own_twin.data() + lane}};
    fem::strain_pass(element, options, layout, xs, vs, dt, records, true, kept_twin, &scratch_twin);
    scratch_twin.modulus = 1.3;
    fem::ForceAnswer<double> twin;
    fem::force_pass(element, options, layout, dt, records, kept_twin, &scratch_twin, fs, twin);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(scratch.strain[i][lane], scratch_twin.strain[i]);
    for (int i = 0; i < 9; ++i) EXPECT_EQ(scratch.F[i][lane], scratch_twin.F[i]);
    EXPECT_EQ(scratch.viscosity[lane], scratch_twin.viscosity);
    EXPECT_EQ(answer.stable_step[lane], twin.stable_step);
    EXPECT_EQ(answer.hourglass[lane], twin.hourglass);
    EXPECT_EQ(answer.damping[lane], twin.damping);
    for (int a = 0; a < 8; ++a) {
      EXPECT_EQ(f[a].x[lane], fs[a].x);
      EXPECT_EQ(f[a].y[lane], fs[a].y);
      EXPECT_EQ(f[a].z[lane], fs[a].z);
    }
  }
  EXPECT_TRUE(point == point_twin);
  EXPECT_TRUE(own == own_twin);
}

TEST(SolidBlock, LanesAndSingleElementsGiveTheSameBits) {
  check_scalar_twin<fem::ViscousHourglass>();
  check_scalar_twin<fem::StiffnessHourglass>();
  check_scalar_twin<fem::AssumedStrainHourglass>();
}

TEST(SolidBlock, DeformationGradientIsThatOfALinearField) {
  const auto rubber = law("*MAT_MOONEY-RIVLIN_RUBBER\n1,1.0,0.495,0.3,0.1\n0,0,0\n");
  ASSERT_TRUE(rubber && rubber->needs_F());
  const Sample s = box(2, 2, 2, rubber, 1.0, [](Point x) { return Point{x.x + 0.2 * x.y * x.z, x.y, x.z}; });
  Body body(s);
  // Simple shear of a rubber: s12 = mu gamma, s11 - s22 = mu gamma^2 with mu = 2 (A + B).
  const double gamma = 0.4, mu = 0.8;
  body.move_to(1e6, [&](Point x) { return Point{x.x + gamma * x.y, x.y, x.z}; });
  const auto stress = body.field("stress", 6);
  for (std::size_t e = 0; e < 8; ++e) {
    EXPECT_NEAR(stress[6 * e + 3], mu * gamma, 1e-12);
    EXPECT_NEAR(stress[6 * e] - stress[6 * e + 1], mu * gamma * gamma, 1e-12);
  }
}

TEST(SolidBlock, AFailedElementIsDeletedWithItsEnergy) {
  // Failure strain of 1 per cent: the stretched half fails, the other stays.
  const auto metal = law("*MAT_PLASTIC_KINEMATIC\n1,1.0,200.0,0.3,0.2,1.0,1.0\n0,0,0.01\n");
  ASSERT_TRUE(metal && metal->can_fail());
  const Sample s = box(2, 1, 1, metal);
  Body body(s);
  const auto at = [](double t) {
    return [t](Point x) { return Point{x.x > 0.5 ? x.x + t * (x.x - 0.5) : x.x, x.y, x.z}; };
  };
  StepOutput out;
  double before = 0.0;
  int n = 0;
  while (out.eroded.empty() && n < 100) {
    before = out.internal_energy;
    out = body.move_to(1e6, at(0.001 * ++n));
  }
  EXPECT_EQ(out.eroded, std::vector<Id>{2});
  EXPECT_GT(out.eroded_internal, before);
  EXPECT_EQ(out.internal_energy, 0.0) << "the other half never moved";
  EXPECT_EQ(body.force_at(11).x, 0.0) << "no force from a deleted element";
  bool alive[2];
  body.block->alive(body.state, alive);
  for (std::size_t e = 0; e < 2; ++e) EXPECT_EQ(alive[e], body.block->element_ids()[e] == 1);
  // It stays where it was, whatever its nodes do, and its mass stays on the nodes.
  const auto stress = body.field("stress", 6);
  out = body.move_to(1e6, at(-0.7));
  EXPECT_TRUE(out.status.ok && out.eroded.empty());
  EXPECT_EQ(stress, body.field("stress", 6));
  double steps[2];
  body.block->stable_steps(body.position, body.state, steps);
  for (std::size_t e = 0; e < 2; ++e) EXPECT_EQ(steps[e] == 1e30, !alive[e]);
}

TEST(SolidBlock, SmallElementsAreDeletedByTheirStep) {
  const Sample s = box(3, 1, 1, elastic(1.0, 0.0), 1.0, [](Point x) { return Point{x.x * x.x, x.y, x.z}; });
  Body body(s);
  body.force.begin(1.0);
  const auto out = body.block->add_force({0.0, 0.0, body.position.data(), body.velocity.data(), 0.2},
                                         body.state, body.force);
  EXPECT_EQ(out.eroded, std::vector<Id>{1});  // 1/9 long, at unit wave speed
  EXPECT_EQ(out.stable_element, 2);
  EXPECT_NEAR(out.stable_step, 1.0 / 3.0, 1e-14);
}

TEST(SolidBlock, BulkViscosityActsInCompressionOnly) {
  Sample s = box(1, 1, 1, elastic(1.0, 0.0), 4.0);
  s.part().hourglass.quadratic_bulk = 1.5;
  s.part().hourglass.linear_bulk = 0.06;
  const double dt = 1e-6, rate = 0.5;
  for (const double sign : {-1.0, 1.0}) {
    Body body(s);
    const auto out = body.move_to(
        dt,
        [&](Point x) {
          return Point{x.x * (1.0 + sign * rate * dt), x.y, x.z};
        },
        1e-2);
    const double q = sign < 0.0 ? 4.0 * (1.5 * rate * rate + 0.06 * 0.5 * rate) : 0.0;
    EXPECT_NEAR(body.force_at(0).x, 0.25 * (sign * rate * dt - q), 1e-5 * rate * dt + 1e-6 * q);
    const double both = sign < 0.0 ? 0.06 * 0.5 + 1.5 * rate : 0.0;
    EXPECT_NEAR(out.stable_step, 1.0 / (both + std::sqrt(both * both + 0.25)), 1e-6);
  }
}

/// COEF = 0.1 damps the highest mode of an element by a tenth of critical. A cube held across rings along x
/// with stiffness 1 between end masses of 1/2: omega = 2.
TEST(SolidBlock, StiffnessDampingIsAFractionOfCritical) {
  Sample s = box(1, 1, 1, elastic(1.0, 0.0));
  s.part().hourglass = {2, 0.1, 0.0, 0.0};
  s.part().stiffness_damping = 0.1;
  Body body(s);
  const double start = 1e-4, dt = 0.002;
  double stretch = start, rate = 0.0, dissipated = 0.0;
  std::vector<double> shortest;  // turning points
  const auto to = [&](double step) {
    return body.move_to(
        step,
        [&](Point x) {
          return Point{x.x + (x.x - 0.5) * stretch, x.y, x.z};
        },
        1e-4);
  };
  to(1e6);
  while (shortest.size() < 5) {
    const double before = rate;
    rate += dt * 2.0 * 4.0 * body.force_at(1).x / 0.5;  // both ends, four nodes each
    if (before < 0.0 && rate >= 0.0) shortest.push_back(stretch);
    stretch += dt * rate;
    dissipated += to(dt).damping_work;
  }
  const double xi = 0.1, per_period = 2.0 * std::acos(-1.0) * xi / std::sqrt(1 - xi * xi);
  EXPECT_NEAR(std::log(shortest[0] / shortest[4]) / 4.0, per_period, 0.01 * per_period);
  EXPECT_NEAR(dissipated, 0.5 * start * start, 0.01 * start * start);
}

}  // namespace
}  // namespace cleave::discretisation::sample
