#include "discretisation/world.hpp"

#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "sample.hpp"

namespace cleave::discretisation::sample {
namespace {

/// Two parts of unequal density that share the nodes between them, and a point mass.
Sample two_parts() {
  Sample s = box(4, 2, 2, elastic(), 2.0);
  model::Part other = s.model.parts[0];
  other.id = 7;
  other.density = 6.0;
  s.model.parts.push_back(other);
  auto& solids = s.solids();
  for (std::size_t e = 0; e < solids.count(); ++e) solids.part[e] = e % 4 >= 2;
  s.model.point_masses.push_back({1, 5, 0.25});
  s.model.initial_velocity.assign(3 * s.node_count(), 0.0);
  s.model.initial_velocity[4] = 3.0;
  return s;
}

TEST(World, HasABlockPerPartAndStartsFromTheModel) {
  const Sample s = two_parts();
  deck::Diagnostics diagnostics;
  const World world = build(s.model, diagnostics);
  EXPECT_FALSE(diagnostics.failed());
  ASSERT_EQ(world.blocks.size(), 2u);
  EXPECT_EQ(world.blocks[0]->part(), 0);
  EXPECT_EQ(world.blocks[1]->part(), 1);
  EXPECT_EQ(world.blocks[1]->element_ids().size(), 8u);

  State state;
  ASSERT_TRUE(initialise(world, state).ok);
  double mass = 0.0;
  for (const double m : state.mass) mass += m;
  EXPECT_NEAR(mass, 0.5 * 2.0 + 0.5 * 6.0 + 0.25, 1e-14);
  EXPECT_EQ(state.velocity[4], 3.0);
  EXPECT_EQ(state.parts.size(), 2u);
  EXPECT_GT(state.largest_force, 0.0);
}

TEST(World, PartsThatShareNodesPullAtEachOther) {
  // Uniform stretch of both parts with the same moduli: no force on the nodes between them.
  const Sample s = two_parts();
  deck::Diagnostics diagnostics;
  const World world = build(s.model, diagnostics);
  State state;
  ASSERT_TRUE(initialise(world, state).ok);
  base::Array<double> velocity(state.position.size(), 0.0);
  for (std::size_t n = 0; n < s.node_count(); ++n) {
    velocity[3 * n] = 1e-9 * state.position[3 * n];
    state.position[3 * n] *= 1.001;
  }
  for (const int threads : {1, 2}) {
    base::set_thread_count(threads);
    ForceSum force(s.node_count());
    force.begin(0.1);
    auto blocks = state.blocks;
    for (std::size_t b = 0; b < 2; ++b)
      world.blocks[b]->add_force({1e6, 1e6, state.position.data(), velocity.data(), 0.0}, blocks[b], force);
    for (std::size_t n = 0; n < s.node_count(); ++n) {
      const double x = s.model.mesh.nodes.position[3 * n];
      if (x > 0.1 && x < 0.9) {
        EXPECT_NEAR(force.value(static_cast<Index>(n), 0), 0.0, 1e-13);
      }
    }
    EXPECT_GT(force.value(0, 0), 1e-3);
  }
  base::set_thread_count(1);
}

/// One wedge on corners of the unit box.
Sample wedge() {
  Sample s = box(1, 1, 1, elastic(), 2.0);
  auto& solids = s.solids();
  const auto n = solids.node;
  solids = {
      .shape = model::Shape::penta6, .id = {9}, .part = {0}, .node = {n[0], n[1], n[3], n[4], n[5], n[7]}};
  return s;
}

// Wedges become ELFORM 15 in a part of hexahedra, and with *CONTROL_SOLID ESORT in a part of tetrahedra too.
TEST(World, ElementSortMakesWedgesOfTheirOwn) {
  for (const auto& [form, sort, accepted] :
       {std::tuple(1, 0, true), std::tuple(2, 0, true), std::tuple(10, 0, false), std::tuple(10, 1, true),
        std::tuple(13, 1, true), std::tuple(16, 0, false)}) {
    Sample s = wedge();
    s.model.parts[0].section.form = form;
    s.model.control.solid_sort = sort;
    deck::Diagnostics diagnostics;
    const World world = build(s.model, diagnostics);
    EXPECT_EQ(!diagnostics.failed(), accepted) << form << ' ' << sort;
    if (!accepted) continue;
    ASSERT_EQ(world.blocks.size(), 1u);
    EXPECT_EQ(world.blocks[0]->formulation(), "penta6");
    State state;
    EXPECT_TRUE(initialise(world, state).ok);
  }
}

TEST(World, ASectionNobodyHonoursIsAnErrorThatNamesThePart) {
  Sample s = two_parts();
  s.model.parts[1].section.form = 99;
  deck::Diagnostics diagnostics;
  build(s.model, diagnostics);
  ASSERT_EQ(diagnostics.count(deck::Severity::error), 1u);
  const auto& message = diagnostics.all()[0].message;
  EXPECT_NE(message.find("99"), std::string::npos);
  EXPECT_NE(message.find("part 7"), std::string::npos);
  const auto& hint = diagnostics.all()[0].hint;
  EXPECT_NE(hint.find("1 (hex8-one-point); 2 (hex8-selective)"), std::string::npos) << hint;
}

/// Forms of the format that are not computed here are refused, not replaced by a neighbour.
TEST(World, OtherFormsOfSolidsAreRefused) {
  for (const int form : {-18, -2, -1, 3, 4, 5, 10, 13, 15, 16, 17, 18, 41, 43, 47}) {
    Sample s = two_parts();
    s.model.parts[1].section.form = form;
    deck::Diagnostics diagnostics;
    build(s.model, diagnostics);
    EXPECT_EQ(diagnostics.count(deck::Severity::error), 1u) << form;
  }
}

TEST(World, AnHourglassTypeNobodyHonoursIsAnError) {
  Sample s = two_parts();
  s.model.parts[0].hourglass.type = 8;
  deck::Diagnostics diagnostics;
  build(s.model, diagnostics);
  EXPECT_EQ(diagnostics.count(deck::Severity::error), 1u);
}

TEST(World, AnInvertedElementStopsTheStart) {
  Sample s = two_parts();
  std::swap(s.solids().node[8], s.solids().node[12]);
  std::swap(s.solids().node[9], s.solids().node[13]);
  std::swap(s.solids().node[10], s.solids().node[14]);
  std::swap(s.solids().node[11], s.solids().node[15]);
  deck::Diagnostics diagnostics;
  const World world = build(s.model, diagnostics);
  State state;
  const StepStatus status = initialise(world, state);
  EXPECT_FALSE(status.ok);
  EXPECT_EQ(status.element, 2);
}

TEST(Energy, RatioIsOneWhenNothingIsLost) {
  Energy e;
  EXPECT_EQ(e.ratio(), 1.0);
  e.initial = 2.0;
  e.external = 3.0;
  e.kinetic = 1.0;
  e.internal = 3.5;
  e.hourglass = 0.5;
  EXPECT_EQ(e.ratio(), 1.0);
  e.eroded_internal = 0.5;
  EXPECT_EQ(e.ratio(), 1.0);  // eroded shares are in the sums
  EXPECT_EQ(e.ratio_without_eroded(), 0.9);
}

}  // namespace
}  // namespace cleave::discretisation::sample
