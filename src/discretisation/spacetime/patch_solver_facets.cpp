// Facet and volume terms of the patch system.
#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/basis_facet.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using base::lane_count;
using base::Lanes;

template <int N>
Matrix<N> scaled(const Matrix<N>& a, double s) {
  Matrix<N> b = a;
  for (auto& row : b)
    for (double& x : row) x *= s;
  return b;
}

/// sum_r a_r b_r^T over the first `rows` rows.
template <int N>
Matrix<N> outer(const Matrix<N>& a, const Matrix<N>& b, int rows) {
  Matrix<N> m{};
  for (int r = 0; r < rows; ++r)
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) m[i][j] += a[r][i] * b[r][j];
  return m;
}

}  // namespace

template <int D>
auto PatchSolver<D>::side(int element, const Facet<D>& facet, const FacetRule& rule, bool at_points) -> Side {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(element)];
  const int points = rule.rule->points, n = space.polynomials;
  Side s;
  s.element = element;
  s.scale = 1.0 / std::sqrt(space.volume);
  s.count = at_points ? points : polynomial_count(D, space.degree);
  if (space.choice.space == LocalSpace::trefftz) {
    s.modes = space.trefftz_modes(facet.corner, rule, at_points, arena_);
    return s;
  }
  s.opposite = space.opposite(facet.corner);
  if (!at_points && s.opposite >= 0) {
    const Block& table = FacetBasis<D>::get().modes(s.opposite);
    s.modes = {table.data, n, s.count, table.stride};
    return s;
  }
  facet_points(facet, *rule.rule);
  const Block value = take(arena_, points, n);
  for (int q = 0; q < points; ++q)
    Basis<D + 1>::get().evaluate(space.map(points_[static_cast<std::size_t>(q)]).data(), space.degree,
                                 value.row(q));
  s.modes = take(arena_, n, s.count);
  if (!at_points) {
    multiply_transposed(value, rule.weighted, s.modes);
    return s;
  }
  for (int q = 0; q < points; ++q)
    for (int a = 0; a < n; ++a)
      s.modes.row(a)[q] = value.row(q)[a] * std::sqrt(rule.rule->weight[static_cast<std::size_t>(q)]);
  return s;
}

/// All components of the state on the facet as functionals of the unknowns, without the scale of the side.
template <int D>
void PatchSolver<D>::trace(Side& s) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(s.element)];
  if (!space.span.data || s.trace.data) return;
  s.trace = take_raw(arena_, NU * s.count, space.unknowns);
  for (int a = 0; a < NU; ++a)
    multiply_transposed({s.modes.data, s.modes.rows, s.count, s.modes.stride},
                        {space.span.row(a * s.modes.rows), s.modes.rows, space.unknowns, space.span.stride},
                        {s.trace.row(a * s.count), s.count, space.unknowns, s.trace.stride});
}

/// The first `rows` combinations of the components in the first `count` modes; one combination for all modes
/// or one for each. Three fields stay a combination unless `in_full`.
template <int D>
auto PatchSolver<D>::functional(const Side& s, std::span<const Combination> c, int rows, int count,
                                bool in_full) -> Functional {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(s.element)];
  Functional f{.rows = rows, .count = count, .full = {}, .combination = {}, .modes = s.modes};
  if (!space.span.data && !in_full) {
    f.combination = scaled<NU>(c[0], s.scale);
    return f;
  }
  f.full = s.trace.data ? take_raw(arena_, rows * count, space.unknowns)
                        : take(arena_, rows * count, space.unknowns);
  for (int r = 0; r < rows; ++r)
    for (int m = 0; m < count; ++m) {
      const auto& row = c[c.size() == 1 ? 0 : static_cast<std::size_t>(m)][static_cast<std::size_t>(r)];
      double* to = f.full.row(r * count + m);
      if (s.trace.data) {
        const double* from = s.trace.row(m);
        const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(s.count) * s.trace.stride;
        for (int k = 0; k < f.full.stride; k += lane_count) {
          Lanes sum(0.0);
          for (int a = 0; a < NU; ++a)
            sum =
                fma(Lanes(s.scale * row[static_cast<std::size_t>(a)]), Lanes::load(from + a * next + k), sum);
          sum.store(to + k);
        }
        continue;
      }
      for (int a = 0; a < NU; ++a)
        for (int k = 0; k < space.polynomials; ++k)
          to[a * space.polynomials + k] += s.scale * row[static_cast<std::size_t>(a)] * s.modes.row(k)[m];
    }
  return f;
}

