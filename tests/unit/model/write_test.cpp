/// Deck -> model -> deck -> model gives the same model.

#include <gtest/gtest.h>

#include "round_trip.hpp"

namespace cleave::model {
namespace {

TEST(Write, Cube) {
  expect_round_trip(cube);
}

TEST(Write, EveryShape) {
  expect_round_trip(cube +
                    "*NODE\n9,0.5,0.5,2\n10,0.5,0,3\n11,0.5,1,3\n12,0,0,10\n13,2,0,10\n14,0,2,10\n15,0,0,12\n"
                    "16,1,0,10\n17,1,1,10\n18,0,1,10\n19,0,0,11\n20,1,0,11\n21,0,1,11\n"
                    "*ELEMENT_SOLID\n2,1,5,6,7,8,9,9,9,9\n3,1,5,6,7,8,10,10,11,11\n4,1,1,2,4,5,5,5,5,5\n"
                    "5,1\n12,13,14,15,16,17,18,19,20,21\n");
}

TEST(Write, ActionsOfEveryKind) {
  expect_round_trip(
      cube +
      "*TITLE\nall, of it\n*CONTROL_TIMESTEP\n0,0.67,0,0,-1e-7,7,1,1\n0,7\n*CONTROL_ENERGY\n2,2,2,2\n"
      "*CONTROL_BULK_VISCOSITY\n1.2,0.07,1\n*CONTROL_HOURGLASS\n4,0.05\n*CONTROL_SOLID\n1\n"
      "*DEFINE_CURVE_TITLE\nramp, "
      "rising\n7,0,2,3,0.1,0.2\n0,0\n1,0.123456789012345\n*DEFINE_CURVE\n8\n0,0\n2,1\n"
      "*DEFINE_TABLE\n70\n0\n10\n*DEFINE_CURVE\n71\n0,1\n1,2\n*DEFINE_CURVE\n72\n0,2\n1,3\n"
      "*SET_NODE_LIST_TITLE\ntop\n5\n5,6,7,8\n*SET_NODE_LIST\n6\n1,2,3\n*SET_PART_LIST\n3\n1\n*SET_"
      "SOLID\n4\n1\n"
      "*SET_SEGMENT\n9\n5,6,7,8\n1,2,6,6\n"
      "*BOUNDARY_SPC_SET_ID\n        11bottom, "
      "fixed\n6,0,1,0,1,0,0,1\n*BOUNDARY_SPC_NODE\n1,0,0,1\n2,0,0,1\n3,0,1,1\n"
      "*BOUNDARY_SPC_SET_BIRTH_DEATH\n5,21,1,1,1\n0.25,0.5\n"
      "*DEFINE_COORDINATE_SYSTEM\n21,1,2,3,2,3.3,4.7\n1.2,3,3\n*DEFINE_VECTOR\n3,0,0,0,1,2,3.3\n"
      "*BOUNDARY_PRESCRIBED_MOTION_SET_ID\n        12push\n5,3,2,7,1.5,0,0.75,0.125\n"
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,-4,0,8,2,3\n2,-4,0,8,2,3\n3,1,1,8\n"
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n4,9,2,7\n0.1,0.2\n5,-10,0,8,2\n0.1,0.2\n6,11,1,8\n0.3,0.4\n7,1,3,8\n"
      "*LOAD_NODE_SET\n5,1,7,0.3,21\n*LOAD_NODE_POINT\n1,2,7\n2,2,7\n3,4,8,2,0,1,2,3\n"
      "*LOAD_SEGMENT_SET\n9,7,-2,0.25\n*LOAD_SEGMENT\n8,1,0,1,2,3,4\n8,1,0,1,2,6,5\n"
      "*LOAD_BODY_Z\n7,9810\n*LOAD_BODY_RY\n8,3,0,1,2,3\n*LOAD_BODY_VECTOR\n7,1\n1,1,0\n*LOAD_BODY_PARTS\n3\n"
      "*LOAD_BODY_GENERALIZED\n2,5,7,0,1,2,3\n0.1,0.2,0.3,4,5,6,21,CORI\n"
      "*LOAD_BODY_GENERALIZED_SET_PART\n3,0,8\n0,0,9.81\n"
      "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0,0.3\n"
      "*RIGIDWALL_PLANAR\n0\n0,0,-2,0,0,0,2,12.5\n"
      "*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,-2,0,0,0\n0.2,0.4,0.1,0.3,5,6\n0,0,1,2,0\n"
      "*RIGIDWALL_PLANAR_ORTHO_FINITE\n0\n0,0,-2,0,0,0\n0.2,0.4,0.1,0.3,5,6\n1,2\n3,0,-2,1,2\n"
      "*RIGIDWALL_GEOMETRIC_FLAT\n5\n0,0,-1,0.1,0,0,0.5\n2,0,-1,3,0\n"
      "*RIGIDWALL_GEOMETRIC_PRISM_MOTION_ID\n        "
      "32box\n0,0,0,0.5,2\n0,0,-1,0,0,0\n2,0,-1,3,4,5\n7,1,0,3,4\n"
      "*RIGIDWALL_GEOMETRIC_CYLINDER\n0\n0,0,-9,0,0.2,-8\n2.5,6\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR_MOTION\n0\n0,0,0\n5\n8,0,1\n"
      "*RIGIDWALL_PLANAR_FINITE_MOVING_FORCES_ID\n        31plate\n5,0,0,0,0.1,0.9\n"
      "0.3,0.1,-3.7,1.3,0.1,-3.6,0.5\n1.3,2.1,-3.7,10,20\n0.5,-12\n3\n"
      "*CONSTRAINED_GLOBAL\n3,0,3,0,0,0\n*CONSTRAINED_LOCAL\n1,0,1,0,0,0,21,10\n"
      "*BOUNDARY_SPC_SYMMETRY_PLANE\n5,1,0,0,0,1,1,0\n"
      "*DAMPING_GLOBAL\n0,0.5\n*DAMPING_PART_MASS\n1,7,0.5,1\n1,0.5,0\n*DAMPING_PART_STIFFNESS\n1,0.1\n"
      "*BOUNDARY_NON_REFLECTING\n9,0,1\n*ELEMENT_MASS\n100,3,0.5\n*ELEMENT_MASS_PART\n1,1e-9\n"
      "*INITIAL_VELOCITY_GENERATION\n1,2,100\n0.5,0.5,0,0,0,1\n*TERMINATION_NODE\n5,3,2,-1.5\n"
      "*HOURGLASS\n1,5,0.03\n*DATABASE_GLSTAT\n0.01\n*DATABASE_RWFORC\n0,0,7\n*DATABASE_BINARY_D3PLOT\n0.1\n"
      "*DATABASE_BINARY_D3DUMP\n1000\n*DATABASE_BINARY_RUNRSF\n500\n"
      "*DATABASE_HISTORY_NODE\n8,1,5\n*DATABASE_HISTORY_NODE_ID\n         3corner, "
      "top\n*DATABASE_HISTORY_SOLID_SET\n4\n");
}

TEST(Write, DifferencesAreNamed) {
  const Built a = build_text(cube), b = build_text(cube + "*CONTROL_TIMESTEP\n0,0.5\n");
  EXPECT_EQ(first_difference(a.model, b.model), "control.step");
}

// Every kind of contact, with every field that counts given a value of its own.
TEST(Write, Contacts) {
  const std::string two =
      cube +
      "*NODE\n11,0,0,1.1\n12,1,0,1.1\n13,1,1,1.1\n14,0,1,1.1\n15,0,0,2\n16,1,0,2\n17,1,1,2\n18,0,1,2\n"
      "*ELEMENT_SOLID\n2,2,11,12,13,14,15,16,17,18\n*PART\nupper\n2,1,1\n"
      "*SET_SEGMENT\n9\n5,6,7,8\n*SET_NODE_LIST\n5\n11,12,13,14\n*SET_PART_LIST\n3\n2\n"
      "*CONTROL_CONTACT\n0.2,0,1,0,2,0,2\n\n\n1\n";
  const std::string friction = "0.3,0.2,0.5,7,15,0,0.25,0.75\n";  // FS FD DC VC VDC PENCHK BT DT
  const std::string rest = "1.5,0.5\n", a_to_c = "1,0.2,0,1.05\n0.6\n0,2\n";
  for (const std::string kind : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE",
                                 "SURFACE_TO_SURFACE", "FORMING_ONE_WAY_SURFACE_TO_SURFACE"}) {
    expect_round_trip(two + "*CONTACT_" + kind + "_ID\n12,upper on lower\n2,1,3,3\n" + friction + rest +
                      a_to_c);
    expect_round_trip(two + "*CONTACT_" + kind + "\n3,9,2,0\n" + friction + rest + a_to_c);
  }
  for (const std::string kind : {"AUTOMATIC_NODES_TO_SURFACE", "NODES_TO_SURFACE"})
    expect_round_trip(two + "*CONTACT_" + kind + "\n5,1,4,3\n" + friction + rest + a_to_c);
  for (const std::string kind : {"AUTOMATIC_SINGLE_SURFACE", "SINGLE_SURFACE"})
    expect_round_trip(two + "*CONTACT_" + kind + "\n0,0,5\n" + friction + rest + a_to_c);
  for (const std::string order : {"0,1,1\n", "0,0,1\n", "\n"}) {
    expect_round_trip(two + "*CONTACT_ERODING_SURFACE_TO_SURFACE\n2,1,3,3\n" + friction + rest + order +
                      a_to_c);
    expect_round_trip(two + "*CONTACT_ERODING_NODES_TO_SURFACE\n5,1,4,3\n" + friction + rest + order +
                      a_to_c);
    expect_round_trip(two + "*CONTACT_ERODING_SINGLE_SURFACE\n3,0,2\n" + friction + rest + order + a_to_c);
  }
  for (const std::string kind :
       {"TIED_SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE", "TIED_SURFACE_TO_SURFACE_OFFSET"})
    expect_round_trip(two + "*CONTACT_" + kind + "\n2,1,3,3\n0,0,0,0,0,0,0.25,0.75\n1.5,0.5,-0.2\n");
}

}  // namespace
}  // namespace cleave::model
