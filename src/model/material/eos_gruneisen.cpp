#include "model/material/eos.hpp"
#include "model/material/kernel.hpp"

namespace cleave::model {
namespace {

/// Mie-Gruneisen pressure with a cubic shock velocity - particle velocity curve. With mu = 1/v - 1,
///   mu > 0: p = rho0 C^2 mu [1 + (1 - g0/2) mu - a/2 mu^2] / D^2 + (g0 + a mu) E,
///           D = 1 - (S1 - 1) mu - S2 mu^2 / (mu + 1) - S3 mu^3 / (mu + 1)^2,
///   mu < 0: p = rho0 C^2 mu + (g0 + a mu) E.
/// Source: Steinberg, Equation of state and strength properties of selected materials, UCRL-MA-106439 (1996).
struct Gruneisen {
  double stiffness;          ///< rho0 C^2 [stress]
  double s1, s2, s3;         ///< [-]
  double gamma, gamma_rate;  ///< g0, a [-]

  template <class Real>
  PressureLine<Real> line(const Real& v) const {
    const Real one(1.0), density = one / v, mu = density - one;
    const Real m = max(mu, Real(0.0)), stretched = min(mu, Real(0.0));
    const Real w = m / (m + one), half_a(0.5 * gamma_rate), b(1.0 - 0.5 * gamma);

    // Hugoniot part; the denominator stays off zero at the limit compression of the shock curve.
    const Real above = one + m * (b - half_a * m);
    const Real below = max(one - m * (Real(s1 - 1.0) + w * (Real(s2) + Real(s3) * w)), Real(1e-3));
    const Real below_slope =
        -(Real(s1 - 1.0) + Real(s2) * w * (Real(2.0) - w) + Real(s3) * w * w * (Real(3.0) - Real(2.0) * w));
    const Real share = one / (below * below);
    const Real hugoniot = m * above * share;
    const Real slope = (one + m * (Real(2.0) * b - Real(3.0) * half_a * m)) * share -
                       Real(2.0) * hugoniot * below_slope / below;

    const Real dmu = -(density * density);  // d mu / dv
    return {
        .cold = Real(stiffness) * (hugoniot + stretched),
        .thermal = Real(gamma) + Real(gamma_rate) * mu,
        .cold_slope = Real(stiffness) * slope * dmu,  // the slope is 1 in tension, where m = 0
        .thermal_slope = Real(gamma_rate) * dmu,
    };
  }
};

constexpr LawField fields[] = {
    {.name = "C", .dimension = "length/time", .low = 0.0, .low_open = true, .required = true},
    {.name = "S1", .dimension = "-"},
    {.name = "S2", .dimension = "-"},
    {.name = "S3", .dimension = "-"},
    {.name = "GAMA0", .dimension = "-"},
    {.name = "A", .dimension = "-"},
    {.name = "E0", .dimension = "energy/volume"},
    {.name = "V0", .dimension = "-", .low = 0.0},
};

std::unique_ptr<PressureLaw> build(const deck::Card& card, double density, deck::Diagnostics& diagnostics) {
  auto law = std::make_unique<TiledPressureLaw<Gruneisen>>(Gruneisen{
      .stiffness = density * card["C"] * card["C"],
      .s1 = card["S1"],
      .s2 = card["S2"],
      .s3 = card["S3"],
      .gamma = card["GAMA0"],
      .gamma_rate = card["A"],
  });
  law->initial_energy = card["E0"];
  law->initial_volume = card["V0"] > 0.0 ? card["V0"] : 1.0;
  if (!(law->bulk_modulus() > 0.0)) {
    diagnostics.error(
        card.place(), card.keyword(), "C",
        "the bulk modulus in the initial state must be positive; RO of the material and C give it");
    return nullptr;
  }
  return law;
}

}  // namespace

extern const PressureEntry eos_gruneisen{"EOS_GRUNEISEN", fields, build, "Steinberg 1996, UCRL-MA-106439"};

}  // namespace cleave::model
