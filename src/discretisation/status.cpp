#include <utility>

#include "discretisation/block.hpp"

namespace cleave::discretisation {

void StepStatus::merge(StepStatus other) {
  if (other.ok) return;
  if (ok || other.element < element || (other.element == element && other.part < part))
    *this = std::move(other);
}

double Energy::ratio() const {
  const double given = initial + external;
  return given != 0.0 ? total() / given : 1.0;
}

double Energy::ratio_without_eroded() const {
  const double given = initial + external;
  return given != 0.0 ? (total() - eroded_kinetic - eroded_internal - eroded_hourglass) / given : 1.0;
}

}  // namespace cleave::discretisation
