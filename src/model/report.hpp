#pragma once
/// What a model amounts to: mass, volume, size, element quality, likely units. For `check` and the log.

#include <string>
#include <vector>

#include "model/model.hpp"

namespace cleave::model {

struct PartReport {
  Id id = 0;
  std::string title;
  std::size_t elements = 0;
  double volume = 0.0,
         mass = 0.0;  ///< of shells area times thickness, of bars length times area [length^3], [mass]
  double worst_jacobian = 1.0;  ///< smallest ratio of corner Jacobians
  Id worst_jacobian_element = 0;
  double worst_aspect = 1.0;  ///< largest edge ratio
  Id worst_aspect_element = 0;
  /// Of parts solved in spacetime: smallest height of a triangle or tetrahedron (of a quadrilateral cut along
  /// its better diagonal), smallest length of a bar; it limits the tents. 0 elsewhere. [length]
  double least_height = 0.0;
  Id least_height_element = 0;
  double sound_speed = 0.0;  ///< sqrt(longitudinal modulus / density) [length/time]
  std::string units;  ///< likely unit system by density and modulus, e.g. "tonne mm s"; empty: no match
};

struct ModelReport {
  std::size_t nodes = 0, elements = 0;
  double mass = 0.0;                               ///< with point masses [mass]
  double volume = 0.0;                             ///< [length^3]
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  ///< of the nodes [length]
  double least_time_step = 0.0;  ///< rough: shortest edge (spacetime: height) over sound speed [time]
  Id least_time_step_element = 0;
  std::vector<PartReport> parts;
  std::string units;  ///< when all parts that match any system agree; else empty
};

ModelReport report(const Model& model);

/// The unit system in which this density and Young's modulus are those of a metal; empty when none or many
/// fit. Source: table of consistent units of the format; metals from magnesium to tungsten.
std::string guess_units(double density, double modulus);

}  // namespace cleave::model
