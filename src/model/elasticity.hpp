#pragma once
/// Constants of a linear elastic material, as spacetime parts need them.

#include "model/load.hpp"

namespace cleave::model {

struct Elasticity {
  bool isotropic = true;
  double young = 0.0, poisson = 0.0;  ///< isotropic [stress], [-]

  // --- orthotropic, along the material axes a, b, c -------------------------------------------------
  double modulus[3] = {0, 0, 0};                                ///< EA, EB, EC [stress]
  double poisson_ba = 0.0, poisson_ca = 0.0, poisson_cb = 0.0;  ///< strain along a when b is pulled, ... [-]
  double shear_ab = 0.0, shear_bc = 0.0, shear_ca = 0.0;        ///< [stress]

  /// Where the axes come from; angle and `across` are for shells.
  enum class Axes : std::uint8_t {
    element,  ///< a from node 1 to node 2 of each element
    frame,    ///< those of `frame`
    across    ///< a = reference x normal of the shell
  };
  Axes axes = Axes::frame;
  Frame frame;                ///< axis[0..2] = a, b, c
  Vector reference{0, 0, 0};  ///< V of Axes::across
  double angle = 0.0;         ///< turn about the normal, of `element` and `across` [radian]
  deck::Place place;
};

}  // namespace cleave::model
