/// Each criterion of *MAT_ADD_EROSION deletes at its bound and not before.

#include "material_support.hpp"
#include "model/material/principal.hpp"

namespace cleave::model::testing {
namespace {

const std::string elastic = "*MAT_ELASTIC\n1,7.8e-9,210000,0.3\n";
constexpr double E = 210000.0, nu = 0.3, G = E / (2.0 * (1.0 + nu)), K = E / (3.0 * (1.0 - 2.0 * nu));

struct Case {
  const char* name;
  std::string before, after;  ///< text of the card around the bound; a sign may stand at the end of `before`
  Sym increment;              ///< per step
  double per_step;            ///< growth of the watched quantity per step
};

/// With a bound just below what twenty steps reach the twentieth must fail, just above it the next one.
void expect_failure_at_bound(const Case& c) {
  for (const int expected : {20, 21}) {
    char bound[40];
    std::snprintf(bound, sizeof bound, "%.12g",
                  20.0 * c.per_step * (expected == 20 ? 1.0 - 1e-6 : 1.0 + 1e-6));
    const Material m(elastic + "*MAT_ADD_EROSION\n" + c.before + bound + c.after + "\n");
    ASSERT_NE(m.law, nullptr) << c.name;
    EXPECT_TRUE(m.law->can_fail());
    Points points(*m.law);
    points.dt = 1e-3;
    for (int i = 1; i < expected; ++i) {
      points.step(c.increment);
      ASSERT_EQ(points.failed(0), 0.0) << c.name << " too early, step " << i << " of " << expected;
    }
    points.step(c.increment);
    EXPECT_EQ(points.failed(0), 1.0) << c.name << " not at step " << expected;
    EXPECT_EQ(points.failed(7), 1.0);
  }
}

TEST(Erosion, EachCriterionFailsAtItsBound) {
  const Sym squeeze{-1e-4, -1e-4, -1e-4, 0, 0, 0}, swell{1e-4, 1e-4, 1e-4, 0, 0, 0};
  const Sym axial{2e-4, -1e-4, -1e-4, 0, 0, 0}, shear{0, 0, 0, 1e-4, 0, 0};
  const Case cases[] = {
      {"MXPRES", "1,0,", "\n0", squeeze, K * 3e-4},
      {"MNPRES", "1,0\n-", ",", swell, K * 3e-4},
      {"SIGP1", "1,0\n0,", "", shear, 2.0 * G * 1e-4},
      {"SIGVM", "1,0\n0,0,", "", shear, std::sqrt(3.0) * 2.0 * G * 1e-4},
      {"MXEPS", "1,0\n0,0,0,", "", axial, 2e-4},
      {"MNEPS", "1,0,0,-", "\n0", axial, 1e-4},
      {"EPSSH", "1,0\n0,0,0,0,", "", axial, 1.5e-4},
      {"EFFEPS", "1,0,0,0,", "\n0", axial, 2e-4},
      {"VOLEPS tension", "1,0,0,0,0,", "\n0", swell, 3e-4},
      {"VOLEPS compression", "1,0,0,0,0,-", "\n0", squeeze, 3e-4},
      {"FAILTM", "1,0\n0,0,0,0,0,0,0,", "", shear, 1e-3},
  };
  for (const Case& c : cases) expect_failure_at_bound(c);
}

TEST(Erosion, NegativeEffectiveStrainBoundsThePlasticStrain) {
  const Material m(
      "*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,210000,0.3,300,1000,1\n0,0,0,0\n*MAT_ADD_EROSION\n1,0,0,0,-0."
      "02\n0\n");
  Points points(*m.law);
  while (points.plastic_strain(0) < 0.02) {
    EXPECT_EQ(points.failed(0), 0.0);
    points.step({0, 0, 0, 1e-4, 0, 0});
  }
  EXPECT_EQ(points.failed(0), 1.0);
  EXPECT_EQ(Material(elastic + "*MAT_ADD_EROSION\n1,0,0,0,-0.02\n0\n").law, nullptr);
}

TEST(Erosion, StressImpulse) {
  // Constant principal stress 1000 above the threshold 400: impulse 600^2 t.
  const Material m(elastic + "*MAT_ADD_EROSION\n1,0\n0,0,0,0,0,400,3.6e4\n");
  Points points(*m.law);
  points.dt = 1e-3;
  for (int i = 0; i < 8; ++i) points.set_stress(i, {1000, 0, 0, 0, 0, 0});
  const int needed = 100;  // 3.6e4 / (600^2 1e-3)
  for (int i = 1; i <= needed - 1; ++i) {
    points.step(Sym{});
    ASSERT_EQ(points.failed(0), 0.0) << i;
  }
  points.step(Sym{});
  points.step(Sym{});  // roundoff of the sum may take one step more
  EXPECT_EQ(points.failed(0), 1.0);
  EXPECT_NEAR(points.state(0, m.law->state_size() - 1), 360.0 * 101.0, 1e-9 * 36360.0);
}

TEST(Erosion, SeveralCriteriaCanBeAskedFor) {
  // NCS = 2: shear strain alone is not enough, the largest principal stress must be reached as well.
  const Material m(elastic + "*MAT_ADD_EROSION\n1,0,0,0,0,0,1,2\n0,1000,0,0,0.001\n");
  Points points(*m.law);
  int met = 0;
  for (int i = 0; i < 100 && points.failed(0) == 0.0; ++i) {
    points.step({0, 0, 0, 1e-4, 0, 0});
    met = (points.stress(0).xy >= 1000.0 - 1e-9) + (points.state_tensor(0, 0).xy >= 0.001 - 1e-12);
    EXPECT_EQ(points.failed(0), met == 2 ? 1.0 : 0.0);
  }
  EXPECT_EQ(met, 2);
}

TEST(Erosion, ExclusionNumberSwitchesOff) {
  // With EXCL = 1234 a bound of 0 is a bound: no tension allowed.
  const Material m(elastic +
                   "*MAT_ADD_EROSION\n1,1234,1234,1234,1234,1234\n0,1234,1234,1234,1234,1234,1234\n");
  Points points(*m.law);
  points.step({-1e-5, -1e-5, -1e-5, 0, 0, 0});
  EXPECT_EQ(points.failed(0), 0.0);
  points.step({2e-5, 2e-5, 2e-5, 0, 0, 0});
  EXPECT_EQ(points.failed(0), 1.0);
  // With EXCL = 0 it is off.
  const Material off(elastic + "*MAT_ADD_EROSION\n1,0\n0,1e6\n");
  Points others(*off.law);
  others.step({2e-5, 2e-5, 2e-5, 0, 0, 0});
  EXPECT_EQ(others.failed(0), 0.0);
}

TEST(Erosion, KeepsTheStateOfTheInnerLaw) {
  const std::string law = "*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,210000,0.3,300,1000,0.5\n0,0,0,0\n";
  const Material plain(law), eroding(law + "*MAT_ADD_EROSION\n1,0\n0,1e6,0,0,0,1e5,1\n");
  EXPECT_EQ(eroding.law->rotated_tensors(), 2);
  EXPECT_EQ(eroding.law->state_size(), plain.law->state_size() + 7);
  EXPECT_EQ(eroding.law->plastic_strain(), 12);
  Points a(*plain.law), b(*eroding.law);
  Random random(1);
  Sym sum{};
  for (int i = 0; i < 20; ++i) {
    const Sym e = random.tensor(0.005);
    sum = sum + e;
    a.step(e);
    b.step(e);
  }
  EXPECT_EQ(components(a.stress(0)), components(b.stress(0)));
  EXPECT_EQ(components(a.state_tensor(0, 0)), components(b.state_tensor(0, 6)));
  EXPECT_EQ(a.plastic_strain(0), b.plastic_strain(0));
  EXPECT_EQ(a.energy(0), b.energy(0));
  EXPECT_LT(norm(b.state_tensor(0, 0) - sum), 1e-15);
}

TEST(Erosion, CountsFailedPoints) {
  EXPECT_EQ(Material(elastic + "*MAT_ADD_EROSION\n1,0,0,0,0,0,4\n0,100\n").law->failed_points_needed(), 4);
  EXPECT_EQ(Material(elastic + "*MAT_ADD_EROSION\n1,0\n0,100\n").law->failed_points_needed(), 1);
  EXPECT_EQ(Material(elastic + "*MAT_ADD_EROSION\n1,0,0,0,0,0,-50\n0,100\n").law, nullptr);
}

TEST(Erosion, RefusesDamageModelsByName) {
  const Material m(elastic + "*MAT_ADD_EROSION\n1,0\n0,100\n1\n");
  EXPECT_EQ(m.law, nullptr);
  ASSERT_FALSE(m.diagnostics.all().empty());
  EXPECT_EQ(m.diagnostics.all()[0].field, "IDAM");
  EXPECT_EQ(Material(elastic + "*MAT_ADD_EROSION\n1,0\n0,0,-7\n").law, nullptr);  // a curve for SIGVM
}

TEST(Principal, ValuesOfKnownTensors) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    double v[3] = {random(10.0), random(10.0), random(10.0)};
    if (i % 4 == 1) v[1] = v[0];         // twins
    if (i % 4 == 2) v[2] = v[1] + 1e-5;  // near twins
    if (i % 100 == 3) v[0] = v[1] = v[2];
    std::sort(v, v + 3);
    const Sym turned = rotate(random.rotation(), Sym{v[0], v[1], v[2], 0, 0, 0});
    const auto p = principal_values(turned);
    const double tolerance = i % 4 == 1 || i % 4 == 2 ? 5e-7 : 1e-10;
    EXPECT_NEAR(p.first, v[2], tolerance);
    EXPECT_NEAR(p.second, v[1], tolerance);
    EXPECT_NEAR(p.third, v[0], tolerance);
  }
  const auto zero = principal_values(Sym{});
  EXPECT_EQ(zero.first, 0.0);
  EXPECT_EQ(zero.third, 0.0);
}

}  // namespace
}  // namespace cleave::model::testing
