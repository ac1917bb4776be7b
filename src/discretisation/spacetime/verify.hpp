#pragma once
/// What every solved patch can be held to: balance of momentum and of energy, to rounding.

#include <span>
#include <vector>

#include "discretisation/spacetime/solution.hpp"

namespace cleave::discretisation::spacetime {

struct Verify {
  double momentum = 0.0;      ///< largest residual of (3.6) over the elements, against the largest facet flux
  double energy = 0.0;        ///< residual of (3.7) over the patch, against the largest term
  double front_energy = 0.0;  ///< gained by the front: new minus old [energy]
  double boundary_work = 0.0;               ///< done by the boundary on the body [energy]
  double body_work = 0.0;                   ///< done by the body force [energy]
  double interface_work = 0.0;              ///< drawn from the bulk by interfaces that open or slip [energy]
  double dissipation = 0.0;                 ///< numerical, sum of e_Q (2.7) [energy]
  std::vector<double> element_dissipation;  ///< e_Q of each element: the error indicator [energy]
};

}  // namespace cleave::discretisation::spacetime