template <int D>
void PatchSolver<D>::add(const Side& s, const Functional& a, const Functional& b, double scale) {
  const auto e = static_cast<std::size_t>(s.element);
  if (a.full.data) {
    multiply_transposed_add(scale, a.full, b.full, own_[e]);
    own_filled_[e] = 1;
    return;
  }
  Block mass;
  if (s.opposite >= 0) {
    mass = FacetBasis<D>::get().mass(s.opposite);
  } else {
    const Block transposed = take(arena_, s.count, s.modes.rows);
    for (int k = 0; k < s.modes.rows; ++k)
      for (int c = 0; c < s.count; ++c) transposed.row(c)[k] = s.modes.row(k)[c];
    mass = take(arena_, s.modes.rows, s.modes.rows);
    multiply_transposed_add(transposed, transposed, mass);
  }
  term_[e].push_back({scaled<NU>(outer<NU>(a.combination, b.combination, a.rows), scale), mass});
}

template <int D>
void PatchSolver<D>::load(int element, const Functional& f, double scale, const double* data) {
  double* rhs = rhs_[static_cast<std::size_t>(element)];
  const int stride = padded(f.count);
  if (f.full.data) {
    for (int r = 0; r < f.rows; ++r)
      for (int c = 0; c < f.count; ++c)
        axpy(f.full.stride, scale * data[r * stride + c], f.full.row(r * f.count + c), rhs);
    return;
  }
  const int n = elements_[static_cast<std::size_t>(element)].polynomials;
  for (int r = 0; r < f.rows; ++r)
    for (int k = 0; k < n; ++k) {
      Lanes sum(0.0);
      for (int c = 0; c < stride; c += lane_count)
        sum = fma(Lanes::load(f.modes.row(k) + c), Lanes::load(data + r * stride + c), sum);
      const double x = scale * base::sum(sum);
      for (int a = 0; a < NU; ++a) rhs[a * n + k] += f.combination[r][a] * x;
    }
}

template <int D>
void PatchSolver<D>::assemble_volume(int e) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
  const Elastic<D>& m = *space.material;
  const int n = space.polynomials;
  if (space.choice.space == LocalSpace::three_field) {
    for (int l = 1; l <= D + 1; ++l) {
      const auto& gradient = space.map.gradient[static_cast<std::size_t>(l - 1)];
      Matrix<NU> a{};
      for (int i = 0; i < NU; ++i) a[i][i] = gradient[D];
      for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i)
          for (int c = 0; c < strain_count<D>; ++c) {
            a[i][D + c] -= gradient[static_cast<std::size_t>(j)] * m.flux[j][i][c];
            a[D + c][i] -= gradient[static_cast<std::size_t>(j)] * m.flux[j][i][c];
          }
      term_[static_cast<std::size_t>(e)].push_back({a, FacetBasis<D>::get().weak(l)});
    }
  } else if (space.choice.space == LocalSpace::one_field) {
    const Block& k = own_[static_cast<std::size_t>(e)];
    const auto derivative = space.derivatives(space.degree, space.degree, arena_);
    // Compatibility holds identically for derivatives of a displacement: momentum rows only.
    const Block strain = take(arena_, n, space.unknowns);
    for (int i = 0; i < D; ++i) {
      const Block residual = take(arena_, n, space.unknowns);
      const Block test{space.span.row(i * n), n, space.unknowns, space.span.stride};
      multiply_add(1.0, derivative[D], test, residual);
      for (int j = 0; j < D; ++j) {
        std::fill_n(strain.data, strain.rows * strain.stride, 0.0);
        for (int c = 0; c < strain_count<D>; ++c)
          for (int a = 0; m.flux[j][i][c] != 0.0 && a < n; ++a)
            for (int b = 0; b < space.unknowns; ++b)
              strain.row(a)[b] += m.flux[j][i][c] * space.span.row((D + c) * n + a)[b];
        multiply_add(-1.0, derivative[j], strain, residual);
      }
      multiply_transposed_add(test, residual, k);
    }
  }
  if (!problem_.body_force) return;
  const SimplexRule& rule = simplex_rule(D + 1, space.degree + body_points);
  double* rhs = rhs_[static_cast<std::size_t>(e)];
  double phi[Basis<D + 1>::count];
  for (int q = 0; q < rule.points; ++q) {
    const double* lambda = &rule.barycentric[static_cast<std::size_t>(q * (D + 2))];
    Event<D> y{};
    for (int c = 0; c < D + 2; ++c)
      for (int i = 0; i <= D; ++i) y[i] += lambda[c] * space.corner[c][i];
    Basis<D + 1>::get().evaluate(lambda, space.degree, phi);
    const Vector<D> b = problem_.body_force(y);
    // The mean over the element times its volume, times phi / sqrt(volume), tested with sqrt(rho) v.
    const double scale = rule.weight[static_cast<std::size_t>(q)] * std::sqrt(space.volume * m.density);
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < n; ++a) {
        const double f = scale * b[i] * phi[a];
        if (!space.span.data) rhs[i * n + a] += f;
        for (int c = 0; space.span.data && c < space.unknowns; ++c)
          rhs[c] += f * space.span.row(i * n + a)[c];
      }
  }
}

