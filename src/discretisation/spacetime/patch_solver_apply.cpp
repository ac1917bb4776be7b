// Patches go through their operators, equal ones together.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "discretisation/spacetime/basis_facet.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;

}  // namespace

template <int D>
void PatchSolver<D>::solve(std::span<PatchJob<D>> jobs) {
  group_count_ = 0;
  const auto finish = [&](Group& group) {
    if (!group.jobs.empty()) apply(*group.op, group.jobs);
    group.jobs.clear();
  };
  const auto finish_all = [&] {
    for (std::size_t g = 0; g < group_count_; ++g) finish(groups_[g]);
    group_count_ = 0;
  };
  for (PatchJob<D>& job : jobs) {
    const Patch<D>& patch = *job.patch;
    if (!repeats(patch)) {
      job.status = solve(patch, job.older, job.out);
      job.unknowns = unknowns_;
      continue;
    }
    CLEAVE_ASSERT(job.out.size() == patch.elements.size() && job.older.size() == patch.facets.size(),
                  "arrays of a patch");
    iterations_ = 1;
    if (elements_.size() < patch.elements.size()) elements_.resize(patch.elements.size());
    const PatchOperator<D>* op = find_operator(patch);
    if (!op) {
      finish_all();  // a new operator may drive out those that wait for their patches
      op = new_operator(patch);
    }
    if (!op) {
      job.status = PatchStatus::singular;
      continue;
    }
    std::size_t g = 0;
    while (g < group_count_ && groups_[g].op != op) ++g;
    if (g == group_count_) {
      if (groups_.size() == g) groups_.emplace_back();
      groups_[g].op = op;
      ++group_count_;
    }
    groups_[g].jobs.push_back(&job);
    if (groups_[g].jobs.size() == lane_count) finish(groups_[g]);
  }
  finish_all();
}

template <int D>
void PatchSolver<D>::apply(const PatchOperator<D>& op, std::span<PatchJob<D>* const> jobs) {
  arena_.release();
  unknowns_ = op.unknowns, flops_ = op.flops;
  const int width = jobs.size() == 1 ? 1 : lane_count;
  const std::size_t count = op.elements.size(), parts = count + op.joins.size();
  count_ = static_cast<int>(count);
  for (auto* list : {&input_, &carried_}) list->resize(std::max(list->size(), count));
  for (auto* list : {&part_out_, &first_sent_, &second_sent_}) list->resize(std::max(list->size(), parts));
  wave_.resize(std::max(wave_.size(), static_cast<std::size_t>(op.link_count)));
  for (std::size_t e = 0; e < count; ++e) elements_[e] = op.elements[e].space;
  for (std::size_t e = 0; e < count; ++e) gather(op, e, jobs, width);
  for (std::size_t j = 0; j < op.joins.size(); ++j) join_waves(op, j, width);
  for (std::size_t j = op.joins.size(); j-- > 0;) return_waves(op, j, width);
  for (PatchJob<D>* job : jobs) job->status = PatchStatus::solved, job->unknowns = op.unknowns;
  for (std::size_t e = 0; e < count; ++e) restore(op, e, jobs, width);
}

