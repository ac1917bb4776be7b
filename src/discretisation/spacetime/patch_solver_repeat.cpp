// Patches over tents that repeat: one operator for all that are equal.
#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "discretisation/spacetime/basis_facet.hpp"
#include "discretisation/spacetime/geometry.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;
using base::Lanes;

/// Memory for operators, shared out among the threads. [doubles]
constexpr std::size_t operator_memory = std::size_t{1} << 27;

/// Columns column .. column + columns of a, as rows.
Block transposed(Arena& arena, const Block& a, int column, int columns) {
  const Block t = take(arena, columns, a.rows);
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < columns; ++j) t.row(j)[i] = a.row(i)[column + j];
  return t;
}

std::uint64_t bits(double x) {
  std::uint64_t word;
  x += 0.0;  // no negative zero
  std::memcpy(&word, &x, sizeof word);
  return word;
}

}  // namespace

/// Columns of b: scale times the transpose of a functional. Whole lanes may reach into columns that come
/// next.
template <int D>
void PatchSolver<D>::put_columns(int e, const Functional& f, double scale, const Block& b, int column) const {
  if (f.full.data) {
    for (int k = 0; k < b.rows; ++k) {
      double* to = b.row(k) + column;
      for (int j = 0; j < f.full.rows; ++j) to[j] = scale * f.full.row(j)[k];
    }
    return;
  }
  const int poly = elements_[static_cast<std::size_t>(e)].polynomials;
  for (int a = 0; a < NU; ++a)
    for (int k = 0; k < poly; ++k)
      for (int r = 0; r < f.rows; ++r) {
        const double factor = scale * f.combination[r][a];
        const Lanes s(factor);
        double* to = b.row(a * poly + k) + column + r * f.count;
        for (int j = 0; j < f.count; j += lane_count)
          if (j + lane_count <= f.count || to + j + lane_count <= b.row(a * poly + k) + b.stride)
            store_any(s * Lanes::load(f.modes.row(k) + j), to + j);
          else
            for (int t = j; t < f.count; ++t) to[t] = factor * f.modes.row(k)[t];
      }
}

/// The patch as seen from the foot of its pole, with the coordinates of its shape.
template <int D>
void PatchSolver<D>::place(const Patch<D>& patch) {
  constexpr auto N = static_cast<std::size_t>(D + 1);
  placed_ = patch;
  placed_.foot = {}, placed_.top = {};
  placed_.top[D] = patch.top[D] - patch.foot[D];
  for (std::size_t e = 0; e < placed_.elements.size(); ++e) {
    PatchElement<D>& element = placed_.elements[e];
    for (std::size_t i = 0; i < D; ++i) {
      for (std::size_t k = 0; k < D; ++k) element.corner[i + 1][k] = patch.shape->corner[e][i][k];
      element.corner[i + 1][D] = patch.elements[e].corner[i + 1][D] - patch.foot[D];
    }
    element.corner[0] = placed_.foot, element.corner[D + 1] = placed_.top;
    element.volume = std::fabs(signed_volume<N>(element.corner));
    for (std::size_t n = 0; n < D + 2; ++n) {
      Facet<D>& f = placed_.facets[e * (D + 2) + n];
      const std::size_t opposite = n == 0 ? D + 1 : n - 1;  // inflow, outflow, those with the pole
      for (std::size_t i = 0, to = 0; i < D + 2; ++i)
        if (i != opposite) f.corner[to++] = element.corner[i];
      f.normal = area_vector<N>(f.corner, element.corner[opposite]);
      if (f.kind == FacetKind::interior && listed_before(f))
        for (std::size_t k = 0; k <= D; ++k)
          f.normal[k] = -placed_.facets[static_cast<std::size_t>(f.twin)].normal[k];
    }
  }
}

template <int D>
PatchStatus PatchSolver<D>::solve_repeated(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                                           std::span<Solution<D>> out) {
  iterations_ = 1;
  key_.clear();
  key_.push_back(bits(patch.top[D] - patch.foot[D]));
  for (std::size_t e = 0; e < patch.elements.size(); ++e) {
    const PatchElement<D>& element = patch.elements[e];
    key_.push_back(static_cast<std::uint64_t>(element.material));
    for (std::size_t i = 0; i < D; ++i) {
      for (std::size_t k = 0; k < D; ++k) key_.push_back(bits(patch.shape->corner[e][i][k]));
      key_.push_back(bits(element.corner[i + 1][D] - patch.foot[D]));
      key_.push_back(static_cast<std::uint64_t>(patch.facets[e * (D + 2) + 2 + i].neighbour));
    }
  }
  const PatchOperator<D>* op = nullptr;
  if (const auto* list = operators_.find(key_))
    for (const auto& candidate : *list)
      if (!op && fits(*candidate, patch)) op = candidate.get();
  if (op) {
    operators_.count_found();
  } else {
    place(patch);
    auto made = std::make_unique<PatchOperator<D>>();
    origin_ = patch.foot;
    recording_ = true;
    pivoting_ = false;
    bool ok = make_operator(patch, *made);
    if (!ok) {
      pivoting_ = true;
      *made = {};
      ok = make_operator(patch, *made);
    }
    recording_ = false;
    origin_ = {};
    for (auto& list : given_) list.clear();
    if (!ok) return PatchStatus::singular;
    op = operators_.add(key_, std::move(made),
                        operator_memory / static_cast<std::size_t>(std::max(1, base::thread_count())));
  }
  apply(*op, patch, older, out);
  for (int e = 0; e < count_; ++e)
    for (const double x : out[static_cast<std::size_t>(e)].fields)
      if (!std::isfinite(x)) return PatchStatus::singular;
  return PatchStatus::solved;
}