template <int D>
void PatchSolver<D>::assemble_inflow(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(facet.element)];
  const FacetRule& rule = facet_rule(space.degree + 1);
  Side s = side(facet.element, facet, rule, false);
  trace(s);
  const Matrix<NU> a = scaled<NU>(scaled_flux(facet), -1.0);
  Matrix<NU> one{};
  for (int i = 0; i < NU; ++i) one[i][i] = 1.0;
  Functional all;
  if (s.trace.data)
    all = {.rows = NU, .count = s.count, .full = s.trace, .combination = {}, .modes = s.modes};
  else
    all = functional(s, {&one, 1}, NU, s.count, false);
  add(s, all, functional(s, {&a, 1}, NU, s.count, false), s.trace.data ? s.scale : 1.0);

  if (recording_) {
    given_[static_cast<std::size_t>(facet.element)].push_back({all, s.trace.data ? s.scale : 1.0});
    return;
  }
  const double* state = trace_modes(patch, facet, older, space.degree, s.count, false);
  const int stride = padded(s.count);
  double* data = arena_.take(static_cast<std::size_t>(NU * stride));
  for (int i = 0; i < NU; ++i)
    for (int j = 0; j < NU; ++j)
      if (a[i][j] != 0.0) axpy(stride, a[i][j], state + (D + j) * stride, data + i * stride);
  load(facet.element, all, s.trace.data ? s.scale : 1.0, data);
}

/// With tau = Z v + s and c = s - Z v, both with the side's outward normal, the facet term of a side is
/// tau^ . (v - v*): star values agree with the outgoing characteristic c, so that the rows of traction and of
/// velocity are the same but for the impedance. v* depends on the other side through its c alone.
template <int D>
void PatchSolver<D>::assemble_vertical(const Facet<D>& facet, std::span<const Solution<D>> now) {
  const double area = star_values(facet, now);
  const bool linear = target(facet).linear();
  const FacetRule& rule = facet_rule(points_per_direction(facet));
  if (!linear) {
    stars_.resize(std::max(stars_.size(), star_count_ + points_.size()));
    for (std::size_t q = 0; q < points_.size(); ++q, ++star_count_) {
      const Star<D> star = maps_[q].apply(traces_[q], loads_[q]);
      for (int i = 0; i < D; ++i) {
        star_change_ = std::max(star_change_, std::fabs(star.s[i] - stars_[star_count_].s[i]));
        star_size_ = std::max(star_size_, std::fabs(star.s[i]));
      }
      stars_[star_count_] = star;
    }
  }
  const Interface<D> face = interface_of(facet);
  const int sides = facet.neighbour >= 0 ? 2 : 1;
  Side s[2];
  for (int k = 0; k < sides; ++k) {
    s[k] = side(k == 0 ? facet.element : facet.neighbour, facet, rule, !linear);
    trace(s[k]);
  }
  const int shared = sides == 2 ? std::min(s[0].count, s[1].count) : 0;
  for (int k = 0; k < sides; ++k) {
    const Elastic<D>& m = *elements_[static_cast<std::size_t>(s[k].element)].material;
    const double root = std::sqrt(m.density), out = k == 0 ? 1.0 : -1.0;
    const Matrix<D>& z = k == 0 ? face.z_minus : face.z_plus;
    Matrix<D, NU> velocity{}, traction{};  // traction on the side's own outward normal
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        velocity[i][i] = 1.0 / root;
        for (int c = 0; c < strain_count<D>; ++c)
          traction[i][D + c] += out * root * face.n[j] * m.flux[j][i][c];
      }
    }
    Combination tau{};
    Matrix<D, NU> c{};
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < NU; ++a) {
        double zv = 0.0;
        for (int j = 0; j < D; ++j) zv += z[i][j] * velocity[j][a];
        tau[i][a] = traction[i][a] + zv, c[i][a] = traction[i][a] - zv;
      }
    for (auto& list : combination_) list.assign(maps_.size(), Combination{});
    for (std::size_t q = 0; q < maps_.size(); ++q)
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < NU; ++a) {
          double own = velocity[i][a], sent = 0.0;
          for (int j = 0; j < D; ++j) {
            // The map knows tractions on the normal of side minus.
            own -= out * maps_[q].map[(1 + k) * D + i][2 * D * k + D + j] * c[j][a];
            if (sides == 2) sent -= out * maps_[q].map[(2 - k) * D + i][2 * D * k + D + j] * c[j][a];
          }
          combination_[0][q][i][a] = own, combination_[1][q][i][a] = sent;
        }
    const Functional test = functional(s[k], {&tau, 1}, D, s[k].count, !linear);
    add(s[k], test, functional(s[k], combination_[0], D, s[k].count, !linear), area);
    if (sides == 2) {
      Link& l = links_[static_cast<std::size_t>(new_link(s[k].element))];
      l.scale = area;
      l.lift = shared == s[k].count ? test : functional(s[k], {&tau, 1}, D, shared, !linear);
      l.emit = functional(s[k], combination_[1], D, shared, !linear);
    }
    if (facet.boundary < 0) continue;  // bonded: star values depend on traces alone
    if (recording_) {
      given_[static_cast<std::size_t>(facet.element)].push_back({test, area});
      continue;
    }
    const int stride = padded(s[k].count);
    double* data = arena_.take(static_cast<std::size_t>(D * stride));
    for (int q = 0; q < rule.rule->points; ++q) {
      const Star<D>& g = loads_[static_cast<std::size_t>(q)];
      for (int i = 0; i < D; ++i) {
        const double v = k == 0 ? g.v_minus[i] : g.v_plus[i];
        if (!linear)
          data[i * stride + q] = std::sqrt(rule.rule->weight[static_cast<std::size_t>(q)]) * v;
        else
          for (int j = 0; j < s[k].count; ++j) data[i * stride + j] += v * rule.weighted.row(q)[j];
      }
    }
    load(s[k].element, test, area, data);
  }
}