/// The data of an element, and what it sends before it hears of others.
template <int D>
void PatchSolver<D>::gather(const PatchOperator<D>& op, std::size_t e, std::span<PatchJob<D>* const> jobs,
                            int width) {
  constexpr int rows = D + NU;
  const auto& element = op.elements[e];
  const int modes = element.modes, stride = padded(modes), carried = element.carried;
  const auto w = static_cast<std::size_t>(width);
  input_[e] = vectors(element.respond.rows, width);
  carried_[e] = vectors(element.carry.rows, width);
  double* data = input_[e] + static_cast<std::size_t>(element.waves_in) * w;
  double* state = vectors(NU * modes, width);
  if (width > 1) {
    std::fill_n(state, vectors_size(NU * modes, width), 0.0);
    std::fill_n(data, static_cast<std::size_t>(element.respond.rows - element.waves_in) * w, 0.0);
    std::fill_n(carried_[e], vectors_size(element.carry.rows, width), 0.0);
  }
  for (std::size_t v = 0; v < jobs.size(); ++v) {
    const Patch<D>& patch = *jobs[v]->patch;
    const std::size_t f = e * (D + 2);
    const Solution<D>* below = jobs[v]->older[f];
    const double *older = older_modes(patch, patch.facets[f], below, element.space.degree, modes,
                                      below ? 0 : D, rows),
                 *u = below ? older
                            : older_modes(patch, patch.facets[f], below, element.space.choice.degree, modes,
                                          0, D);
    for (int i = 0; i < D; ++i)
      for (int c = 0; c < carried; ++c)
        carried_[e][static_cast<std::size_t>(i * carried + c) * w + v] = u[i * stride + c];
    for (int i = 0; i < NU; ++i)
      for (int c = 0; c < modes; ++c)
        state[static_cast<std::size_t>(i * modes + c) * w + v] = older[(D + i) * stride + c];

    origin_ = patch.foot;
    double* given = data + static_cast<std::size_t>(NU * modes) * w + v;
    for (const int b : element.boundary) {
      Facet<D> facet = op.patch.facets[static_cast<std::size_t>(b)];
      facet.boundary = patch.facets[static_cast<std::size_t>(b)].boundary;
      star_values(facet, {});
      const FacetRule& rule = facet_rule(points_per_direction(facet));
      for (int i = 0; i < D; ++i)
        for (int c = 0; c < modes; ++c, given += width) {
          double sum = 0.0;
          for (int q = 0; q < rule.rule->points; ++q)
            sum += loads_[static_cast<std::size_t>(q)].v_minus[i] * rule.weighted.row(q)[c];
          *given = sum;
        }
    }
    origin_ = {};
  }
  const int length = modes * width;
  for (int i = 0; i < NU; ++i) {
    double* flux = data + static_cast<std::ptrdiff_t>(i) * length;
    std::fill_n(flux, length, 0.0);
    for (int j = 0; j < NU; ++j)
      if (const double f = element.flux[i][j]; f != 0.0)
        for (int k = 0; k < length; ++k) flux[k] += f * state[j * length + k];
  }
  part_out_[e] = vectors(element.emit.columns, width);
  multiply_vectors(element.emit, data, part_out_[e], width);
}

/// a = (1 - S1 S2)^-1 (h1 - S1 h2), b = h2 - S2 a; then what the parts send elsewhere.
template <int D>
void PatchSolver<D>::join_waves(const PatchOperator<D>& op, std::size_t j, int width) {
  const auto& join = op.joins[j];
  double *in = vectors(join.first_shared + join.second_shared, width),
         *first = vectors(join.first_shared, width), *second = vectors(join.second_shared, width),
         *to = vectors(join.out, width), *rest = vectors(join.out, width);
  const double *h1 = part_out_[static_cast<std::size_t>(join.first)],
               *h2 = part_out_[static_cast<std::size_t>(join.second)];
  for (const auto& m : join.of_first)
    std::copy_n(h1 + m.from * width, m.count * width, (m.shared ? in : to) + m.to * width);
  for (const auto& m : join.of_second)
    for (int k = 0; k < m.count * width; ++k)
      if (m.shared)
        in[(join.first_shared + m.to) * width + k] = -h2[m.from * width + k];
      else
        to[m.to * width + k] = h2[m.from * width + k];
  multiply_vectors(join.solve, in, first, width);
  multiply_vectors(join.second_on_first, first, second, width);
  for (int k = 0; k < join.second_shared * width; ++k)
    second[k] = -in[join.first_shared * width + k] - second[k];
  multiply_vectors(join.first_rest_on_second, second, rest, width);
  for (int k = 0; k < join.first_rest * width; ++k) to[k] -= rest[k];
  multiply_vectors(join.second_rest_on_first, first, rest, width);
  for (int k = join.first_rest * width; k < join.out * width; ++k) to[k] -= rest[k - join.first_rest * width];
  first_sent_[j] = first, second_sent_[j] = second, part_out_[op.elements.size() + j] = to;
}

/// What the parts of a join send each other once it is known what comes from outside.
template <int D>
void PatchSolver<D>::return_waves(const PatchOperator<D>& op, std::size_t j, int width) {
  const auto& join = op.joins[j];
  double* in = vectors(join.in, width);
  for (const Open& o : join.open)
    std::copy_n(wave_[static_cast<std::size_t>(o.wave ^ 1)], o.in * width, in + o.column * width);
  for (const bool is_first : {true, false}) {
    const Block& from = is_first ? join.from_first : join.from_second;
    double *sent = is_first ? first_sent_[j] : second_sent_[j], *echo = vectors(from.columns, width);
    multiply_vectors(from, in, echo, width);
    for (int k = 0; k < from.columns * width; ++k) sent[k] -= echo[k];
    for (const Open& o : join.shared)
      wave_[static_cast<std::size_t>(is_first ? o.wave : o.wave ^ 1)] =
          sent + (is_first ? o.row : o.column) * width;
  }
}

