/// Homogeneous deformations of the rubber laws against closed forms.

#include "material_support.hpp"

namespace cleave::model::testing {
namespace {

Mat diagonal(double x, double y, double z) {
  Mat F = Mat::identity();
  F.m[0][0] = x, F.m[1][1] = y, F.m[2][2] = z;
  return F;
}

/// Cauchy stress at a deformation gradient.
Sym stress_at(const Law& law, const Mat& F) {
  Points points(law);
  for (int i = 0; i < points.point_count(); ++i) points.set_F(i, F);
  points.update();
  return points.stress(0);
}

/// Solves f(x) = 0 between two bounds of opposite sign.
template <class F>
double bisect(F f, double low, double high) {
  const bool rising = f(high) > 0.0;
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (low + high);
    (f(mid) > 0.0) == rising ? high = mid : low = mid;
  }
  return 0.5 * (low + high);
}

std::string mooney(double nu, double a, double b) {
  char text[200];
  std::snprintf(text, sizeof text, "*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-9,%.12g,%.12g,%.12g\n", nu, a, b);
  return text;
}

/// Nearly incompressible: K / G about 1e6, so that the incompressible closed forms hold to 1e-5.
constexpr double stiff = 0.4999995;

TEST(MooneyRivlin, UniaxialNominalStress) {
  const double a = 0.4, b = 0.1;
  const Material m(mooney(stiff, a, b));
  for (const double l : {0.5, 0.8, 1.25, 2.0, 4.0}) {
    const auto at = [&](double lateral) { return diagonal(l, lateral, lateral); };
    const double side = bisect([&](double x) { return stress_at(*m.law, at(x)).yy; }, 0.98 / std::sqrt(l),
                               1.02 / std::sqrt(l));
    const double nominal = stress_at(*m.law, at(side)).xx * side * side;
    const double expected = 2.0 * (l - 1.0 / (l * l)) * (a + b / l);
    EXPECT_NEAR(nominal, expected, 3e-5 * std::abs(expected)) << l;
  }
}

TEST(MooneyRivlin, EquibiaxialNominalStress) {
  const double a = 0.4, b = 0.1;
  const Material m(mooney(stiff, a, b));
  for (const double l : {0.8, 1.25, 2.0, 3.0}) {
    const double thickness = bisect([&](double x) { return stress_at(*m.law, diagonal(l, l, x)).zz; },
                                    0.98 / (l * l), 1.02 / (l * l));
    const double nominal = stress_at(*m.law, diagonal(l, l, thickness)).xx * l * thickness;
    const double expected = 2.0 * (l - std::pow(l, -5)) * (a + b * l * l);
    EXPECT_NEAR(nominal, expected, 3e-5 * std::abs(expected)) << l;
  }
}

TEST(MooneyRivlin, SimpleShear) {
  // sigma_xy = 2 (A + B) g, sigma_xx - sigma_zz = 2 A g^2, sigma_yy - sigma_zz = -2 B g^2; exact at any PR.
  const double a = 0.4, b = 0.1;
  for (const double nu : {0.3, 0.495}) {
    const Material m(mooney(nu, a, b));
    for (const double g : {0.1, 1.0, 3.0}) {
      Mat F = Mat::identity();
      F.m[0][1] = g;
      const Sym s = stress_at(*m.law, F);
      EXPECT_NEAR(s.xy, 2.0 * (a + b) * g, 1e-13 * (1.0 + g));
      EXPECT_NEAR(s.xx - s.zz, 2.0 * a * g * g, 1e-12 * (1.0 + g * g));
      EXPECT_NEAR(s.yy - s.zz, -2.0 * b * g * g, 1e-12 * (1.0 + g * g));
    }
  }
}

TEST(MooneyRivlin, NeoHookeanShear) {
  // Verification case A05: s12 = mu g, s11 - s22 = mu g^2.
  const Material m(mooney(0.49, 0.5, 0.0));
  for (double g = 0.0; g <= 6.0; g += 0.5) {
    Mat F = Mat::identity();
    F.m[0][1] = g;
    const Sym s = stress_at(*m.law, F);
    EXPECT_NEAR(s.xy, g, 1e-13 * (1.0 + g));
    EXPECT_NEAR(s.xx - s.yy, g * g, 1e-12 * (1.0 + g * g));
  }
}

TEST(MooneyRivlin, LongWallUnderBiaxialStress) {
  // Verification case C03: A = 80, B = 20, plane strain, Cauchy stress (-50, 100): u_x = -0.16753 of 1,
  // u_y = 0.40250 of 2. Incompressible.
  const Material m(mooney(stiff, 80.0, 20.0));
  double x = 0.85, y = 1.18;
  for (int i = 0; i < 60; ++i) {  // Newton with differences
    const auto residual = [&](double lx, double ly) {
      const Sym s = stress_at(*m.law, diagonal(lx, ly, 1.0));
      return std::array{s.xx + 50.0, s.yy - 100.0};
    };
    const double h = 1e-8;
    const auto r = residual(x, y), rx = residual(x + h, y), ry = residual(x, y + h);
    const double a = (rx[0] - r[0]) / h, b = (ry[0] - r[0]) / h, c = (rx[1] - r[1]) / h,
                 d = (ry[1] - r[1]) / h;
    x -= (d * r[0] - b * r[1]) / (a * d - b * c);
    y -= (a * r[1] - c * r[0]) / (a * d - b * c);
  }
  EXPECT_NEAR(x - 1.0, -0.16753, 1e-5);
  EXPECT_NEAR(2.0 * (y - 1.0), 0.40250, 1e-5);
}

TEST(MooneyRivlin, SmallStrainModuliAreThoseOfTheCard) {
  for (const double nu : {0.3, 0.49}) {
    const Material m(mooney(nu, 0.4, 0.1));
    const double shear = 1.0, h = 1e-7;
    EXPECT_DOUBLE_EQ(m.law->shear_modulus(), shear);
    EXPECT_NEAR(m.law->longitudinal_modulus(), 2.0 * shear * (1.0 - nu) / (1.0 - 2.0 * nu),
                1e-11 * m.law->longitudinal_modulus());
    const double measured =
        (stress_at(*m.law, diagonal(1.0 + h, 1, 1)).xx - stress_at(*m.law, diagonal(1.0 - h, 1, 1)).xx) /
        (2.0 * h);
    EXPECT_NEAR(measured, m.law->longitudinal_modulus(), 1e-6 * measured);
  }
}

TEST(MooneyRivlin, RefusesFittingAndNegativeStiffness) {
  EXPECT_EQ(Material(mooney(0.49, 0.1, -0.2)).law, nullptr);
  const auto& fields = find_law("MAT_MOONEY-RIVLIN_RUBBER")->fields;
  for (const LawField& f : fields)
    if (f.name == "LCID") {
      EXPECT_EQ(f.high, 0.0);
    }
}

TEST(BlatzKo, UniaxialStretch) {
  // Free sides: l_s^2 = J^(1 - 1/(1 - 2 nu)) with J = l l_s^2, so l_s = l^-nu.
  const Material m("*MAT_BLATZ-KO_RUBBER\n1,1e-9,1.5\n");
  const double nu = 0.463;
  for (const double l : {0.6, 0.9, 1.5, 3.0}) {
    const double side = std::pow(l, -nu), J = l * side * side;
    const Sym s = stress_at(*m.law, diagonal(l, side, side));
    EXPECT_NEAR(s.yy, 0.0, 1e-12);
    EXPECT_NEAR(s.xx, 1.5 * (l * l - side * side) / J, 1e-12 * (1.0 + std::abs(s.xx))) << l;
  }
}

TEST(BlatzKo, SmallStrainModuli) {
  const Material m("*MAT_BLATZ-KO_RUBBER\n1,1e-9,1.5\n");
  const double h = 1e-6;
  const double measured =
      (stress_at(*m.law, diagonal(1.0 + h, 1, 1)).xx - stress_at(*m.law, diagonal(1.0 - h, 1, 1)).xx) /
      (2.0 * h);
  EXPECT_NEAR(measured, 2.0 * 1.5 * (1.0 - 0.463) / (1.0 - 2.0 * 0.463), 1e-7 * measured);
  EXPECT_NEAR(m.law->longitudinal_modulus(), measured, 1e-7 * measured);
}

/// Work P : F' on a closed path of deformation, summed at equal steps of the path's parameter.
double closed_path_work(const Law& law, int steps) {
  double work = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2.0 * M_PI * i / steps, s = std::sin(angle), c = std::cos(angle);
    Mat F = Mat::identity(), slope = Mat::identity();
    F.m[0][0] += 0.3 * s, F.m[1][1] += 0.2 * (1.0 - c), F.m[2][2] -= 0.15 * s;
    F.m[0][1] += 0.4 * (1.0 - c), F.m[1][2] += 0.3 * s * (1.0 - c);
    slope.m[0][0] = 0.3 * c, slope.m[1][1] = 0.2 * s, slope.m[2][2] = -0.15 * c;
    slope.m[0][1] = 0.4 * s, slope.m[1][2] = 0.3 * (c - c * c + s * s);
    const double J = determinant(F);
    const Mat back = inverse(F, J);
    const Sym t = stress_at(law, F);
    const double sigma[3][3] = {{t.xx, t.xy, t.zx}, {t.xy, t.yy, t.yz}, {t.zx, t.yz, t.zz}};
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)  // P = J sigma F^-T
          work += J * sigma[r][j] * back.m[k][j] * slope.m[r][k] * (2.0 * M_PI / steps);
  }
  return work;
}

TEST(Hyperelastic, ClosedPathsTakeNoWork) {
  for (const std::string& deck :
       {mooney(0.45, 0.4, 0.1), std::string("*MAT_BLATZ-KO_RUBBER\n1,1e-9,1.5\n")}) {
    const Material m(deck);
    // The path is smooth and periodic: the sum converges faster than any power of the step.
    EXPECT_NEAR(closed_path_work(*m.law, 400), 0.0, 1e-10 * m.law->longitudinal_modulus());
  }
}

}  // namespace
}  // namespace cleave::model::testing
