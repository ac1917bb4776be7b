#include "discretisation/spacetime/patch_solver.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"

namespace cleave::discretisation::spacetime {
namespace {

constexpr int most_iterations = 40;
constexpr double star_tolerance = 1e-10;  ///< change of the star values between iterates, relative

}  // namespace

template <int D>
PatchSolver<D>::PatchSolver(const Problem<D>& problem) : problem_(problem), bonded_(make_bonded<D>()) {
  CLEAVE_ASSERT(problem.spaces.size() == problem.materials.size(), "one local space per material");
}

template <int D>
SpaceChoice PatchSolver<D>::choice(const PatchElement<D>& element, std::size_t index,
                                   std::span<const SpaceChoice> choices) const {
  SpaceChoice c =
      choices.empty() ? problem_.spaces[static_cast<std::size_t>(element.material)] : choices[index];
  // Trefftz functions solve the homogeneous equation of motion only.
  if (problem_.body_force && c.space == LocalSpace::trefftz)
    c = {LocalSpace::three_field, std::max(1, c.degree - 1)};
  return c;
}

template <int D>
const TrefftzTable<D>* PatchSolver<D>::table(SpaceChoice c, int material) {
  if (c.space != LocalSpace::trefftz) return nullptr;
  auto& entry = tables_[{material, c.degree}];
  if (!entry)
    entry =
        std::make_unique<TrefftzTable<D>>(problem_.materials[static_cast<std::size_t>(material)], c.degree);
  return entry.get();
}

template <int D>
bool PatchSolver<D>::is_linear(const Patch<D>& patch) const {
  for (const Facet<D>& f : patch.facets)
    if ((f.kind == FacetKind::interior || f.kind == FacetKind::boundary) && !target(f).linear()) return false;
  return true;
}

template <int D>
bool PatchSolver<D>::repeats(const Patch<D>& patch) const {
  return patch.shape && !problem_.body_force && !keep_matrix && is_linear(patch);
}

template <int D>
PatchStatus PatchSolver<D>::solve(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                                  std::span<Solution<D>> out, std::span<const SpaceChoice> choices) {
  CLEAVE_ASSERT(out.size() == patch.elements.size() && older.size() == patch.facets.size(),
                "arrays of a patch");
  if (choices.empty() && repeats(patch)) {
    PatchJob<D> job{.patch = &patch, .older = older, .out = out};
    solve({&job, 1});
    return job.status;
  }
  count_ = static_cast<int>(patch.elements.size());
  if (elements_.size() < patch.elements.size()) elements_.resize(patch.elements.size());
  stars_.clear();
  const bool linear = is_linear(patch);
  origin_ = {};
  pivoting_ = false;
  bool again = false;  // the same iterate, with pivoting
  for (iterations_ = 1;; ++iterations_) {
    if (!begin(patch, choices)) return PatchStatus::degenerate;
    const PatchStatus status = assemble(patch, older, iterations_ > 1 ? out : std::span<Solution<D>>{});
    if (status != PatchStatus::solved) return status;
    // The star values of the last iterate have been compared with those before it while assembling.
    if (!linear && iterations_ > 1 && !again && star_change_ <= star_tolerance * star_size_)
      return PatchStatus::solved;
    if (iterations_ > most_iterations) return PatchStatus::not_converged;
    if (!eliminate()) {
      if (pivoting_) return PatchStatus::singular;
      pivoting_ = true;
      again = true;
      --iterations_;
      continue;
    }
    again = false;
    for (int e = 0; e < count_; ++e) {
      const auto i = static_cast<std::size_t>(e);
      elements_[i].recover(rhs_[i], arena_, out[i]);
    }
    displacements(patch, older, out);
    if (linear) return PatchStatus::solved;
  }
}

/// Local spaces, and what does not depend on facets.
template <int D>
bool PatchSolver<D>::begin(const Patch<D>& patch, std::span<const SpaceChoice> choices) {
  arena_.release();
  unknowns_ = 0;
  for (int e = 0; e < count_; ++e) {
    const auto i = static_cast<std::size_t>(e);
    const PatchElement<D>& element = patch.elements[i];
    const SpaceChoice c = choice(element, i, choices);
    if (!elements_[i].set(c, problem_.materials[static_cast<std::size_t>(element.material)],
                          table(c, element.material), element.corner, element.volume, arena_))
      return false;
    unknowns_ += elements_[i].unknowns;
  }
  own_.resize(elements_.size()), rhs_.resize(elements_.size());
  term_.resize(elements_.size()), links_of_.resize(elements_.size()), given_.resize(elements_.size());
  own_filled_.assign(elements_.size(), 0);
  link_count_ = 0;
  for (int e = 0; e < count_; ++e) {
    const auto i = static_cast<std::size_t>(e);
    const int n = elements_[i].unknowns;
    // One lane more than needed: see sum_tables().
    own_[i] = {arena_.take(static_cast<std::size_t>(n * padded(n) + 8)), n, n, padded(n)};
    rhs_[i] = arena_.take(static_cast<std::size_t>(n));
    term_[i].clear(), links_of_[i].clear(), given_[i].clear();
    assemble_volume(e);
  }
  star_change_ = star_size_ = 0.0;
  star_count_ = 0;
  return true;
}

template <int D>
PatchStatus PatchSolver<D>::assemble(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                                     std::span<const Solution<D>> now) {
  for (std::size_t f = 0; f < patch.facets.size(); ++f) {
    const Facet<D>& facet = patch.facets[f];
    if (facet.kind == FacetKind::inflow) assemble_inflow(patch, facet, older[f]);
    if (facet.kind == FacetKind::inflow || facet.kind == FacetKind::outflow || listed_before(facet)) continue;
    if (is_vertical(facet)) {
      assemble_vertical(facet, now);
      continue;
    }
    const PatchStatus status = assemble_tilted(facet);
    if (status != PatchStatus::solved) return status;
  }
  return PatchStatus::solved;
}

template class PatchSolver<1>;
template class PatchSolver<2>;
template class PatchSolver<3>;

}  // namespace cleave::discretisation::spacetime
