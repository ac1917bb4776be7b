#pragma once
/// The established layout of elout: a heading at each time, then its elements.

#include <string>

#include "model/mesh.hpp"

namespace cleave::results {

void append_elout_heading(std::string& ascii, model::ElementKind kind, std::int64_t cycle, double time);

/// One element. Stresses are in global axes.
/// @param stress xx yy zz xy yz zx; of a beam xx alone is shown [stress]
/// @param area   of the cross section of a beam [length^2]
void append_elout_element(std::string& ascii, model::ElementKind kind, model::Id element, model::Id part,
                          const double* stress, double von_mises, double plastic_strain, double area = 0.0);

}  // namespace cleave::results
