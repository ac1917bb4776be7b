#include "solver/tents_instants.hpp"

#include <algorithm>

namespace cleave::solver {
namespace {

constexpr double same = 1e-9;             // of the end time
constexpr double energy_outputs = 100.0;  // where the deck does not say how many

void add(const model::Interval& interval, const model::Model& model, double end, std::vector<double>& out) {
  if (interval.curve >= 0) {
    const model::Curve& curve = model.curves[static_cast<std::size_t>(interval.curve)];
    double step = curve.value(0.0);
    for (double t = step; step > same * end && t < end; t += step) {
      out.push_back(t);
      step = curve.value(t);
    }
  } else if (interval.every > same * end) {
    for (double k = 1.0; k * interval.every < end; k += 1.0) out.push_back(k * interval.every);
  }
}

/// All but those of nodout and elout, in no order.
std::vector<double> instants_of_energies(const model::Model& model, double end_time) {
  const model::Requests& wanted = model.requests;
  model::Interval energies = wanted.glstat;
  if (!energies.active()) energies.every = end_time / energy_outputs;
  std::vector<double> all;
  for (const model::Interval& interval : {energies, wanted.field, wanted.matsum, wanted.spcforc})
    add(interval, model, end_time, all);
  return all;
}

}  // namespace

std::vector<double> output_instants(const model::Model& model, double end_time) {
  std::vector<double> all = instants_of_energies(model, end_time);
  add(model.requests.nodout, model, end_time, all);
  if (model.requests.any_element()) add(model.requests.elout, model, end_time, all);
  std::sort(all.begin(), all.end());
  std::vector<double> instants;
  for (const double t : all)
    if ((instants.empty() || t > instants.back() + same * end_time) && t < end_time * (1.0 - same))
      instants.push_back(t);
  instants.push_back(end_time);
  return instants;
}

std::vector<char> energy_instants(const model::Model& model, const std::vector<double>& instants) {
  const double end = instants.back();
  std::vector<char> due(instants.size(), 0);
  due.back() = 1;
  for (const double t : instants_of_energies(model, end)) {
    const auto at = std::lower_bound(instants.begin(), instants.end(), t - same * end);
    if (at != instants.end()) due[static_cast<std::size_t>(at - instants.begin())] = 1;
  }
  return due;
}

std::vector<std::size_t> pauses(const std::vector<double>& instants, double shortest) {
  std::vector<std::size_t> last;
  for (std::size_t first = 0; first < instants.size(); first = last.back() + 1) {
    std::size_t k = first;
    while (k + 1 < instants.size() && instants[k + 1] <= instants[first] + shortest) ++k;
    last.push_back(k);
  }
  return last;
}

}  // namespace cleave::solver
