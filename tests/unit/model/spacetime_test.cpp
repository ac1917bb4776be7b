/// Keywords of spacetime parts: sections, shells and bars, control, cracks; and back to a deck.

#include <gtest/gtest.h>

#include <algorithm>

#include "model/elasticity.hpp"
#include "round_trip.hpp"

namespace cleave::model {
namespace {

using deck::Severity;

/// A triangle and a quadrilateral side by side, part 1; ends without *END so that text can follow.
const std::string plate =
    "*KEYWORD\n"
    "*CONTROL_TERMINATION\n1.0\n"
    "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
    "*SECTION_SHELL_SDG_TITLE\nthin plate\n1,12,2,4,0.5\n"
    "*PART\nplate\n1,1,1\n"
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,2,0,0\n"
    "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,3,3\n"
    "*DEFINE_CURVE\n9\n0,0\n2,2\n";
const int after_plate = 25;

Built plate_with(const std::string& from, const std::string& to) {
  std::string text = plate;
  return build_text(text.replace(text.find(from), from.size(), to));
}

TEST(SpacetimeDeck, ShellsOfBothShapes) {
  const Built b = build_text(plate);
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.mesh.shells.size(), 2u);
  EXPECT_EQ(b.model.mesh.shells[0].shape, Shape::tri3);
  EXPECT_EQ(b.model.mesh.shells[0].node, (std::vector<Index>{1, 4, 2}));
  EXPECT_EQ(b.model.mesh.shells[1].node, (std::vector<Index>{0, 1, 2, 3}));
  const Part& part = b.model.parts.at(0);
  EXPECT_EQ(spacetime_dimension(part.section), 2);
  EXPECT_EQ(spacetime_thickness(part.section), 0.5);
  EXPECT_EQ(part.section.form, 12);
  EXPECT_EQ(part.section.number("DEGREE", 0), 4.0);
  ASSERT_TRUE(part.elastic);
  EXPECT_EQ(part.elastic->poisson, 0.3);
  EXPECT_TRUE(build_text(plate + "*ELEMENT_SHELL\n2,1,1,2,3\n")
                  .says(Severity::error, after_plate + 1, "a second time"));
  EXPECT_TRUE(plate_with("1,1,1,2,3,4\n", "1,1,1,2,3,7\n").says(Severity::error, 19, "uses node 7"));
  EXPECT_TRUE(plate_with("1,1,1,2,3,4\n", "1,1,1,2,3,4,5\n").says(Severity::error, 19, "has mid nodes"));
  EXPECT_TRUE(
      plate_with("1,1,1,2,3,4\n", "1,3,1,2,3,4\n").says(Severity::error, 19, "part 3 is not defined"));
}

TEST(SpacetimeDeck, SegmentsOfAPlaneAreItsOuterEdges) {
  // The plate is a square 1 2 3 4 with a triangle 2 5 3 beside it; 2 3 is shared.
  const std::string whole = "*SET_SEGMENT_GENERAL\n1\nALL\n*SET_SEGMENT_GENERAL\n2\nPART,1\nDSEG,1,2,2,2\n";
  const Built b =
      build_text(plate + whole + "*DEFINE_BOX\n4,-9,0.001,-9,9,-9,9\n*SET_SEGMENT_GENERAL\n3\nBOX,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto edges = [&](std::size_t set) {
    std::vector<std::pair<Index, Index>> all;
    for (const Segment& s : b.model.segment_sets.at(set).members) {
      EXPECT_EQ(s.node[1], s.node[2]);
      all.emplace_back(s.node[0], s.node[1]);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(edges(0), (std::vector<std::pair<Index, Index>>{{0, 1}, {1, 4}, {2, 3}, {3, 0}, {4, 2}}));
  EXPECT_EQ(edges(1), (std::vector<std::pair<Index, Index>>{{1, 4}, {2, 3}, {3, 0}, {4, 2}}));
  EXPECT_EQ(edges(2), (std::vector<std::pair<Index, Index>>{{3, 0}}));
}

TEST(SpacetimeDeck, OrdinaryShellsAreRefusedAsAWhole) {
  EXPECT_TRUE(plate_with("*SECTION_SHELL_SDG_TITLE\nthin plate\n1,12,2,4,0.5\n", "*SECTION_SHELL\n1,2\n1.0\n")
                  .says(Severity::error, 19, "not computed here"));
  EXPECT_TRUE(build_text(cube + "*ELEMENT_SHELL\n7,1,1,2,3,4\n")
                  .says(Severity::error, after_cube, "not computed here"));
  EXPECT_TRUE(
      build_text(cube + "*ELEMENT_BEAM\n7,1,1,2,3\n").says(Severity::error, after_cube, "not computed here"));
  EXPECT_TRUE(build_text(plate + "*SECTION_SHELL\n2,2\n1.0\n*PART\n\n2,2,1\n*ELEMENT_SHELL\n7,2,1,2,3\n")
                  .says(Severity::error, after_plate + 7, "not computed here: part 2 has *SECTION_SHELL"));
}

TEST(SpacetimeDeck, SectionsAreChecked) {
  const auto section = [](const std::string& values) { return plate_with("1,12,2,4,0.5", values); };
  EXPECT_TRUE(section("1,2").says(Severity::error, 8, "found 2, which is no spacetime element"));
  EXPECT_TRUE(section("1,12,4").says(Severity::error, 8, "found 4, expected 1, 2 or 3"));
  EXPECT_TRUE(section("1,12,0,7").says(Severity::error, 8, "found 7, expected 1 to 6"));
  EXPECT_TRUE(section("1,12,0,0,-1.0").says(Severity::error, 8, "negative"));
  EXPECT_EQ(section("1,").model.parts.at(0).section.form, 13);
}

TEST(SpacetimeDeck, OnlyLinearElasticLaws) {
  EXPECT_TRUE(
      plate_with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n", "*MAT_PLASTIC_KINEMATIC\n1,7.85e-9,2.1e5,0.3,200\n")
          .says(Severity::error, 11, "this law is not computed in spacetime"));
  EXPECT_TRUE(build_text(plate + "*MAT_ADD_EROSION\n1,0,100\n")
                  .says(Severity::error, after_plate + 1, "elements are not deleted"));
}

TEST(SpacetimeDeck, ControlIsReadAndChecked) {
  const auto control = [](const std::string& values) {
    return build_text(plate + "*CONTROL_SPACETIME\n" + values);
  };
  const Built b = control("1,2,0.9,3,0.2,0.8,0.01,0.25\n2,1,3\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const SpacetimeControl& c = b.model.control.spacetime;
  EXPECT_EQ(c.space, SpacetimeControl::Space::one_field);
  EXPECT_EQ(c.degree, 2);
  EXPECT_EQ(c.chi, 0.9);
  EXPECT_EQ(c.progress, SpacetimeControl::Progress::budget);
  EXPECT_EQ(c.eps, 0.2);
  EXPECT_EQ(c.height_factor, 0.8);
  EXPECT_EQ(c.height_cap, 0.01);
  EXPECT_EQ(c.smoothing, 0.25);
  EXPECT_EQ(c.threads, 2);
  EXPECT_TRUE(c.verify);
  EXPECT_EQ(c.subdivision, 3);
  const SpacetimeControl blank = control("0,\n").model.control.spacetime;
  EXPECT_EQ(blank.space, SpacetimeControl::Space::trefftz);
  EXPECT_EQ(blank.chi, 0.95);
  for (const auto* bad : {"4,", "0,7", "0,0,1.0", "0,0,0,4", "0,0,0,0,0.6", "0,0,0,0,0,1.5", "0,0,0,0,0,0,-1",
                          "0,0,0,0,0,0,0,2", "0,0\n-1,", "0,0\n0,2"})
    EXPECT_TRUE(control(std::string(bad) + "\n").failed()) << bad;
}

TEST(SpacetimeDeck, EdgesAreSegments) {
  const Built b = build_text(plate + "*LOAD_SEGMENT\n9,1,0,4,3\n9,2,0,1,2,2,2\n*SET_SEGMENT\n4\n1,2\n2,5\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.segment_loads.size(), 2u);
  for (const SegmentLoad& load : b.model.segment_loads) EXPECT_EQ(corner_count(load.segments.at(0)), 2);
  EXPECT_EQ(b.model.segment_sets.at(0).members.size(), 2u);
  EXPECT_EQ(corner_count(b.model.segment_sets[0].members[1]), 2);
  EXPECT_TRUE(build_text(cube + "*DEFINE_CURVE\n9\n0,0\n2,2\n*LOAD_SEGMENT\n9,1,0,1,2\n").failed());
}

TEST(SpacetimeDeck, CracksBelongToSpacetimeParts) {
  const Built b = build_text(plate + "*BOUNDARY_PRECRACK\n1,1,2\n1,0,0\n1,1,0\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.precracks.size(), 1u);
  EXPECT_EQ(b.model.precracks[0].points.size(), 2u);
  EXPECT_EQ(b.model.precracks[0].points[1].y, 1.0);
  EXPECT_TRUE(build_text(cube + "*BOUNDARY_PRECRACK\n1,1,1\n1,0,0\n")
                  .says(Severity::error, after_cube + 1, "is not solved in spacetime"));
}

TEST(SpacetimeDeck, IncidentWavesAreChecked) {
  const auto wave = [](const std::string& rows) {
    return build_text(plate + "*SET_SEGMENT\n4\n1,2\n*BOUNDARY_NON_REFLECTING\n4\n*LOAD_INCIDENT_WAVE\n" +
                      rows);
  };
  const Built b = wave("4,2,9,2.0,0.5\n0,3,4,1,2,0\n\n");
  EXPECT_TRUE(b.says(Severity::error, after_plate + 7, "does not travel in the plane"));
  const Built good = wave("4,2,9,2.0,0.5\n3,4,0,1,2,0\n\n");
  ASSERT_FALSE(good.failed()) << good.text();
  ASSERT_EQ(good.model.incident_waves.size(), 1u);
  const IncidentWave& w = good.model.incident_waves[0];
  EXPECT_EQ(w.kind, IncidentWave::Kind::shear);
  EXPECT_NEAR(w.direction.x, 0.6, 1e-15);
  EXPECT_NEAR(w.polarisation.x, -0.8, 1e-15);  // to the left of its path
  EXPECT_EQ(w.reference.y, 2.0);
  EXPECT_EQ(w.scale, 2.0);
  EXPECT_EQ(w.arrival, 0.5);
  EXPECT_TRUE(wave("4,3,9\n1,0,0\n").says(Severity::error, after_plate + 6, "found 3, expected 1 or 2"));
  EXPECT_TRUE(wave("4,1,9\n0,0,0\n").failed());
  EXPECT_TRUE(wave("4,2,9\n1,0,0\n2,0,0\n").says(Severity::error, after_plate + 8, "needs a direction"));
  EXPECT_TRUE(build_text(cube + "*DEFINE_CURVE\n9\n0,0\n2,2\n*LOAD_INCIDENT_WAVE\n4,1,9\n1,0,0\n")
                  .says(Severity::error, after_cube + 5, "for spacetime parts only"));
}

TEST(SpacetimeDeck, InitialStressesAreUniform) {
  const auto stress = [](const std::string& rows) {
    return build_text(plate + "*INITIAL_STRESS_SHELL\n" + rows);
  };
  const Built b = stress("2,1,1\n0,1,2,0,3\n1,1,2\n-1,4,5,0,6\n1,4,5,0,6\n");
  ASSERT_FALSE(b.failed()) << b.text();
  ASSERT_EQ(b.model.initial_stress.size(), 2u);
  EXPECT_EQ(b.model.initial_stress[0].element, 1);  // in ascending order
  EXPECT_EQ(b.model.initial_stress[0].stress[3], 6.0);
  EXPECT_EQ(b.model.initial_stress[1].stress[1], 2.0);
  EXPECT_TRUE(
      stress("1,1,2\n-1,4,5,0,6\n1,4,5,0,7\n").says(Severity::error, after_plate + 2, "different stresses"));
  EXPECT_TRUE(stress("7,1,1\n0,1,2\n").says(Severity::error, after_plate + 1, "is not defined"));
  EXPECT_TRUE(stress("1,1,1\n0,1,2\n1,1,1\n0,1,2\n").says(Severity::error, after_plate + 3, "a second time"));
  EXPECT_TRUE(stress("1,1,1\n0,1,2,0,0,0,0,0.1\n").failed());
  EXPECT_TRUE(build_text(cube + "*INITIAL_STRESS_SOLID\n1,1\n1,2\n")
                  .says(Severity::error, after_cube + 1, "is not solved in spacetime"));
}

TEST(SpacetimeDeck, SetsOfShells) {
  const Built b =
      build_text(plate +
                 "*ELEMENT_SHELL\n3,1,3,4,1,1\n*SET_SHELL_LIST\n1,0\n2,1,0,3\n*SET_SHELL_LIST_GENERATE\n"
                 "2,0\n2,3\n*SET_SHELL_ADD\n3\n1,2\n*SET_SHELL_GENERAL\n4,0\nALL\nDELEM,2\n"
                 "DSET_SHELL,5\n*SET_SHELL\n5,0\n3\n*DEFINE_BOX\n7,-1,1.5,-1,2,-1,1\n*SET_SHELL_GENERAL\n"
                 "6,0\nBOX,7\n*SET_NODE_GENERAL\n1,0\nSET_SHELL,5\n");
  // Element 3 lies on element 1, which is the mesh's affair.
  ASSERT_FALSE(b.failed()) << b.text();
  using Ids = std::vector<Id>;
  const std::vector<Ids> wanted = {{1, 2, 3}, {2, 3}, {1, 2, 3}, {1}, {3}, {1, 3}};
  ASSERT_EQ(b.model.shell_sets.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_EQ(b.model.shell_sets[k].members, wanted[k]) << k;
  EXPECT_EQ(b.model.node_sets[0].members, (std::vector<Index>{0, 2, 3}));
  EXPECT_TRUE(
      build_text(plate + "*SET_SHELL_LIST\n1,0\n77\n").says(Severity::error, after_plate + 1, "shell 77"));
  EXPECT_TRUE(
      build_text(cube + "*SET_SHELL_LIST\n1,0\n1\n").says(Severity::error, after_cube + 1, "no shells"));
  EXPECT_TRUE(build_text(cube + "*SET_SOLID\n1\n1\n*SET_SOLID_ADD\n2\n1\n").model.solid_sets[1].members ==
              Ids{1});
}

TEST(SpacetimeDeck, HistoriesAndStressesOfShellsBySet) {
  const Built b =
      build_text(plate +
                 "*SET_SHELL_LIST\n1,0\n1,2\n*DATABASE_HISTORY_SHELL\n2\n*DATABASE_HISTORY_SHELL_SET\n1\n"
                 "*INITIAL_STRESS_SHELL_SET\n1,1,1\n0,1,2,0,3\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.requests.history_shells, (std::vector<Id>{2, 1}));
  ASSERT_EQ(b.model.initial_stress.size(), 2u);
  EXPECT_EQ(b.model.initial_stress[0].element, 1);
  EXPECT_EQ(b.model.initial_stress[1].stress[3], 3.0);
  const auto with = [](const std::string& text) { return build_text(plate + text); };
  EXPECT_TRUE(with("*DATABASE_HISTORY_SHELL\n77\n").says(Severity::error, after_plate + 1, "element 77"));
  EXPECT_TRUE(with("*DATABASE_HISTORY_SHELL_SET\n3\n").says(Severity::error, after_plate + 1, "shell set 3"));
  EXPECT_TRUE(
      with("*INITIAL_STRESS_SHELL_SET\n3,1,1\n0,1\n").says(Severity::error, after_plate + 1, "shell set 3"));
  EXPECT_TRUE(with("*DATABASE_HISTORY_BEAM\n1\n").says(Severity::warning, after_plate + 1, "no beams"));
  EXPECT_NE(with("*LOAD_SHELL_ELEMENT\n1,9,1.0\n").text().find("load their edges"), std::string::npos);
  // Rigid shells have no stresses.
  EXPECT_TRUE(build_text("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_RIGID\n1,1.0,1.0,0.3\n*SECTION_SHELL\n1\n"
                         "0.1,0.1,0.1,0.1\n*PART\nplate\n1,1,1\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n"
                         "*ELEMENT_SHELL\n1,1,1,2,3,3\n*DATABASE_HISTORY_SHELL\n1\n")
                  .says(Severity::warning, 19, "is rigid"));
}

const std::string orthotropic =
    "*MAT_ORTHOTROPIC_ELASTIC\n1,7.85e-9,2.0e5,1.0e5,1.5e5,0.1,0.2,0.3\n"
    "8.0e4,7.0e4,6.0e4,3.0\n0,0,0\n0,1,0,0,0,0,30.0\n";

TEST(SpacetimeDeck, OrthotropicMaterials) {
  const Built b = plate_with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n", orthotropic);
  ASSERT_FALSE(b.failed()) << b.text();
  const Part& part = b.model.parts.at(0);
  ASSERT_TRUE(part.elastic);
  EXPECT_FALSE(part.law);
  EXPECT_FALSE(part.elastic->isotropic);
  EXPECT_EQ(part.elastic->modulus[1], 1.0e5);
  EXPECT_EQ(part.elastic->poisson_cb, 0.3);
  EXPECT_EQ(part.elastic->shear_ca, 6.0e4);
  EXPECT_EQ(part.elastic->axes, Elasticity::Axes::across);
  EXPECT_NEAR(part.elastic->angle, 0.5235987755982988, 1e-15);
  const auto with = [](const std::string& from, const std::string& to) {
    std::string card = orthotropic;
    return plate_with("*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n", card.replace(card.find(from), from.size(), to));
  };
  EXPECT_TRUE(with("0.1,0.2,0.3", "0.8,0.2,0.3").says(Severity::error, 5, "would gain energy"));
  EXPECT_TRUE(with("7.85e-9", "0.0").says(Severity::error, 5, "density must be above 0"));
  EXPECT_TRUE(with("6.0e4,3.0", "6.0e4,1.0").says(Severity::error, 6, "material axes by AOPT 1"));
  EXPECT_TRUE(with("6.0e4,3.0", "6.0e4,3.0,5.0").says(Severity::error, 6, "not honoured"));  // damping
  std::string solids = cube;
  const std::string law = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n";
  EXPECT_TRUE(build_text(solids.replace(solids.find(law), law.size(), orthotropic))
                  .says(Severity::error, 4, "this law is not computed"));
}

TEST(SpacetimeDeck, RoundTrip) {
  expect_round_trip(
      plate +
      "*SET_SEGMENT\n4\n1,2\n2,5\n*BOUNDARY_NON_REFLECTING\n4\n*LOAD_INCIDENT_WAVE\n4,2,9,0.7,"
      "0.3\n1,2,0,4,5\n\n"
      "4,1,9\n1,1,0\n*INITIAL_STRESS_SHELL\n1,1,1\n0,1.1,2,0,3\n2,1,1\n0,1,2,3,4\n"
      "*SET_SHELL_LIST_TITLE\nboth\n1,0\n1,2\n*DATABASE_HISTORY_SHELL\n2\n*DATABASE_ELOUT\n0.1\n");
  std::string stiff = plate;
  const std::string law = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n";
  expect_round_trip(stiff.replace(stiff.find(law), law.size(), orthotropic));
  expect_round_trip(
      plate +
      "*CONTROL_SPACETIME\n1,2,0.9,3,0.2,0.8,0.01,0.25\n2,1,3\n*SET_SEGMENT\n4\n1,2\n2,5\n"
      "*LOAD_SEGMENT\n9,1,0,4,3\n*BOUNDARY_NON_REFLECTING\n4\n*BOUNDARY_PRECRACK\n1,1,2\n1,0,0\n1,1,0\n");
  expect_round_trip(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
      "*SECTION_BEAM_SDG\n1,2,0,0,0.25\n*PART\nbar\n1,1,1\n*NODE\n1,0,0,0\n2,1,0,0\n3,2,0,0\n"
      "*ELEMENT_BEAM\n1,1,1,2\n2,1,2,3\n*DEFINE_CURVE\n9\n0,0\n2,2\n*LOAD_SEGMENT\n9,1,0,3\n"
      "*SET_BEAM\n4\n1\n*SET_BEAM_GENERAL\n5\nALL\n*DATABASE_HISTORY_BEAM_SET\n5\n");
  expect_round_trip(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
      "*SECTION_SOLID_SDG\n1,1,3,2\n*PART\ntet\n1,1,1\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"
      "*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n");
}

}  // namespace
}  // namespace cleave::model
