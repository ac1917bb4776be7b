#include "model/material/hyperelastic.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Nearly incompressible Mooney-Rivlin rubber,
///   W = A (I - 3) + B (II - 3) + C (III^-2 - 1) + D (III - 1)^2,
/// I, II, III the invariants of F^T F, C = A/2 + B, D = (A (5 nu - 2) + B (11 nu - 5)) / (2 (1 - 2 nu)).
/// Source: Mooney, J. Appl. Phys. 11 (1940) 582; Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379; the terms in
/// III: Hallquist, LS-DYNA theory manual, material 27.
struct MooneyRivlin {
  static constexpr int state_size = 0, rotated_tensors = 0, plastic_strain = -1;
  static constexpr bool needs_F = true;
  static constexpr std::array<StateName, 0> state_names{};

  double a, b, c, d;  ///< [stress]

  bool can_fail() const { return false; }
  double shear() const { return 2.0 * (a + b); }
  double longitudinal() const { return 2.0 * a + 4.0 * b + 20.0 * c + 8.0 * d; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const Real one(1.0), two(2.0), jacobian = p.volume_ratio;
    const auto left = left_cauchy_green(p.F);
    const Real first = trace(left), third = jacobian * jacobian, inverse = one / third;

    // sigma = 2/J [(W1 + I W2) b - W2 b^2 + III W3 1], ordered so that it is exactly zero for b = 1.
    const Real reference = inverse * inverse, volume = Real(2.0 * d) * third * (third - one);
    const auto from_a = left - base::spherical(reference);
    const auto from_b = first * left - square(left) - base::spherical(two * reference);
    p.stress = (two / jacobian) * (Real(a) * from_a + Real(b) * from_b + base::spherical(volume));

    // lambda_i^2 W_ii / J over the principal directions, from above.
    const Real greatest = greatest_bound(left), half = min(greatest, Real(0.5) * first);
    p.modulus = (two * Real(a) * greatest + two * Real(b) * half * (first - half) +
                 Real(20.0 * c) * reference + Real(d) * third * (Real(12.0) * third - Real(4.0))) /
                jacobian;
    p.modulus = max(p.modulus, Real(longitudinal()));
  }
};

constexpr LawField fields[] = {
    {.name = "PR", .dimension = "-", .low = 0.0, .high = 0.5, .high_open = true, .required = true},
    {.name = "A", .dimension = "stress", .required = true},
    {.name = "B", .dimension = "stress"},
    {.name = "REF", .dimension = "-", .low = 0.0, .high = 0.0},
    {.name = "LCID", .dimension = "-", .low = 0.0, .high = 0.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext& context) {
  const double a = card["A"], b = card["B"], nu = card["PR"];
  const MooneyRivlin law{.a = a,
                         .b = b,
                         .c = 0.5 * a + b,
                         .d = (a * (5.0 * nu - 2.0) + b * (11.0 * nu - 5.0)) / (2.0 * (1.0 - 2.0 * nu))};
  if (!(a + b > 0.0)) {
    context.diagnostics.error(card.place("A"), card.keyword(), "A",
                              "A + B, half the shear modulus, must be positive");
    return nullptr;
  }
  return std::make_unique<TiledLaw<MooneyRivlin>>(law);
}

}  // namespace

extern const LawEntry mooney_rivlin{
    "MAT_MOONEY-RIVLIN_RUBBER", fields, build,
    "Mooney 1940; Rivlin 1948; Hallquist, LS-DYNA theory manual, material 27"};

}  // namespace cleave::model
