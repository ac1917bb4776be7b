/// Equations of state, and the laws that live on them.

#include "material_samples.hpp"
#include "material_support.hpp"

namespace cleave::model::testing {
namespace {

/// The points of a fluid or solid squeezed in all directions to the relative volume, in many small steps.
void squeeze(Points& points, double ratio, int steps) {
  const double e = std::log(ratio) / (3.0 * steps);
  for (int i = 0; i < steps; ++i) points.step({e, e, e, 0, 0, 0});
}

double pressure(Points& points) {
  return -trace(points.stress(0)) / 3.0;
}

const char* fluid = "*MAT_NULL\n1,8.96e-9\n";

TEST(Gruneisen, ReachesTheHugoniot) {
  // One step from rest to v with the shock's viscosity q = p/2: the energy is that of the Hugoniot,
  // e = p (1 - v) / 2, at which p = rho0 C^2 mu [1 + (1 - g0/2) mu - a/2 mu^2] / D^2 + (g0 + a mu) e.
  const double K = 8.96e-9 * 3.94e6 * 3.94e6, g = 2.02, a = 0.47, s1 = 1.489;
  const Material m(std::string(fluid) + copper_eos());
  for (const double v : {0.99, 0.9, 0.75}) {
    const double mu = 1.0 / v - 1.0, D = 1.0 - (s1 - 1.0) * mu;
    const double reference = K * mu * (1.0 + (1.0 - g / 2.0) * mu - a / 2.0 * mu * mu) / (D * D);
    const double expected = reference / (1.0 - (g + a * mu) * (1.0 - v) / 2.0);
    Points points(*m.law);
    const double e = std::log(v) / 3.0;
    points.set_strain(0, {e, e, e, 0, 0, 0});
    points.update();  // the step takes the mean of 0 and p, which is the Hugoniot's energy
    EXPECT_NEAR(pressure(points), expected, 1e-12 * expected) << v;
    EXPECT_NEAR(points.energy(0), expected * (1.0 - v) / 2.0, 1e-12 * points.energy(0));
  }
}

TEST(Gruneisen, LinearHugoniotMeetsTheShockJumpForConstantGamma) {
  // With a = g0 the product rho gamma is constant to first order; for the linear shock curve U = C + S u the
  // jump conditions give p = rho0 C^2 x / (1 - S x)^2, x = 1 - v. The formula of the format is built from it.
  const Material m("*MAT_NULL\n1,8.96e-9\n*EOS_GRUNEISEN\n1,3.94e6,1.489,0,0,0,0,0\n1\n");
  const double K = 8.96e-9 * 3.94e6 * 3.94e6;
  for (const double v : {0.95, 0.8}) {
    Points points(*m.law);
    squeeze(points, v, 1);
    const double x = 1.0 - v;
    EXPECT_NEAR(pressure(points), K * x / std::pow(1.0 - 1.489 * x, 2), 1e-12 * K) << v;
  }
}

TEST(Gruneisen, TensionIsLinear) {
  const Material m("*MAT_NULL\n1,8.96e-9\n*EOS_GRUNEISEN\n1,3.94e6,1.489,0,0,0,0,0\n1\n");
  Points points(*m.law);
  squeeze(points, 1.02, 1);
  EXPECT_NEAR(pressure(points), 8.96e-9 * 3.94e6 * 3.94e6 * (1.0 / 1.02 - 1.0), 1e-9);
}

TEST(Pressure, SlopesAreDerivatives) {
  const char* decks[] = {"*EOS_GRUNEISEN\n1,3.94e6,1.489,0.2,0.1,2.02,0.47,100\n1.02\n",
                         "*EOS_LINEAR_POLYNOMIAL\n1,0,1e5,2e5,3e5,1.4,0.3,0.7\n50,0.98\n"};
  for (const char* eos : decks) {
    const Material m(std::string(fluid) + eos);
    for (const double v : {0.8, 0.95, 1.05, 1.3}) {
      const double h = 1e-6;
      const auto at = m.pressure->line(v), up = m.pressure->line(v + h), down = m.pressure->line(v - h);
      EXPECT_NEAR(at.cold_slope, (up.cold - down.cold) / (2.0 * h), 1e-7 * std::abs(at.cold_slope));
      EXPECT_NEAR(at.thermal_slope, (up.thermal - down.thermal) / (2.0 * h), 1e-7);
    }
  }
}

TEST(Pressure, GasFollowsItsIsentrope) {
  // p = 0.4 (mu + 1) E: an ideal gas with exponent 1.4, from p0 = 0.1: p = p0 v^-1.4, error second order in
  // the step.
  const Material m("*MAT_NULL\n1,1.2e-12\n*EOS_LINEAR_POLYNOMIAL\n1,0,0,0,0,0.4,0.4,0\n0.25,1\n");
  EXPECT_NEAR(m.law->longitudinal_modulus(), 1.4 * 0.1, 1e-15);
  double errors[2];
  for (const int k : {0, 1}) {
    Points points(*m.law);
    points.step(Sym{});
    EXPECT_NEAR(pressure(points), 0.1, 1e-15);
    squeeze(points, 0.5, 100 << k);
    errors[k] = pressure(points) / (0.1 * std::pow(0.5, -1.4)) - 1.0;
    // Energy is conserved to roundoff with the pressure as it is: e = p v / 0.4.
    EXPECT_NEAR(points.energy(0) + 0.25, pressure(points) * 0.5 / 0.4, 1e-14);
    EXPECT_NEAR(points.modulus(0), 1.4 * pressure(points), 1e-12);
  }
  EXPECT_LT(std::abs(errors[1]), 1e-5);
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.1);
  // There and back again: no energy lost beyond the same error.
  Points points(*m.law);
  points.step(Sym{});
  squeeze(points, 0.5, 200);
  squeeze(points, 2.0, 200);
  EXPECT_NEAR(points.energy(0), 0.0, 1e-6 * 0.25);
}

TEST(Pressure, InitialVolumeAndEnergyAreHonoured) {
  // v = V0 J; energies per reference volume. Gas: p = 0.4 E / v.
  const Material m("*MAT_NULL\n1,1.2e-12\n*EOS_LINEAR_POLYNOMIAL\n1,0,0,0,0,0.4,0.4,0\n0.25,0.5\n");
  Points points(*m.law);
  points.step(Sym{});
  EXPECT_NEAR(pressure(points), 0.4 * 0.25 / 0.5, 1e-15);
  squeeze(points, 0.7, 400);
  EXPECT_NEAR(pressure(points), 0.2 * std::pow(0.7, -1.4), 1e-6);
}

TEST(Pressure, BulkViscosityHeats) {
  // de = -(p + q) dJ, and the heat raises the pressure within the same step.
  const Material m("*MAT_NULL\n1,1.2e-12\n*EOS_LINEAR_POLYNOMIAL\n1,0,0,0,0,0.4,0.4,0\n0.25,1\n");
  Points points(*m.law);
  points.step(Sym{});
  points.viscosity(0) = 0.02;
  const double before = pressure(points), e = std::log(0.9) / 3.0;
  points.step({e, e, e, 0, 0, 0});
  const double p = pressure(points);
  EXPECT_NEAR(points.energy(0), (0.5 * (p + before) + 0.02) * 0.1, 1e-15);
  EXPECT_NEAR(p, 0.4 / 0.9 * (0.25 + points.energy(0)), 1e-15);
}

TEST(Pressure, PolynomialTermsOfCompressionOnly) {
  const Material m("*MAT_NULL\n1,1e-9\n*EOS_LINEAR_POLYNOMIAL\n1,0,100,1000,10,0,0,5\n3,1\n");
  for (const double v : {0.9, 1.1}) {
    const double mu = 1.0 / v - 1.0, squeezed = std::max(mu, 0.0);
    const auto line = m.pressure->line(v);
    EXPECT_NEAR(line.cold, 100.0 * mu + 1000.0 * squeezed * squeezed + 10.0 * mu * mu * mu, 1e-12);
    EXPECT_NEAR(line.thermal, 5.0 * squeezed * squeezed, 1e-12);
  }
}

TEST(Pressure, RefusesAMaterialWithoutStiffness) {
  const Material m("*MAT_NULL\n1,1e-9\n*EOS_LINEAR_POLYNOMIAL\n1,0,0,0,0,0,0,0\n0,1\n");
  EXPECT_EQ(m.law, nullptr);
  EXPECT_TRUE(m.diagnostics.failed());
}

TEST(Null, ViscousShearStress) {
  const Material m(std::string("*MAT_NULL\n1,8.96e-9,0,2e-3\n") + copper_eos());
  Points points(*m.law);
  points.dt = 1e-6;
  points.step({0, 0, 0, 1e-4, 0, 0});
  EXPECT_NEAR(points.stress(0).xy, 2.0 * 2e-3 * 1e-4 / 1e-6, 1e-12);
  EXPECT_NEAR(pressure(points), 2.02 * points.energy(0), 1e-12);  // viscous heat
  points.step(Sym{});
  EXPECT_EQ(points.stress(0).xy, 0.0);
}

TEST(Null, CutsTensionAndErodes) {
  const Material m(std::string("*MAT_NULL\n1,8.96e-9,-10,0,1.1,0.8\n") + copper_eos());
  EXPECT_TRUE(m.law->can_fail());
  Points points(*m.law);
  squeeze(points, 1.0999, 10);
  EXPECT_NEAR(pressure(points), -10.0, 1e-12);
  EXPECT_EQ(points.failed(0), 0.0);
  squeeze(points, 1.0002, 1);
  EXPECT_EQ(points.failed(0), 1.0);
  Points squeezed(*m.law);
  squeeze(squeezed, 0.8001, 10);
  EXPECT_EQ(squeezed.failed(0), 0.0);
  squeeze(squeezed, 0.9998, 1);
  EXPECT_EQ(squeezed.failed(0), 1.0);
}

/// *MAT_JOHNSON_COOK with the constants of OFHC copper (Johnson & Cook 1983), first and last fields as given.
std::string copper(const std::string& vp, const std::string& third, const std::string& fourth = "0\n",
                   const std::string& step = "0") {
  return "*MAT_JOHNSON_COOK\n1,8.96e-9,46000,0,0," + step + "," + vp +
         ",0\n90,292,0.31,0.025,1.09,1356,294,1\n" + third + fourth + copper_eos();
}
constexpr int temperature = 1, damage = 2;

TEST(JohnsonCook, FlowStressAtGivenRateAndTemperature) {
  for (const double rate : {0.01, 1.0, 1e3, 1e6}) {
    const Material m(copper("0", "3.83e8,0,0,0\n"));
    Points points(*m.law);
    points.dt = 1e-3 / rate;
    for (int i = 0; i < 400; ++i) {
      const double homologous = (points.state(0, temperature) - 294.0) / (1356.0 - 294.0);
      points.step({0, 0, 0, 1e-3 * std::sqrt(0.75), 0, 0});
      if (points.plastic_strain(0) == 0.0) continue;
      const double expected = (90.0 + 292.0 * std::pow(points.plastic_strain(0), 0.31)) *
                              (1.0 + 0.025 * std::log(std::max(rate, 1.0))) *
                              (1.0 - std::pow(homologous, 1.09));
      EXPECT_NEAR(mises(points.stress(0)), expected, 1e-8 * expected) << rate;
    }
    EXPECT_GT(points.state(0, temperature), 320.0);
  }
}

TEST(JohnsonCook, HeatIsThePlasticWork) {
  const Material m(copper("0", "3.83e8,0,0,0\n"));
  Points points(*m.law);
  points.dt = 1e-7;
  for (int i = 0; i < 4000; ++i) points.step({0, 0, 0, 1e-4, 0, 0});
  const Sym s = deviator(points.stress(0));
  const double elastic = dot(s, s) / (4.0 * 46000.0);
  const double heat = 8.96e-9 * 3.83e8 * (points.state(0, temperature) - 294.0);
  EXPECT_NEAR(heat, points.energy(0) - elastic, 1e-3 * heat);
  EXPECT_NEAR(pressure(points), 0.0, 2.1 * points.energy(0));  // the same heat pushes through gamma
  EXPECT_GT(pressure(points), 1.9 * points.energy(0));
}

TEST(JohnsonCook, MeltsAway) {
  const Material m(copper("0", "1e6,0,0,0\n"));  // tiny heat capacity
  Points points(*m.law);
  for (int i = 0; i < 2000; ++i) points.step({0, 0, 0, 1e-3, 0, 0});
  EXPECT_GT(points.state(0, temperature), 0.999 * 1356.0);
  EXPECT_LT(mises(points.stress(0)), 1.0);
}

TEST(JohnsonCook, ViscoplasticFlowTakesTheRateOfFlow) {
  const Material m(copper("1", "0,0,0,0\n"));  // CP = 0: stays cold
  Points points(*m.law);
  points.dt = 1e-8;
  double before = 0.0;
  for (int i = 0; i < 300; ++i) {
    points.step({0, 0, 0, 1e-4, 0, 0});
    const double e = points.plastic_strain(0), rate = (e - before) / points.dt;
    before = e;
    if (rate == 0.0) continue;
    const double expected =
        (90.0 + 292.0 * std::pow(e, 0.31)) * (1.0 + 0.025 * std::log(std::max(rate, 1.0)));
    EXPECT_NEAR(mises(points.stress(0)), expected, 1e-8 * expected);
  }
  EXPECT_EQ(points.state(0, temperature), 294.0);
}

TEST(JohnsonCook, DamageIsStrainOverFractureStrain) {
  // Pure shear at rate 100 and room temperature: fracture strain (D1 + D2) (1 + D4 ln 100), but for the small
  // pressure that heat makes; CP = 0 keeps it cold, and energy still pushes, so compare step by step.
  const Material m(copper("0", "0,0,0,0,0.1,0.05,-3.0,0.014\n", "1.12\n"));
  EXPECT_TRUE(m.law->can_fail());
  Points points(*m.law);
  points.dt = 1e-3 / 100.0;
  double expected = 0.0, before = 0.0;
  for (int i = 0; i < 1000 && points.failed(0) == 0.0; ++i) {
    points.step({0, 0, 0, 1e-3 * std::sqrt(0.75), 0, 0});
    const double flow = points.plastic_strain(0) - before;
    before += flow;
    const double triaxiality = -pressure(points) / mises(points.stress(0));
    expected += flow / ((0.1 + 0.05 * std::exp(-3.0 * triaxiality)) * (1.0 + 0.014 * std::log(100.0)));
    EXPECT_NEAR(points.state(0, damage), expected, 1e-9);
    EXPECT_EQ(points.failed(0), expected >= 1.0 ? 1.0 : 0.0);
  }
  EXPECT_NEAR(expected, 1.0, 0.01);
}

TEST(JohnsonCook, WithoutErosionFractureLeavesRubble) {
  const Material m(copper("0", "0,0,0,0,0.1,0,0,0\n", "0,0,1\n"));
  EXPECT_FALSE(m.law->can_fail());
  Points points(*m.law);
  for (int i = 0; i < 400; ++i) points.step({0, 0, 0, 1e-3, 0, 0});
  EXPECT_EQ(points.failed(0), 0.0);
  EXPECT_LT(mises(points.stress(0)), 1e-12);
  points.step({0.01, 0, 0, 0, 0, 0});  // no tension
  EXPECT_GE(pressure(points), 0.0);
  points.step({-0.02, 0, 0, 0, 0, 0});  // compression still
  EXPECT_GT(pressure(points), 100.0);
  EXPECT_LT(mises(points.stress(0)), 1e-12 * pressure(points));
}

TEST(JohnsonCook, SpallModels) {
  const auto pull = [](const std::string& spall, double strain) {
    const Material m(copper("0", "0,-1500," + spall + ",0\n"));
    Points points(*m.law);
    for (int i = 0; i < 100; ++i)
      points.step({strain / 100, strain / 100, strain / 100, 0.2 * strain / 100, 0, 0});
    return std::array{pressure(points), mises(points.stress(0))};
  };
  // Pressure at which tension breaks: about K trace. 1: pressure is held at PC, shear stays.
  EXPECT_NEAR(pull("1", 0.01)[0], -1500.0, 1e-9);
  EXPECT_GT(pull("1", 0.01)[1], 50.0);
  // 2: largest principal stress; 3: pressure. No shear, no tension afterwards.
  for (const char* model : {"0", "2", "3"}) {
    EXPECT_LT(pull(model, 0.003)[0], -1000.0) << model;  // not yet
    EXPECT_EQ(pull(model, 0.01)[0], 0.0) << model;
    EXPECT_EQ(pull(model, 0.01)[1], 0.0) << model;
  }
  // Between the two bounds the principal stress breaks and the pressure does not.
  const double between = 1470.0 / (3.0 * 8.96e-9 * 3.94e6 * 3.94e6);
  EXPECT_EQ(pull("2", between)[0], 0.0);
  EXPECT_LT(pull("3", between)[0], -1400.0);
}

TEST(JohnsonCook, DeletesBelowItsTimeStep) {
  const Material m(copper("0", "0,0,0,0\n", "0\n", "1e-7"));
  EXPECT_TRUE(m.law->can_fail());
  const double limit = 1e-7 * std::sqrt(m.law->longitudinal_modulus() / 8.96e-9);
  Points points(*m.law);
  points.length(0) = 1.0001 * limit;
  points.length(1) = 0.9999 * limit;
  points.step(Sym{});
  EXPECT_EQ(points.failed(0), 0.0);
  EXPECT_EQ(points.failed(1), 1.0);
}

TEST(JohnsonCook, RefusesAMeltingPointBelowTheRoom) {
  const Material m(
      std::string("*MAT_JOHNSON_COOK\n1,8.96e-9,46000\n90,292,0.31,0.025,1.09,200,294,1\n3.83e8\n0\n") +
      copper_eos());
  EXPECT_EQ(m.law, nullptr);
}

TEST(JohnsonCook, EnergyIsConservedInAClosedVolumeCycle) {
  // Compression and release of the pressure alone, below yield in shear: nothing is lost.
  const Material m(copper("0", "0,0,0,0\n"));
  Points points(*m.law);
  squeeze(points, 0.9, 200);
  const double stored = points.energy(0);
  squeeze(points, 1.0 / 0.9, 200);
  EXPECT_GT(stored, 100.0);
  EXPECT_NEAR(points.energy(0), 0.0, 1e-5 * stored);
  EXPECT_NEAR(pressure(points), 0.0, 1e-4 * 139000.0 * 0.1);
}

}  // namespace
}  // namespace cleave::model::testing
