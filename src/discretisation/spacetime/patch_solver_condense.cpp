// Solves the patch system. Elements know of each other only what passes through the facets between them: the
// characteristics that travel across, D for each mode of the facet. So every element is condensed to a matrix
// from waves in to waves out, and two elements are joined by eliminating the waves of their common facets.
#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;
using base::Lanes;

/// Rows row .. row + rows and columns column .. column + columns of `from`, to another place.
void copy(const Block& from, int row, int column, int rows, int columns, const Block& to, int to_row,
          int to_column) {
  for (int i = 0; i < rows; ++i)
    std::memcpy(to.row(to_row + i) + to_column, from.row(row + i) + column,
                static_cast<std::size_t>(columns) * sizeof(double));
}

Block rows_of(const Block& b, int first, int rows) {
  return {b.row(first), rows, b.columns, b.stride};
}

/// y -= a x for one vector; the order of the sum is that of the lanes.
void subtract_product(const Block& a, int column, int columns, const double* x, double* y) {
  for (int i = 0; i < a.rows; ++i) {
    const double* row = a.row(i) + column;
    Lanes sum(0.0);
    int j = 0;
    for (; j + lane_count <= columns; j += lane_count) sum = fma(load_any(row + j), load_any(x + j), sum);
    double rest = 0.0;
    for (; j < columns; ++j) rest += row[j] * x[j];
    y[i] -= base::sum(sum) + rest;
  }
}

double product_flops(double rows, double columns, double depth) {
  return 2.0 * rows * columns * depth;
}

}  // namespace

/// K of a three-field element: components times constant tables. A row is written in pieces of one component,
/// in their order: the whole lanes of a piece reach into the next, which is written after it.
template <int D>
void PatchSolver<D>::sum_tables(int e) {
  const auto& terms = term_[static_cast<std::size_t>(e)];
  if (terms.empty()) return;
  const int n = elements_[static_cast<std::size_t>(e)].polynomials;
  const Block& k = own_[static_cast<std::size_t>(e)];
  // Terms of nonlinear targets are there already.
  Block others;
  if (own_filled_[static_cast<std::size_t>(e)]) {
    others = take_raw(arena_, k.rows, k.columns);
    copy(k, 0, 0, k.rows, k.stride, others, 0, 0);
  }
  for (int a = 0; a < NU; ++a) {
    double factor[NU][4 * (D + 2)];
    const Block* table[NU][4 * (D + 2)];
    int used[NU] = {};
    for (int b = 0; b < NU; ++b)
      for (const Term& t : terms)
        if (t.factor[a][b] != 0.0) factor[b][used[b]] = t.factor[a][b], table[b][used[b]++] = &t.table;
    for (int i = 0; i < n; ++i)
      for (int b = 0; b < NU; ++b) {
        double* to = k.row(a * n + i) + b * n;
        const auto lanes = [&]<int V>(int j) {
          Lanes sum[V];
          for (Lanes& x : sum) x = Lanes(0.0);
          for (int t = 0; t < used[b]; ++t) {
            const Lanes f(factor[b][t]);
            const double* from = table[b][t]->row(i) + j;
            for (int v = 0; v < V; ++v) sum[v] = fma(f, Lanes::load(from + v * lane_count), sum[v]);
          }
          for (int v = 0; v < V; ++v) store_any(sum[v], to + j + v * lane_count);
        };
        int j = 0;  // three lanes at a time: one chain of sums would wait for itself
        for (; j + 2 * lane_count < n; j += 3 * lane_count) lanes.template operator()<3>(j);
        for (; j < n; j += lane_count) lanes.template operator()<1>(j);
      }
  }
  if (!others.data) return;
  for (int i = 0; i < k.rows; ++i) axpy(k.stride, 1.0, others.row(i), k.row(i));
}

/// What a functional gives for every column of b.
template <int D>
void PatchSolver<D>::emitted(const Link& link, const Block& b, const Block& out) {
  const Functional& f = link.emit;
  if (f.full.data) {
    multiply(f.full, b, out);
    flops_ += product_flops(f.full.rows, b.columns, f.full.columns);
    return;
  }
  const int n = elements_[static_cast<std::size_t>(link.element)].polynomials;
  const Block part = take_raw(arena_, f.count * NU, b.columns);
  for (int a = 0; a < NU; ++a)
    multiply_transposed({f.modes.data, n, f.count, f.modes.stride}, rows_of(b, a * n, n),
                        rows_of(part, a * f.count, f.count));
  flops_ += product_flops(NU * f.count, b.columns, n);
  for (int r = 0; r < f.rows; ++r)
    for (int c = 0; c < f.count; ++c) {
      double* to = out.row(r * f.count + c);
      for (int j = 0; j < out.stride; j += lane_count) {
        Lanes sum(0.0);
        for (int a = 0; a < NU; ++a)
          sum = fma(Lanes(f.combination[r][a]), Lanes::load(part.row(a * f.count + c) + j), sum);
        sum.store(to + j);
      }
    }
}