/// Do the targets of the patch depend on traces as those did that the operator was made for?
template <int D>
bool PatchSolver<D>::fits(const PatchOperator<D>& op, const Patch<D>& patch) {
  std::size_t next = 0;
  bool same = true;
  origin_ = patch.foot;
  for (std::size_t e = 0; e < op.elements.size() && same; ++e) {
    elements_[e].degree = op.elements[e].space.degree;  // all that star values need of an element
    elements_[e].material = op.elements[e].space.material;
    for (const int f : op.elements[e].boundary) {
      Facet<D> facet = op.patch.facets[static_cast<std::size_t>(f)];
      facet.boundary = patch.facets[static_cast<std::size_t>(f)].boundary;
      star_values(facet, {});
      same = same && maps_[0].map == op.maps[next].map;
      ++next;
    }
  }
  origin_ = {};
  return same;
}

/// From placed_. False if a system is singular.
template <int D>
bool PatchSolver<D>::make_operator(const Patch<D>& patch, PatchOperator<D>& op) {
  if (!begin(placed_, {})) return false;
  const std::vector<const Solution<D>*> none(patch.facets.size(), nullptr);
  if (assemble(placed_, none, {}) != PatchStatus::solved || !condense_and_join()) return false;
  keep_elements(op);
  for (int j = count_; j < component_count_; ++j) {
    const Component& c = components_[static_cast<std::size_t>(j)];
    const Component &a = components_[static_cast<std::size_t>(c.first)],
                    &b = components_[static_cast<std::size_t>(c.second)];
    auto& to = op.joins.emplace_back();
    to.first = c.first, to.second = c.second;
    to.first_shared = c.solve.rows, to.second_shared = c.second_on_first.rows;
    to.first_rest = c.first_rest_on_second.rows;
    to.out = c.s.rows, to.in = c.s.columns - 1;
    to.open = c.open, to.shared = c.shared;
    std::size_t open_at = 0;
    const auto moves = [&](const Component& part, bool first,
                           std::vector<typename PatchOperator<D>::Move>& list) {
      for (const Open& o : part.open) {
        const auto s = std::find_if(c.shared.begin(), c.shared.end(), [&](const Open& q) {
          return q.wave == o.wave || (q.wave ^ 1) == o.wave;
        });
        if (s != c.shared.end())
          list.push_back({o.row, first ? s->row : s->column, o.out, true});
        else
          list.push_back({o.row, c.open[open_at++].row, o.out, false});
      }
    };
    moves(a, true, to.of_first);
    moves(b, false, to.of_second);
    to.solve = transposed(arena_, c.solve, 0, c.solve.columns);
    to.second_on_first = transposed(arena_, c.second_on_first, 0, c.second_on_first.columns);
    to.first_rest_on_second = transposed(arena_, c.first_rest_on_second, 0, c.first_rest_on_second.columns);
    to.second_rest_on_first = transposed(arena_, c.second_rest_on_first, 0, c.second_rest_on_first.columns);
    to.from_first = transposed(arena_, c.from_first, 0, to.in);
    to.from_second = transposed(arena_, c.from_second, 0, to.in);
  }
  // Into memory of its own, in the order of use.
  to_pack_.clear();
  for (auto& e : op.elements) to_pack_.push_back(&e.emit);
  for (auto& j : op.joins)
    for (Block* b : {&j.solve, &j.second_on_first, &j.first_rest_on_second, &j.second_rest_on_first})
      to_pack_.push_back(b);
  for (auto& j : op.joins) to_pack_.push_back(&j.from_first), to_pack_.push_back(&j.from_second);
  for (auto& e : op.elements) {
    to_pack_.push_back(&e.respond);
    if (e.settle.data) to_pack_.push_back(&e.settle);
    if (e.space.change.data) to_pack_.push_back(&e.space.change);
    if (e.space.choice.space == LocalSpace::one_field)
      to_pack_.push_back(&e.space.span), to_pack_.push_back(&e.space.undo);
  }
  std::size_t size = 0;
  for (const Block* b : to_pack_)
    size += static_cast<std::size_t>(b->rows) * static_cast<std::size_t>(b->stride);
  op.memory.take_raw(size);
  op.memory.release();
  for (Block* b : to_pack_) {
    const std::size_t count = static_cast<std::size_t>(b->rows) * static_cast<std::size_t>(b->stride);
    double* to = op.memory.take_raw(count);
    std::copy_n(b->data, count, to);
    b->data = to;
  }
  op.patch = placed_;
  op.link_count = link_count_, op.unknowns = unknowns_;
  op.flops = 2.0 * static_cast<double>(size);
  return true;
}

