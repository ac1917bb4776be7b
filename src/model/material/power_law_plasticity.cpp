#include "model/material/power_flow.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// von Mises plasticity with isotropic hardening K (e0 + plastic strain)^N and Cowper-Symonds rate effect.
/// Source: Swift, J. Mech. Phys. Solids 1 (1952) 1, eq. 1; Cowper & Symonds 1957.
struct PowerLawPlasticity {
  static constexpr int state_size = 1, rotated_tensors = 0, plastic_strain = 0;
  static constexpr bool needs_F = false;
  static constexpr std::array state_names{StateName{"effective_plastic_strain", 0, 1}};

  Moduli elastic;
  PowerHardening hardening;
  double offset = 0.0;  ///< e0, elastic strain at yield [-]
  CowperSymonds rate;
  bool viscoplastic = false;
  double failure_strain = 0.0;  ///< EPSF, 0 for none [-]

  bool can_fail() const { return failure_strain > 0.0; }
  double longitudinal() const { return elastic.longitudinal(); }
  double shear() const { return elastic.shear; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const double stiffness = 3.0 * elastic.shear;
    const auto trial = elastic_trial(p, elastic);
    const Real q = effective(trial.deviator), strain = p.state[0] + Real(offset);
    Real flow;
    if (rate.active() && viscoplastic) {
      flow = viscoplastic_flow(q, stiffness, PowerFlowStress<Real>{hardening, Real(1.0), strain},
                               CowperSymondsFlow(rate, p.dt));
    } else {
      const Real factor = rate.active() ? Real(1.0) + rate.overstress(effective_rate(p)) : Real(1.0);
      flow = power_flow(q, stiffness, factor, strain, hardening);
    }
    const Real scale = Real(1.0) - Real(stiffness) * flow / positive(q);
    p.stress = scale * trial.deviator + base::spherical(trial.mean);
    p.state[0] = p.state[0] + flow;
    p.modulus = Real(longitudinal());
    p.failed = flag<Real>(p.state[0] >= Real(failure_strain > 0.0 ? failure_strain : 1e300));
  }
};

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "K", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "N", .dimension = "-", .low = 0.0, .high = 1.0, .high_open = true},
    {.name = "SRC", .dimension = "1/time", .low = 0.0},
    {.name = "SRP", .dimension = "-", .low = 0.0},
    {.name = "SIGY", .dimension = "-", .low = 0.0},
    {.name = "EPSF", .dimension = "-", .low = 0.0},
    {.name = "VP", .dimension = "-", .low = 0.0, .high = 1.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  const double e = card["E"], k = card["K"], n = card["N"], yield = card["SIGY"];
  // SIGY: 0, the power law meets the elastic line; below 0.02, a strain; else a stress.
  double offset = yield;
  if (yield == 0.0)
    offset = std::pow(e / k, 1.0 / (n - 1.0));
  else if (yield > 0.02)
    offset = n > 0.0 ? std::pow(yield / k, 1.0 / n) : 0.0;
  return std::make_unique<TiledLaw<PowerLawPlasticity>>(
      PowerLawPlasticity{.elastic = Moduli::from(e, card["PR"]),
                         .hardening = PowerHardening::from(0.0, k, n),
                         .offset = offset,
                         .rate = {.reference = card["SRC"], .exponent = card["SRP"]},
                         .viscoplastic = card["VP"] != 0.0,
                         .failure_strain = card["EPSF"]});
}

}  // namespace

extern const LawEntry power_law_plasticity{"MAT_POWER_LAW_PLASTICITY", fields, build,
                                           "Swift 1952, eq. 1; Cowper & Symonds 1957"};

}  // namespace cleave::model
