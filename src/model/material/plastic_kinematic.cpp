#include "model/material/flow.hpp"
#include "model/material/plasticity.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

enum class Rate { none, scaled, viscoplastic };

struct Constants {
  Moduli elastic;
  double yield = 0.0;      ///< SIGY [stress]
  double isotropic = 0.0;  ///< beta Ep [stress]
  double kinematic = 0.0;  ///< (1 - beta) Ep [stress]
  CowperSymonds rate;
  double failure_strain = 0.0;  ///< FS, 0 for none [-]
};

/// von Mises plasticity with linear isotropic, kinematic or mixed hardening and Cowper-Symonds rate effect.
/// Source: Krieg & Key, Implementation of a time dependent plasticity theory, AMD 20 (1976); Simo & Hughes,
/// Computational Inelasticity (1998), box 3.1; rates: Cowper & Symonds, Brown University report 28 (1957).
template <bool moves, Rate form>
struct PlasticKinematic : Constants {
  static constexpr int rotated_tensors = moves ? 1 : 0;  ///< back stress
  static constexpr int plastic_strain = 6 * rotated_tensors, state_size = plastic_strain + 1;
  static constexpr bool needs_F = false;
  static constexpr auto state_names = [] {
    constexpr StateName strain{"effective_plastic_strain", plastic_strain, 1};
    if constexpr (moves) {
      return std::array{StateName{"back_stress", 0, 6}, strain};
    } else {
      return std::array{strain};
    }
  }();

  bool can_fail() const { return failure_strain > 0.0; }
  double longitudinal() const { return elastic.longitudinal(); }
  double shear() const { return elastic.shear; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const double stiffness = 3.0 * elastic.shear + kinematic;
    const auto trial = elastic_trial(p, elastic);

    // Stress relative to the centre of the yield surface.
    auto relative = trial.deviator;
    base::Sym3<Real> back;
    if constexpr (moves) {
      back = {p.state[0], p.state[1], p.state[2], p.state[3], p.state[4], p.state[5]};
      relative = relative - back;
    }
    const Real q = effective(relative);
    const Real strain = p.state[plastic_strain];
    const Real radius = Real(yield) + Real(isotropic) * strain;

    // Increment of plastic strain that brings the stress back to the surface.
    Real flow;
    if constexpr (form == Rate::none) {
      flow = max(q - radius, Real(0.0)) * Real(1.0 / (stiffness + isotropic));
    } else if constexpr (form == Rate::scaled) {
      const Real factor = Real(1.0) + rate.overstress(effective_rate(p));
      flow = max(q - factor * radius, Real(0.0)) / (Real(stiffness) + factor * Real(isotropic));
    } else {
      flow = viscoplastic_flow(q, stiffness, LinearHardening<Real>{radius, isotropic},
                               CowperSymondsFlow(rate, p.dt));
    }

    const Real over_q = flow / positive(q);
    p.stress = trial.deviator - (Real(3.0 * elastic.shear) * over_q) * relative + base::spherical(trial.mean);
    if constexpr (moves) {
      back = back + (Real(kinematic) * over_q) * relative;
      p.state[0] = back.xx, p.state[1] = back.yy, p.state[2] = back.zz;
      p.state[3] = back.xy, p.state[4] = back.yz, p.state[5] = back.zx;
    }
    p.state[plastic_strain] = strain + flow;
    p.modulus = Real(longitudinal());
    p.failed = flag<Real>(p.state[plastic_strain] >= Real(failure_strain > 0.0 ? failure_strain : 1e300));
  }
};

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "SIGY", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "ETAN", .dimension = "stress", .low = 0.0},
    {.name = "BETA", .dimension = "-", .low = 0.0, .high = 1.0},
    {.name = "SRC", .dimension = "1/time", .low = 0.0},
    {.name = "SRP", .dimension = "-", .low = 0.0},
    {.name = "FS", .dimension = "-", .low = 0.0},
    {.name = "VP", .dimension = "-", .low = 0.0, .high = 1.0},
};

template <bool moves>
std::unique_ptr<Law> with_rate(const Constants& constants, bool viscoplastic) {
  if (!constants.rate.active())
    return std::make_unique<TiledLaw<PlasticKinematic<moves, Rate::none>>>(
        PlasticKinematic<moves, Rate::none>{constants});
  if (!viscoplastic)
    return std::make_unique<TiledLaw<PlasticKinematic<moves, Rate::scaled>>>(
        PlasticKinematic<moves, Rate::scaled>{constants});
  return std::make_unique<TiledLaw<PlasticKinematic<moves, Rate::viscoplastic>>>(
      PlasticKinematic<moves, Rate::viscoplastic>{constants});
}

std::unique_ptr<Law> build(const deck::Card& card, const LawContext& context) {
  const double e = card["E"], tangent = card["ETAN"], beta = card["BETA"];
  if (tangent >= e) {
    context.diagnostics.error(card.place("ETAN"), card.keyword(), "ETAN",
                              "the tangent modulus must be below Young's modulus");
    return nullptr;
  }
  const double plastic = e * tangent / (e - tangent);  // slope over plastic strain
  const Constants constants{.elastic = Moduli::from(e, card["PR"]),
                            .yield = card["SIGY"],
                            .isotropic = beta * plastic,
                            .kinematic = (1.0 - beta) * plastic,
                            .rate = {.reference = card["SRC"], .exponent = card["SRP"]},
                            .failure_strain = card["FS"]};
  // Without kinematic hardening the back stress stays zero: spare its memory.
  return constants.kinematic > 0.0 ? with_rate<true>(constants, card["VP"] != 0.0)
                                   : with_rate<false>(constants, card["VP"] != 0.0);
}

}  // namespace

extern const LawEntry plastic_kinematic{
    "MAT_PLASTIC_KINEMATIC", fields, build,
    "Krieg & Key 1976; Simo & Hughes 1998, box 3.1; Cowper & Symonds 1957"};

}  // namespace cleave::model
