/// Decks of spacetime parts as meshes, materials and targets.

#include <gtest/gtest.h>

#include <cmath>

#include "spacetime_deck.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

TEST(SpacetimeBody, SquareOfTriangles) {
  const FromDeck<2> b(square);
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_EQ(dimension_of(b.model), 2);
  EXPECT_EQ(b.body->mesh.simplex_count(), 4);
  EXPECT_EQ(b.body->mesh.boundary().size(), 4u);
  EXPECT_DOUBLE_EQ(b.body->mesh.volume(), 1.0);
  EXPECT_EQ(b.body->thickness, 1.0);
  EXPECT_EQ(b.body->end_time, 1.0);
  EXPECT_EQ(b.body->element_of_simplex, (std::vector<model::Id>{11, 12, 13, 14}));
  EXPECT_EQ(b.body->node_of_vertex, (std::vector<model::Index>{0, 1, 2, 3, 4}));
  const Elastic<2>& m = b.body->problem.materials.at(0);
  EXPECT_EQ(m.density, 2.0);
  EXPECT_NEAR(m.stiffness[0][0], 3.0, 1e-14);  // lambda + 2 mu
  EXPECT_NEAR(m.fastest, std::sqrt(1.5), 1e-12);
  EXPECT_EQ(b.body->problem.spaces.at(0), (SpaceChoice{LocalSpace::trefftz, 3}));
  EXPECT_FALSE(b.body->problem.initial);
  EXPECT_FALSE(b.body->problem.body_force);
  ASSERT_EQ(b.body->problem.targets.size(), 4u);
  EXPECT_EQ(b.body->target.size(), 1u);  // free faces share theirs
  // Free: no traction, and the velocity of the incoming wave: v* = v - Z^-1 s.
  const Star<2> star = b.star(b.face({1, 2}), 0.3, {0.5, 0.25}, {0.0, std::sqrt(6.0)});
  EXPECT_NEAR(star.s[1], 0.0, 1e-15);
  EXPECT_NEAR(star.v_minus[0], 0.5, 1e-15);
  EXPECT_NEAR(star.v_minus[1], 0.25 - 1.0, 1e-14);
}

TEST(SpacetimeBody, PlaneStressSectionAndControl) {
  const FromDeck<2> b(square_with("*SECTION_SHELL_SDG\n1\n", "*SECTION_SHELL_SDG\n1,12,2,4,0.5\n") +
                      "*CONTROL_SPACETIME\n1,2,0.9,3,0.2,0.8,0.01,0.25\n2,1,3\n");
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_NEAR(b.body->problem.materials[0].stiffness[0][0], 2.5 / (1 - 0.0625), 1e-14);  // E / (1 - nu^2)
  EXPECT_EQ(b.body->problem.spaces[0], (SpaceChoice{LocalSpace::three_field, 4}));
  EXPECT_EQ(b.body->thickness, 0.5);
  EXPECT_EQ(b.body->pitch.chi, 0.9);
  EXPECT_EQ(b.body->pitch.progress, Progress::budget);
  EXPECT_EQ(b.body->pitch.eps, 0.2);
  EXPECT_EQ(b.body->pitch.height_factor, 0.8);
  EXPECT_EQ(b.body->pitch.height_cap, 0.01);
  EXPECT_EQ(b.body->pitch.smoothing, 0.25);
  EXPECT_TRUE(b.body->verify);
  EXPECT_EQ(b.model.control.spacetime.threads, 2);
  EXPECT_EQ(b.model.control.spacetime.subdivision, 3);
  EXPECT_FALSE(b.body->pitch.repeat);
  const FromDeck<2> again(square_with("*SECTION_SHELL_SDG\n1\n", "*SECTION_SHELL_SDG\n1,12,2,4,0.5\n") +
                          "*CONTROL_SPACETIME\n3,2\n0,0,0,1\n");
  ASSERT_TRUE(again.body) << again.text();
  EXPECT_TRUE(again.body->pitch.repeat);
  EXPECT_FALSE(again.body->verify);
}

TEST(SpacetimeBody, SupportsMotionsAndPressures) {
  const FromDeck<2> b(plate(2) +
                      "*SET_NODE\n1\n1,4,7\n*SET_NODE\n2\n1,2,3\n*SET_NODE\n3\n3,6,9\n"
                      "*BOUNDARY_SPC_SET\n1,0,1,0,1,1,1,1\n*BOUNDARY_SPC_SET\n2,0,0,1,1\n"
                      "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,0,9,3.0\n*LOAD_SEGMENT\n9,-4,0.25,9,8\n");
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_EQ(b.body->mesh.simplex_count(), 8);
  // Left face: vx = 0, free along y. Bottom: vy = 0, free along x. Z = rho c_p = sqrt(6) along the normal.
  Star<2> star = b.star(b.face({1, 4}), 0.5, {0.3, 0.2}, {0.7, 0.0});
  EXPECT_NEAR(star.v_minus[0], 0.0, 1e-15);
  EXPECT_NEAR(star.v_minus[1], 0.2, 1e-15);
  EXPECT_NEAR(star.s[1], 0.0, 1e-15);
  EXPECT_NEAR(star.s[0], 0.7 - std::sqrt(6.0) * 0.3, 1e-14);
  star = b.star(b.face({1, 2}), 0.5, {0.3, 0.2}, {0.0, 0.0});
  EXPECT_NEAR(star.v_minus[0], 0.3, 1e-15);
  EXPECT_NEAR(star.v_minus[1], 0.0, 1e-15);
  EXPECT_NEAR(star.s[0], 0.0, 1e-15);
  // Right: vx = 3 * curve(t) = 3 t. Top: pressure -4 * curve(t - 0.25), a pull along +y.
  EXPECT_NEAR(b.star(b.face({3, 6}), 0.5).v_minus[0], 1.5, 1e-14);
  star = b.star(b.face({8, 9}), 0.75);
  EXPECT_NEAR(star.s[0], 0.0, 1e-15);
  EXPECT_NEAR(star.s[1], 4.0 * 0.5, 1e-14);
  EXPECT_NEAR(b.star(b.face({8, 9}), 0.2).s[1], 0.0, 1e-15);
  EXPECT_NEAR(b.star(b.face({7, 8}), 0.75).s[1], 0.0, 1e-15);
}

