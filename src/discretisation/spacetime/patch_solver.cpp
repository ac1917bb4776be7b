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
Block& PatchSolver<D>::block(int row, int column) {
  Block& b = blocks_[static_cast<std::size_t>(row * count_ + column)];
  if (!b.data)
    b = take(arena_, elements_[static_cast<std::size_t>(row)].unknowns,
             elements_[static_cast<std::size_t>(column)].unknowns);
  return b;
}

template <int D>
PatchStatus PatchSolver<D>::solve(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                                  std::span<Solution<D>> out, std::span<const SpaceChoice> choices) {
  CLEAVE_ASSERT(out.size() == patch.elements.size() && older.size() == patch.facets.size(),
                "arrays of a patch");
  count_ = static_cast<int>(patch.elements.size());
  if (elements_.size() < patch.elements.size()) elements_.resize(patch.elements.size());
  stars_.clear();
  bool linear = true;
  for (const Facet<D>& f : patch.facets)
    if (f.kind == FacetKind::interior || f.kind == FacetKind::boundary) linear = linear && target(f).linear();

  for (iterations_ = 1;; ++iterations_) {
    arena_.release();
    unknowns_ = 0;
    for (int e = 0; e < count_; ++e) {
      const auto i = static_cast<std::size_t>(e);
      const PatchElement<D>& element = patch.elements[i];
      const SpaceChoice c = choice(element, i, choices);
      if (!elements_[i].set(c, problem_.materials[static_cast<std::size_t>(element.material)],
                            table(c, element.material), element.corner, element.volume, arena_))
        return PatchStatus::degenerate;
      unknowns_ += elements_[i].unknowns;
    }
    blocks_.assign(static_cast<std::size_t>(count_ * count_), Block{});
    rhs_.resize(static_cast<std::size_t>(count_));
    for (int e = 0; e < count_; ++e) {
      rhs_[static_cast<std::size_t>(e)] = take(arena_, elements_[static_cast<std::size_t>(e)].unknowns, 1);
      assemble_volume(e);
    }
    star_change_ = star_size_ = 0.0;
    star_count_ = 0;
    for (std::size_t f = 0; f < patch.facets.size(); ++f) {
      const Facet<D>& facet = patch.facets[f];
      if (facet.kind == FacetKind::inflow) assemble_inflow(patch, facet, older[f]);
      if (facet.kind == FacetKind::inflow || facet.kind == FacetKind::outflow || listed_before(facet))
        continue;
      if (is_vertical(facet)) {
        assemble_vertical(facet, iterations_ > 1 ? out : std::span<Solution<D>>{});
        continue;
      }
      const PatchStatus status = assemble_tilted(facet);
      if (status != PatchStatus::solved) return status;
    }
    // The star values of the last iterate have been compared with those before it while assembling.
    if (!linear && iterations_ > 1 && star_change_ <= star_tolerance * star_size_) return PatchStatus::solved;
    if (iterations_ > most_iterations) return PatchStatus::not_converged;
    if (!eliminate()) return PatchStatus::singular;
    for (int e = 0; e < count_; ++e) {
      const auto i = static_cast<std::size_t>(e);
      double* x = arena_.take(static_cast<std::size_t>(elements_[i].unknowns));
      for (int k = 0; k < elements_[i].unknowns; ++k) x[k] = rhs_[i].row(k)[0];
      elements_[i].recover(x, arena_, out[i]);
    }
    displacements(patch, older, out);
    if (linear) return PatchStatus::solved;
  }
}

/// Block elimination around the pole: the element with the fewest neighbours left goes first. The symmetric
/// part of the matrix is positive definite (energy), so blocks need no pivoting between them.
template <int D>
bool PatchSolver<D>::eliminate() {
  if (keep_matrix) {
    matrix_.assign(static_cast<std::size_t>(unknowns_) * static_cast<std::size_t>(unknowns_), 0.0);
    int row0 = 0;
    for (int r = 0; r < count_; row0 += elements_[static_cast<std::size_t>(r++)].unknowns) {
      int column0 = 0;
      for (int c = 0; c < count_; column0 += elements_[static_cast<std::size_t>(c++)].unknowns) {
        const Block& b = blocks_[static_cast<std::size_t>(r * count_ + c)];
        for (int i = 0; b.data && i < b.rows; ++i)
          for (int j = 0; j < b.columns; ++j)
            matrix_[static_cast<std::size_t>(row0 + i) * static_cast<std::size_t>(unknowns_) +
                    static_cast<std::size_t>(column0 + j)] = b.row(i)[j];
      }
    }
  }
  flops_ = 0.0;
  const auto at = [&](int r, int c) -> Block& { return blocks_[static_cast<std::size_t>(r * count_ + c)]; };
  done_.assign(static_cast<std::size_t>(count_), 0);
  order_.clear();
  for (int step = 0; step < count_; ++step) {
    int k = -1, fewest = count_ + 1;
    for (int e = 0; e < count_; ++e) {
      if (done_[static_cast<std::size_t>(e)]) continue;
      int neighbours = 0;
      for (int j = 0; j < count_; ++j)
        neighbours += !done_[static_cast<std::size_t>(j)] && at(e, j).data ? 1 : 0;
      if (neighbours < fewest) fewest = neighbours, k = e;
    }
    done_[static_cast<std::size_t>(k)] = 1;
    order_.push_back(k);
    const Block& pivot = block(k, k);
    const double n = pivot.rows;
    pivot_.resize(std::max(pivot_.size(), static_cast<std::size_t>(pivot.rows)));
    if (!factor(pivot, pivot_.data())) return false;
    flops_ += 2.0 / 3.0 * n * n * n;
    spacetime::solve(pivot, pivot_.data(), rhs_[static_cast<std::size_t>(k)]);
    for (int j = 0; j < count_; ++j) {
      if (done_[static_cast<std::size_t>(j)] || !at(k, j).data) continue;
      spacetime::solve(pivot, pivot_.data(), at(k, j));
      flops_ += 2.0 * n * n * at(k, j).columns;
    }
    for (int i = 0; i < count_; ++i) {
      if (done_[static_cast<std::size_t>(i)] || !at(i, k).data) continue;
      multiply_add(-1.0, at(i, k), rhs_[static_cast<std::size_t>(k)], rhs_[static_cast<std::size_t>(i)]);
      for (int j = 0; j < count_; ++j) {
        if (done_[static_cast<std::size_t>(j)] || !at(k, j).data) continue;
        multiply_add(-1.0, at(i, k), at(k, j), block(i, j));
        flops_ += 2.0 * n * at(i, k).rows * at(k, j).columns;
      }
    }
  }
  for (int step = count_ - 1; step >= 0; --step) {
    const int k = order_[static_cast<std::size_t>(step)];
    for (int later = step + 1; later < count_; ++later) {
      const int j = order_[static_cast<std::size_t>(later)];
      if (at(k, j).data)
        multiply_add(-1.0, at(k, j), rhs_[static_cast<std::size_t>(j)], rhs_[static_cast<std::size_t>(k)]);
    }
  }
  for (int e = 0; e < count_; ++e)
    for (int k = 0; k < rhs_[static_cast<std::size_t>(e)].rows; ++k)
      if (!std::isfinite(rhs_[static_cast<std::size_t>(e)].row(k)[0])) return false;
  return true;
}

template class PatchSolver<1>;
template class PatchSolver<2>;
template class PatchSolver<3>;

}  // namespace cleave::discretisation::spacetime
