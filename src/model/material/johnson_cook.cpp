#include "model/material/eos_update.hpp"
#include "model/material/power_flow.hpp"
#include "model/material/principal.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// What SPALL says: how the material fails under tension.
enum class Spall { none, pressure_limit, principal_stress, pressure };

/// Johnson-Cook plasticity: (A + B e^N) (1 + C ln rate*) (1 - T*^M), pressure from an equation of state,
/// adiabatic heating by plastic work, cumulative damage with the fracture strain
/// [D1 + D2 exp(D3 sigma*)] (1 + D4 ln rate*) (1 + D5 T*), sigma* = mean over von Mises stress.
/// Source: Johnson & Cook, 7th Int. Symp. Ballistics (1983) 541; Eng. Fract. Mech. 21 (1985) 31, eqs. 1
/// and 2.
struct JohnsonCook {
  enum { strain, temperature, damage, rubble };  ///< state; rubble = 1: no shear, no tension
  static constexpr int state_size = 4, rotated_tensors = 0, plastic_strain = strain;
  static constexpr bool needs_F = false, integrates_energy = true, uses_pressure = true;
  static constexpr std::array state_names{StateName{"effective_plastic_strain", strain, 1},
                                          StateName{"temperature", temperature, 1},
                                          StateName{"damage", damage, 1}, StateName{"rubble", rubble, 1}};

  EosConstants eos;
  double shear_modulus = 0.0;  ///< G [stress]
  PowerHardening hardening;
  JohnsonCookRate rate;
  bool viscoplastic = false;
  double room = 0.0, melt = 0.0, exponent = 1.0;  ///< TR, TM [temperature], M; melt = 0: no softening
  double heating = 0.0;                           ///< 1 / (RO CP) [temperature/stress]; 0: stays at TR
  Spall spall = Spall::none;
  double tension = 0.0;                           ///< PC, negative [stress]
  double d1 = 0, d2 = 0, d3 = 0, d4 = 0, d5 = 0;  ///< fracture constants [-]
  double least_fracture_strain = 1e-6;            ///< EFMIN [-]
  bool fractures = false, erodes = true;          ///< is any D given; does damage 1 delete the point?
  double density = 0.0, least_step = 0.0;         ///< RO, DTF; 0 for none [time]

  bool can_fail() const { return (fractures && erodes) || least_step > 0.0; }
  double shear() const { return shear_modulus; }
  double longitudinal() const { return eos.bulk_modulus + 4.0 / 3.0 * shear_modulus; }
  void initialise(std::span<double> state) const { state[temperature] = room; }

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const Real one(1.0), zero(0.0);
    const double stiffness = 3.0 * shear_modulus;
    const Real before = trace(p.stress) * Real(-1.0 / 3.0);
    const auto deviator_before = p.stress + base::spherical(before);
    const auto trial = deviator_before + Real(2.0 * shear_modulus) * deviator(p.strain_increment);
    const Real q = effective(trial);

    // Plastic flow at the temperature of the begin of the step.
    const Real homologous =
        melt > 0.0 ? min(max((p.state[temperature] - Real(room)) * Real(1.0 / (melt - room)), zero), one)
                   : zero;
    const Real softening = melt > 0.0 ? one - pow(homologous, Real(exponent)) : one;
    const Real total_rate = effective_rate(p);
    Real flow;
    if (viscoplastic && rate.constant > 0.0) {
      flow = viscoplastic_flow(q, stiffness, PowerFlowStress<Real>{hardening, softening, p.state[strain]},
                               JohnsonCookFlow(rate, p.dt));
    } else {
      flow = power_flow(q, stiffness, softening * rate.factor(total_rate), p.state[strain], hardening);
    }
    const auto broken = p.state[rubble] > Real(0.5);
    flow = select(broken, zero, flow);
    const Real scale = select(broken, zero, one - Real(stiffness) * flow / positive(q));
    auto shear_stress = scale * trial;
    const Real flow_stress = q - Real(stiffness) * flow;
    p.state[strain] = p.state[strain] + flow;
    p.state[temperature] = p.state[temperature] + Real(heating) * flow_stress * flow * p.volume_ratio;

    // Pressure, then what tension and damage make of it.
    const Real work = eos.work(p, deviator_before, shear_stress);
    Real pressure = eos.pressure(p, work, before);
    if (fractures) {
      const Real triaxiality = -pressure / positive(flow_stress);
      const Real shape = exp(min(max(Real(d3) * triaxiality, Real(-100.0)), Real(100.0)));
      const Real rate_used = viscoplastic ? flow * Real(inverse_step(p.dt)) : total_rate;
      const Real log_rate = log(max(rate_used * Real(1.0 / rate.reference), one));
      const Real fracture_strain =
          max((Real(d1) + Real(d2) * shape) * (one + Real(d4) * log_rate) * (one + Real(d5) * homologous),
              Real(least_fracture_strain));
      p.state[damage] = p.state[damage] + flow / fracture_strain;
      if (erodes)
        p.failed = flag<Real>(p.state[damage] >= one);
      else
        p.state[rubble] = max(p.state[rubble], flag<Real>(p.state[damage] >= one));
    }
    if (spall == Spall::principal_stress) {
      const Real greatest = principal_values(shear_stress).first - pressure;
      p.state[rubble] = max(p.state[rubble], flag<Real>(greatest >= Real(-tension)));
    } else if (spall == Spall::pressure) {
      p.state[rubble] = max(p.state[rubble], flag<Real>(pressure <= Real(tension)));
    } else if (spall == Spall::pressure_limit) {
      pressure = max(pressure, Real(tension));
    }
    const auto loose = p.state[rubble] > Real(0.5);
    pressure = select(loose, max(pressure, zero), pressure);
    shear_stress = select(loose, zero, one) * shear_stress;

