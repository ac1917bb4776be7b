#include "model/material/erosion.hpp"

#include "model/material/kernel.hpp"
#include "model/material/principal.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Bounds of the criteria; `off` values are never reached. Compression is positive in pressures only.
struct Criteria {
  static constexpr double off = 1e300;

  double greatest_pressure = off, least_pressure = -off;         ///< MXPRES, MNPRES [stress]
  double principal_stress = off, mises_stress = off;             ///< SIGP1, SIGVM [stress]
  double principal_strain = off, least_principal_strain = -off;  ///< MXEPS, MNEPS [-]
  double shear_strain = off;                                     ///< EPSSH, (first - third) / 2 [-]
  double strain = off, plastic_strain = off;                     ///< EFFEPS above and below 0 [-]
  double swelling = off, shrinking = -off;                       ///< VOLEPS above and below 0 [-]
  double threshold = 0.0, impulse = off;                         ///< SIGTH [stress], IMPULSE [stress^2 time]
  double time = off;                                             ///< FAILTM [time]
  double criteria_needed = 1.0;                                  ///< NCS

  bool has_impulse() const { return impulse < off; }
};

/// What the criteria look at.
template <class Real>
struct Situation {
  base::Sym3<Real> stress, strain;
  Real volume_ratio, plastic_strain;
  double dt, time;
};

/// 1 where enough criteria are met. Moves the impulse.
/// Source of the impulse: Tuler & Butcher, Int. J. Fract. Mech. 4 (1968) 431, eq. 5.
template <class Real>
Real erodes(const Criteria& c, const Situation<Real>& s, Real& impulse) {
  const Real pressure = trace(s.stress) * Real(-1.0 / 3.0);
  const auto stress = principal_values(s.stress), strain = principal_values(s.strain);
  const auto shape = deviator(s.strain);
  const Real effective_strain = sqrt(Real(2.0 / 3.0) * dot(shape, shape));
  const Real volume_strain = log(s.volume_ratio);
  if (c.has_impulse()) {
    const Real above = max(stress.first - Real(c.threshold), Real(0.0));
    impulse = impulse + above * above * Real(s.dt);
  }
  const auto met = [](const auto& reached) { return select(reached, Real(1.0), Real(0.0)); };
  const Real count =
      met(pressure >= Real(c.greatest_pressure)) + met(pressure <= Real(c.least_pressure)) +
      met(stress.first >= Real(c.principal_stress)) + met(von_mises(s.stress) >= Real(c.mises_stress)) +
      met(strain.first >= Real(c.principal_strain)) + met(strain.third <= Real(c.least_principal_strain)) +
      met(Real(0.5) * (strain.first - strain.third) >= Real(c.shear_strain)) +
      met(effective_strain >= Real(c.strain)) + met(s.plastic_strain >= Real(c.plastic_strain)) +
      met(volume_strain >= Real(c.swelling)) + met(volume_strain <= Real(c.shrinking)) +
      met(impulse >= Real(c.impulse)) + Real(s.time >= c.time ? 1.0 : 0.0);
  return met(count >= Real(c.criteria_needed));
}

class ErodingLaw final : public Law {
 public:
  ErodingLaw(std::unique_ptr<Law> inner, const Criteria& criteria, int failed_points)
      : inner_(std::move(inner)), criteria_(criteria), failed_points_(failed_points) {}

  int state_size() const override { return 6 + inner_->state_size() + (criteria_.has_impulse() ? 1 : 0); }
  int rotated_tensors() const override { return 1 + inner_->rotated_tensors(); }
  bool needs_F() const override { return inner_->needs_F(); }
  bool can_fail() const override { return true; }
  int plastic_strain() const override {
    return inner_->plastic_strain() < 0 ? -1 : 6 + inner_->plastic_strain();
  }
  std::vector<StateName> state_names() const override {
    std::vector<StateName> names{{"strain", 0, 6}};
    for (const auto& name : inner_->state_names()) names.push_back({name.name, name.first + 6, name.size});
    if (criteria_.has_impulse()) names.push_back({"stress_impulse", state_size() - 1, 1});
    return names;
  }
  void initialise(std::span<double> state) const override {
    inner_->initialise(state.subspan(6, inner_->state_size()));
  }
  double longitudinal_modulus() const override { return inner_->longitudinal_modulus(); }
  double shear_modulus() const override { return inner_->shear_modulus(); }
  double bulk_modulus() const override { return inner_->bulk_modulus(); }
  int failed_points_needed() const override { return failed_points_; }

  [[gnu::flatten]] void update(const Tile& tile) const override {
    inner_->update(inside(tile));
    for (int b = 0; b < tile.batch_count; ++b) judge<base::Lanes>(tile, b, 0);
  }
  void update_scalar(const Tile& tile) const override {
    inner_->update_scalar(inside(tile));
    for (int b = 0; b < tile.batch_count; ++b)
      for (int lane = 0; lane < base::lane_count; ++lane) judge<double>(tile, b, lane);
  }
  void tangent(const Tile& tile, std::span<double> out) const override { inner_->tangent(inside(tile), out); }

 private:
  /// The tile as the inner law sees it.
  static Tile inside(Tile tile) {
    tile.state += 6 * base::lane_count;
    return tile;
  }

