/// Incident waves, initial stresses and orthotropic materials of spacetime decks.

#include <gtest/gtest.h>

#include <cmath>

#include "spacetime_deck.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

const std::string outline = "*SET_SEGMENT\n4\n1,2\n2,3\n3,4\n4,1\n*BOUNDARY_NON_REFLECTING\n4\n";
const std::string constant_curve = "*DEFINE_CURVE\n8\n0,1\n100,1\n";

std::string row(std::initializer_list<double> values) {
  std::string text;
  char number[40];
  for (const double v : values) {
    std::snprintf(number, sizeof number, "%s%.17g", text.empty() ? "" : ",", v);
    text += number;
  }
  return text + "\n";
}

// rho = 2, lambda = mu = 1: c_p^2 = 3/2, c_s^2 = 1/2.
TEST(SpacetimeBodyWaves, NormalIncidence) {
  // The curve of `square` is the time itself: sigma_xx = 3 (t - 0.1 - (x - 0.5) / c_p), v_x = -sigma / (rho
  // c_p).
  const FromDeck<2> b(square + outline + "*LOAD_INCIDENT_WAVE\n4,1,9,3.0,0.1\n1,0,0,0.5,0,0\n");
  ASSERT_TRUE(b.body) << b.text();
  const double c = std::sqrt(1.5), sigma = 3.0 * (0.9 - 0.1 + 0.5 / c), v = -sigma / (2.0 * c);
  // At the left face, at rest: half of the characteristic, which is the traction of the wave itself.
  Star<2> star = b.star(b.face({1, 4}), 0.9);
  EXPECT_NEAR(star.s[0], -sigma, 1e-13);
  EXPECT_NEAR(star.s[1], 0.0, 1e-14);
  EXPECT_NEAR(star.v_minus[0], v, 1e-13);
  // With the wave inside, the face does nothing to it.
  star = b.star(b.face({1, 4}), 0.9, {v, 0.0}, {-sigma, 0.0});
  EXPECT_NEAR(star.s[0], -sigma, 1e-13);
  EXPECT_NEAR(star.v_minus[0], v, 1e-13);
  // Where it leaves, nothing comes in.
  EXPECT_NEAR(b.star(b.face({2, 3}), 0.9).s[0], 0.0, 1e-14);
}

/// A wave of constant stress that fills the square from the start: initial stress and velocity, and its
/// entering and leaving through all four sides, keep it exactly as it is.
void expect_steady(int kind, double nx, double ny, const std::string& control) {
  const double c = kind == 1 ? std::sqrt(1.5) : std::sqrt(0.5);
  const double px = kind == 1 ? nx : -ny, py = kind == 1 ? ny : nx;
  const double sxx = kind == 1 ? 1.0 / 3.0 + 2.0 / 3.0 * nx * nx : 2.0 * px * nx,
               syy = kind == 1 ? 1.0 / 3.0 + 2.0 / 3.0 * ny * ny : 2.0 * py * ny,
               sxy = kind == 1 ? 2.0 / 3.0 * nx * ny : px * ny + py * nx;
  std::string text = square + outline + constant_curve + control + "*LOAD_INCIDENT_WAVE\n4," +
                     std::to_string(kind) + ",8,1.0,-10\n" + row({nx, ny, 0.0});
  if (kind == 2) text += "\n";
  text += "*INITIAL_VELOCITY\n0\n" + row({-px / (2.0 * c), -py / (2.0 * c)}) + "*INITIAL_STRESS_SHELL\n";
  for (int e = 11; e <= 14; ++e) text += std::to_string(e) + ",1,1\n" + row({0.0, sxx, syy, 0.0, sxy});
  const FromDeck<2> b(text);
  ASSERT_TRUE(b.body) << b.text();
  const auto solution = solve(*b.body);
  for (const auto& s : solution) {
    const PointState<2> at = s.at({0.4, 0.45, 1.0});
    const Voigt<2> stress = s.material->stress(at.strain);
    EXPECT_NEAR(at.v[0], -px / (2.0 * c), 1e-11);
    EXPECT_NEAR(at.v[1], -py / (2.0 * c), 1e-11);
    EXPECT_NEAR(stress[0], sxx, 1e-11);
    EXPECT_NEAR(stress[1], syy, 1e-11);
    EXPECT_NEAR(stress[2], sxy, 1e-11);
  }
}

