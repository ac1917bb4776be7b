/// Uniaxial responses, rate effects and erosion of the von Mises laws against closed forms.

#include "material_support.hpp"

namespace cleave::model::testing {
namespace {

constexpr double E = 210000.0, nu = 0.3, G = E / (2.0 * (1.0 + nu));

std::string kinematic(const std::string& rest) {
  return "*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,210000,0.3,300,1000," + rest;
}

TEST(PlasticKinematic, UniaxialCurveIsTheTangentModulus) {
  for (const char* beta : {"0.0\n", "0.5\n", "1.0\n"}) {
    const Material m(kinematic(beta));
    Points points(*m.law);
    for (int i = 1; i <= 40; ++i) {
      const Sym s = step_uniaxial(*m.law, points, 1e-3);
      const double strain = 1e-3 * i, yield = 300.0 / E;
      const double expected = strain < yield ? E * strain : 300.0 + 1000.0 * (strain - yield);
      EXPECT_NEAR(s.xx, expected, 1e-8 * 300.0) << beta << i;
    }
  }
}

TEST(PlasticKinematic, ReverseYieldTellsIsotropicFromKinematic) {
  // After hardening to S the reverse yield stress is -S (isotropic), S - 2 SIGY (kinematic), or in between.
  const double Ep = E * 1000.0 / (E - 1000.0);
  for (const double beta : {0.0, 0.25, 1.0}) {
    const Material m(kinematic(std::to_string(beta) + "\n"));
    Points points(*m.law);
    for (int i = 0; i < 50; ++i) step_uniaxial(*m.law, points, 1e-3);
    const double peak = points.stress(0).xx, flow = points.plastic_strain(0);
    while (points.plastic_strain(0) == flow) step_uniaxial(*m.law, points, -1e-5);
    const double expected = (1.0 - beta) * Ep * flow - (300.0 + beta * Ep * flow);
    EXPECT_NEAR(points.stress(0).xx, expected, 2.5);  // within one step of 1e-5 E
    EXPECT_NEAR(peak, 300.0 + Ep * flow, 1e-6);
  }
}

TEST(PlasticKinematic, BackStressIsTraceless) {
  const Material m(kinematic("0.3\n"));
  Points points(*m.law);
  Random random(1);
  for (int s = 0; s < 20; ++s) points.step(random.tensor(0.01));
  const Sym back = points.state_tensor(0, 0);
  EXPECT_GT(norm(back), 1.0);
  EXPECT_NEAR(trace(back), 0.0, 1e-10 * norm(back));
  // The stress lies on the displaced surface.
  const double Ep = E * 1000.0 / (E - 1000.0);
  EXPECT_NEAR(mises(deviator(points.stress(0)) - back), 300.0 + 0.3 * Ep * points.plastic_strain(0),
              1e-9 * 300.0);
}

/// Pure shear at a constant rate until flow is steady. Returns von Mises stress.
double shear_flow_stress(const Material& m, double effective_rate, double effective_strain, int steps) {
  Points points(*m.law);
  const double increment = effective_strain / steps;
  points.dt = increment / effective_rate;
  const double xy = increment * std::sqrt(3.0) / 2.0;  // effective strain = 2/sqrt(3) e_xy
  for (int i = 0; i < steps; ++i) points.step({0, 0, 0, xy, 0, 0});
  return mises(points.stress(0));
}

TEST(PlasticKinematic, CowperSymondsScalesTheYieldStress) {
  const double Ep = E * 1000.0 / (E - 1000.0);
  for (const double rate : {0.01, 40.0, 5000.0}) {
    const Material m(kinematic("1.0\n40,5,0,0\n"));
    Points points(*m.law);
    points.dt = 1e-4 / rate;
    for (int i = 0; i < 1000; ++i) points.step({0, 0, 0, 1e-4 * std::sqrt(0.75), 0, 0});
    const double factor = 1.0 + std::pow(rate / 40.0, 0.2);
    EXPECT_NEAR(mises(points.stress(0)), factor * (300.0 + Ep * points.plastic_strain(0)), 1e-9 * 300.0)
        << rate;
  }
}

TEST(PlasticKinematic, ViscoplasticFlowTakesTheRateOfFlow) {
  // In each step: stress = (SIGY + Ep e) (1 + (e rate / C)^(1/P)) with the rate of plastic strain.
  const double Ep = E * 1000.0 / (E - 1000.0);
  for (const double rate : {1e-3, 1.0, 40.0, 5000.0, 1e7}) {
    const Material m(kinematic("1.0\n40,5,0,1\n"));
    Points points(*m.law);
    points.dt = 1e-4 / rate;
    double before = 0.0;
    for (int i = 0; i < 300; ++i) {
      points.step({0, 0, 0, 1e-4 * std::sqrt(0.75), 0, 0});
      const double e = points.plastic_strain(0), flow = (e - before) / points.dt;
      before = e;
      if (flow == 0.0) continue;
      const double expected = (300.0 + Ep * e) * (1.0 + std::pow(flow / 40.0, 0.2));
      EXPECT_NEAR(mises(points.stress(0)), expected, 1e-9 * expected) << rate << " step " << i;
    }
    EXPECT_GT(points.plastic_strain(0), 0.0);
  }
}

TEST(PlasticKinematic, ErodesAtItsFailureStrain) {
  const Material m(kinematic("1.0\n0,0,0.02,0\n"));
  EXPECT_TRUE(m.law->can_fail());
  Points points(*m.law);
  while (points.plastic_strain(0) < 0.02) {
    EXPECT_EQ(points.failed(0), 0.0);
    points.step({0, 0, 0, 1e-4, 0, 0});
  }
  EXPECT_EQ(points.failed(0), 1.0);
  EXPECT_FALSE(Material(kinematic("1.0\n")).law->can_fail());
}

TEST(PlasticKinematic, RefusesATangentModulusAboveYoungs) {
  const Material m("*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,1000,0.3,300,1000,1\n");
  EXPECT_EQ(m.law, nullptr);
  EXPECT_TRUE(m.diagnostics.failed());
}

TEST(PlasticKinematic, EnergyIsTheWorkDone) {
  const Material m(kinematic("1.0\n"));
  Points points(*m.law);
  double work = 0.0, before = 0.0;
  for (int i = 0; i < 100; ++i) {
    points.viscosity(0) = 5.0;
    points.step({1e-4, -2e-4, 3e-4, 1e-4, 0, 0});
    const Sym s = points.stress(0);
    const double power = s.xx * 1e-4 - s.yy * 2e-4 + s.zz * 3e-4 + 2.0 * s.xy * 1e-4;
    work += 0.5 * (power + before) * 0.5 * (points.volume(0) + points.volume_before(0)) -
            5.0 * (points.volume(0) - points.volume_before(0));
    before = power;
  }
  EXPECT_NEAR(points.energy(0), work, 1e-12 * std::abs(work));
}

std::string piecewise(const std::string& rest) {
  return "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-9,210000,0.3," + rest;
}

TEST(PiecewiseLinear, UniaxialStressRunsThroughThePoints) {
  const std::vector<double> x{0, 0.01, 0.05, 0.1, 0.3}, y{250, 300, 360, 390, 450};
  const Material by_points(piecewise("0,0\n0\n0,0.01,0.05,0.1,0.3\n250,300,360,390,450\n"));
  const Material by_curve(
      piecewise("0,0\n0,0,7\n*DEFINE_CURVE\n7\n0,250\n0.01,300\n0.05,360\n0.1,390\n0.3,450\n"));
  for (const Material* m : {&by_points, &by_curve}) {
    Points points(*m->law);
    for (int i = 0; i < 200; ++i) {
      const Sym s = step_uniaxial(*m->law, points, 2e-3);
      const double e = points.plastic_strain(0);
      const std::size_t k = std::min<std::size_t>(std::upper_bound(x.begin(), x.end(), e) - x.begin(), 4);
      const double expected = y[k - 1] + (y[k] - y[k - 1]) / (x[k] - x[k - 1]) * (e - x[k - 1]);
      EXPECT_NEAR(s.xx, expected, 1e-9 * expected);  // beyond the last point with the last slope
    }
    EXPECT_GT(points.plastic_strain(0), 0.35);
  }
}

TEST(PiecewiseLinear, OneLargeStepCrossesSegmentsExactly) {
  const Material m(piecewise("0,0\n0\n0,0.01,0.05,0.1,0.3\n250,300,360,390,450\n"));
  Points once(*m.law);
  once.step({0, 0, 0, 0.12, 0, 0});
  const double e = once.plastic_strain(0), stress = 390.0 + 300.0 * (e - 0.1);
  EXPECT_GT(e, 0.1);
  EXPECT_NEAR(mises(once.stress(0)), stress, 1e-10 * stress);
  EXPECT_NEAR(mises(once.stress(0)), 2.0 * G * 0.12 * std::sqrt(3.0) - 3.0 * G * e, 1e-6);
}

TEST(PiecewiseLinear, HundredsOfPointsAreFollowed) {
  std::string text = piecewise("0,0\n0,0,7\n*DEFINE_CURVE\n7\n");
  for (int i = 0; i < 300; ++i)
    text += std::to_string(0.002 * i) + "," + std::to_string(200.0 + 300.0 * std::sqrt(0.002 * i)) + "\n";
  const Material m(text);
  Points points(*m.law);
  for (int i = 0; i < 40; ++i) {
    points.step({0, 0, 0, 0.012, 0, 0});
    EXPECT_NEAR(mises(points.stress(0)), 200.0 + 300.0 * std::sqrt(points.plastic_strain(0)), 0.5);
  }
}

TEST(PiecewiseLinear, TableInterpolatesBetweenRates) {
  const std::string curves = "*DEFINE_CURVE\n1\n0,200\n1,300\n*DEFINE_CURVE\n2\n0,400\n0.5,450\n1,600\n";
  const auto stress_at = [&](const std::string& table, double rate) {
    const Material m(piecewise("0,0\n0,0,9\n" + curves + table));
    Points points(*m.law);
    points.dt = 1e-4 / rate;
    for (int i = 0; i < 500; ++i) points.step({0, 0, 0, 1e-4 * std::sqrt(0.75), 0, 0});
    const double e = points.plastic_strain(0);
    return std::array{mises(points.stress(0)), 200.0 + 100.0 * e, 400.0 + 100.0 * e};
  };
  const std::string linear = "*DEFINE_TABLE_2D\n9\n1,1\n101,2\n";
  const std::string logarithmic = "*DEFINE_TABLE_2D\n9\n-4.605170185988091,1\n4.605170185988091,2\n";
  // {table, rate, share of the second curve}
  const std::tuple<std::string, double, double> cases[] = {
      {linear, 0.1, 0.0},      {linear, 26.0, 0.25},      {linear, 1000.0, 1.0},     {logarithmic, 1e-3, 0.0},
      {logarithmic, 1.0, 0.5}, {logarithmic, 10.0, 0.75}, {logarithmic, 1000.0, 1.0}};
  for (const auto& [table, rate, share] : cases) {
    const auto [stress, low, high] = stress_at(table, rate);
    EXPECT_NEAR(stress, low + share * (high - low), 1e-8 * stress) << rate;
  }
}

TEST(PiecewiseLinear, ViscoplasticTableTakesTheRateOfFlow) {
  const std::string curves = "*DEFINE_CURVE\n1\n0,200\n1,300\n*DEFINE_CURVE\n2\n0,400\n0.5,450\n";
  const Material m(piecewise("0,0\n0,0,9,0,1\n" + curves + "*DEFINE_TABLE_2D\n9\n1,1\n101,2\n"));
  for (const double rate : {0.5, 20.0, 90.0, 500.0}) {
    Points points(*m.law);
    points.dt = 1e-4 / rate;
    double before = 0.0;
    for (int i = 0; i < 200; ++i) {
      points.step({0, 0, 0, 1e-4 * std::sqrt(0.75), 0, 0});
      const double e = points.plastic_strain(0), flow = (e - before) / points.dt;
      before = e;
      if (flow == 0.0) continue;
      const double share = std::min(std::max((flow - 1.0) / 100.0, 0.0), 1.0);
      const double expected = 200.0 + 200.0 * share + 100.0 * e;
      EXPECT_NEAR(mises(points.stress(0)), expected, 1e-9 * expected) << rate << " " << i;
    }
  }
}

TEST(PiecewiseLinear, ViscoplasticSumAddsToTheGivenYieldStress) {
  // SIGY given: curve + SIGY (rate/C)^(1/P); SIGY not given: curve times the factor.
  const std::string curve = "*DEFINE_CURVE\n1\n0,200\n1,300\n";
  for (const double yield : {0.0, 150.0}) {
    const Material m(piecewise(std::to_string(yield) + ",0\n40,5,1,0,1\n" + curve));
    Points points(*m.law);
    points.dt = 1e-6;
    double before = 0.0;
    for (int i = 0; i < 200; ++i) {
      points.step({0, 0, 0, 1e-4, 0, 0});
      const double e = points.plastic_strain(0), flow = (e - before) / points.dt,
                   curve_stress = 200.0 + 100.0 * e;
      before = e;
      if (flow == 0.0) continue;
      const double expected =
          curve_stress + (yield > 0.0 ? yield : curve_stress) * std::pow(flow / 40.0, 0.2);
      EXPECT_NEAR(mises(points.stress(0)), expected, 1e-9 * expected);
    }
    EXPECT_GT(before, 0.0);
  }
}

TEST(PiecewiseLinear, RateCurveScalesTheYieldStress) {
  const Material m(piecewise("300,0\n0,0,0,4,0\n*DEFINE_CURVE\n4\n0,1\n10,1.2\n1000,1.6\n"));
  for (const auto& [rate, factor] : {std::pair{5.0, 1.1}, {505.0, 1.4}, {5000.0, 1.6}})
    EXPECT_NEAR(shear_flow_stress(m, rate, 0.1, 500), 300.0 * factor, 1e-8) << rate;
}

TEST(PiecewiseLinear, FailsAtPlasticStrainOrShortStep) {
  const Material strain(piecewise("300,1000,0.03,0\n"));
  Points points(*strain.law);
  while (points.plastic_strain(0) < 0.03) {
    EXPECT_EQ(points.failed(0), 0.0);
    points.step({0, 0, 0, 1e-4, 0, 0});
  }
  EXPECT_EQ(points.failed(0), 1.0);

  // Step of an element of length L: L sqrt(rho / modulus).
  const Material step(piecewise("300,1000,0,1e-7\n"));
  EXPECT_TRUE(step.law->can_fail());
  const double limit = 1e-7 * std::sqrt(step.law->longitudinal_modulus() / 7.8e-9);
  Points elements(*step.law);
  elements.length(0) = limit * 1.0001;
  elements.length(1) = limit * 0.9999;
  elements.step(Sym{});
  EXPECT_EQ(elements.failed(0), 0.0);
  EXPECT_EQ(elements.failed(1), 1.0);
}

TEST(PiecewiseLinear, RefusesCurvesItCannotFollow) {
  EXPECT_EQ(Material(piecewise("0,0\n0,0,7\n")).law, nullptr);                                // absent
  EXPECT_EQ(Material(piecewise("0,0\n")).law, nullptr);                                       // no yield
  EXPECT_EQ(Material(piecewise("0,0\n0,0,7\n*DEFINE_CURVE\n7\n0,0\n1,300\n")).law, nullptr);  // zero
  EXPECT_EQ(Material(piecewise("0,0\n0,0,7\n*DEFINE_CURVE\n7\n0,300\n0.0001,1\n")).law,
            nullptr);                                               // too steep
  EXPECT_EQ(Material(piecewise("300,0\n0,0,0,7\n")).law, nullptr);  // LCSR absent
}

TEST(PowerLaw, YieldStressHasThreeMeanings) {
  const auto yield_of = [](const std::string& field) {
    const Material m("*MAT_POWER_LAW_PLASTICITY\n1,7.8e-9,210000,0.3,600,0.2,0,0\n" + field + ",0,0\n");
    Points points(*m.law);
    while (points.plastic_strain(0) == 0.0) points.step({0, 0, 0, 1e-6, 0, 0});
    return mises(points.stress(0));
  };
  const double meeting = std::pow(E / 600.0, 1.0 / (0.2 - 1.0));  // E e = K e^N
  EXPECT_NEAR(yield_of("0"), E * meeting, 0.5);
  EXPECT_NEAR(yield_of("300"), 300.0, 0.5);
  EXPECT_NEAR(yield_of("0.002"), 600.0 * std::pow(0.002, 0.2), 0.5);
}

TEST(PowerLaw, StressFollowsThePower) {
  const Material m("*MAT_POWER_LAW_PLASTICITY\n1,7.8e-9,210000,0.3,600,0.2,0,0\n300,0.15,0\n");
  const double offset = std::pow(0.5, 5.0);
  Points points(*m.law);
  while (points.failed(0) == 0.0) {
    const Sym s = step_uniaxial(*m.law, points, 1e-3);
    if (points.plastic_strain(0) == 0.0) continue;
    const double expected = 600.0 * std::pow(offset + points.plastic_strain(0), 0.2);
    EXPECT_NEAR(s.xx, expected, 1e-9 * expected);
  }
  EXPECT_NEAR(points.plastic_strain(0), 0.15, 1e-3);
}

TEST(PowerLaw, AnyExponentAndStepSizeSolves) {
  for (const char* n : {"0.05", "0.2", "0.5", "0.9"})
    for (const double step : {1e-5, 1e-3, 1e-1}) {
      const Material m(std::string("*MAT_POWER_LAW_PLASTICITY\n1,7.8e-9,210000,0.3,600,") + n +
                       ",0,0\n0,0,0\n");
      const double exponent = std::stod(n), offset = std::pow(E / 600.0, 1.0 / (exponent - 1.0));
      Points points(*m.law);
      for (int i = 0; i < 50; ++i) {
        points.step({0, 0, 0, step, 0, 0});
        const double e = points.plastic_strain(0);
        if (e == 0.0) continue;
        const double expected = 600.0 * std::pow(offset + e, exponent);
        EXPECT_NEAR(mises(points.stress(0)), expected, 1e-9 * expected) << n << " " << step;
      }
    }
}

std::string simplified(const std::string& vp, const std::string& rest) {
  return "*MAT_SIMPLIFIED_JOHNSON_COOK\n1,7.8e-9,210000,0.3," + vp + "\n" + rest;
}

TEST(SimplifiedJohnsonCook, FlowStressAtGivenRate) {
  for (const double rate : {0.01, 1.0, 100.0, 1e5}) {
    const Material m(simplified("0", "350,275,0.36,0.022,0,0,0,1\n"));
    Points points(*m.law);
    points.dt = 1e-3 / rate;
    for (int i = 0; i < 200; ++i) points.step({0, 0, 0, 1e-3 * std::sqrt(0.75), 0, 0});
    const double factor = 1.0 + 0.022 * std::log(std::max(rate, 1.0));
    const double expected = (350.0 + 275.0 * std::pow(points.plastic_strain(0), 0.36)) * factor;
    EXPECT_NEAR(mises(points.stress(0)), expected, 1e-8 * expected) << rate;
  }
}

TEST(SimplifiedJohnsonCook, CapsBeforeAndAfterTheRate) {
  const Material before(simplified("0", "350,275,0.36,0.022,0,400,0,1\n"));
  EXPECT_NEAR(shear_flow_stress(before, 100.0, 0.5, 500), 400.0 * (1.0 + 0.022 * std::log(100.0)), 1e-8);
  const Material after(simplified("0", "350,275,0.36,0.022,0,400,430,1\n"));
  EXPECT_NEAR(shear_flow_stress(after, 100.0, 0.5, 500), 430.0, 1e-8);
}

TEST(SimplifiedJohnsonCook, ViscoplasticFlowTakesTheRateOfFlow) {
  const Material m(simplified("1", "350,275,0.36,0.022,0,0,0,1\n"));
  for (const double rate : {0.01, 10.0, 1e4, 1e8}) {
    Points points(*m.law);
    points.dt = 1e-4 / rate;
    double before = 0.0;
    for (int i = 0; i < 300; ++i) {
      points.step({0, 0, 0, 1e-4 * std::sqrt(0.75), 0, 0});
      const double e = points.plastic_strain(0), flow = (e - before) / points.dt;
      before = e;
      if (flow == 0.0) continue;
      const double expected =
          (350.0 + 275.0 * std::pow(e, 0.36)) * (1.0 + 0.022 * std::log(std::max(flow, 1.0)));
      EXPECT_NEAR(mises(points.stress(0)), expected, 1e-8 * expected) << rate << " " << i;
    }
  }
}

}  // namespace
}  // namespace cleave::model::testing