template <int D>
void PatchSolver<D>::keep_elements(PatchOperator<D>& op) {
  op.elements.resize(static_cast<std::size_t>(count_));
  for (int e = 0; e < count_; ++e) {
    const auto i = static_cast<std::size_t>(e);
    const Facet<D>& inflow = placed_.facets[i * (D + 2)];
    auto& to = op.elements[i];
    to.space = elements_[i];
    to.flux = scaled_flux(inflow);
    for (auto& row : to.flux)
      for (double& x : row) x = -x;
    to.modes = polynomial_count(D, to.space.degree);
    to.open = components_[i].open;
    for (const Open& o : to.open) to.waves_in += o.in, to.waves_out += o.out;
    const Block &b = response_[i], &s = components_[i].s;
    const int given = b.columns - to.waves_in - 1;
    // Data count positive, waves negative: x = K^-1 (data - lifts).
    to.respond = take(arena_, to.waves_in + given, b.rows);
    for (int k = 0; k < b.rows; ++k) {
      for (int j = 0; j < to.waves_in; ++j) to.respond.row(j)[k] = -b.row(k)[j];
      for (int j = 0; j < given; ++j) to.respond.row(to.waves_in + j)[k] = b.row(k)[to.waves_in + 1 + j];
    }
    to.emit = transposed(arena_, s, to.waves_in + 1, given);
    for (std::size_t n = 2; n < D + 2; ++n) {
      const std::size_t f = i * (D + 2) + n;
      if (placed_.facets[f].kind != FacetKind::boundary) continue;
      to.boundary.push_back(static_cast<int>(f));
      star_values(placed_.facets[f], {});
      op.maps.push_back(maps_[0]);
    }
    if (to.space.choice.space == LocalSpace::trefftz) to.space.change = to.space.change_of_basis(arena_);
    if (to.space.choice.space == LocalSpace::three_field) {
      const Block matrix = displacement_matrix(e, inflow);
      const Block inverse = take(arena_, matrix.rows, matrix.rows);
      for (int k = 0; k < matrix.rows; ++k) inverse.row(k)[k] = 1.0;
      pivot_.resize(std::max(pivot_.size(), static_cast<std::size_t>(matrix.rows)));
      if (factor(matrix, pivot_.data())) spacetime::solve(matrix, pivot_.data(), inverse);
      to.settle = transposed(arena_, inverse, 0, inverse.columns);
    }
  }
}

