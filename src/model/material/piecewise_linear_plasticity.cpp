#include <cmath>

#include "model/material/flow_curve.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

enum class Rate { none, symonds, curve, table };

/// von Mises plasticity with isotropic hardening by points, and rate effect by a table of curves, a curve of
/// factors, or Cowper and Symonds.
/// Source: Simo & Hughes, Computational Inelasticity (1998), sec. 3.3; rates: Cowper & Symonds 1957.
struct PiecewiseLinearPlasticity {
  static constexpr int state_size = 1, rotated_tensors = 0, plastic_strain = 0;
  static constexpr bool needs_F = false;
  static constexpr std::array state_names{StateName{"effective_plastic_strain", 0, 1}};

  Moduli elastic;
  FlowCurve hardening{};
  Rate form = Rate::none;
  bool viscoplastic = false;
  CowperSymonds symonds;
  double added = 0.0;  ///< SIGY of the viscoplastic sum [stress]
  RateCurve factors{};
  double failure_strain = 1e300;           ///< FAIL [-]
  double density = 0.0, least_step = 0.0;  ///< RO, TDEL; 0 for none

  bool can_fail() const { return failure_strain < 1e20 || least_step > 0.0; }
  double longitudinal() const { return elastic.longitudinal(); }
  double shear() const { return elastic.shear; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const double stiffness = 3.0 * elastic.shear;
    const auto trial = elastic_trial(p, elastic);
    const Real q = effective(trial.deviator);
    const Real flow = viscoplastic ? flow_at_own_rate(p, q) : flow_at_total_rate(p, q);
    const Real scale = Real(1.0) - Real(stiffness) * flow / positive(q);
    p.stress = scale * trial.deviator + base::spherical(trial.mean);
    p.state[0] = p.state[0] + flow;
    p.modulus = Real(longitudinal());
    p.failed = flag<Real>(p.state[0] >= Real(failure_strain));
    if (least_step > 0.0) p.failed = max(p.failed, flag<Real>(step_below(p, density, least_step)));
  }

 private:
  /// The rate of the whole strain scales the curve.
  template <class P, class Real>
  Real flow_at_total_rate(const P& p, const Real& q) const {
    RowShares<Real> shares;
    Real factor(1.0);
    if (form == Rate::table) share_rows<Real>(hardening, effective_rate(p), shares, nullptr);
    if (form == Rate::curve) factor = factors.at(effective_rate(p)).first;
    if (form == Rate::symonds) factor = Real(1.0) + symonds.overstress(effective_rate(p));
    return curve_flow(hardening, shares, q, 3.0 * elastic.shear, factor, p.state[0]);
  }

  /// The rate of plastic strain, part of the solution.
  template <class P, class Real>
  Real flow_at_own_rate(const P& p, const Real& q) const {
    const double inverse = inverse_step(p.dt), stiffness = 3.0 * elastic.shear;
    const CurveHardening<Real> curve(hardening, p.state[0], inverse);
    if (form == Rate::table) return viscoplastic_flow(q, stiffness, curve, NoRate{});
    if (form == Rate::curve) return viscoplastic_flow(q, stiffness, curve, CurveRate(factors, inverse));
    return viscoplastic_flow(q, stiffness, curve, CowperSymondsFlow(symonds, p.dt, added));
  }
};

constexpr LawField fields[] = {
    {.name = "RO", .dimension = "mass/length^3", .low = 0.0, .low_open = true, .required = true},
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "SIGY", .dimension = "stress", .low = 0.0},
    {.name = "ETAN", .dimension = "stress", .low = 0.0},
    {.name = "FAIL", .dimension = "-", .low = 0.0},
    {.name = "TDEL", .dimension = "time", .low = 0.0},
    {.name = "C", .dimension = "1/time", .low = 0.0},
    {.name = "P", .dimension = "-", .low = 0.0},
    {.name = "LCSS", .dimension = "-", .low = 0.0},
    {.name = "LCSR", .dimension = "-", .low = 0.0},
    {.name = "VP", .dimension = "-", .low = -1.0, .high = 1.0},
    {.name = "EPS1", .dimension = "-", .low = 0.0},
    {.name = "EPS2", .dimension = "-", .low = 0.0},
    {.name = "EPS3", .dimension = "-", .low = 0.0},
    {.name = "EPS4", .dimension = "-", .low = 0.0},
    {.name = "EPS5", .dimension = "-", .low = 0.0},
    {.name = "EPS6", .dimension = "-", .low = 0.0},
    {.name = "EPS7", .dimension = "-", .low = 0.0},
    {.name = "EPS8", .dimension = "-", .low = 0.0},
    {.name = "ES1", .dimension = "stress", .low = 0.0},
    {.name = "ES2", .dimension = "stress", .low = 0.0},
    {.name = "ES3", .dimension = "stress", .low = 0.0},
    {.name = "ES4", .dimension = "stress", .low = 0.0},
    {.name = "ES5", .dimension = "stress", .low = 0.0},
    {.name = "ES6", .dimension = "stress", .low = 0.0},
    {.name = "ES7", .dimension = "stress", .low = 0.0},
    {.name = "ES8", .dimension = "stress", .low = 0.0},
};

