#pragma once
/// A valid deck for every law of the catalogue, and variants with other options. A law without one fails the
/// sweep tests. Units: tonne, mm, s (stress in MPa).

#include <string>
#include <string_view>
#include <vector>

namespace cleave::model::testing {

struct Sample {
  std::string_view keyword;
  std::string name;  ///< of the variant; "scaled" in it: the rate of the whole strain scales the yield stress
  std::string deck;
  double strain = 0.01;  ///< typical size of a strain increment that leaves the elastic range
  double dt = 1e-5;
};

inline const char* copper_eos() {
  return "*EOS_GRUNEISEN\n1,3.94e6,1.489,0,0,2.02,0.47,0\n1.0\n";
}

inline std::vector<Sample> samples() {
  std::vector<Sample> s;
  s.push_back({"MAT_ELASTIC", "plain", "*MAT_ELASTIC\n1,7.8e-9,210000,0.3\n"});

  s.push_back({"MAT_RIGID", "what contact sees", "*MAT_RIGID\n1,7.8e-9,210000,0.3\n0,0,0\n0,0,0,0,0,0\n"});

  const std::string kinematic = "*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,210000,0.3,300,1000,";
  s.push_back({"MAT_PLASTIC_KINEMATIC", "isotropic", kinematic + "1.0\n0,0,0,0\n"});
  s.push_back({"MAT_PLASTIC_KINEMATIC", "kinematic", kinematic + "0.0\n0,0,0,0\n"});
  s.push_back({"MAT_PLASTIC_KINEMATIC", "mixed", kinematic + "0.4\n0,0,0.5,0\n"});
  s.push_back({"MAT_PLASTIC_KINEMATIC", "mixed scaled", kinematic + "0.4\n40,5,0,0\n"});
  s.push_back({"MAT_PLASTIC_KINEMATIC", "isotropic viscoplastic", kinematic + "1.0\n40,5,0,1\n"});
  s.push_back({"MAT_PLASTIC_KINEMATIC", "mixed viscoplastic", kinematic + "0.4\n40,5,0,1\n"});

  s.push_back({"MAT_BLATZ-KO_RUBBER", "plain", "*MAT_BLATZ-KO_RUBBER\n1,1e-9,1.5\n", 0.2});

  s.push_back({"MAT_NULL", "viscous",
               "*MAT_NULL\n1,1e-9,-1000,1e-3,1.5,0.5\n*EOS_GRUNEISEN\n1,1.48e6,1.75,0,0,0.28,0,0\n1\n"});
  s.push_back({"MAT_NULL", "gas",
               "*MAT_NULL\n1,1.2e-12\n*EOS_LINEAR_POLYNOMIAL\n1,0,0,0,0,0.4,0.4,0\n0.25,1\n", 0.1});

  const std::string copper = "*MAT_JOHNSON_COOK\n1,8.96e-9,46000,0,0,0,";
  const std::string constants = "\n90,292,0.31,0.025,1.09,1356,294,1\n";
  s.push_back({"MAT_JOHNSON_COOK", "copper scaled",
               copper + "0,0" + constants + "3.83e8,0,0,0,0.54,4.89,-3.03,0.014\n1.12\n" + copper_eos()});
  s.push_back(
      {"MAT_JOHNSON_COOK", "viscoplastic", copper + "1,0" + constants + "3.83e8,0,0,0\n0\n" + copper_eos()});
  s.push_back(
      {"MAT_JOHNSON_COOK", "spall", copper + "0,0" + constants + "3.83e8,-1500,2,0\n0\n" + copper_eos()});

  const std::string power = "*MAT_POWER_LAW_PLASTICITY\n1,7.8e-9,210000,0.3,600,0.2,";
  s.push_back({"MAT_POWER_LAW_PLASTICITY", "plain", power + "0,0\n0,0.8,0\n"});
  s.push_back({"MAT_POWER_LAW_PLASTICITY", "scaled", power + "40,5\n300,0,0\n"});
  s.push_back({"MAT_POWER_LAW_PLASTICITY", "viscoplastic", power + "40,5\n0.002,0,1\n"});

  const std::string piece = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-9,210000,0.3,250,1000,0,0\n";
  const std::string points = "0,0.01,0.05,0.1,0.3,0.6,0,0\n250,300,360,390,450,480,0,0\n";
  const std::string curves =
      "*DEFINE_CURVE\n1\n0,250\n0.02,320\n0.1,390\n0.5,470\n*DEFINE_CURVE\n2\n0,300\n0.01,350\n0.2,450\n1,"
      "520\n"
      "*DEFINE_CURVE\n3\n0,400\n0.05,470\n1,600\n*DEFINE_CURVE\n4\n0,1\n10,1.1\n1000,1.4\n10000,1.5\n";
  const std::string table = "*DEFINE_TABLE_2D\n9\n0.001,1\n10,2\n1000,3\n",
                    log_table = "*DEFINE_TABLE_2D\n9\n-6.9,1\n2.3,2\n6.9,3\n";
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "tangent", piece});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "points scaled", piece + "40,5,0,0,0\n" + points});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "points viscoplastic", piece + "40,5,0,0,1\n" + points});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "curve scaled by factors", piece + "0,0,1,4,0\n" + curves});
  s.push_back(
      {"MAT_PIECEWISE_LINEAR_PLASTICITY", "curve and factors viscoplastic", piece + "0,0,1,4,1\n" + curves});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "table scaled", piece + "0,0,9,0,0\n" + curves + table});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "logarithmic table scaled",
               piece + "0,0,9,0,0\n" + curves + log_table});
  s.push_back(
      {"MAT_PIECEWISE_LINEAR_PLASTICITY", "table viscoplastic", piece + "0,0,9,0,1\n" + curves + table});
  s.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "logarithmic table viscoplastic",
               piece + "0,0,9,0,1\n" + curves + log_table});

  s.push_back(
      {"MAT_MOONEY-RIVLIN_RUBBER", "plain", "*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-9,0.495,0.4,0.1\n", 0.2});

  const std::string simple = "*MAT_SIMPLIFIED_JOHNSON_COOK\n1,7.8e-9,210000,0.3,";
  s.push_back({"MAT_SIMPLIFIED_JOHNSON_COOK", "scaled", simple + "0\n350,275,0.36,0.022,0.9,0,0,1\n"});
  s.push_back(
      {"MAT_SIMPLIFIED_JOHNSON_COOK", "capped scaled", simple + "0\n350,275,0.36,0.022,0,400,430,1\n"});
  s.push_back({"MAT_SIMPLIFIED_JOHNSON_COOK", "viscoplastic", simple + "1\n350,275,0.36,0.022,0,0,0,1\n"});

  s.push_back(
      {"MAT_PLASTIC_KINEMATIC", "with erosion",
       kinematic +
           "0.4\n0,0,0,0\n*MAT_ADD_EROSION\n1,0,8000,-0.3,0,0.05,1,1\n-2500,2600,1500,0.25,0.3,500,2.0,1\n"});
  return s;
}

}  // namespace cleave::model::testing