template <int D>
void PatchSolver<D>::apply(const PatchOperator<D>& op, const Patch<D>& patch,
                           std::span<const Solution<D>* const> older, std::span<Solution<D>> out) {
  arena_.release();
  unknowns_ = op.unknowns, flops_ = op.flops;
  const std::size_t count = op.elements.size(), parts = count + op.joins.size();
  input_.resize(std::max(input_.size(), count)), part_out_.resize(std::max(part_out_.size(), parts));
  first_sent_.resize(std::max(first_sent_.size(), parts)), second_sent_.resize(first_sent_.size());
  wave_.resize(std::max(wave_.size(), static_cast<std::size_t>(op.link_count)));

  for (std::size_t e = 0; e < count; ++e) {
    const auto& element = op.elements[e];
    elements_[e] = element.space;
    const int modes = element.modes, stride = padded(modes);
    input_[e] = arena_.take_raw(static_cast<std::size_t>(element.respond.rows));
    double* data = input_[e] + element.waves_in;
    const std::size_t f = e * (D + 2);
    const double* state = trace_modes(patch, patch.facets[f], older[f], element.space.degree, modes, false);
    double* flux = arena_.take(static_cast<std::size_t>(NU * stride));
    for (int i = 0; i < NU; ++i) {
      for (int j = 0; j < NU; ++j)
        if (element.flux[i][j] != 0.0)
          axpy(stride, element.flux[i][j], state + (D + j) * stride, flux + i * stride);
      data = std::copy_n(flux + i * stride, modes, data);
    }
    origin_ = patch.foot;
    for (const int b : element.boundary) {
      Facet<D> facet = op.patch.facets[static_cast<std::size_t>(b)];
      facet.boundary = patch.facets[static_cast<std::size_t>(b)].boundary;
      star_values(facet, {});
      const FacetRule& rule = facet_rule(points_per_direction(facet));
      std::fill_n(data, D * modes, 0.0);
      for (int q = 0; q < rule.rule->points; ++q)
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < modes; ++j)
            data[i * modes + j] += loads_[static_cast<std::size_t>(q)].v_minus[i] * rule.weighted.row(q)[j];
      data += D * modes;
    }
    origin_ = {};
    part_out_[e] = arena_.take(static_cast<std::size_t>(element.emit.stride));
    add_transposed(element.emit, input_[e] + element.waves_in, part_out_[e]);
  }

  for (std::size_t j = 0; j < op.joins.size(); ++j) {
    const auto& join = op.joins[j];
    const int a = join.first_shared, b = join.second_shared;
    double *in = arena_.take_raw(static_cast<std::size_t>(a + b)),
           *first = arena_.take(static_cast<std::size_t>(join.solve.stride)),
           *second = arena_.take(static_cast<std::size_t>(join.second_on_first.stride)),
           *to = arena_.take(static_cast<std::size_t>(join.out)),
           *rest = arena_.take(static_cast<std::size_t>(join.first_rest_on_second.stride)),
           *other_rest = arena_.take(static_cast<std::size_t>(join.second_rest_on_first.stride));
    const double *h1 = part_out_[static_cast<std::size_t>(join.first)],
                 *h2 = part_out_[static_cast<std::size_t>(join.second)];
    for (const auto& m : join.of_first) std::copy_n(h1 + m.from, m.count, (m.shared ? in : to) + m.to);
    for (const auto& m : join.of_second)
      for (int k = 0; k < m.count; ++k)
        if (m.shared)
          in[a + m.to + k] = -h2[m.from + k];
        else
          to[m.to + k] = h2[m.from + k];
    // a = (1 - S1 S2)^-1 (h1 - S1 h2), b = h2 - S2 a; then what the parts send elsewhere.
    add_transposed(join.solve, in, first);
    add_transposed(join.second_on_first, first, second);
    for (int k = 0; k < b; ++k) second[k] = -in[a + k] - second[k];
    add_transposed(join.first_rest_on_second, second, rest);
    add_transposed(join.second_rest_on_first, first, other_rest);
    for (int k = 0; k < join.first_rest; ++k) to[k] -= rest[k];
    for (int k = join.first_rest; k < join.out; ++k) to[k] -= other_rest[k - join.first_rest];
    first_sent_[j] = first, second_sent_[j] = second, part_out_[count + j] = to;
  }
  const auto incoming = [&](const std::vector<Open>& open, double* to) {
    for (const Open& o : open) std::copy_n(wave_[static_cast<std::size_t>(o.wave ^ 1)], o.in, to + o.column);
  };
  for (std::size_t j = op.joins.size(); j-- > 0;) {
    const auto& join = op.joins[j];
    double* in = arena_.take_raw(static_cast<std::size_t>(join.in));
    incoming(join.open, in);
    for (const bool is_first : {true, false}) {
      const Block& from = is_first ? join.from_first : join.from_second;
      double* sent = is_first ? first_sent_[j] : second_sent_[j];
      double* echo = arena_.take(static_cast<std::size_t>(from.stride));
      add_transposed(from, in, echo);
      for (int k = 0; k < from.columns; ++k) sent[k] -= echo[k];
      for (const Open& o : join.shared)
        wave_[static_cast<std::size_t>(is_first ? o.wave : o.wave ^ 1)] =
            sent + (is_first ? o.row : o.column);
    }
  }

  for (std::size_t e = 0; e < count; ++e) {
    const auto& element = op.elements[e];
    incoming(element.open, input_[e]);
    double* x = arena_.take(static_cast<std::size_t>(element.respond.stride));
    add_transposed(element.respond, input_[e], x);
    element.space.recover(x, arena_, out[e]);
    // Its own corners, as after a restart.
    out[e].map.set(patch.elements[e].corner);
    if (element.space.choice.space != LocalSpace::three_field) {
      rigid_motion(op.patch, patch, static_cast<int>(e), older, out[e]);
      continue;
    }
    const std::size_t f = e * (D + 2);
    settle(element, op.patch.facets[f],
           trace_modes(patch, patch.facets[f], older[f], element.space.degree, element.modes, true), out[e]);
  }
}

#define CLEAVE_INSTANTIATE(D)                                                                               \
  template void PatchSolver<D>::put_columns(int, const Functional&, double, const Block&, int) const;       \
  template PatchStatus PatchSolver<D>::solve_repeated(const Patch<D>&, std::span<const Solution<D>* const>, \
                                                      std::span<Solution<D>>);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