  template <class Real>
  void judge(const Tile& tile, int b, int lane) const {
    const auto at = [lane](const double* from, int component) {
      return detail::load<Real>(from + component * base::lane_count, lane);
    };
    const auto tensor = [&at](const double* from) {
      return base::Sym3<Real>{at(from, 0), at(from, 1), at(from, 2), at(from, 3), at(from, 4), at(from, 5)};
    };
    const std::ptrdiff_t one = b * tile.scratch_stride_1, record = b * tile.record_stride;
    double* state = tile.state + record;
    const Situation<Real> s{
        .stress = tensor(tile.stress + record),
        .strain = tensor(state) + tensor(tile.strain_increment + b * tile.scratch_stride_6),
        .volume_ratio = at(tile.volume_ratio + one, 0),
        .plastic_strain = plastic_strain() < 0 ? Real(0.0) : at(state, plastic_strain()),
        .dt = tile.dt,
        .time = tile.time};
    Real impulse = criteria_.has_impulse() ? at(state, state_size() - 1) : Real(0.0);
    const Real failed = max(at(tile.failed + one, 0), erodes(criteria_, s, impulse));

    const Real strain[6] = {s.strain.xx, s.strain.yy, s.strain.zz, s.strain.xy, s.strain.yz, s.strain.zx};
    for (int i = 0; i < 6; ++i) detail::store(strain[i], state + i * base::lane_count, lane);
    if (criteria_.has_impulse()) detail::store(impulse, state + (state_size() - 1) * base::lane_count, lane);
    detail::store(failed, tile.failed + one, lane);
  }

  std::unique_ptr<Law> inner_;
  Criteria criteria_;
  int failed_points_;
};

constexpr LawField fields[] = {
    {.name = "EXCL", .dimension = "-"},
    {.name = "MXPRES", .dimension = "stress"},
    {.name = "MNEPS", .dimension = "-"},
    {.name = "EFFEPS", .dimension = "-"},
    {.name = "VOLEPS", .dimension = "-"},
    {.name = "NUMFIP", .dimension = "-", .low = 1.0},
    {.name = "NCS", .dimension = "-", .low = 1.0},
    {.name = "MNPRES", .dimension = "stress"},
    {.name = "SIGP1", .dimension = "stress", .low = 0.0},
    {.name = "SIGVM", .dimension = "stress", .low = 0.0},
    {.name = "MXEPS", .dimension = "-", .low = 0.0},
    {.name = "EPSSH", .dimension = "-", .low = 0.0},
    {.name = "SIGTH", .dimension = "stress", .low = 0.0},
    {.name = "IMPULSE", .dimension = "stress^2 time", .low = 0.0},
    {.name = "FAILTM", .dimension = "time", .low = 0.0},
};

/// Fields that ask for physics which is not there.
constexpr std::string_view refused[] = {"IDAM",   "LCREGD",  "LCFLD",   "EPSTHIN", "ENGCRT",
                                        "RADCRT", "LCEPS12", "LCEPS13", "LCEPSMX", "VOLFRAC",
                                        "MXTMP",  "DTMIN",   "FFUNC",   "DIAGR",   "EDGER"};

}  // namespace

std::span<const LawField> erosion_fields() {
  return fields;
}

std::unique_ptr<Law> add_erosion(std::unique_ptr<Law> inner, const deck::Card& card,
                                 const LawContext& context) {
  bool usable = inner != nullptr;
  const auto refuse = [&](std::string_view field, std::string message) {
    context.diagnostics.error(card.place(field), card.keyword(), std::string(field), std::move(message));
    usable = false;
  };
  for (const std::string_view field : refused)
    if (card.has_field(field) && card[field] != 0.0)
      refuse(field, "this damage or erosion option is not implemented");

  // A criterion is off where its field is blank or holds the number EXCL.
  const double exclusion = card["EXCL"];
  const auto set = [&](std::string_view field, double& bound) {
    if (card.given(field) && card[field] != exclusion) bound = card[field];
  };
  // Negative values of these name curves.
  for (const std::string_view field : {"SIGP1", "SIGVM", "MXEPS", "EPSSH"})
    if (card.given(field) && card[field] != exclusion && card[field] < 0.0)
      refuse(field, "a bound given by a curve (negative value) is not implemented");

  Criteria c;
  set("MXPRES", c.greatest_pressure);
  set("MNPRES", c.least_pressure);
  set("SIGP1", c.principal_stress);
  set("SIGVM", c.mises_stress);
  set("MXEPS", c.principal_strain);
  set("MNEPS", c.least_principal_strain);
  set("EPSSH", c.shear_strain);
  set("IMPULSE", c.impulse);
  set("SIGTH", c.threshold);
  if (card["FAILTM"] > 0.0) set("FAILTM", c.time);
  double effective = 0.0, volume = 0.0;
  set("EFFEPS", effective);
  set("VOLEPS", volume);
  if (effective > 0.0) c.strain = effective;
  if (effective < 0.0) c.plastic_strain = -effective;
  if (volume > 0.0) c.swelling = volume;
  if (volume < 0.0) c.shrinking = volume;
  if (effective < 0.0 && inner && inner->plastic_strain() < 0)
    refuse("EFFEPS", "a negative value bounds the plastic strain, which this material does not have");

  const double points = card["NUMFIP"], needed = card["NCS"];
  if (points < 0.0) refuse("NUMFIP", "a percentage of layers (negative value) is for shells");
  c.criteria_needed = needed > 0.0 ? needed : 1.0;
  if (!usable) return nullptr;
  return std::make_unique<ErodingLaw>(std::move(inner), c, points > 1.0 ? static_cast<int>(points) : 1);
}

}  // namespace cleave::model