/// The symmetric parts of the matrices of elements are positive definite by the balance of energy, those of
/// joins close to it. Where that does not help, the patch is made anew and solved with pivoting.
template <int D>
bool PatchSolver<D>::factorise(const Block& a) {
  pivot_.resize(std::max(pivot_.size(), static_cast<std::size_t>(a.rows)));
  return pivoting_ ? factor(a, pivot_.data()) : factor_definite(a, pivot_.data());
}

template <int D>
bool PatchSolver<D>::condense(int e) {
  const auto i = static_cast<std::size_t>(e);
  const int n = elements_[i].unknowns;
  Component& c = components_[i];
  c.open.clear();
  c.joined = false;
  int in = 0, out = 0;
  for (const int l : links_of_[i]) {
    const Link& link = links_[static_cast<std::size_t>(l)];
    Open o;
    o.wave = link.wave, o.row = out, o.column = in;
    o.in = link.lift.rows * link.lift.count, o.out = link.emit.rows * link.emit.count;
    in += o.in, out += o.out;
    c.open.push_back(o);
    owner_[static_cast<std::size_t>(link.wave)] = e;
    wave_width_[static_cast<std::size_t>(link.wave)] = o.out;
  }
  int given = 0;
  for (const Given& g : given_[i]) given += g.test.rows * g.test.count;
  const int columns = in + 1 + given, stride = padded(columns);
  const Block b{arena_.take_raw(static_cast<std::size_t>(n * stride + 8)), n, columns, stride};
  for (std::size_t l = 0; l < c.open.size(); ++l) {
    const Link& link = links_[static_cast<std::size_t>(links_of_[i][l])];
    put_columns(e, link.lift, link.scale, b, c.open[l].column);
  }
  int at = in + 1;
  for (const Given& g : given_[i]) {
    put_columns(e, g.test, g.scale, b, at);
    at += g.test.rows * g.test.count;
  }
  for (int k = 0; k < n; ++k) {
    b.row(k)[in] = rhs_[i][k];
    std::fill(b.row(k) + columns, b.row(k) + stride, 0.0);
  }
  sum_tables(e);
  if (!factorise(own_[i])) return false;
  spacetime::solve(own_[i], pivot_.data(), b);
  flops_ += 2.0 / 3.0 * n * n * n + product_flops(n, columns, n);
  c.s = take_raw(arena_, out, columns);
  for (std::size_t l = 0; l < c.open.size(); ++l)
    emitted(links_[static_cast<std::size_t>(links_of_[i][l])], b, rows_of(c.s, c.open[l].row, c.open[l].out));
  response_[i] = b;
  c.s.columns = in + 1;  // what joins see
  return true;
}

