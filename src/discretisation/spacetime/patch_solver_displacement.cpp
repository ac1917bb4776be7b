// The displacement: it follows velocity and strain, element by element.
#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/basis_facet.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
void PatchSolver<D>::displacements(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                                   std::span<Solution<D>> out) {
  for (int e = 0; e < count_; ++e)
    if (out[static_cast<std::size_t>(e)].space.space != LocalSpace::three_field)
      rigid_motion(patch, e, older, out[static_cast<std::size_t>(e)]);
  // Three-field elements exchange displacement through tilted facets only.
  bool tilted = false;
  for (const Facet<D>& f : patch.facets)
    tilted = tilted || (f.kind == FacetKind::interior && !is_vertical(f));
  group_.clear();
  for (int e = 0; e < count_; ++e) {
    if (out[static_cast<std::size_t>(e)].space.space != LocalSpace::three_field) continue;
    group_.push_back(e);
    if (tilted) continue;
    three_field_displacement(patch, group_, older, out);
    group_.clear();
  }
  if (!group_.empty()) three_field_displacement(patch, group_, older, out);
}

/// The rigid motions carry neither velocity nor strain. They are those that bring the displacement closest to
/// the older one on the inflow facet: the last term of (3.4).
template <int D>
Block PatchSolver<D>::rigid_fit(int e, const Facet<D>& inflow) {
  constexpr int r = rigid_count<D>, modes = D + 1, linear = D + 2;
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
  const Block normal = take(arena_, r, r), motion = take(arena_, r, D * modes),
              fit = take(arena_, D * modes, D * linear);
  // Translations and rotations at a place, about the centre of the element.
  const auto rigid = [&](const Event<D>& y, double share, int stride, double* to, std::ptrdiff_t next) {
    for (int i = 0, k = D; i < D; ++i) {
      to[i * next + i * stride] += share;
      for (int j = i + 1; j < D; ++j, ++k) {
        to[k * next + i * stride] += share * (y[j] - space.centre[j]) / space.length;
        to[k * next + j * stride] -= share * (y[i] - space.centre[i]) / space.length;
      }
    }
  };
  for (int c = 0; c < modes; ++c)
    for (int l = 0; l <= D; ++l)
      rigid(inflow.corner[static_cast<std::size_t>(l)],
            Basis<D>::get().linear(l)[static_cast<std::size_t>(c)], modes, motion.data + c, motion.stride);
  for (int k = 0; k < r; ++k)
    for (int l = 0; l < r; ++l)
      for (int c = 0; c < D * modes; ++c) normal.row(k)[l] += motion.row(k)[c] * motion.row(l)[c];
  int pivot[r];
  if (!factor(normal, pivot)) return fit;  // an element without inflow is refused before
  spacetime::solve(normal, pivot, motion);
  double polynomial[r][D * linear] = {};
  for (int a = 0; a < linear; ++a)
    for (int l = 0; l < linear; ++l)
      rigid(space.corner[static_cast<std::size_t>(l)],
            Basis<D + 1>::get().linear(l)[static_cast<std::size_t>(a)], linear, polynomial[0] + a,
            D * linear);
  for (int c = 0; c < D * modes; ++c)
    for (int a = 0; a < D * linear; ++a)
      for (int k = 0; k < r; ++k) fit.row(c)[a] += motion.row(k)[c] * polynomial[k][a];
  return fit;
}

template <int D>
void PatchSolver<D>::rigid_motion(const Patch<D>& patch, int e, std::span<const Solution<D>* const> older,
                                  Solution<D>& out) {
  const int nu = polynomial_count(D + 1, out.displacement_degree);
  for (std::size_t f = 0; f < patch.facets.size(); ++f) {
    const Facet<D>& facet = patch.facets[f];
    if (facet.kind != FacetKind::inflow || facet.element != e) continue;
    const Block fit = rigid_fit(e, facet);
    constexpr int modes = D + 1, linear = D + 2, stride = padded(modes);
    const double *before = trace_modes(patch, facet, older[f], out.displacement_degree, modes, true),
                 *now = trace_modes(patch, facet, &out, out.displacement_degree, modes, true);
    for (int i = 0; i < D; ++i)
      for (int c = 0; c < modes; ++c)
        for (int a = 0; a < D * linear; ++a)
          out.displacement[static_cast<std::size_t>(a / linear * nu + a % linear)] +=
              fit.row(i * modes + c)[a] * (before[i * stride + c] - now[i * stride + c]);
  }
}

/// int phi_a phi_b,t dV, from row and column `at` on.
template <int D>
static void add_time_derivative(const ElementSpace<D>& space, const Block& matrix, int at) {
  for (int l = 1; l <= D + 1; ++l) {
    const Block& weak = FacetBasis<D>::get().weak(l);
    const double s = space.volume * space.map.gradient[static_cast<std::size_t>(l - 1)][D];
    for (int a = 0; a < space.polynomials; ++a)
      for (int b = 0; b < space.polynomials; ++b) matrix.row(at + a)[at + b] += s * weak.row(a)[b];
  }
}

/// The displacement's matrix of an element that learns of others through its inflow facet only.
template <int D>
Block PatchSolver<D>::displacement_matrix(int e, const Facet<D>& inflow) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
  const int n = space.polynomials;
  const Block matrix = take(arena_, n, n), &mass = FacetBasis<D>::get().mass(space.opposite(inflow.corner));
  add_time_derivative(space, matrix, 0);
  const double weight = std::fabs(inflow.normal[D]);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) matrix.row(a)[b] += weight * mass.row(a)[b];
  return matrix;
}

