#include "model/material/flow_curve.hpp"

#include <algorithm>

namespace cleave::model {
namespace {

/// Points of one curve with strictly ascending abscissae from 0: a jump becomes a very steep segment.
void tidy(std::vector<double>& x, std::vector<double>& y) {
  const double span = std::max(x.back() - x.front(), 1e-6);
  for (std::size_t i = 1; i < x.size(); ++i) x[i] = std::max(x[i], x[i - 1] + 1e-9 * span);
  if (x.front() > 0.0) {
    x.insert(x.begin(), 0.0);
    y.insert(y.begin(), y.front());
  }
}

/// Linear interpolation, going on with the first and last slope.
double at(const std::vector<double>& x, const std::vector<double>& y, double e) {
  if (x.size() == 1) return y[0];
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, e) - x.begin();
  const double slope = (y[above] - y[above - 1]) / (x[above] - x[above - 1]);
  return y[above - 1] + slope * (e - x[above - 1]);
}

}  // namespace

FlowCurve FlowCurve::from(const std::vector<Curve>& rows, std::vector<double> rates, double stiffness,
                          std::string& problem) {
  FlowCurve result;
  if (rows.size() > most_rows) {
    problem = "at most 64 curves over strain rate are taken";
    return result;
  }
  std::vector<std::vector<double>> x, y;
  for (const Curve& row : rows) {
    if (row.x.empty() || row.x.front() < 0.0) {
      problem = "the flow curve needs points at plastic strains from 0";
      return result;
    }
    x.push_back(row.x);
    y.push_back(row.y);
    if (*std::min_element(y.back().begin(), y.back().end()) < 0.0 || y.back().front() <= 0.0) {
      problem = "the flow stress must be positive";
      return result;
    }
    tidy(x.back(), y.back());
    // A last segment that falls goes on to zero stress and stays there.
    auto& xs = x.back();
    auto& ys = y.back();
    const std::size_t last = xs.size() - 1;
    if (last > 0 && ys[last] < ys[last - 1]) {
      const double fall = (ys[last - 1] - ys[last]) / (xs[last] - xs[last - 1]);
      const double end = std::max(xs[last] + ys[last] / fall, xs[last] * (1.0 + 1e-9));
      xs.insert(xs.end(), {end, 2.0 * end});
      ys.insert(ys.end(), {0.0, 0.0});
    }
  }

  for (const auto& xs : x) result.strain.insert(result.strain.end(), xs.begin(), xs.end());
  std::sort(result.strain.begin(), result.strain.end());
  result.strain.erase(std::unique(result.strain.begin(), result.strain.end()), result.strain.end());
  if (result.strain.size() == 1) result.strain.push_back(1.0);
  if (rows.size() > 1) result.rate = std::move(rates);

  const std::size_t points = result.strain.size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (double e : result.strain) result.stress.push_back(at(x[r], y[r], e));
    const double* stress = &result.stress[r * points];
    for (std::size_t k = 0; k + 1 < points; ++k) {
      const double slope = (stress[k + 1] - stress[k]) / (result.strain[k + 1] - result.strain[k]);
      if (slope <= -0.999 * stiffness) {
        problem =
            "the flow curve falls more steeply than three times the shear modulus; no step can follow it";
        return {};
      }
      result.slope.push_back(slope);
    }
    result.slope.push_back(result.slope.back());
  }
  return result;
}

}  // namespace cleave::model
