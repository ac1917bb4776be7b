#include "discretisation/fem/hourglass_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "discretisation/fem/hex_modes.hpp"

namespace cleave::discretisation::fem {
namespace {

/// Largest eigenvalue of the products gamma_k . gamma_l of an element's four hourglass vectors [-].
double largest_product(const HexModes<double>& modes, const HexGradient<double>& gradient) {
  // gamma_k by its components along the seven sign patterns, whose squares are 8.
  double gamma[4][7];
  for (int k = 0; k < 4; ++k) {
    const Vec3<double> h = (1.0 / gradient.volume) * modes.h[k];
    for (int i = 0; i < 3; ++i) {
      gamma[k][i] = -dot(h, gradient.a[i]);
      gamma[k][3 + i] = (i == k ? 1.0 : 0.0) - dot(h, gradient.h[i]);
    }
    gamma[k][6] = k == 3 ? 1.0 : 0.0;
  }
  // Power iteration; the Rayleigh quotient is good to the square of what is left in the vector.
  std::array<double, 4> v{1.0, 0.9, 0.8, 0.7};
  double value = 0.0;
  for (int round = 0; round < 40; ++round) {
    double along[7] = {}, length = 0.0, square = 0.0;
    for (int i = 0; i < 7; ++i) {
      for (std::size_t k = 0; k < 4; ++k) along[i] += v[k] * gamma[k][i];
      square += along[i] * along[i];
    }
    for (const double x : v) length += x * x;
    value = 8.0 * square / length;
    std::array<double, 4> next{};
    for (std::size_t k = 0; k < 4; ++k)
      for (int i = 0; i < 7; ++i) next[k] += gamma[k][i] * along[i] / std::sqrt(length);
    v = next;
  }
  return value;
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

ViscousLimit viscous_hourglass_limit(const PartElements& elements) {
  double shortest = 1e300, least = 1e300;
  ViscousLimit limit;
  for (std::size_t e = 0; e < elements.id.size(); ++e) {
    Vec3<double> x[8];
    for (std::size_t a = 0; a < 8; ++a) {
      const double* p =
          &elements.model.mesh.nodes.position[3 * static_cast<std::size_t>(elements.node[8 * e + a])];
      x[a] = {p[0], p[1], p[2]};
    }
    const auto modes = hex_modes(x);
    const auto gradient = hex_gradient(modes);
    if (!(gradient.volume > 0.0)) continue;  // reported where blocks are initialised
    shortest = std::min(shortest, 0.25 * gradient.volume / std::sqrt(hex_largest_face(modes)));
    const double bearable = std::cbrt(gradient.volume) / largest_product(modes, gradient);
    if (bearable < least) {
      least = bearable;
      limit.element = elements.id[e];
    }
  }
  limit.coefficient = least / (elements.model.control.step.safety * shortest);
  return limit;
}

void warn_of_unstable_hourglass(const PartElements& elements, deck::Diagnostics& diagnostics) {
  const auto& part = elements.model.parts[static_cast<std::size_t>(elements.part)];
  const ViscousLimit limit = viscous_hourglass_limit(elements);
  // Equal within roundoff is stable.
  if (part.hourglass.coefficient <= limit.coefficient * (1.0 + 1e-9)) return;
  diagnostics.warning(part.hourglass.place, "HOURGLASS", "QM",
                      "viscous hourglass control of part " + std::to_string(part.id) +
                          " with QM = " + short_text(part.hourglass.coefficient) +
                          " is unstable at TSSFAC = " + short_text(elements.model.control.step.safety) +
                          ": element " + std::to_string(limit.element) + " bears at most " +
                          short_text(limit.coefficient) + ", above it hourglass modes grow",
                      "lower QM (0.05 to 0.1 is usual) or TSSFAC, or choose type 4, 5 or 6");
}

}  // namespace cleave::discretisation::fem
