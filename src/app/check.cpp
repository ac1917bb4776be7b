#include "model/check.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/account.hpp"
#include "app/simulate.hpp"
#include "discretisation/spacetime/estimate.hpp"
#include "model/keyword/row_place.hpp"
#include "model/report.hpp"

namespace cleave::app {
namespace {

void print_parts(const model::ModelReport& report) {
  std::printf("\n  %8s %9s %12s %12s %10s %10s  %s\n", "part", "elements", "volume", "mass", "jacobian",
              "aspect", "title");
  for (const model::PartReport& part : report.parts)
    std::printf("  %8lld %9zu %12.5g %12.5g %10.3f %10.3g  %s\n", static_cast<long long>(part.id),
                part.elements, part.volume, part.mass, part.worst_jacobian, part.worst_aspect,
                part.title.c_str());
  std::printf(
      "  (jacobian: least corner ratio, 1 is a brick; aspect: largest ratio of edges in an element)\n");
}

/// Of parts solved in spacetime: what limits the tents, and where.
void print_tents(const model::Model& model, const model::ModelReport& report) {
  const auto tents = discretisation::spacetime::estimate_tents(model);
  if (tents.lowest == 0.0) return;
  const auto flattest =
      std::min_element(report.parts.begin(), report.parts.end(), [](const auto& a, const auto& b) {
        return a.least_height_element != 0 &&
               (b.least_height_element == 0 || a.least_height < b.least_height);
      });
  std::printf("\n  least height %.4g, of element %lld of part %lld\n", flattest->least_height,
              static_cast<long long>(flattest->least_height_element), static_cast<long long>(flattest->id));
  std::printf("  first tents  %.4g (node %lld at %.5g %.5g %.5g) to %.4g high", tents.lowest,
              static_cast<long long>(tents.lowest_at), tents.position[0], tents.position[1],
              tents.position[2], tents.highest);
  if (tents.patches > 0.0)
    std::printf("; about %.2g to the end at %.4g", tents.patches, model.control.end.time);
  std::printf("\n");
}

/// Step and memory from the blocks themselves, so that they are those of a run.
void print_costs(const model::Model& model, const discretisation::World& world,
                 discretisation::State& state) {
  double least = 1.0e30, bytes = 0.0;
  long long element = 0;
  std::size_t elements = 0;
  for (std::size_t b = 0; b < world.blocks.size(); ++b) {
    const auto& block = *world.blocks[b];
    const auto ids = block.element_ids();
    std::vector<double> steps(ids.size());
    block.stable_steps(state.position, state.blocks[b], steps);
    const auto at = std::min_element(steps.begin(), steps.end());
    if (at != steps.end() && *at < least) {
      least = *at;
      element = ids[static_cast<std::size_t>(at - steps.begin())];
    }
    bytes += block.bytes_per_element() * static_cast<double>(ids.size());
    elements += ids.size();
  }
  if (elements == 0) return;
  const double step = least * model.control.step.safety;
  const double nodes = 8.0 * 10.0 * static_cast<double>(world.node_count());  // ten numbers a node
  std::printf("\n  time step  %.4g (element %lld, with safety factor %.3g)", step, element,
              model.control.step.safety);
  if (model.control.end.time > 0.0)
    std::printf("; about %.0f cycles to the end at %.4g", model.control.end.time / step,
                model.control.end.time);
  std::printf("\n  memory     %.3g MiB, %.0f bytes per element\n", (bytes + nodes) / 1048576.0,
              (bytes + nodes) / static_cast<double>(elements));
}

}  // namespace

int check(const Options& options) {
  // Without an end time nothing runs, but everything else can be told.
  Reading reading = read_deck(options, false);
  auto world = reading.failed() ? nullptr : world_of(reading);
  // What makes spacetime parts computable is in their solver; it has much to say against a deck.
  if (world && world->blocks.empty()) solver_of(*world, {}, reading.diagnostics);
  const bool complete = !reading.failed();
  if (complete) model::check_end_time(reading.model, *reading.deck, reading.diagnostics);
  model::find_rows(*reading.deck, reading.diagnostics);
  print_diagnostics(reading);
  std::printf("%s\n\n%s", reading.model.title.empty() ? options.input.c_str() : reading.model.title.c_str(),
              table_of(reading.account).c_str());
  if (!complete) return bad_deck;

  const model::ModelReport report = model::report(reading.model);
  print_parts(report);
  std::printf("\n  %zu nodes, %zu elements, mass %.6g, volume %.6g\n", report.nodes, report.elements,
              report.mass, report.volume);
  std::printf("  box        %.5g %.5g %.5g to %.5g %.5g %.5g\n", report.low[0], report.low[1], report.low[2],
              report.high[0], report.high[1], report.high[2]);
  if (!report.units.empty()) std::printf("  units      probably %s\n", report.units.c_str());

  print_tents(reading.model, report);
  discretisation::State state;
  const auto status = discretisation::initialise(*world, state);
  if (!status.ok) {
    print_unfit(reading, status);
    return bad_deck;
  }
  print_costs(reading.model, *world, state);
  return reading.failed() ? bad_deck : done;
}

}  // namespace cleave::app
