#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "results/summary.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

/// Is a part a round bar or ball about an axis at the start? Its diameter is then that of its box.
bool round(const Extent& before, const PartAxes& axes, int k) {
  double width[2];
  for (int i = 0; i < 2; ++i) {
    const int j = (k + 1 + i) % 3;
    width[i] = before.length(j) * (axes.symmetry[j] ? 2.0 : 1.0);
  }
  const double wide = std::max(width[0], width[1]), narrow = std::min(width[0], width[1]);
  return narrow > 0.95 * wide && before.diameter[k] < 1.05 * wide;
}

/// Is the middle of the part still on that axis? Else its distance from there is no diameter.
bool on_axis(const Extent& before, const Extent& after, const PartAxes& axes, int k) {
  for (int i = 1; i < 3; ++i) {
    const int j = (k + i) % 3;
    const double off = 0.5 * (after.low[j] + after.high[j]) - axes.centre[j];
    if (!axes.symmetry[j] && std::abs(off) > 0.05 * before.diameter[k]) return false;
  }
  return true;
}

/// One part: its mass, then a line per axis with its length before and after, and its diameter about the axes
/// about which it is round.
void append_part(std::string& out, const model::Part& part, double mass, const Extent& before,
                 const Extent& after, const PartAxes& axes) {
  append_format(out, "\npart %lld  %s: %zu elements, mass %.6g", static_cast<long long>(part.id),
                part.title.c_str(), before.elements, mass);
  if (after.elements < before.elements) append_format(out, ", %zu eroded", before.elements - after.elements);
  const bool diameters = round(before, axes, 0) || round(before, axes, 1) || round(before, axes, 2);
  out += "\n  axis      length before        after   change";
  out += diameters ? "    diameter before        after   change\n" : "\n";
  const auto change = [](double from, double to) { return from > 0.0 ? 100.0 * (to / from - 1.0) : 0.0; };
  for (int k = 0; k < 3; ++k) {
    append_format(out, "  %c          %12.6g %12.6g %+7.2f%%", "xyz"[k], before.length(k), after.length(k),
                  change(before.length(k), after.length(k)));
    if (round(before, axes, k)) {
      append_format(out, "       %12.6g", before.diameter[k]);
      if (on_axis(before, after, axes, k))
        append_format(out, " %12.6g %+7.2f%%", after.diameter[k],
                      change(before.diameter[k], after.diameter[k]));
      else
        out += "  off its axis";
    }
    out += '\n';
  }
  for (int k = 0; k < 3; ++k)
    if (axes.symmetry[k])
      append_format(out, "  symmetric about the plane %c = %.6g%s\n", "xyz"[k], axes.centre[k],
                    diameters ? "; the diameters count the other half" : "");
}

}  // namespace

std::string Summary::text(const solver::Outcome& outcome) const {
  std::string out = "\n";
  const auto line = [&](const char* label) { append_format(out, "%-14s", label); };
  line(is_normal(ending_) ? "ended" : "STOPPED");
  append_format(out, "%s, at time %.6g after %lld cycles\n", std::string(describe(ending_)).c_str(), time_,
                static_cast<long long>(cycles_));
  if (!status_.ok) {
    line("");
    if (status_.element > 0) append_format(out, "element %lld: ", static_cast<long long>(status_.element));
    out += status_.what + '\n';
    if (!status_.likely_cause.empty()) {
      line("");
      out += status_.likely_cause + '\n';
    }
  }
  if (cycles_ > 0) {
    line("time step");
    append_format(out, "%.4g at last, between %.4g and %.4g\n", last_step_, step_.low, step_.high);
  }
  line("energies");
  append_format(out, "kinetic %.6g, internal %.6g, hourglass %.4g, external work %.6g\n", energy_.kinetic,
                energy_.internal, energy_.hourglass, energy_.external);
  line("");
  append_format(out, "total %.6g, ratio %.5f (%.5f to %.5f)\n", energy_.total(), energy_.ratio(), ratio_.low,
                ratio_.high);
  if (energy_.wall != 0.0 || energy_.damping != 0.0 || energy_.sliding != 0.0) {
    line("");
    append_format(out, "walls %.4g, damping %.4g, contact %.4g\n", energy_.wall, energy_.damping,
                  energy_.sliding);
  }
  if (energy_.eroded_internal != 0.0 || energy_.eroded_kinetic != 0.0) {
    line("");
    append_format(out, "eroded: kinetic %.4g, internal %.4g, hourglass %.4g\n", energy_.eroded_kinetic,
                  energy_.eroded_internal, energy_.eroded_hourglass);
  }
  if (added_mass_ > 0.0) {
    line("added mass");
    append_format(out, "%.4g (%.3f %%)\n", added_mass_,
                  base_mass_ > 0.0 ? 100.0 * added_mass_ / base_mass_ : 0.0);
  }
  for (std::size_t p = 0; p < parts_.size(); ++p)
    if (parts_[p].before.elements > 0)
      append_part(out, context_.model.parts[p], parts_[p].mass, parts_[p].before, parts_[p].after,
                  parts_[p].axes);

  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  out += '\n';
  line("speed");
  const double rate = outcome.seconds > 0.0 ? outcome.element_cycles / outcome.seconds : 0.0;
  append_format(out, "%s element-cycles/s", count_text(rate).c_str());
  if (rate > 0.0) append_format(out, " (%.0f ns each)", 1.0e9 / rate);
  append_format(out, " on %d thread%s, %s in all, %.0f MB\n", base::thread_count(),
                base::thread_count() == 1 ? "" : "s", duration(outcome.seconds).c_str(),
                static_cast<double>(usage.ru_maxrss) / 1024.0);
  if (!outcome.phases.empty() && outcome.seconds > 0.0) {
    line("");
    for (std::size_t i = 0; i < outcome.phases.size(); ++i)
      append_format(out, "%s%s %.1f %%", i ? ", " : "", outcome.phases[i].name.c_str(),
                    100.0 * outcome.phases[i].seconds / outcome.seconds);
    out += '\n';
  }
  for (const solver::Fact& fact : outcome.facts) {
    std::string name = fact.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    append_format(out, "  %-26s %.6g\n", name.c_str(), fact.value);
  }
  if (context_.trouble.any()) {
    line("FILES");
    out += context_.trouble.what() + '\n';
  }
  return out;
}

}  // namespace cleave::results
