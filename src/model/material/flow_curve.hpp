#pragma once
/// Flow stress from points: a piecewise linear curve over plastic strain, or a family of them over strain
/// rate.

#include <memory>
#include <string>
#include <vector>

#include "model/curve.hpp"
#include "model/material/flow.hpp"
#include "model/material/law.hpp"

namespace cleave::model {

/// Points are used as given, none is resampled: the curves of a family are brought to the union of their
/// abscissae, where each stays exactly what it was. Beyond the last point the last slope goes on, but the
/// stress stays positive; between rates stress is interpolated linearly in the rate or in its logarithm,
/// beyond the first and last rate it stays.
struct FlowCurve {
  std::vector<double> strain;  ///< [point], ascending from 0 [-]
  std::vector<double> rate;    ///< [row]; empty for a single curve [1/time] or its natural logarithm
  bool logarithmic = false;
  std::vector<double> stress, slope;  ///< [row][point]; slope of the segment that starts there [stress]

  static constexpr int most_rows = 64;

  int point_count() const { return static_cast<int>(strain.size()); }
  int row_count() const { return rate.empty() ? 1 : static_cast<int>(rate.size()); }
  double initial() const { return stress.front(); }

  /// @param rows one curve per rate. Reports to `problem` and returns an empty curve when they cannot be
  /// used.
  static FlowCurve from(const std::vector<Curve>& rows, std::vector<double> rates, double stiffness,
                        std::string& problem);
};

/// Shares of the curves of a family in the flow stress at one rate; no rows for a single curve. The shares
/// themselves are set only as far as there are rows: this is made once per point and step.
template <class Real>
struct RowShares {
  int rows = 0;
  Real share[FlowCurve::most_rows];
};

/// Hat functions over the rows, and their slope with respect to `at` if asked for.
template <class Real>
void share_rows(const FlowCurve& curve, const Real& rate, RowShares<Real>& shares, RowShares<Real>* slopes) {
  const int rows = curve.row_count();
  const Real zero(0.0), one(1.0);
  const Real at = curve.logarithmic ? log(positive(rate)) : rate;
  const Real inner = curve.logarithmic ? one / positive(rate) : one;
  shares.rows = rows;
  for (int r = 0; r < rows; ++r) shares.share[r] = zero;
  if (slopes) {
    slopes->rows = rows;
    for (int r = 0; r < rows; ++r) slopes->share[r] = zero;
  }
  shares.share[0] = one;
  for (int r = 0; r + 1 < rows; ++r) {
    const double width = 1.0 / (curve.rate[r + 1] - curve.rate[r]);
    const Real part = min(max((at - Real(curve.rate[r])) * Real(width), zero), one);
    shares.share[r] = shares.share[r] - part;  // the share above row r is handed to row r + 1
    shares.share[r + 1] = part;
    if (slopes) {
      const Real slope = select((part > zero) & (part < one), inner * Real(width), zero);
      slopes->share[r] = slopes->share[r] - slope;
      slopes->share[r + 1] = slope;
    }
  }
}

/// The value at point k of the table `of`, weighted over the rows.
template <class Real>
Real weighted(const FlowCurve& curve, const std::vector<double>& of, const RowShares<Real>& shares, int k) {
  if (shares.rows == 0) return Real(of[k]);
  const int points = curve.point_count();
  Real sum = shares.share[0] * Real(of[k]);
  for (int r = 1; r < shares.rows; ++r) sum = sum + shares.share[r] * Real(of[r * points + k]);
  return sum;
}

/// A segment of the weighted curve: stress = base + slope (strain - start).
template <class Real>
struct CurveSegment {
  Real start, base, slope;
};

/// The segment that holds the strain e.
template <class Real>
CurveSegment<Real> segment_at(const FlowCurve& curve, const RowShares<Real>& shares, const Real& e) {
  CurveSegment<Real> s{Real(curve.strain[0]), weighted(curve, curve.stress, shares, 0),
                       weighted(curve, curve.slope, shares, 0)};
  for (int k = 1; k < curve.point_count(); ++k) {
    const auto reached = Real(curve.strain[k]) <= e;
    if (!any(reached)) break;
    s.start = select(reached, Real(curve.strain[k]), s.start);
    s.base = select(reached, weighted(curve, curve.stress, shares, k), s.base);
    s.slope = select(reached, weighted(curve, curve.slope, shares, k), s.slope);
  }
  return s;
}

/// Increment x >= 0 with q = stiffness x + factor stress(e + x): exact, the segment found by comparing q with
/// the right side at each point.
template <class Real>
Real curve_flow(const FlowCurve& curve, const RowShares<Real>& shares, const Real& q, double stiffness,
                const Real& factor, const Real& e) {
  const Real k3(stiffness);
  CurveSegment<Real> s{Real(curve.strain[0]), weighted(curve, curve.stress, shares, 0),
                       weighted(curve, curve.slope, shares, 0)};
  auto reached = q >= q;
  for (int k = 1; k < curve.point_count(); ++k) {
    const Real start(curve.strain[k]), base = weighted(curve, curve.stress, shares, k);
    reached = reached & (factor * base + k3 * (start - e) <= q);
    if (!any(reached)) break;
    s.start = select(reached, start, s.start);
    s.base = select(reached, base, s.base);
    s.slope = select(reached, weighted(curve, curve.slope, shares, k), s.slope);
  }
  const Real beyond = q - factor * s.base - k3 * (s.start - e);
  const Real end = s.start + beyond / max(k3 + factor * s.slope, Real(1e-6 * stiffness));
  return max(end - e, Real(0.0));
}

/// The curve as the hardening of viscoplastic_flow; a family takes the rate of the increment itself.
template <class Real>
class CurveHardening {
 public:
  CurveHardening(const FlowCurve& curve, const Real& strain, double inverse_dt)
      : curve_(curve), strain_(strain), inverse_dt_(inverse_dt) {}

