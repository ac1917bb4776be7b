#pragma once
/// The energy between two faces as a function of a few measures of what they share, and its change with each.
/// Theory: docs/solver/contact.md, section 3. Everything is for a pressure of 1 per length of depth.

#include <algorithm>
#include <cmath>

namespace cleave::solver {

/// What the springs between two faces stand on.
struct Springs {
  double area;          ///< of face a, at the start: they get no more when it is stretched [length^2]
  double smaller_area;  ///< of both faces, at the start: what a corner or an edge meets [length^2]
  double hardening;     ///< a constant depth g has the pressure g (1 + hardening g^2) [1/length^2]
};

namespace pair_energy {

inline constexpr double least_facing = 0.1;  // faces at more than 84 degrees do not push each other,
inline constexpr double full_facing = 0.3;   // and fully at less than 73
inline constexpr double flat = 0.996;        // less than 5 degrees: the depth is integrated,
inline constexpr double poking = 0.975;      // more than 13: a corner or an edge meets the whole face,
inline constexpr double grasp = 4.0;         // of a small shared area: this and one times as stiff,
inline constexpr double blunt = 0.5;         // times d^3: less volume is not a corner that goes in

struct Ramp {
  double value, slope;
};
/// From 0 to 1 without a kink.
inline Ramp ramp(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return {t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (to - from)};
}

/// How much of an inclined pair is treated as a corner or an edge that pokes.
inline Ramp pokes(double facing) {
  return ramp(-facing, -flat, -poking);
}

}  // namespace pair_energy

/// What the energy depends on.
struct Measures {
  double facing;              ///< minus the cosine between the normals [-]
  double stretch;             ///< area of face a at the start over that of now [-]
  double area;                ///< S, of the shared polygon [length^2]
  double square, volume;      ///< integrals of g^2 and g, bilinear, over where a is behind b
  double cone_square = 0.0;   ///< the same of a depth that is linear in triangles; where nothing pokes,
  double cone_volume = 0.0;   ///< these are not used
  double cone_area = 0.0;     ///< where a is behind b [length^2]
  double width_square = 0.0;  ///< of the shared polygon, see Width [length^2]
};

/// The energy and how it changes with each measure.
struct PairEnergy {
  double value;
  double with_facing, with_area, with_square, with_volume;
  double with_cone_square = 0.0, with_cone_volume = 0.0, with_width_square = 0.0;
  double rate;  ///< by how much the force along the normal grows with the depth [length^2]

  /// @param deep_area  where a is behind b [length^2]
  PairEnergy(const Springs& springs, const Measures& m, double deep_area) {
    using namespace pair_energy;
    const double h = springs.hardening;
    const Ramp fade = ramp(m.facing, least_facing, full_facing), s = pokes(m.facing);
    const double of_flat = m.stretch * fade.value * (1.0 - s.value);
    const double of_poke = m.stretch * fade.value * s.value;

    // Where the faces are parallel: half the integral of g^2, and more by the depth in which it lies.
    const double d = m.volume > 0.0 ? m.square / m.volume : 0.0;
    const double flat_energy = 0.5 * m.square * (1.0 + 0.5 * h * d * d);
    with_square = of_flat * (0.5 + 0.75 * h * d * d);
    with_volume = -0.5 * of_flat * h * d * d * d;
    rate = of_flat * deep_area * (1.0 + 3.0 * h * d * d);
    with_area = 0.0;
    value = m.stretch * fade.value * flat_energy;
    with_facing = m.stretch * fade.slope * flat_energy;
    if (s.value > 0.0) poke(springs, m, fade, s, of_poke, flat_energy);
  }

 private:
  /// Where a corner or an edge pokes: that of a depth d = (integral of g^2) / (integral of g) over as much as
  /// a whole face, unless they share hardly anything. Where they overlap by a strip narrower than they are
  /// deep, or by a splinter of less volume than a corner takes, the way out is across it: the energy goes to
  /// zero with the square of its width, so that no edge pulls with all its length from the first touch.
  void poke(const Springs& springs, const Measures& m, const pair_energy::Ramp& fade,
            const pair_energy::Ramp& s, double of_poke, double flat_energy) {
    using namespace pair_energy;
    const double h = springs.hardening;
    const double d = m.cone_square / m.cone_volume;
    const double share = 1.0 / (1.0 + grasp * m.area / springs.smaller_area);
    const double whole = (1.0 + grasp) * m.area * share;
    double strip = d * d / std::max(m.width_square, 1e-300);
    double splinter = blunt * d * d * d / m.cone_volume;
    splinter *= splinter;
    const double lets = 1.0 / std::sqrt(1.0 + strip + splinter);
    strip *= lets * lets;
    splinter *= lets * lets;

    const double spring = 0.5 * lets * d * d * (1.0 + 0.5 * h * d * d), energy = whole * spring;
    const double with_d = lets * whole * d * (1.0 + h * d * d) - energy * (strip + 3.0 * splinter) / d;
    with_area = of_poke * (1.0 + grasp) * share * share * spring;
    with_cone_square = of_poke * with_d / m.cone_volume;
    with_cone_volume = of_poke * (energy * splinter - with_d * d) / m.cone_volume;
    if (m.width_square > 0.0) with_width_square = 0.5 * of_poke * energy * strip / m.width_square;
    const double grows = 2.0 - d * m.cone_area / m.cone_volume;  // d with the depth
    rate += of_poke * whole * grows * grows * (1.0 + 3.0 * h * d * d);

    const double more = energy - flat_energy;
    value += m.stretch * fade.value * s.value * more;
    with_facing += m.stretch * (fade.slope * s.value - fade.value * s.slope) * more;
  }
};

}  // namespace cleave::solver