TEST(SpacetimeBodyWaves, ObliqueWavesPassUnchanged) {
  expect_steady(1, 1.0, 0.0, "");
  expect_steady(1, 0.6, 0.8, "");
  expect_steady(2, 0.6, 0.8, "");
  expect_steady(2, -0.8, 0.6, "*CONTROL_SPACETIME\n2,1\n");
  expect_steady(1, 0.6, -0.8, "*CONTROL_SPACETIME\n1,2\n");
}

TEST(SpacetimeBodyWaves, BarsAndTetrahedra) {
  const FromDeck<1> bar(bar_of_two + "*SET_SEGMENT\n4\n1\n*BOUNDARY_NON_REFLECTING\n4\n" + constant_curve +
                        "*LOAD_INCIDENT_WAVE\n4,1,8\n1,0,0\n");
  ASSERT_TRUE(bar.body) << bar.text();
  EXPECT_NEAR(bar.star(bar.face({1}), 0.5).s[0], -1.0, 1e-14);
  EXPECT_NEAR(bar.star(bar.face({1}), 0.5).v_minus[0], -1.0 / (2.0 * std::sqrt(1.25)),
              1e-14);  // c^2 = E / rho
  const FromDeck<3> block(tetrahedron + "*SET_SEGMENT\n4\n1,3,2,2\n*BOUNDARY_NON_REFLECTING\n4\n" +
                          constant_curve + "*LOAD_INCIDENT_WAVE\n4,2,8\n0,0,1\n1,1,1\n");
  ASSERT_TRUE(block.body) << block.text();
  const Star<3> star = block.star(block.face({1, 2, 3}), 0.5);
  EXPECT_NEAR(star.s[0], -std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(star.s[1], -std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(star.s[2], 0.0, 1e-14);
}

TEST(SpacetimeBodyWaves, RefusedWhereNothingIsSilent) {
  const std::string one_side = "*SET_SEGMENT\n4\n4,1\n";
  EXPECT_TRUE(FromDeck<2>(square + one_side + "*LOAD_INCIDENT_WAVE\n4,1,9\n1,0,0\n")
                  .refuses(after_square + 4, "is not silent"));
  EXPECT_TRUE(FromDeck<2>(square + "*LOAD_INCIDENT_WAVE\n4,1,9\n1,0,0\n").text().find("segment set 4") !=
              std::string::npos);
}

/// The square of an orthotropic material; the axes follow.
std::string orthotropic(const std::string& axes, const std::string& section = "1,13") {
  return square_with("*MAT_ELASTIC\n1,2.0,2.5,0.25\n*SECTION_SHELL_SDG\n1\n",
                     "*MAT_ORTHOTROPIC_ELASTIC\n1,2.0,10.0,4.0,5.0,0.12,0.1,0.25\n" + axes +
                         "*SECTION_SHELL_SDG\n" + section + "\n");
}

TEST(SpacetimeBodyOrthotropic, StiffnessInvertsTheCompliance) {
  const std::string along = "1.5,1.0,0.8,2\n0,0,0,1,0,0\n0,0,0,0,1,0\n";
  // Plane stress by hand: C = (E_a, nu E_a; ., E_b) / (1 - nu_ab nu_ba), nu_ab = nu_ba E_a / E_b = 0.3.
  const FromDeck<2> thin(orthotropic(along, "1,12"));
  ASSERT_TRUE(thin.body) << thin.text();
  const auto& c = thin.body->problem.materials[0].stiffness;
  EXPECT_NEAR(c[0][0], 10.0 / (1.0 - 0.3 * 0.12), 1e-13);
  EXPECT_NEAR(c[1][1], 4.0 / (1.0 - 0.3 * 0.12), 1e-13);
  EXPECT_NEAR(c[0][1], 0.3 * 4.0 / (1.0 - 0.3 * 0.12), 1e-13);
  EXPECT_NEAR(c[2][2], 1.5, 1e-14);
  // Plane strain: eps_cc = 0 gives the in-plane compliance S_ij - S_i3 S_j3 / S_33.
  const FromDeck<2> thick(orthotropic(along));
  ASSERT_TRUE(thick.body) << thick.text();
  const double s13 = -0.1 / 5.0, s23 = -0.25 / 5.0, s33 = 1.0 / 5.0, s11 = 0.1 - s13 * s13 / s33,
               s22 = 0.25 - s23 * s23 / s33, s12 = -0.03 - s13 * s23 / s33, det = s11 * s22 - s12 * s12;
  const auto& d = thick.body->problem.materials[0].stiffness;
  EXPECT_NEAR(d[0][0], s22 / det, 1e-12);
  EXPECT_NEAR(d[1][1], s11 / det, 1e-12);
  EXPECT_NEAR(d[0][1], -s12 / det, 1e-12);
  // What keeps eps_cc at zero: sigma_c = -(S_13 sigma_a + S_23 sigma_b) / S_33; none in a thin sheet.
  const Voigt<2> strain{0.3, -0.2, 0.7};
  const Elastic<2>& m = thick.body->problem.materials[0];
  const auto stress = m.stress(strain);
  EXPECT_NEAR(m.stress_across(strain), -(s13 * stress[0] + s23 * stress[1]) / s33, 1e-13);
  EXPECT_EQ(thin.body->problem.materials[0].stress_across(strain), 0.0);
  // The same state seen by axes turned by 30 degrees: shear takes part.
  const double turn = std::acos(-1.0) / 6.0, co = std::cos(turn), si = std::sin(turn);
  const FromDeck<2> turned(orthotropic("1.5,1.0,0.8,2\n" + row({0, 0, 0, co, si, 0}) + "0,0,0,0,1,0\n"));
  ASSERT_TRUE(turned.body) << turned.text();
  const Voigt<2> seen{co * co * strain[0] + si * si * strain[1] - 2 * si * co * strain[2],
                      si * si * strain[0] + co * co * strain[1] + 2 * si * co * strain[2],
                      si * co * (strain[0] - strain[1]) + (co * co - si * si) * strain[2]};
  EXPECT_NEAR(turned.body->problem.materials[0].stress_across(seen), m.stress_across(strain), 1e-12);
}

TEST(SpacetimeBodyOrthotropic, AxesTurnTheSpeeds) {
  const FromDeck<2> along(orthotropic("1.5,1.0,0.8,2\n0,0,0,1,0,0\n0,0,0,0,1,0\n"));
  ASSERT_TRUE(along.body) << along.text();
  const Elastic<2>& m = along.body->problem.materials[0];
  EXPECT_NEAR(m.speeds({1.0, 0.0})[1], std::sqrt(m.stiffness[0][0] / 2.0), 1e-13);  // along a
  EXPECT_NEAR(m.speeds({1.0, 0.0})[0], std::sqrt(1.5 / 2.0), 1e-13);
  EXPECT_NEAR(m.speeds({0.0, 1.0})[1], std::sqrt(m.stiffness[1][1] / 2.0), 1e-13);
  // a at 30 degrees, by two vectors, by v x n with v = (sin, -cos) turned, and by a coordinate system.
  const double turn = std::acos(-1.0) / 6.0;
  const std::string by[] = {
      "1.5,1.0,0.8,2\n" + row({0, 0, 0, std::cos(turn), std::sin(turn), 0}) + "0,0,0,0,1,0\n",
      "1.5,1.0,0.8,3\n0,0,0\n0,1,0,0,0,0,30.0\n",
      "1.5,1.0,0.8,-7\n0,0,0\n0,0,0\n*DEFINE_COORDINATE_VECTOR\n7," +
          row({std::cos(turn), std::sin(turn), 0, 0, 1, 0})};
  for (const std::string& axes : by) {
    const FromDeck<2> turned(orthotropic(axes));
    ASSERT_TRUE(turned.body) << turned.text();
    for (const double angle : {0.0, 0.3, 1.2}) {
      const Vector<2> speeds =
          turned.body->problem.materials[0].speeds({std::cos(turn + angle), std::sin(turn + angle)});
      const Vector<2> same = m.speeds({std::cos(angle), std::sin(angle)});
      EXPECT_NEAR(speeds[0], same[0], 1e-12);
      EXPECT_NEAR(speeds[1], same[1], 1e-12);
    }
  }
}

TEST(SpacetimeBodyOrthotropic, WhatIsRefused) {
  const auto with = [](const std::string& axes) { return FromDeck<2>(orthotropic(axes)); };
  EXPECT_TRUE(with("1.5,1.0,0.8,0\n0,0,0\n0,0,0\n").refuses(5, "are not parallel"));
  EXPECT_TRUE(with("1.5,1.0,0.8,4\n0,0,0\n0,0,0\n").refuses(6, "material axes by AOPT 4"));
  EXPECT_TRUE(with("1.5,1.0,0.8,2\n0,0,0,1,0,0\n0,0,0,2,0,0\n").refuses(7, "are parallel"));
  EXPECT_TRUE(with("0.0,1.0,0.8,2\n0,0,0,1,0,0\n0,0,0,0,1,0\n").refuses(6, "must be above 0"));
  EXPECT_TRUE(with("1.5,1.0,0.8,2\n0,0,0,1,0,1\n0,0,0,0,1,0\n").refuses(5, "must stand across the plane"));
  EXPECT_TRUE(with("1.5,1.0,0.8,-7\n0,0,0\n0,0,0\n").refuses(6, "coordinate system 7 is not defined"));
}

// Blocks: the stiffness of the isotropic constants written as orthotropic ones is the isotropic one.
TEST(SpacetimeBodyOrthotropic, IsotropicConstantsInSpace) {
  std::string text = tetrahedron;
  const std::string from = "*MAT_ELASTIC\n1,2.0,2.5,0.25\n";
  text.replace(text.find(from), from.size(),
               "*MAT_ORTHOTROPIC_ELASTIC\n1,2.0,2.5,2.5,2.5,0.25,0.25,0.25\n1.0,1.0,1.0,2\n0,0,0,1,2,3\n0,0,"
               "0,0,1,1\n");
  const FromDeck<3> b(text), plain(tetrahedron);
  ASSERT_TRUE(b.body) << b.text();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(b.body->problem.materials[0].stiffness[i][j],
                  plain.body->problem.materials[0].stiffness[i][j], 1e-13);
}

TEST(SpacetimeBodyStress, JumpsBetweenElements) {
  const std::string text = square + "*INITIAL_STRESS_SHELL\n11,1,1\n0,3.0,1.0,0,0.5\n";
  const FromDeck<2> b(text);
  ASSERT_TRUE(b.body) << b.text();
  const PointState<2> below = b.body->problem.initial(0, {0.5, 0.1, 0.0}),
                      above = b.body->problem.initial(2, {0.5, 0.9, 0.0});
  EXPECT_NEAR(below.strain[0], 1.0, 1e-14);  // (3, 1, 1) = (1, 0, 0) of lambda = mu = 1, in plane strain
  EXPECT_NEAR(below.strain[1], 0.0, 1e-14);
  EXPECT_NEAR(below.strain[2], 0.25, 1e-14);
  EXPECT_EQ(above.strain, (Voigt<2>{}));
  // About the middle of the element, (1/2, 1/6); in those without stress nothing.
  EXPECT_NEAR(below.u[0], 0.25 * (0.1 - 1.0 / 6.0), 1e-14);
  EXPECT_NEAR(below.u[1], 0.0, 1e-14);
  EXPECT_EQ(above.u, (Vector<2>{}));
  EXPECT_TRUE(
      FromDeck<2>(text + "*CONTROL_SPACETIME\n1,2\n").refuses(after_square + 1, "displacements alone"));
  EXPECT_TRUE(FromDeck<2>(square + "*INITIAL_STRESS_SHELL\n11,1,1\n0,3.0,1.0,0,0.5,0.1\n")
                  .refuses(after_square + 1, "across the plane"));
  // One strain everywhere: one linear field, zero at the first node.
  const FromDeck<2> uniform(
      square + "*SET_SHELL_LIST\n7,0\n11,12,13,14\n*INITIAL_STRESS_SHELL_SET\n7,1,1\n0,3.0,1.0,0,0.5\n");
  ASSERT_TRUE(uniform.body) << uniform.text();
  for (Simplex s = 0; s < 4; ++s) {
    const PointState<2> at = uniform.body->problem.initial(s, {0.5, 0.5, 0.0});
    EXPECT_NEAR(at.strain[0], 1.0, 1e-14);
    EXPECT_NEAR(at.u[0], 0.5 + 0.25 * 0.5, 1e-14);
    EXPECT_NEAR(at.u[1], 0.25 * 0.5, 1e-14);
  }
  const FromDeck<3> block(tetrahedron + "*INITIAL_STRESS_SOLID\n1,1\n3,1,1,0.5,0,1\n");
  ASSERT_TRUE(block.body) << block.text();
  const Voigt<3> strain = block.body->problem.initial(0, {0.1, 0.1, 0.1, 0.0}).strain;
  const Voigt<3> expected{1.0, 0.0, 0.0, 0.25, 0.0, 0.5};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(strain[k], expected[k], 1e-14);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