/// The next side of an interior facet; the two sides of a facet follow each other.
template <int D>
int PatchSolver<D>::new_link(int element) {
  if (links_.size() <= static_cast<std::size_t>(link_count_)) links_.resize(links_.size() + 16);
  links_of_[static_cast<std::size_t>(element)].push_back(link_count_);
  Link& l = links_[static_cast<std::size_t>(link_count_)];
  l = {};
  l.element = element, l.wave = link_count_;
  return link_count_++;
}

/// Tilted facet inside one material: upwinding in the eigenvectors of A_N, which lets modes faster than the
/// facet pass both ways and carries the others along.
template <int D>
PatchStatus PatchSolver<D>::assemble_tilted(const Facet<D>& facet) {
  const ElementSpace<D>&minus = elements_[static_cast<std::size_t>(facet.element)],
        &plus = elements_[static_cast<std::size_t>(facet.neighbour)];
  if (minus.material != plus.material || !target(facet).linear()) return PatchStatus::tilted_interface;
  const FacetRule& rule = facet_rule(points_per_direction(facet));
  Matrix<NU> work = scaled_flux(facet), vector{};
  std::array<double, NU> value{};
  symmetric_eigen(NU, work[0].data(), value.data(), vector[0].data());
  Side s[2] = {side(facet.element, facet, rule, false), side(facet.neighbour, facet, rule, false)};
  const int shared = std::min(s[0].count, s[1].count);
  for (int k = 0; k < 2; ++k) {
    trace(s[k]);
    // Side minus takes in the modes of negative speed and sends the positive ones, side plus the reverse.
    Combination taken{}, own{}, sent{};
    int in = 0, out = 0;
    for (int i = 0; i < NU; ++i) {
      const bool receives = (value[i] > 0.0) == (k == 1);
      for (int a = 0; a < NU; ++a) {
        if (receives)
          taken[in][a] = vector[a][i], own[in][a] = std::fabs(value[i]) * vector[a][i];
        else
          sent[out][a] = -std::fabs(value[i]) * vector[a][i];
      }
      ++(receives ? in : out);
    }
    const Functional test = functional(s[k], {&taken, 1}, in, s[k].count, false);
    add(s[k], test, functional(s[k], {&own, 1}, in, s[k].count, false), 1.0);
    Link& l = links_[static_cast<std::size_t>(new_link(s[k].element))];
    l.lift = shared == s[k].count ? test : functional(s[k], {&taken, 1}, in, shared, false);
    l.emit = functional(s[k], {&sent, 1}, out, shared, false);
  }
  return PatchStatus::solved;
}

#define CLEAVE_INSTANTIATE(D)                                                                          \
  template auto PatchSolver<D>::side(int, const Facet<D>&, const FacetRule&, bool)->Side;              \
  template void PatchSolver<D>::assemble_volume(int);                                                  \
  template void PatchSolver<D>::assemble_inflow(const Patch<D>&, const Facet<D>&, const Solution<D>*); \
  template void PatchSolver<D>::assemble_vertical(const Facet<D>&, std::span<const Solution<D>>);      \
  template PatchStatus PatchSolver<D>::assemble_tilted(const Facet<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
