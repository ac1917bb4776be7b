#include "model/material/eos_update.hpp"
#include "model/material/plasticity.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Fluid: pressure from the equation of state, viscous deviator 2 MU D', cavitation at the pressure PC.
/// Source: Batchelor, An Introduction to Fluid Dynamics (1967), eq. 3.3.11.
struct Null {
  static constexpr int state_size = 0, rotated_tensors = 0, plastic_strain = -1;
  static constexpr bool needs_F = false, integrates_energy = true, uses_pressure = true;
  static constexpr std::array<StateName, 0> state_names{};

  EosConstants eos;
  double viscosity;               ///< MU [stress time]
  double least_pressure;          ///< PC, -1e300 for none [stress]
  double expansion, compression;  ///< TEROD, CEROD: volume ratios of erosion, 1e300 and -1 for none [-]

  bool can_fail() const { return expansion < 1e300 || compression > 0.0; }
  double shear() const { return 0.0; }
  double longitudinal() const { return eos.bulk_modulus; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const Real before = trace(p.stress) * Real(-1.0 / 3.0);
    const auto deviator_before = p.stress + base::spherical(before);
    const auto viscous = Real(2.0 * viscosity * inverse_step(p.dt)) * deviator(p.strain_increment);

    const Real work = eos.work(p, deviator_before, viscous);
    const Real pressure = max(eos.pressure(p, work, before), Real(least_pressure));
    p.energy = eos.energy(p, work, before, pressure);
    p.stress = viscous - base::spherical(pressure);
    p.modulus = eos.bulk(p, pressure, p.energy);
    p.failed = flag<Real>((p.volume_ratio >= Real(expansion)) | (p.volume_ratio <= Real(compression)));
  }
};

constexpr LawField fields[] = {
    {.name = "PC", .dimension = "stress", .high = 0.0},
    {.name = "MU", .dimension = "stress time", .low = 0.0},
    {.name = "TEROD", .dimension = "-", .low = 0.0},
    {.name = "CEROD", .dimension = "-", .low = 0.0, .high = 1.0, .high_open = true},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext& context) {
  const double cut = card["PC"], expansion = card["TEROD"], compression = card["CEROD"];
  if (expansion > 0.0 && expansion <= 1.0) {
    context.diagnostics.error(card.place("TEROD"), card.keyword(), "TEROD",
                              "the volume ratio of erosion by expansion must be above 1");
    return nullptr;
  }
  return std::make_unique<TiledLaw<Null>>(Null{.eos = EosConstants::from(*context.pressure),
                                               .viscosity = card["MU"],
                                               .least_pressure = cut < 0.0 ? cut : -1e300,
                                               .expansion = expansion > 0.0 ? expansion : 1e300,
                                               .compression = compression > 0.0 ? compression : -1.0},
                                          context.pressure);
}

}  // namespace

extern const LawEntry null{.keyword = "MAT_NULL",
                           .fields = fields,
                           .build = build,
                           .source = "Batchelor 1967, eq. 3.3.11",
                           .needs_pressure = true,
                           .takes_pressure = true,
                           .harmless = "YM PR"};

}  // namespace cleave::model