/// The eight points of the card, up to the last one with a strain; empty if none is given.
Curve points_of(const deck::Card& card) {
  Curve curve;
  int count = 0;
  for (int i = 1; i <= 8; ++i)
    if (card["EPS" + std::to_string(i)] > 0.0) count = i;
  for (int i = 1; i <= count; ++i) {
    curve.x.push_back(card["EPS" + std::to_string(i)]);
    curve.y.push_back(card["ES" + std::to_string(i)]);
  }
  return curve;
}

/// Curves and rates the card asks for, in the order LCSS, points, SIGY with ETAN. False after an error.
bool collect(const deck::Card& card, const LawContext& context, std::vector<Curve>& rows,
             std::vector<double>& rates) {
  const auto fail = [&](std::string_view field, std::string message) {
    context.diagnostics.error(card.place(field), card.keyword(), std::string(field), std::move(message));
    return false;
  };
  if (const Id id = card.integer("LCSS")) {
    if (const Curve* curve = context.curve(id)) {
      rows = {*curve};
    } else if (const Table* table = context.table(id)) {
      for (const Index i : table->curve) rows.push_back(context.curves[i]);
      rates = table->value;
    } else {
      return fail("LCSS", "no curve or table " + std::to_string(id));
    }
    if (rows.empty()) return fail("LCSS", "the table has no curves");
    return true;
  }
  rows = {points_of(card)};
  if (!rows[0].x.empty()) return true;
  const double e = card["E"], yield = card["SIGY"], tangent = card["ETAN"];
  if (yield <= 0.0) return fail("SIGY", "give a yield stress, the points EPS1 ES1 ..., or the curve LCSS");
  if (tangent >= e) return fail("ETAN", "the tangent modulus must be below Young's modulus");
  rows[0].x = {0.0, 1.0};
  rows[0].y = {yield, yield + e * tangent / (e - tangent)};
  return true;
}

std::unique_ptr<Law> build(const deck::Card& card, const LawContext& context) {
  std::vector<Curve> rows;
  std::vector<double> rates;
  if (!collect(card, context, rows, rates)) return nullptr;

  PiecewiseLinearPlasticity law{.elastic = Moduli::from(card["E"], card["PR"]),
                                .viscoplastic = card["VP"] == 1.0,
                                .symonds = {.reference = card["C"], .exponent = card["P"]},
                                .failure_strain = card["FAIL"] > 0.0 ? card["FAIL"] : 1e300,
                                .density = card["RO"],
                                .least_step = card["TDEL"]};
  std::string problem;
  law.hardening = FlowCurve::from(rows, rates, 3.0 * law.elastic.shear, problem);
  if (!problem.empty()) {
    context.diagnostics.error(card.place("LCSS"), card.keyword(), "LCSS", problem);
    return nullptr;
  }
  // A first value below zero says that the values are logarithms of rates.
  law.hardening.logarithmic = !law.hardening.rate.empty() && law.hardening.rate.front() < 0.0;

  if (rows.size() > 1) {
    law.form = Rate::table;
  } else if (const Id id = card.integer("LCSR")) {
    const Curve* curve = context.curve(id);
    if (!curve) {
      context.diagnostics.error(card.place("LCSR"), card.keyword(), "LCSR", "no curve " + std::to_string(id));
      return nullptr;
    }
    law.form = Rate::curve;
    law.factors = {curve->x, curve->y};
    auto& r = law.factors.rate;  // a jump becomes a steep segment
    for (std::size_t i = 1; i < r.size(); ++i)
      r[i] = std::max(r[i], r[i - 1] + 1e-9 * (r.back() - r.front()));
  } else if (law.symonds.active()) {
    law.form = Rate::symonds;
    // Viscoplastic: the rate adds to SIGY alone, or scales the curve where SIGY is not given.
    if (law.viscoplastic) law.added = card["SIGY"];
  }
  if (law.form == Rate::none) law.viscoplastic = false;
  return std::make_unique<TiledLaw<PiecewiseLinearPlasticity>>(std::move(law));
}

}  // namespace

extern const LawEntry piecewise_linear_plasticity{"MAT_PIECEWISE_LINEAR_PLASTICITY", fields, build,
                                                  "Simo & Hughes 1998, sec. 3.3; Cowper & Symonds 1957"};

}  // namespace cleave::model