/// The coefficients of an element.
template <int D>
void PatchSolver<D>::restore(const PatchOperator<D>& op, std::size_t e, std::span<PatchJob<D>* const> jobs,
                             int width) {
  const auto& element = op.elements[e];
  const LocalSpace space = element.space.choice.space;
  const int nu = polynomial_count(D + 1, element.space.choice.degree),
            fields = NU * element.space.polynomials;
  for (const Open& o : element.open)
    std::copy_n(wave_[static_cast<std::size_t>(o.wave ^ 1)], o.in * width, input_[e] + o.column * width);
  double *unknowns = vectors(element.respond.columns, width), *x = unknowns;
  multiply_vectors(element.respond, input_[e], unknowns, width);
  if (space != LocalSpace::three_field) x = vectors(fields + D * nu + padded(nu), width);
  if (space == LocalSpace::one_field) multiply_vectors(element.restore, unknowns, x, width);
  if (space == LocalSpace::trefftz) sum_functions(element, unknowns, x, width);

  double* u = x + fields * width;
  if (space != LocalSpace::three_field) {  // the jump on the inflow facet
    double* now = vectors(element.carried, width);
    const Block& below =
        FacetBasis<D>::get().modes(element.space.opposite(op.patch.facets[e * (D + 2)].corner));
    for (int i = 0; i < D; ++i) {
      multiply_vectors({below.data, nu, element.carried, below.stride}, u + i * nu * width, now, width);
      for (int k = 0; k < element.carried * width; ++k)
        carried_[e][i * element.carried * width + k] -= now[k];
    }
  }
  double* carry = vectors(element.carry.columns, width);
  multiply_vectors(element.carry, carried_[e], carry, width);
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < element.carried_to * width; ++k)
      u[i * nu * width + k] += carry[i * element.carried_to * width + k];

  // What the next patch will read.
  const int rows = D + NU;
  const Block& modes = FacetBasis<D>::get().modes(0);
  double* above = vectors(rows * element.modes + lane_count, width);
  double* trace = vectors(element.modes, width);
  for (int r = 0; r < rows; ++r) {
    const double* from = r < D ? u + r * nu * width : x + (r - D) * element.space.polynomials * width;
    multiply_vectors({modes.data, r < D ? nu : element.space.polynomials, element.modes, modes.stride}, from,
                     trace, width);
    std::copy_n(trace, element.modes * width, above + r * element.modes * width);
  }

  for (std::size_t v = 0; v < jobs.size(); ++v) {
    Solution<D>& out = jobs[v]->out[e];
    out.map.set(jobs[v]->patch->elements[e].corner);  // its own, as after a restart
    out.space = element.space.choice, out.material = element.space.material;
    out.degree = element.space.degree, out.displacement_degree = element.space.choice.degree;
    out.fields.resize(static_cast<std::size_t>(fields));
    out.displacement.resize(static_cast<std::size_t>(D * nu));
    double nothing = 0.0;  // but for numbers that are none
    const double* from = x + v;
    for (double& c : out.fields) c = *from, nothing += 0.0 * c, from += width;
    for (double& c : out.displacement) c = *from, from += width;
    out.above.resize(static_cast<std::size_t>(rows * element.modes));
    from = above + v;
    for (double& c : out.above) c = *from, from += width;
    if (nothing != 0.0) jobs[v]->status = PatchStatus::singular;
  }
}

/// Trefftz functions to polynomials. A monomial adds to no polynomial of higher degree: eight polynomials at
/// a time need the monomials from the degree of the first of them on.
template <int D>
void PatchSolver<D>::sum_functions(const typename PatchOperator<D>::Element& element, const double* unknowns,
                                   double* x, int width) {
  const ElementSpace<D>& space = element.space;
  const int n = space.polynomials, nu = polynomial_count(D + 1, space.choice.degree);
  constexpr int components = TrefftzTable<D>::components;
  double *monomial = vectors(components * nu, width), *part = vectors(lane_count, width);
  space.table->sum(unknowns, arena_.take_raw(static_cast<std::size_t>(components * space.table->spread())),
                   monomial, width);
  const double scale = 1.0 / std::sqrt(space.volume);
  for (int c = 0; c < components; ++c) {
    const int count = c < D ? nu : n;
    double* to = x + (c < D ? NU * n + c * nu : (c - D) * n) * width;
    const double factor = c < D ? scale * space.length : scale;
    for (int first = 0, degree = 0; first < count; first += lane_count) {
      while (polynomial_count(D + 1, degree) <= first) ++degree;
      const int row = degree > 0 ? polynomial_count(D + 1, degree - 1) : 0,
                columns = std::min(lane_count, count - first);
      multiply_vectors({element.restore.row(row) + first, count - row, columns, element.restore.stride},
                       monomial + (c * nu + row) * width, part, width);
      for (int k = 0; k < columns * width; ++k) to[first * width + k] = factor * part[k];
    }
  }
}

#define CLEAVE_INSTANTIATE(D) template void PatchSolver<D>::solve(std::span<PatchJob<D>>);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