TEST(SpacetimeBody, PressuresOfOneFaceAddUp) {
  const FromDeck<2> b(plate(2) + "*LOAD_SEGMENT\n9,-4,0.25,9,8\n9,-1,0,9,8\n");
  ASSERT_TRUE(b.body) << b.text();
  EXPECT_NEAR(b.star(b.face({8, 9}), 0.75).s[1], 4.0 * 0.5 + 0.75, 1e-14);
}

/// The curve of `square` is the time itself; 8 rises to 1 at t = 1/2 and stays.
TEST(SpacetimeBody, DisplacementsAndAccelerationsAreVelocities) {
  const std::string right = plate(2) + "*DEFINE_CURVE\n8\n0,0\n0.5,1\n2,1\n*SET_NODE\n3\n3,6,9\n";
  const auto moved = [&](const std::string& card, double time) {
    const FromDeck<2> b(right + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card);
    EXPECT_TRUE(b.body) << b.text();
    return b.body ? b.star(b.face({3, 6}), time).v_minus[0] : -1.0;
  };
  EXPECT_NEAR(moved("3,1,2,8,3.0\n", 0.25), 6.0, 1e-14);  // displacement 3 * 2 t
  EXPECT_NEAR(moved("3,1,2,8,3.0\n", 0.75), 0.0, 1e-14);
  EXPECT_NEAR(moved("3,1,1,9,3.0\n", 0.5), 3.0 * 0.125, 1e-14);  // acceleration 3 t
  EXPECT_NEAR(moved("3,1,0,8,3.0\n", 0.25), 1.5, 1e-14);
  const int line = after_plate(2) + 7;
  EXPECT_TRUE(FromDeck<2>(right + "*DEFINE_CURVE\n7\n0,1\n2,2\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,2,7\n")
                  .refuses(line + 6, "jumps"));
  EXPECT_TRUE(
      FromDeck<2>(right + "*DEFINE_CURVE\n7\n0,0\n1,2\n1,3\n2,4\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,2,7\n")
          .refuses(line + 8, "jumps"));
  EXPECT_TRUE(
      FromDeck<2>(right + "*INITIAL_VELOCITY_NODE\n6,2.0\n*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,1,9,3.0\n")
          .refuses(line + 4, "an initial velocity"));
}

TEST(SpacetimeBody, RefusesPointSupportsAndInteriorNodes) {
  EXPECT_TRUE(
      FromDeck<2>(square + "*BOUNDARY_SPC_NODE\n1,0,1,1\n").refuses(after_square + 1, "no face has all"));
  EXPECT_TRUE(
      FromDeck<2>(square + "*BOUNDARY_SPC_NODE\n5,0,1,1\n").refuses(after_square + 1, "inside the body"));
  EXPECT_TRUE(
      FromDeck<2>(square + "*LOAD_NODE_POINT\n1,1,9\n").refuses(after_square + 1, "a force at a point"));
  EXPECT_TRUE(FromDeck<2>(square + "*LOAD_SEGMENT\n9,1,0,1,5\n")
                  .refuses(after_square + 1, "no face on the boundary of the body: 1-5"));
}

TEST(SpacetimeBody, RefusesBadElements) {
  const auto with = [](const std::string& from, const std::string& to) {
    return FromDeck<2>(square_with(from, to));
  };
  EXPECT_TRUE(with("12,1,2,3,5,5", "12,1,3,2,5,5").refuses(19, "element 12 is inverted"));
  EXPECT_TRUE(with("5,0.5,0.5,0", "5,0.5,0.0,0").refuses(18, "element 11 has no area"));
  EXPECT_TRUE(with("5,0.5,0.5,0", "5,0.5,0.5,1").refuses(16, "outside the plane z = 0: 5"));
  EXPECT_TRUE(with("1,2.0,2.5,0.25", "1,0.0,2.5,0.25").refuses(5, "density must be above 0"));
  EXPECT_TRUE(with("1,2.0,2.5,0.25", "1,2.0,-2.5,0.25").refuses(5, "expected a value above 0"));
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