  Real start() const { return value(Real(0.0)); }
  Real value(const Real& x) const {
    RowShares<Real> shares;
    if (!curve_.rate.empty()) share_rows<Real>(curve_, x * Real(inverse_dt_), shares, nullptr);
    const auto s = segment_at(curve_, shares, strain_ + x);
    return s.base + s.slope * (strain_ + x - s.start);
  }
  Real slope(const Real& x) const {
    RowShares<Real> shares, slopes;
    if (curve_.rate.empty()) return segment_at(curve_, shares, strain_ + x).slope;
    share_rows<Real>(curve_, x * Real(inverse_dt_), shares, &slopes);
    const auto s = segment_at(curve_, shares, strain_ + x), t = segment_at(curve_, slopes, strain_ + x);
    return s.slope + (t.base + t.slope * (strain_ + x - t.start)) * Real(inverse_dt_);
  }
  Real bound(const Real&) const { return Real(1e300); }

 private:
  const FlowCurve& curve_;
  const Real& strain_;
  double inverse_dt_;
};

/// Yield scale over strain rate from a curve (LCSR); end values are kept.
struct RateCurve {
  std::vector<double> rate, factor;

  /// Factor and its slope over the rate.
  template <class Real>
  std::pair<Real, Real> at(const Real& r) const {
    Real value(factor[0]), slope(0.0);
    for (std::size_t k = 0; k + 1 < rate.size(); ++k) {
      const double rise = (factor[k + 1] - factor[k]) / (rate[k + 1] - rate[k]);
      const auto reached = r >= Real(rate[k]);
      const auto passed = r >= Real(rate[k + 1]);
      value =
          select(reached, Real(factor[k]) + Real(rise) * (min(r, Real(rate[k + 1])) - Real(rate[k])), value);
      slope = select(reached, select(passed, Real(0.0), Real(rise)), slope);
    }
    return {value, slope};
  }
};

/// The same as a rate law of viscoplastic_flow.
class CurveRate {
 public:
  CurveRate(const RateCurve& curve, double inverse_dt) : curve_(curve), inverse_dt_(inverse_dt) {}

  template <class Real>
  RateTerm<Real> term(const Real& u) const {
    const Real rate = exp(u) * Real(inverse_dt_);
    const auto [factor, slope] = curve_.at(rate);
    return {factor, slope * rate, Real(0.0), Real(0.0)};
  }
  template <class Real>
  Real bound(const Real&, const Real&) const {
    return Real(1e300);
  }

 private:
  const RateCurve& curve_;
  double inverse_dt_;
};

}  // namespace cleave::model
