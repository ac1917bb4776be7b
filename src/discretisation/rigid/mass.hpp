#pragma once
/// Mass, centre and inertia of elements and of what is made of them.

#include <span>

#include "base/tensor.hpp"
#include "model/load.hpp"
#include "model/part.hpp"

namespace cleave::discretisation {

struct RigidMass {
  double mass = 0.0;                               ///< [mass]
  model::Vector centre = {0, 0, 0};                ///< [length]
  base::Sym3<double> tensor = {0, 0, 0, 0, 0, 0};  ///< of inertia about the centre [mass length^2]

  /// Both together, by the theorem of parallel axes.
  RigidMass& operator+=(const RigidMass& other);
};

/// A mass in a point.
RigidMass point_mass(double mass, const model::Vector& at);

/// A solid of uniform density: integrals over the element with its curved and warped faces, exact to roundoff
/// (hexahedra and wedges 3 points in each direction, tetrahedra 5 on the collapsed cube).
RigidMass solid_mass(model::Shape shape, std::span<const model::Vector> corner, double density);

/// A shell of uniform thickness: its middle surface (exact for plane shells), and half the thickness to
/// either side of it.
/// @param on_it  further mass per area [mass/length^2]
RigidMass shell_mass(model::Shape shape, std::span<const model::Vector> corner, double density,
                     double thickness, double on_it);

/// An element of a part, by its density, thickness and further mass per area.
RigidMass element_mass(const model::Part& part, model::Shape shape, std::span<const model::Vector> corner);

}  // namespace cleave::discretisation
