/// Every law of the catalogue against what holds for all of them.

#include <algorithm>

#include "material_samples.hpp"
#include "material_support.hpp"

namespace cleave::model::testing {
namespace {

class EveryLaw : public ::testing::TestWithParam<Sample> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLaw, ::testing::ValuesIn(samples()), [](const auto& test) {
  std::string name = std::string(test.param.keyword) + "_" + test.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

TEST(Catalogue, EveryLawHasASample) {
  for (const LawEntry* entry : law_catalogue()) {
    const auto all = samples();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Sample& s) {
      return s.keyword == entry->keyword;
    })) << entry->keyword;
    EXPECT_FALSE(entry->source.empty());
  }
}

/// Moves the points to states that differ from each other: a few random steps, plastic for most of them.
void stir(const Law& law, Points& points, const Sample& sample, std::uint64_t seed, int steps = 4) {
  Random random(seed);
  points.dt = sample.dt;
  for (int s = 0; s < steps; ++s) {
    for (int i = 0; i < points.point_count(); ++i) {
      const double size = sample.strain * (i % 4 == 0 ? 0.05 : 1.0);
      if (law.needs_F()) {
        Mat F = Mat::identity();
        for (auto& row : F.m)
          for (double& c : row) c += random(size);
        points.set_F(i, F);
      } else {
        points.set_strain(i, random.tensor(size));
      }
    }
    points.update();
  }
}

TEST_P(EveryLaw, TangentFromDualNumbersMeetsCentralDifferences) {
  const Material material(GetParam().deck);
  const Law& law = *material.law;
  Points points(law);
  stir(law, points, GetParam(), 1);
  Random random(2);
  const int inputs = law.needs_F() ? 9 : 6;
  std::vector<std::array<double, 9>> base(points.point_count());
  const Points start = points;
  for (int i = 0; i < points.point_count(); ++i)
    for (int k = 0; k < inputs; ++k)
      base[i][k] = random(GetParam().strain) + (law.needs_F() && k % 4 == 0 ? 1.0 : 0.0);

  const auto set = [&](Points& p, int input, double shift) {
    for (int i = 0; i < p.point_count(); ++i) {
      auto v = base[i];
      if (input >= 0) v[input] += shift;
      if (law.needs_F()) {
        Mat F;
        for (int k = 0; k < 9; ++k) F.m[k / 3][k % 3] = v[k];
        p.set_F(i, F);
      } else {
        p.set_strain(i, {v[0], v[1], v[2], v[3], v[4], v[5]});
      }
    }
  };
  Points at = start;
  set(at, -1, 0.0);
  const auto tangent = at.tangent();
  const double h = 1e-6 * GetParam().strain;
  for (int k = 0; k < inputs; ++k) {
    Points up = start, down = start;
    set(up, k, h);
    set(down, k, -h);
    up.update_scalar();
    down.update_scalar();
    for (int i = 0; i < points.point_count(); ++i) {
      const auto a = components(up.stress(i)), b = components(down.stress(i));
      for (int c = 0; c < 6; ++c) {
        const double difference = (a[c] - b[c]) / (2.0 * h);
        EXPECT_NEAR(tangent[(c * inputs + k) * lane_count + i], difference, 2e-6 * law.longitudinal_modulus())
            << "point " << i << " component " << c << " input " << k;
      }
    }
  }
}