/// Redheffer's star product. Over the common facets the first sends a = h1 - S1 (b, in1), the second
/// b = h2 - S2 (a, in2).
template <int D>
bool PatchSolver<D>::join(int first, int second) {
  Component &A = components_[static_cast<std::size_t>(first)],
            &B = components_[static_cast<std::size_t>(second)],
            &C = components_[static_cast<std::size_t>(component_count_)];
  A.joined = B.joined = true;
  C.joined = false, C.first = first, C.second = second;
  C.open.clear(), C.shared.clear();
  int a_out = 0, b_out = 0, in = 0, out = 0;
  const auto closed = [&](const Open& o, int other) {
    return owner_[static_cast<std::size_t>(o.wave ^ 1)] == other;
  };
  for (const Open& o : A.open) {
    if (closed(o, second)) {
      C.shared.push_back({o.wave, a_out, b_out, o.out, o.in});
      a_out += o.out, b_out += o.in;
    } else {
      C.open.push_back({o.wave, out, in, o.out, o.in});
      out += o.out, in += o.in;
    }
  }
  const int open_of_a = static_cast<int>(C.open.size());
  for (const Open& o : B.open)
    if (!closed(o, first)) {
      C.open.push_back({o.wave, out, in, o.out, o.in});
      out += o.out, in += o.in;
    }
  const int a_rest = A.s.rows - a_out, b_rest = B.s.rows - b_out;

  // The parts of S1 and S2, with the columns of the whole.
  const Block aff = take_raw(arena_, a_out, b_out), bff = take_raw(arena_, b_out, a_out),
              arf = take_raw(arena_, a_rest, b_out), brf = take_raw(arena_, b_rest, a_out),
              g = take(arena_, a_out, in + 1), h = take(arena_, b_out, in + 1);
  C.s = take(arena_, out, in + 1);
  const auto split = [&](const Component& part, int own, bool is_first) {
    const auto of = [&](const Open& o) -> const Open* {  // the shared facet, if it is one
      for (const Open& s : C.shared)
        if (s.wave == o.wave || (s.wave ^ 1) == o.wave) return &s;
      return nullptr;
    };
    int open_at = own;
    for (const Open& o : part.open) {
      const Open* row = of(o);
      const int to_row =
          row ? (is_first ? row->row : row->column) : C.open[static_cast<std::size_t>(open_at)].row;
      const Block& own_waves = is_first ? g : h;
      const Block& to = row ? own_waves : C.s;
      int column_at = own;
      for (const Open& q : part.open) {
        const Open* column = of(q);
        if (!column) {
          copy(part.s, o.row, q.column, o.out, q.in, to, to_row,
               C.open[static_cast<std::size_t>(column_at++)].column);
          continue;
        }
        const int to_column = is_first ? column->column : column->row;
        if (row)
          copy(part.s, o.row, q.column, o.out, q.in, is_first ? aff : bff, to_row, to_column);
        else
          copy(part.s, o.row, q.column, o.out, q.in, is_first ? arf : brf, to_row - (is_first ? 0 : a_rest),
               to_column);
      }
      copy(part.s, o.row, part.s.columns - 1, o.out, 1, to, to_row, in);
      if (!row) ++open_at;
    }
  };
  split(A, 0, true);
  split(B, open_of_a, false);

  // (1 - S1 S2) a = h1 - S1 h2 + S1 S2 in2 - S1 in1
  const Block m = take_raw(arena_, a_out, a_out);
  multiply(aff, bff, m);
  for (int i = 0; i < a_out; ++i)
    for (int j = 0; j < a_out; ++j) m.row(i)[j] = (i == j ? 1.0 : 0.0) - m.row(i)[j];
  multiply_add(-1.0, aff, h, g);
  if (!factorise(m)) return false;
  spacetime::solve(m, pivot_.data(), g);
  if (recording_) {
    C.solve = take(arena_, a_out, a_out + b_out);
    for (int i = 0; i < a_out; ++i) C.solve.row(i)[i] = 1.0;
    copy(aff, 0, 0, a_out, b_out, C.solve, 0, a_out);
    spacetime::solve(m, pivot_.data(), C.solve);
    C.second_on_first = bff, C.first_rest_on_second = arf, C.second_rest_on_first = brf;
  }
  multiply_add(-1.0, bff, g, h);
  multiply_add(-1.0, arf, h, rows_of(C.s, 0, a_rest));
  multiply_add(-1.0, brf, g, rows_of(C.s, a_rest, b_rest));
  flops_ += product_flops(a_out, a_out, b_out) + 2.0 / 3.0 * a_out * a_out * a_out +
            product_flops(a_out, in + 1, a_out) + product_flops(a_out, in + 1, 2.0 * b_out) +
            product_flops(a_rest, in + 1, b_out) + product_flops(b_rest, in + 1, a_out);
  C.from_first = g, C.from_second = h;
  for (const Open& o : C.open) owner_[static_cast<std::size_t>(o.wave)] = component_count_;
  ++component_count_;
  return true;
}

template <int D>
bool PatchSolver<D>::condense_and_join() {
  flops_ = 0.0;
  components_.resize(std::max(components_.size(), static_cast<std::size_t>(2 * count_)));
  response_.resize(components_.size());
  const auto waves = static_cast<std::size_t>(link_count_);
  owner_.resize(std::max(owner_.size(), waves));
  wave_.resize(owner_.size()), wave_width_.resize(owner_.size());
  if (keep_matrix) keep();
  component_count_ = count_;
  for (int e = 0; e < count_; ++e)
    if (!condense(e)) return false;
  for (;;) {  // the two parts whose union has the narrowest boundary
    int best = -1, narrowest = 0;
    for (int w = 0; w < link_count_; w += 2) {
      const int a = owner_[static_cast<std::size_t>(w)], b = owner_[static_cast<std::size_t>(w + 1)];
      if (a == b) continue;
      int width = 0;
      for (const int part : {a, b})
        for (const Open& o : components_[static_cast<std::size_t>(part)].open) {
          const int other = owner_[static_cast<std::size_t>(o.wave ^ 1)];
          if (other != a && other != b) width += o.in;
        }
      if (best < 0 || width < narrowest) best = w, narrowest = width;
    }
    if (best < 0) break;
    const int a = owner_[static_cast<std::size_t>(best)], b = owner_[static_cast<std::size_t>(best + 1)];
    if (!join(std::min(a, b), std::max(a, b))) return false;
    // Facets closed by this join have both sides in the same part from now on.
    for (const Open& o : components_[static_cast<std::size_t>(component_count_ - 1)].shared)
      owner_[static_cast<std::size_t>(o.wave)] = owner_[static_cast<std::size_t>(o.wave ^ 1)] = -1;
  }
  return true;
}

