#pragma once

namespace cleave::bench {

/// Floating-point operations of one visit of a one-point hexahedron with viscous hourglass control, the law's
/// own not counted: strain, rotation, viscosity, hourglass, force, energies, stable step.
long hex_operations(double hourglass_coefficient);

}  // namespace cleave::bench