TEST_P(EveryLaw, TurnsWithTheBody) {
  const Material material(GetParam().deck);
  const Law& law = *material.law;
  Points still(law, 2);
  stir(law, still, GetParam(), 3);
  Points turned = still;
  Random random(4);
  std::vector<Mat> Q;
  for (int i = 0; i < still.point_count(); ++i) {
    Q.push_back(random.rotation());
    const Sym e = random.tensor(GetParam().strain);
    if (law.needs_F()) {
      Mat F = still.F(i);
      F.m[0][1] += 0.3 * GetParam().strain;
      still.set_F(i, F);
      turned.set_F(i, Q[i] * F);
    } else {
      still.set_strain(i, e);
      turned.set_strain(i, rotate(Q[i], e));
    }
    turned.set_stress(i, rotate(Q[i], still.stress(i)));
    for (int t = 0; t < law.rotated_tensors(); ++t)
      turned.set_state_tensor(i, 6 * t, rotate(Q[i], still.state_tensor(i, 6 * t)));
  }
  still.update();
  turned.update();
  for (int i = 0; i < still.point_count(); ++i) {
    const Sym expected = rotate(Q[i], still.stress(i));
    EXPECT_LT(norm(expected - turned.stress(i)), 1e-12 * (law.longitudinal_modulus() + norm(expected)));
    for (int t = 0; t < law.rotated_tensors(); ++t)
      EXPECT_LT(norm(rotate(Q[i], still.state_tensor(i, 6 * t)) - turned.state_tensor(i, 6 * t)),
                1e-12 * law.longitudinal_modulus());
    for (int k = 6 * law.rotated_tensors(); k < law.state_size(); ++k)
      EXPECT_NEAR(still.state(i, k), turned.state(i, k), 1e-11 * (1.0 + std::abs(still.state(i, k))));
    EXPECT_NEAR(still.energy(i), turned.energy(i), 1e-11 * (1.0 + std::abs(still.energy(i))));
    EXPECT_EQ(still.failed(i), turned.failed(i));
  }
}

/// Distance of two doubles in units of the last place.
double places_apart(double a, double b) {
  if (a == b) return 0.0;
  return std::abs(a - b) / (std::max(std::abs(a), std::abs(b)) * 2.220446049250313e-16);
}

TEST_P(EveryLaw, LanesMeetTheScalarTwin) {
  const Material material(GetParam().deck);
  const Law& law = *material.law;
  const std::string_view word = GetParam().keyword;
  const bool exact = GetParam().name == "isotropic" || GetParam().name == "kinematic" ||
                     word == "MAT_ELASTIC" || word == "MAT_NULL" || word == "MAT_MOONEY-RIVLIN_RUBBER" ||
                     GetParam().name == "tangent";
  Points lanes(law, 3);
  stir(law, lanes, GetParam(), 5, 3);
  Points scalars = lanes;
  Random random(6);
  for (int i = 0; i < lanes.point_count(); ++i) {
    const Sym e = random.tensor(GetParam().strain);
    Mat F = lanes.F(i);
    F.m[1][2] += random(GetParam().strain);
    for (Points* p : {&lanes, &scalars}) law.needs_F() ? p->set_F(i, F) : p->set_strain(i, e);
  }
  lanes.update();
  scalars.update_scalar();
  // Functions agree to 4 places; a difference of trial and flow stress may lose a few more.
  const double scale = 1e-12;
  for (std::size_t k = 0; k < lanes.record().size(); ++k) {
    const double a = lanes.record()[k], b = scalars.record()[k];
    if (exact)
      EXPECT_EQ(a, b);
    else
      EXPECT_TRUE(places_apart(a, b) <= 64.0 || std::abs(a - b) < scale) << a << " " << b;
  }
  for (int i = 0; i < lanes.point_count(); ++i) EXPECT_EQ(lanes.failed(i), scalars.failed(i));
}

TEST_P(EveryLaw, AnUntouchedPointStaysAtZero) {
  const Material material(GetParam().deck);
  Points points(*material.law);
  const bool gas = GetParam().name == "gas";  // starts under its own pressure
  for (double dt : {GetParam().dt, 0.0}) {
    points.dt = dt;
    for (int i = 0; i < points.point_count(); ++i) points.set_strain(i, Sym{});
    points.update();
    for (int i = 0; i < points.point_count(); ++i) {
      for (const double c : components(points.stress(i))) {
        if (!gas) {
          EXPECT_EQ(c, 0.0);
        }
      }
      EXPECT_EQ(points.energy(i), 0.0);
      EXPECT_EQ(points.failed(i), 0.0);
      if (material.law->plastic_strain() >= 0) {
        EXPECT_EQ(points.plastic_strain(i), 0.0);
      }
      if (!gas) {
        EXPECT_NEAR(points.modulus(i), material.law->longitudinal_modulus(), 1e-12 * points.modulus(i));
      }
    }
  }
}