template <int D>
bool PatchSolver<D>::eliminate() {
  if (!condense_and_join()) return false;
  // Back, the last join first: wave_[w] is what the sender of w sent.
  for (int i = component_count_ - 1; i >= count_; --i) {
    const Component& c = components_[static_cast<std::size_t>(i)];
    for (const bool first : {true, false}) {
      const Block& from = first ? c.from_first : c.from_second;
      double* sent = arena_.take_raw(static_cast<std::size_t>(from.rows));
      for (int k = 0; k < from.rows; ++k) sent[k] = from.row(k)[from.columns - 1];
      for (const Open& o : c.open)
        subtract_product(from, o.column, o.in, wave_[static_cast<std::size_t>(o.wave ^ 1)], sent);
      for (const Open& o : c.shared)
        wave_[static_cast<std::size_t>(first ? o.wave : o.wave ^ 1)] = sent + (first ? o.row : o.column);
    }
  }
  for (int e = 0; e < count_; ++e) {
    const auto i = static_cast<std::size_t>(e);
    const Block& b = response_[i];
    for (int k = 0; k < b.rows; ++k) rhs_[i][k] = b.row(k)[b.columns - 1];
    for (const Open& o : components_[i].open)
      subtract_product(b, o.column, o.in, wave_[static_cast<std::size_t>(o.wave ^ 1)], rhs_[i]);
    for (int k = 0; k < b.rows; ++k)
      if (!std::isfinite(rhs_[i][k])) return false;
  }
  return true;
}

/// The matrix of the whole patch, for tests.
template <int D>
void PatchSolver<D>::keep() {
  std::vector<int> first(static_cast<std::size_t>(count_) + 1, 0);
  for (int e = 0; e < count_; ++e)
    first[static_cast<std::size_t>(e) + 1] =
        first[static_cast<std::size_t>(e)] + elements_[static_cast<std::size_t>(e)].unknowns;
  matrix_.assign(static_cast<std::size_t>(unknowns_) * static_cast<std::size_t>(unknowns_), 0.0);
  const auto put = [&](int row, int column, const Block& b) {
    for (int i = 0; i < b.rows; ++i)
      for (int j = 0; j < b.columns; ++j)
        matrix_[static_cast<std::size_t>(first[static_cast<std::size_t>(row)] + i) *
                    static_cast<std::size_t>(unknowns_) +
                static_cast<std::size_t>(first[static_cast<std::size_t>(column)] + j)] += b.row(i)[j];
  };
  for (int e = 0; e < count_; ++e) {
    const auto i = static_cast<std::size_t>(e);
    const Block copy_of_k = own_[i];
    own_[i] = take(arena_, copy_of_k.rows + 1, copy_of_k.columns);
    own_[i].rows = copy_of_k.rows;
    copy(copy_of_k, 0, 0, copy_of_k.rows, copy_of_k.columns, own_[i], 0, 0);
    sum_tables(e);
    put(e, e, own_[i]);
    own_[i] = copy_of_k;
  }
  for (int l = 0; l < link_count_; ++l) {
    const Link &to = links_[static_cast<std::size_t>(l)], &from = links_[static_cast<std::size_t>(l ^ 1)];
    const Block lift = written(to.lift, to.element), emit = written(from.emit, from.element);
    const Block product = take(arena_, lift.columns, emit.columns);
    multiply_transposed_add(to.scale, lift, emit, product);
    put(to.element, from.element, product);
  }
}

template <int D>
Block PatchSolver<D>::written(const Functional& f, int element) {
  if (f.full.data) return f.full;
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(element)];
  const Block full = take(arena_, f.rows * f.count, space.unknowns);
  for (int r = 0; r < f.rows; ++r)
    for (int c = 0; c < f.count; ++c)
      for (int a = 0; a < NU; ++a)
        for (int k = 0; k < space.polynomials; ++k)
          full.row(r * f.count + c)[a * space.polynomials + k] = f.combination[r][a] * f.modes.row(k)[c];
  return full;
}

#define CLEAVE_INSTANTIATE(D)                                                     \
  template void PatchSolver<D>::sum_tables(int);                                  \
  template void PatchSolver<D>::emitted(const Link&, const Block&, const Block&); \
  template bool PatchSolver<D>::factorise(const Block&);                          \
  template bool PatchSolver<D>::condense(int);                                    \
  template bool PatchSolver<D>::join(int, int);                                   \
  template bool PatchSolver<D>::condense_and_join();                              \
  template bool PatchSolver<D>::eliminate();                                      \
  template void PatchSolver<D>::keep();                                           \
  template Block PatchSolver<D>::written(const Functional&, int);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
