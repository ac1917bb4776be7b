#include "model/material/eos.hpp"
#include "model/material/kernel.hpp"

namespace cleave::model {
namespace {

/// p = C0 + C1 mu + C2 mu^2 + C3 mu^3 + (C4 + C5 mu + C6 mu^2) E, mu = 1/v - 1; C2 and C6 act in compression
/// only.
/// Source: Woodruff, KOVEC user's manual, UCRL-51079 (1973).
struct LinearPolynomial {
  double c0, c1, c2, c3;  ///< [stress]
  double c4, c5, c6;      ///< [-]

  template <class Real>
  PressureLine<Real> line(const Real& v) const {
    const Real density = Real(1.0) / v, mu = density - Real(1.0);
    const Real squeezed = max(mu, Real(0.0)), two(2.0);
    const Real dmu = -(density * density);  // d mu / dv
    return {
        .cold = Real(c0) + mu * (Real(c1) + Real(c3) * mu * mu) + Real(c2) * squeezed * squeezed,
        .thermal = Real(c4) + Real(c5) * mu + Real(c6) * squeezed * squeezed,
        .cold_slope = (Real(c1) + two * Real(c2) * squeezed + Real(3.0 * c3) * mu * mu) * dmu,
        .thermal_slope = (Real(c5) + two * Real(c6) * squeezed) * dmu,
    };
  }
};

constexpr LawField fields[] = {
    {.name = "C0", .dimension = "stress"},
    {.name = "C1", .dimension = "stress"},
    {.name = "C2", .dimension = "stress"},
    {.name = "C3", .dimension = "stress"},
    {.name = "C4", .dimension = "-"},
    {.name = "C5", .dimension = "-"},
    {.name = "C6", .dimension = "-"},
    {.name = "E0", .dimension = "energy/volume"},
    {.name = "V0", .dimension = "-", .low = 0.0},
};

std::unique_ptr<PressureLaw> build(const deck::Card& card, double, deck::Diagnostics& diagnostics) {
  auto law = std::make_unique<TiledPressureLaw<LinearPolynomial>>(LinearPolynomial{
      .c0 = card["C0"],
      .c1 = card["C1"],
      .c2 = card["C2"],
      .c3 = card["C3"],
      .c4 = card["C4"],
      .c5 = card["C5"],
      .c6 = card["C6"],
  });
  law->initial_energy = card["E0"];
  law->initial_volume = card["V0"] > 0.0 ? card["V0"] : 1.0;
  if (!(law->bulk_modulus() > 0.0)) {
    diagnostics.error(card.place(), card.keyword(), "C1",
                      "the bulk modulus in the initial state must be positive, which C1 or C4 with E0 gives");
    return nullptr;
  }
  return law;
}

}  // namespace

extern const PressureEntry eos_linear_polynomial{"EOS_LINEAR_POLYNOMIAL", fields, build,
                                                 "Woodruff 1973, UCRL-51079"};

}  // namespace cleave::model
