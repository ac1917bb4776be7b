#include "solver/tents_patches.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace cleave::solver {

using namespace discretisation::spacetime;
using Clock = std::chrono::steady_clock;

namespace {

// Rounding leaves 1e-14 of both: these are orders above it, and far below any fault of a facet law.
constexpr double momentum_tolerance = 1e-12;  // of the largest flux of the patch
constexpr double energy_tolerance = 1e-10;    // of the largest energy of the patch
constexpr double never = std::numeric_limits<double>::infinity();

double seconds(Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

Verdict verdict_of(PatchStatus status) {
  switch (status) {
    case PatchStatus::solved:
      return {};
    case PatchStatus::degenerate:
      return {Verdict::fail, 0.5, "a spacetime element has no volume"};
    case PatchStatus::singular:
      return {Verdict::lower, 0.9, "the patch is singular: a facet lies on the characteristic cone"};
    case PatchStatus::tilted_interface:  // the next try stands upright
      return {Verdict::lower, 0.99, "a facet between two materials is not vertical"};
    case PatchStatus::not_converged:
      return {Verdict::lower, 0.5, "the laws on the facets of a patch did not converge"};
  }
  return {Verdict::fail, 0.5, "the patch was not solved"};
}

}  // namespace

void Tally::add(const Tally& other) {
  patches += other.patches;
  elements += other.elements;
  unknowns += other.unknowns;
  worst_momentum = std::max(worst_momentum, other.worst_momentum);
  worst_energy = std::max(worst_energy, other.worst_energy);
  solving += other.solving;
  checking += other.checking;
}

template <int D>
void PatchRunner<D>::solve(std::span<const Patch> patches, std::span<Verdict> verdicts, bool verified) {
  const auto started = Clock::now();
  Worker& w = *take_worker();
  if (w.solution.size() < patches.size()) w.solution.resize(patches.size()), w.older.resize(patches.size());
  w.jobs.clear();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Patch& patch = patches[k];
    const std::size_t count = patch.elements.size();
    if (w.solution[k].size() < count) w.solution[k].resize(count);
    w.older[k].assign(patch.facets.size(), nullptr);
    for (std::size_t f = 0; f < patch.facets.size(); ++f)
      if (patch.facets[f].kind == FacetKind::inflow)
        w.older[k][f] =
            columns_.under(patch.elements[static_cast<std::size_t>(patch.facets[f].element)].simplex);
    w.jobs.push_back({.patch = &patch, .older = w.older[k], .out = {w.solution[k].data(), count}});
  }
  w.solver.solve(w.jobs);
  w.tally.solving += seconds(Clock::now() - started);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    verdicts[k] = verdict_of(w.jobs[k].status);
    const std::span<Solution> out = w.jobs[k].out;
    if (verdicts[k].kind == Verdict::accept && verified) {
      const auto before = Clock::now();
      verdicts[k] = check(patches[k], w, w.older[k], out);
      w.tally.checking += seconds(Clock::now() - before);
    }
    if (verdicts[k].kind != Verdict::accept) continue;
    commit(patches[k], w, out, verified);
    ++w.tally.patches;
    w.tally.elements += static_cast<std::int64_t>(out.size());
    w.tally.unknowns += w.jobs[k].unknowns;
  }
  give_worker(&w);
}

template <int D>
void PatchRunner<D>::commit(const Patch& patch, Worker& w, std::span<Solution> solution, bool verified) {
  columns_.commit(patch, solution);
  for (std::size_t e = 0; e < patch.elements.size(); ++e) {
    SolvedElement<D>& element = columns_.last(patch.elements[e].simplex);
    if (verified) element.exchange.dissipation = w.verify.element_dissipation[e];
    element.exchange = outside_.before(patch.elements[e].simplex, element, never);
  }
}

template <int D>
Verdict PatchRunner<D>::check(const Patch& patch, Worker& w, std::span<const Solution* const> older,
                              std::span<const Solution> solution) const {
  w.solver.verify(patch, older, solution, w.verify);
  w.tally.worst_momentum = std::max(w.tally.worst_momentum, w.verify.momentum);
  w.tally.worst_energy = std::max(w.tally.worst_energy, w.verify.energy);
  if (!(w.verify.momentum <= momentum_tolerance))
    return broken(patch, "momentum is not balanced", w.verify.momentum, momentum_tolerance);
  if (!(w.verify.energy <= energy_tolerance))
    return broken(patch, "the energy identity does not hold", w.verify.energy, energy_tolerance);
  return {};
}

template <int D>
Verdict PatchRunner<D>::broken(const Patch& patch, std::string what, double value, double limit) const {
  char numbers[96];
  std::snprintf(numbers, sizeof numbers, ": relative residual %.3g, limit %.3g", value, limit);
  what += numbers;
  what += " in the patch of element " +
          std::to_string(body_.element_of_simplex[static_cast<std::size_t>(patch.elements[0].simplex)]);
  return {Verdict::fail, 0.5, what};
}

template <int D>
Tally PatchRunner<D>::take() {
  Tally all;
  for (const auto& worker : workers_) {
    all.add(worker->tally);
    worker->tally = {};
  }
  return all;
}

template <int D>
typename PatchRunner<D>::Worker* PatchRunner<D>::take_worker() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) {
    workers_.push_back(std::make_unique<Worker>(body_.problem));
    idle_.push_back(workers_.back().get());
  }
  Worker* worker = idle_.back();
  idle_.pop_back();
  return worker;
}

template <int D>
void PatchRunner<D>::give_worker(Worker* worker) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(worker);
}

template class PatchRunner<1>;
template class PatchRunner<2>;
template class PatchRunner<3>;

}  // namespace cleave::solver
