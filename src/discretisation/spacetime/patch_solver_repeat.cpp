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
void PatchSolver<D>::make_key(const Patch<D>& patch) {
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
}

/// The operator that is there already, else null. Leaves the key of the patch.
template <int D>
const PatchOperator<D>* PatchSolver<D>::find_operator(const Patch<D>& patch) {
  make_key(patch);
  if (const auto* list = operators_.find(key_))
    for (const auto& candidate : *list)
      if (fits(*candidate, patch)) {
        operators_.count_found();
        return candidate.get();
      }
  return nullptr;
}

/// Made for the patch whose key was made last; null if it is singular.
template <int D>
const PatchOperator<D>* PatchSolver<D>::new_operator(const Patch<D>& patch) {
  count_ = static_cast<int>(patch.elements.size());
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
  recording_ = pivoting_ = false;
  origin_ = {};
  for (auto& list : given_) list.clear();
  if (!ok) return nullptr;
  return operators_.add(key_, std::move(made),
                        operator_memory / static_cast<std::size_t>(std::max(1, base::thread_count())));
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
  pack(op);
  op.patch = placed_;
  op.link_count = link_count_, op.unknowns = unknowns_;
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
    // Of the energy-scaled state, times its scaling.
    const Elastic<D>& m = *to.space.material;
    const Matrix<NU> flux = scaled_flux(inflow);
    for (int r = 0; r < NU; ++r) {
      for (int j = 0; j < D; ++j) to.flux[r][j] = -flux[r][j] * std::sqrt(m.density);
      for (int d = 0; d < strain_count<D>; ++d)
        for (int c = 0; c < strain_count<D>; ++c) to.flux[r][D + d] -= flux[r][D + c] * m.to_energy[c][d];
    }
    to.modes = polynomial_count(D, to.space.degree);
    to.open = components_[i].open;
    for (const Open& o : to.open) to.waves_in += o.in, to.waves_out += o.out;
    const Block &b = response_[i], &s = components_[i].s;
    const int given = b.columns - to.waves_in - 1;
    // Data count positive, waves negative: x = K^-1 (data - lifts).
    const Block respond = take(arena_, to.waves_in + given, b.rows);
    for (int k = 0; k < b.rows; ++k) {
      for (int j = 0; j < to.waves_in; ++j) respond.row(j)[k] = -b.row(k)[j];
      for (int j = 0; j < given; ++j) respond.row(to.waves_in + j)[k] = b.row(k)[to.waves_in + 1 + j];
    }
    keep_response(e, respond, to);
    to.emit = transposed(arena_, s, to.waves_in + 1, given);
    for (std::size_t n = 2; n < D + 2; ++n) {
      const std::size_t f = i * (D + 2) + n;
      if (placed_.facets[f].kind != FacetKind::boundary) continue;
      to.boundary.push_back(static_cast<int>(f));
      star_values(placed_.facets[f], {});
      op.maps.push_back(maps_[0]);
    }
    to.space.span = to.space.undo = {};
  }
}

/// From waves and data to the coefficients of the solution.
template <int D>
void PatchSolver<D>::keep_response(int e, Block respond, typename PatchOperator<D>::Element& to) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
  const Facet<D>& inflow = placed_.facets[static_cast<std::size_t>(e * (D + 2))];
  const int n = space.polynomials, nu = polynomial_count(D + 1, space.choice.degree), fields = NU * n;
  to.respond = respond;
  if (space.choice.space != LocalSpace::three_field) {
    to.carry = rigid_fit(e, inflow);
    to.carried = D + 1, to.carried_to = D + 2;
  }
  if (space.choice.space == LocalSpace::trefftz) to.restore = space.change_of_basis(arena_);
  if (space.choice.space == LocalSpace::one_field) {
    to.restore = take(arena_, space.unknowns, fields + D * nu);
    Solution<D> out;
    double* unit = arena_.take(static_cast<std::size_t>(space.unknowns));
    for (int k = 0; k < space.unknowns; ++k) {
      unit[k] = 1.0;
      space.recover(unit, arena_, out);
      unit[k] = 0.0;
      std::copy(out.fields.begin(), out.fields.end(), to.restore.row(k));
      std::copy(out.displacement.begin(), out.displacement.end(), to.restore.row(k) + fields);
    }
  }
  if (space.choice.space != LocalSpace::three_field) return;

  const Block matrix = displacement_matrix(e, inflow), inverse = take(arena_, n, n),
              by_volume = take(arena_, n, n),
              &modes = FacetBasis<D>::get().modes(space.opposite(inflow.corner));
  for (int k = 0; k < n; ++k) inverse.row(k)[k] = 1.0;
  pivot_.resize(std::max(pivot_.size(), static_cast<std::size_t>(n)));
  if (factor(matrix, pivot_.data())) spacetime::solve(matrix, pivot_.data(), inverse);
  to.carried = to.modes, to.carried_to = n;
  to.carry = take(arena_, D * to.carried, D * n);
  const double weight = std::fabs(inflow.normal[D]), scale = 1.0 / std::sqrt(space.volume),
               root = 1.0 / std::sqrt(space.material->density);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      by_volume.row(b)[a] = space.volume * inverse.row(a)[b];
      for (int c = 0; c < to.carried; ++c)
        for (int i = 0; i < D; ++i)
          to.carry.row(i * to.carried + c)[i * n + a] += weight * inverse.row(a)[b] * modes.row(b)[c];
    }
  to.respond = take(arena_, respond.rows, fields + D * n);
  const Block velocity = take(arena_, respond.rows, n), displacement = take_raw(arena_, respond.rows, n);
  for (int i = 0; i < NU; ++i)
    for (int k = 0; k < respond.rows; ++k) {
      double* out = to.respond.row(k) + i * n;
      if (i < D)
        for (int a = 0; a < n; ++a) out[a] = scale * root * respond.row(k)[i * n + a];
      for (int d = 0; i >= D && d < strain_count<D>; ++d)
        if (const double s = scale * space.material->from_energy[i - D][d]; s != 0.0)
          for (int a = 0; a < n; ++a) out[a] += s * respond.row(k)[(D + d) * n + a];
    }
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < respond.rows; ++k) std::copy_n(to.respond.row(k) + i * n, n, velocity.row(k));
    multiply(velocity, by_volume, displacement);
    for (int k = 0; k < respond.rows; ++k)
      std::copy_n(displacement.row(k), n, to.respond.row(k) + fields + i * n);
  }
}

/// Into memory of its own, in the order of use.
template <int D>
void PatchSolver<D>::pack(PatchOperator<D>& op) {
  to_pack_.clear();
  for (auto& e : op.elements) to_pack_.push_back(&e.emit);
  for (auto& j : op.joins)
    for (Block* b : {&j.solve, &j.second_on_first, &j.first_rest_on_second, &j.second_rest_on_first})
      to_pack_.push_back(b);
  for (auto& j : op.joins) to_pack_.push_back(&j.from_first), to_pack_.push_back(&j.from_second);
  for (auto& e : op.elements)
    for (Block* b : {&e.respond, &e.restore, &e.carry})
      if (b->data) to_pack_.push_back(b);
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
  op.flops = 2.0 * static_cast<double>(size);
}

#define CLEAVE_INSTANTIATE(D)                                                                         \
  template void PatchSolver<D>::put_columns(int, const Functional&, double, const Block&, int) const; \
  template const PatchOperator<D>* PatchSolver<D>::find_operator(const Patch<D>&);                    \
  template const PatchOperator<D>* PatchSolver<D>::new_operator(const Patch<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