TEST_P(EveryLaw, AStepOfNoLengthGivesNumbers) {
  const Material material(GetParam().deck);
  Points points(*material.law);
  stir(*material.law, points, GetParam(), 7);
  points.dt = 0.0;
  for (int i = 0; i < points.point_count(); ++i)
    if (!material.law->needs_F()) points.set_strain(i, Sym{});
  points.update();
  for (const double v : points.record()) EXPECT_TRUE(std::isfinite(v));
}

TEST_P(EveryLaw, ModulusBoundsTheTangent) {
  // The wave speed used for the stable step is not below that of the tangent along the axes.
  const Material material(GetParam().deck);
  const Law& law = *material.law;
  Points points(law);
  stir(law, points, GetParam(), 8);
  if (GetParam().name == "spall") return;  // a point that breaks within the step has no tangent
  if (GetParam().name.find("scaled") != std::string::npos) return;  // viscous: damps, carries no waves
  Points moved = points;
  if (!law.needs_F()) {
    Random random(9);
    for (int i = 0; i < points.point_count(); ++i) {
      const Sym e = random.tensor(1e-3 * GetParam().strain);
      points.set_strain(i, e), moved.set_strain(i, e);
    }
  }
  const auto tangent = moved.tangent();
  points.update();
  for (int i = 0; i < points.point_count(); ++i)
    for (int d = 0; d < 3; ++d) {
      double stiffness = 0.0;
      if (law.needs_F()) {  // d sigma_dd / d ln(stretch along d) + transport: F' = n n^T F
        for (int k = 0; k < 3; ++k)
          stiffness += tangent[(d * 9 + 3 * d + k) * lane_count + i] * points.F(i).m[d][k];
      } else {
        stiffness = tangent[(d * 6 + d) * lane_count + i];
      }
      EXPECT_LE(stiffness, points.modulus(i) * 1.1) << i << " " << d;
    }
}

TEST_P(EveryLaw, ClosedStrainCyclesDissipate) {
  const Material material(GetParam().deck);
  const Law& law = *material.law;
  if (law.needs_F() || GetParam().keyword == "MAT_NULL") return;  // tested with their closed forms
  Random random(10);
  Points points(law);
  points.dt = GetParam().dt;
  const int corners = 6, steps = 50;
  std::vector<std::array<Sym, corners + 1>> path(points.point_count());
  for (auto& corner : path) {
    for (int c = 1; c < corners; ++c) corner[c] = random.tensor(GetParam().strain);
    corner[0] = corner[corners] = Sym{};
  }
  for (int c = 0; c < corners; ++c)
    for (int s = 0; s < steps; ++s) {
      for (int i = 0; i < points.point_count(); ++i)
        points.set_strain(i, (1.0 / steps) * (path[i][c + 1] - path[i][c]));
      points.update();
    }
  // Whoever bends a body to and fro and back must have paid at least the energy it still holds.
  const double strain = GetParam().strain;
  for (int i = 0; i < points.point_count(); ++i) {
    const Sym shear = deviator(points.stress(i));
    const double held = dot(shear, shear) / (4.0 * law.shear_modulus());
    if (law.plastic_strain() < 0) {
      // A rate law of elasticity conserves energy up to the volume change, one order above the energy itself.
      EXPECT_NEAR(points.energy(i), 0.0, 3.0 * law.longitudinal_modulus() * strain * strain * strain);
    } else {
      EXPECT_GT(points.energy(i), held);
      EXPECT_GT(points.plastic_strain(i), 0.0);
    }
  }
}

}  // namespace
}  // namespace cleave::model::testing
