#include "model/material/power_flow.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Johnson-Cook plasticity without temperature: min{min[A + B e^N, SIGMAX] (1 + C ln rate*), SIGSAT}.
/// Source: Johnson & Cook, 7th Int. Symp. Ballistics (1983) 541, eq. 1.
struct SimplifiedJohnsonCook {
  static constexpr int state_size = 1, rotated_tensors = 0, plastic_strain = 0;
  static constexpr bool needs_F = false;
  static constexpr std::array state_names{StateName{"effective_plastic_strain", 0, 1}};

  Moduli elastic;
  PowerHardening hardening;
  JohnsonCookRate rate;
  double greatest = 1e28, saturation = 1e28;  ///< SIGMAX, SIGSAT [stress]
  bool viscoplastic = false;
  double failure_strain = 1e17;  ///< PSFAIL [-]

  bool can_fail() const { return failure_strain < 1e17; }
  double longitudinal() const { return elastic.longitudinal(); }
  double shear() const { return elastic.shear; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const double stiffness = 3.0 * elastic.shear;
    const auto trial = elastic_trial(p, elastic);
    const Real q = effective(trial.deviator), over_stiffness(1.0 / stiffness);
    Real flow;
    if (viscoplastic && rate.constant > 0.0) {
      flow =
          viscoplastic_flow(q, stiffness, PowerFlowStress<Real>{hardening, Real(1.0), p.state[0], greatest},
                            JohnsonCookFlow(rate, p.dt));
    } else {
      // The lesser of two flow stresses lets the greater increment flow.
      const Real factor = rate.factor(effective_rate(p));
      flow = power_flow(q, stiffness, factor, p.state[0], hardening);
      flow = max(flow, (q - factor * Real(greatest)) * over_stiffness);
    }
    flow = max(flow, (q - Real(saturation)) * over_stiffness);
    const Real scale = Real(1.0) - Real(stiffness) * flow / positive(q);
    p.stress = scale * trial.deviator + base::spherical(trial.mean);
    p.state[0] = p.state[0] + flow;
    p.modulus = Real(longitudinal());
    p.failed = flag<Real>(p.state[0] >= Real(failure_strain));
  }
};

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "VP", .dimension = "-", .low = 0.0, .high = 1.0},
    {.name = "A", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "B", .dimension = "stress", .low = 0.0},
    {.name = "N", .dimension = "-", .low = 0.0, .high = 20.0},
    {.name = "C", .dimension = "-", .low = 0.0},
    {.name = "PSFAIL", .dimension = "-", .low = 0.0},
    {.name = "SIGMAX", .dimension = "stress", .low = 0.0},
    {.name = "SIGSAT", .dimension = "stress", .low = 0.0},
    {.name = "EPSO", .dimension = "1/time", .low = 0.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  // Blank and 0 both mean the default.
  const auto or_default = [&card](std::string_view field, double fallback) {
    const double value = card[field];
    return value > 0.0 ? value : fallback;
  };
  return std::make_unique<TiledLaw<SimplifiedJohnsonCook>>(
      SimplifiedJohnsonCook{.elastic = Moduli::from(card["E"], card["PR"]),
                            .hardening = PowerHardening::from(card["A"], card["B"], card["N"]),
                            .rate = {.constant = card["C"], .reference = or_default("EPSO", 1.0)},
                            .greatest = or_default("SIGMAX", 1e28),
                            .saturation = or_default("SIGSAT", 1e28),
                            .viscoplastic = card["VP"] != 0.0,
                            .failure_strain = or_default("PSFAIL", 1e17)});
}

}  // namespace

extern const LawEntry simplified_johnson_cook{"MAT_SIMPLIFIED_JOHNSON_COOK", fields, build,
                                              "Johnson & Cook 1983, eq. 1"};

}  // namespace cleave::model