    p.energy = eos.energy(p, eos.work(p, deviator_before, shear_stress), before, pressure);
    p.stress = shear_stress - base::spherical(pressure);
    p.modulus = eos.bulk(p, pressure, p.energy) + Real(4.0 / 3.0 * shear_modulus);
    if (least_step > 0.0) p.failed = max(p.failed, flag<Real>(step_below(p, density, least_step)));
  }
};

constexpr LawField fields[] = {
    {.name = "RO", .dimension = "mass/length^3", .low = 0.0, .low_open = true, .required = true},
    {.name = "G", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "E", .dimension = "stress", .low = 0.0},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5},
    {.name = "DTF", .dimension = "time", .low = 0.0},
    {.name = "VP", .dimension = "-", .low = 0.0, .high = 1.0},
    {.name = "RATEOP", .dimension = "-", .low = 0.0, .high = 0.0},
    {.name = "A", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "B", .dimension = "stress", .low = 0.0},
    {.name = "N", .dimension = "-", .low = 0.0, .high = 20.0},
    {.name = "C", .dimension = "-", .low = 0.0},
    {.name = "M", .dimension = "-", .low = 0.0},
    {.name = "TM", .dimension = "temperature"},
    {.name = "TR", .dimension = "temperature"},
    {.name = "EPSO", .dimension = "1/time", .low = 0.0},
    {.name = "CP", .dimension = "energy/mass/temperature", .low = 0.0},
    {.name = "PC", .dimension = "stress", .high = 0.0},
    {.name = "SPALL", .dimension = "-", .low = 0.0, .high = 3.0},
    {.name = "IT", .dimension = "-", .low = 0.0, .high = 1.0},
    {.name = "D1", .dimension = "-"},
    {.name = "D2", .dimension = "-"},
    {.name = "D3", .dimension = "-"},
    {.name = "D4", .dimension = "-"},
    {.name = "D5", .dimension = "-"},
    {.name = "EROD", .dimension = "-"},
    {.name = "EFMIN", .dimension = "-", .low = 0.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext& context) {
  const double melt = card["TM"], room = card["TR"], cut = card["PC"], heat = card["CP"], rho = card["RO"];
  const bool softens = card.given("TM") && melt != 0.0 && card["M"] > 0.0;
  if (softens && melt <= room) {
    context.diagnostics.error(card.place("TM"), card.keyword(), "TM",
                              "the melting temperature must be above the room temperature TR");
    return nullptr;
  }
  JohnsonCook law{.eos = EosConstants::from(*context.pressure),
                  .shear_modulus = card["G"],
                  .hardening = PowerHardening::from(card["A"], card["B"], card["N"]),
                  .rate = {.constant = card["C"], .reference = card["EPSO"] > 0.0 ? card["EPSO"] : 1.0},
                  .viscoplastic = card["VP"] != 0.0,
                  .room = room,
                  .melt = softens ? melt : 0.0,
                  .exponent = card["M"],
                  .heating = heat > 0.0 ? 1.0 / (rho * heat) : 0.0,
                  .tension = cut,
                  .d1 = card["D1"],
                  .d2 = card["D2"],
                  .d3 = card["D3"],
                  .d4 = card["D4"],
                  .d5 = card["D5"],
                  .least_fracture_strain = card["EFMIN"] > 0.0 ? card["EFMIN"] : 1e-6,
                  .erodes = card["EROD"] == 0.0,
                  .density = rho,
                  .least_step = card["DTF"]};
  law.fractures = law.d1 != 0.0 || law.d2 != 0.0;
  const int spall = card["SPALL"] == 0.0 ? 2 : static_cast<int>(card["SPALL"]);
  if (cut < 0.0) law.spall = static_cast<Spall>(spall);
  return std::make_unique<TiledLaw<JohnsonCook>>(law, context.pressure);
}

}  // namespace

extern const LawEntry johnson_cook{.keyword = "MAT_JOHNSON_COOK",
                                   .fields = fields,
                                   .build = build,
                                   .source = "Johnson & Cook 1983; Johnson & Cook 1985, eqs. 1 and 2",
                                   .needs_pressure = true,
                                   .takes_pressure = true};

}  // namespace cleave::model