/// int u^ (u,t - v) dV + int u^ (u* - u) N_t dS = 0, u* from the older element on inflow and from the earlier
/// neighbour on tilted facets. Every component has the same matrix.
template <int D>
void PatchSolver<D>::three_field_displacement(const Patch<D>& patch, const std::vector<int>& group,
                                              std::span<const Solution<D>* const> older,
                                              std::span<Solution<D>> out) {
  const auto& basis = Basis<D + 1>::get();
  int total = 0;
  const auto start = [&](int element) {  // first unknown of a member of the group, -1 of others
    int at = 0;
    for (const int e : group) {
      if (e == element) return at;
      at += elements_[static_cast<std::size_t>(e)].polynomials;
    }
    return -1;
  };
  for (const int e : group) total += elements_[static_cast<std::size_t>(e)].polynomials;
  const Block matrix = take(arena_, total, total), rhs = take(arena_, total, D);
  for (const int e : group) {
    const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
    const int n = space.polynomials, at = start(e);
    add_time_derivative(space, matrix, at);
    for (int a = 0; a < n; ++a) {
      for (int i = 0; i < D; ++i)
        rhs.row(at + a)[i] +=
            space.volume * out[static_cast<std::size_t>(e)].fields[static_cast<std::size_t>(i * n + a)];
    }
  }
  double phi[Basis<D + 1>::count], beyond[Basis<D + 1>::count];
  for (std::size_t f = 0; f < patch.facets.size(); ++f) {
    const Facet<D>& facet = patch.facets[f];
    if (facet.kind == FacetKind::outflow || facet.kind == FacetKind::boundary || listed_before(facet))
      continue;
    if (facet.kind == FacetKind::interior && is_vertical(facet)) continue;
    // The receiver is the element above the facet, the giver lies below it.
    const bool receives = facet.normal[D] < 0.0;
    const int receiver = receives ? facet.element : facet.neighbour, at = receiver < 0 ? -1 : start(receiver);
    if (at < 0) continue;
    const int giver = facet.kind == FacetKind::inflow ? -1 : (receives ? facet.neighbour : facet.element);
    const ElementSpace<D>& space = elements_[static_cast<std::size_t>(receiver)];
    if (const int opposite = giver < 0 ? space.opposite(facet.corner) : -1; opposite >= 0) {
      const Block &mass = FacetBasis<D>::get().mass(opposite), &modes = FacetBasis<D>::get().modes(opposite);
      const int n = space.polynomials, count = polynomial_count(D, space.degree), stride = padded(count);
      const double weight = std::fabs(facet.normal[D]),
                   *u = trace_modes(patch, facet, older[f], space.degree, count, true);
      for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) matrix.row(at + a)[at + b] += weight * mass.row(a)[b];
        for (int i = 0; i < D; ++i) {
          double sum = 0.0;
          for (int c = 0; c < count; ++c) sum += modes.row(a)[c] * u[i * stride + c];
          rhs.row(at + a)[i] += weight * sum;
        }
      }
      continue;
    }
    int degree = space.degree;
    if (older[f] && giver < 0) degree = std::max(degree, older[f]->displacement_degree);
    if (giver >= 0) degree = std::max(degree, elements_[static_cast<std::size_t>(giver)].choice.degree);
    const SimplexRule& rule = *facet_rule(degree + 1).rule;
    facet_points(facet, rule);
    const int other = giver < 0 ? -1 : start(giver);
    if (giver < 0) {
      older_states(patch, facet, older[f]);
    } else if (other < 0) {
      states_.resize(points_.size());
      out[static_cast<std::size_t>(giver)].at(points_, states_);
    }
    for (std::size_t q = 0; q < points_.size(); ++q) {
      const double weight = rule.weight[q] * std::fabs(facet.normal[D]);
      basis.evaluate(space.map(points_[q]).data(), space.degree, phi);
      const int n = space.polynomials;
      int m = 0;
      if (other >= 0) {
        const ElementSpace<D>& from = elements_[static_cast<std::size_t>(giver)];
        m = from.polynomials;
        basis.evaluate(from.map(points_[q]).data(), from.degree, beyond);
      }
      for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) matrix.row(at + a)[at + b] += weight * phi[a] * phi[b];
        for (int b = 0; b < m; ++b) matrix.row(at + a)[other + b] -= weight * phi[a] * beyond[b];
        for (int i = 0; i < D && other < 0; ++i) rhs.row(at + a)[i] += weight * phi[a] * states_[q].u[i];
      }
    }
  }
  pivot_.resize(std::max(pivot_.size(), static_cast<std::size_t>(total)));
  if (!factor(matrix, pivot_.data())) return;  // definite on causal patches
  spacetime::solve(matrix, pivot_.data(), rhs);
  for (const int e : group) {
    const int n = elements_[static_cast<std::size_t>(e)].polynomials, at = start(e);
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < n; ++a)
        out[static_cast<std::size_t>(e)].displacement[static_cast<std::size_t>(i * n + a)] =
            rhs.row(at + a)[i];
  }
}

#define CLEAVE_INSTANTIATE(D)                                                                       \
  template Block PatchSolver<D>::rigid_fit(int, const Facet<D>&);                                   \
  template Block PatchSolver<D>::displacement_matrix(int, const Facet<D>&);                         \
  template void PatchSolver<D>::displacements(const Patch<D>&, std::span<const Solution<D>* const>, \
                                              std::span<Solution<D>>);                              \
  template void PatchSolver<D>::three_field_displacement(const Patch<D>&, const std::vector<int>&,  \
                                                         std::span<const Solution<D>* const>,       \
                                                         std::span<Solution<D>>);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
