// Facet and volume terms of the patch system.
#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/basis.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {

/// A_N in the energy-scaled fields of the facet's element: N_t + N_j A^j.

template <int D>
auto PatchSolver<D>::side(int element, const FacetRule& rule, bool at_points) -> Side {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(element)];
  const int points = rule.rule->points, n = space.polynomials;
  Side s;
  s.element = element;
  s.components = NU;
  for (int i = 0; i < NU; ++i) s.projection[i][i] = 1.0;
  const double scale = 1.0 / std::sqrt(space.volume);
  const Block value = take(arena_, points, n);
  for (int q = 0; q < points; ++q) {
    const auto lambda = space.map(points_[static_cast<std::size_t>(q)]);
    Basis<D + 1>::get().evaluate(lambda.data(), space.degree, value.row(q));
    const double factor =
        scale * (at_points ? std::sqrt(rule.rule->weight[static_cast<std::size_t>(q)]) : 1.0);
    for (int a = 0; a < n; ++a) value.row(q)[a] *= factor;
  }
  if (at_points) {
    s.modes = value;
  } else {
    s.modes = take(arena_, polynomial_count(D, space.degree), n);
    multiply_transposed_add({rule.weighted.data, points, s.modes.rows, rule.weighted.stride}, value, s.modes);
  }
  return s;
}

/// Keeps velocity and traction sigma n only, unscaled: all that a vertical facet sees.

template <int D>
void PatchSolver<D>::project_traces(Side& s, const Vector<D>& n) const {
  const Elastic<D>& m = *elements_[static_cast<std::size_t>(s.element)].material;
  const double root = std::sqrt(m.density);
  s.projection = {};
  s.components = 2 * D;
  for (int i = 0; i < D; ++i) {
    s.projection[i][i] = 1.0 / root;
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < strain_count<D>; ++k) s.projection[D + i][D + k] += root * n[j] * m.flux[j][i][k];
  }
}

/// Writes the functionals out as a matrix on the unknowns.

template <int D>
void PatchSolver<D>::expand(Side& s) {
  if (s.trace.data) return;
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(s.element)];
  const int n = space.polynomials, modes = s.modes.rows;
  s.trace = take(arena_, s.components * modes, space.unknowns);
  const Block part = space.span.data ? take(arena_, modes, space.unknowns) : Block{};
  for (int alpha = 0; alpha < NU; ++alpha) {
    bool used = false;
    for (int r = 0; r < s.components; ++r) used = used || s.projection[r][alpha] != 0.0;
    if (!used) continue;
    if (part.data) {
      std::fill_n(part.data, part.rows * part.stride, 0.0);
      multiply_add(1.0, s.modes, {space.span.row(alpha * n), n, space.unknowns, space.span.stride}, part);
    }
    for (int r = 0; r < s.components; ++r) {
      const double p = s.projection[r][alpha];
      if (p == 0.0) continue;
      for (int c = 0; c < modes; ++c) {
        double* to = s.trace.row(r * modes + c);
        if (part.data)
          for (int k = 0; k < part.stride; ++k) to[k] += p * part.row(c)[k];
        else
          for (int a = 0; a < n; ++a) to[alpha * n + a] += p * s.modes.row(c)[a];
      }
    }
  }
}

/// K(row, column) += row^T factor column; one factor for all modes, or one for each.

template <int D>
void PatchSolver<D>::couple(const Side& row, const Side& column, std::span<const Matrix<NU>> factor) {
  const Block& k = block(row.element, column.element);
  const int modes = std::min(row.modes.rows, column.modes.rows);
  if (!row.trace.data && !column.trace.data) {  // both three-field: coefficients times one scalar matrix
    const Block mass = take(arena_, row.modes.columns, column.modes.columns);
    multiply_transposed_add({row.modes.data, modes, row.modes.columns, row.modes.stride},
                            {column.modes.data, modes, column.modes.columns, column.modes.stride}, mass);
    Matrix<NU> half{}, whole{};
    for (int r = 0; r < row.components; ++r)
      for (int s = 0; s < column.components; ++s)
        for (int b = 0; b < NU; ++b) half[r][b] += factor[0][r][s] * column.projection[s][b];
    for (int a = 0; a < NU; ++a)
      for (int r = 0; r < row.components; ++r)
        for (int b = 0; b < NU; ++b) whole[a][b] += row.projection[r][a] * half[r][b];
    for (int a = 0; a < NU; ++a)
      for (int i = 0; i < mass.rows; ++i) {
        double* to = k.row(a * mass.rows + i);
        const double* from = mass.row(i);
        for (int b = 0; b < NU; ++b) {
          const double f = whole[a][b];
          if (f == 0.0) continue;
          for (int j = 0; j < mass.columns; ++j) to[b * mass.columns + j] += f * from[j];
        }
      }
    return;
  }
  const Block weighted = take(arena_, row.trace.rows, column.trace.columns);
  for (int r = 0; r < row.components; ++r)
    for (int c = 0; c < modes; ++c) {
      const Matrix<NU>& f = factor.size() == 1 ? factor[0] : factor[static_cast<std::size_t>(c)];
      double* to = weighted.row(r * row.modes.rows + c);
      for (int s = 0; s < column.components; ++s) {
        if (f[r][s] == 0.0) continue;
        const double* from = column.trace.row(s * column.modes.rows + c);
        for (int j = 0; j < column.trace.stride; ++j) to[j] += f[r][s] * from[j];
      }
    }
  multiply_transposed_add(row.trace, weighted, k);
}

/// rhs += row^T coefficients. @param coefficients [component][mode]

template <int D>
void PatchSolver<D>::load(const Side& row, const double* coefficients) {
  const Block& r = rhs_[static_cast<std::size_t>(row.element)];
  const int modes = row.modes.rows, n = row.modes.columns;
  if (row.trace.data) {
    for (int c = 0; c < row.trace.rows; ++c)
      for (int k = 0; k < row.trace.columns; ++k) r.row(k)[0] += row.trace.row(c)[k] * coefficients[c];
    return;
  }
  for (int a = 0; a < NU; ++a)
    for (int i = 0; i < row.components; ++i) {
      if (row.projection[i][a] == 0.0) continue;
      for (int c = 0; c < modes; ++c)
        for (int k = 0; k < n; ++k)
          r.row(a * n + k)[0] += row.projection[i][a] * row.modes.row(c)[k] * coefficients[i * modes + c];
    }
}

template <int D>
void PatchSolver<D>::assemble_volume(int e) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(e)];
  const Elastic<D>& m = *space.material;
  const int n = space.polynomials;
  const Block& k = block(e, e);
  if (space.choice.space != LocalSpace::trefftz) {
    const auto derivative = space.derivatives(space.degree, space.degree, arena_);
    if (!space.span.data) {
      const auto add = [&](int row, int column, double factor, const Block& d) {
        for (int a = 0; factor != 0.0 && a < n; ++a)
          for (int b = 0; b < n; ++b) k.row(row * n + a)[column * n + b] += factor * d.row(a)[b];
      };
      for (int i = 0; i < NU; ++i) add(i, i, 1.0, derivative[D]);
      for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i)
          for (int c = 0; c < strain_count<D>; ++c) {
            add(i, D + c, -m.flux[j][i][c], derivative[j]);
            add(D + c, i, -m.flux[j][i][c], derivative[j]);
          }
    } else {
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
  }
  if (!problem_.body_force) return;
  const SimplexRule& rule = simplex_rule(D + 1, space.degree + body_points);
  const Block& rhs = rhs_[static_cast<std::size_t>(e)];
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
        if (!space.span.data) rhs.row(i * n + a)[0] += f;
        for (int c = 0; space.span.data && c < space.unknowns; ++c)
          rhs.row(c)[0] += f * space.span.row(i * n + a)[c];
      }
  }
}

template <int D>
void PatchSolver<D>::assemble_inflow(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older) {
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(facet.element)];
  const FacetRule& rule = facet_rule(points_per_direction(facet, older));
  facet_points(facet, *rule.rule);
  Side s = side(facet.element, rule, false);
  if (space.span.data) expand(s);
  Matrix<NU> a = scaled_flux(facet);
  for (auto& row : a)
    for (double& x : row) x = -x;
  couple(s, s, {&a, 1});

  older_states(patch, facet, older);
  const int modes = s.modes.rows;
  double* data = arena_.take(static_cast<std::size_t>(NU * modes));
  const double root = std::sqrt(space.material->density);
  for (std::size_t q = 0; q < points_.size(); ++q) {
    std::array<double, NU> w{}, flux{};
    for (int i = 0; i < D; ++i) w[i] = root * states_[q].v[i];
    for (int c = 0; c < strain_count<D>; ++c)
      for (int d = 0; d < strain_count<D>; ++d)
        w[D + c] += space.material->to_energy[c][d] * states_[q].strain[d];
    for (int i = 0; i < NU; ++i)
      for (int j = 0; j < NU; ++j) flux[i] += a[i][j] * w[j];
    for (int i = 0; i < NU; ++i)
      for (int c = 0; c < modes; ++c)
        data[i * modes + c] += flux[i] * rule.weighted.row(static_cast<int>(q))[c];
  }
  load(s, data);
}

/// Fills points_, traces_, maps_ and loads_ for a vertical facet. Returns the spatial measure of the facet.

/// Without a solution the traces are zero.

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
  bool kronecker = linear;
  for (int k = 0; k < sides; ++k) {
    s[k] = side(k == 0 ? facet.element : facet.neighbour, rule, !linear);
    project_traces(s[k], face.n);
    kronecker = kronecker && !elements_[static_cast<std::size_t>(s[k].element)].span.data;
  }
  for (int k = 0; k < sides && !kronecker; ++k) expand(s[k]);

  // Rows: v^ . (s - s*) + s^ . (v - v*), both with the same n; side plus sees the normal reversed.
  for (int k = 0; k < sides; ++k) {
    const double sign = k == 0 ? area : -area;
    for (int l = 0; l < sides; ++l) {
      factors_.assign(maps_.size(), Matrix<NU>{});
      for (std::size_t q = 0; q < maps_.size(); ++q)
        for (int i = 0; i < D; ++i)
          for (int c = 0; c < 2 * D; ++c) {
            factors_[q][i][c] = sign * ((k == l && c == D + i ? 1.0 : 0.0) - maps_[q].map[i][2 * D * l + c]);
            factors_[q][D + i][c] =
                sign * ((k == l && c == i ? 1.0 : 0.0) - maps_[q].map[(1 + k) * D + i][2 * D * l + c]);
          }
      couple(s[k], s[l], factors_);
    }
    const int modes = s[k].modes.rows;
    double* data = arena_.take(static_cast<std::size_t>(2 * D * modes));
    for (int q = 0; q < rule.rule->points; ++q) {
      const Star<D>& g = loads_[static_cast<std::size_t>(q)];
      const double root = std::sqrt(rule.rule->weight[static_cast<std::size_t>(q)]);
      for (int i = 0; i < D; ++i) {
        const double traction = sign * g.s[i], velocity = sign * (k == 0 ? g.v_minus[i] : g.v_plus[i]);
        if (!linear) {
          data[i * modes + q] = root * traction, data[(D + i) * modes + q] = root * velocity;
          continue;
        }
        for (int c = 0; c < modes; ++c) {
          data[i * modes + c] += traction * rule.weighted.row(q)[c];
          data[(D + i) * modes + c] += velocity * rule.weighted.row(q)[c];
        }
      }
    }
    load(s[k], data);
  }
}

/// Tilted facet inside one material: upwinding in the eigenvectors of A_N, which lets modes faster than the

/// facet pass both ways and carries the others along.

template <int D>
PatchStatus PatchSolver<D>::assemble_tilted(const Facet<D>& facet) {
  const ElementSpace<D>&minus = elements_[static_cast<std::size_t>(facet.element)],
        &plus = elements_[static_cast<std::size_t>(facet.neighbour)];
  if (minus.material != plus.material || !target(facet).linear()) return PatchStatus::tilted_interface;
  const FacetRule& rule = facet_rule(points_per_direction(facet));
  facet_points(facet, *rule.rule);
  Matrix<NU> work = scaled_flux(facet), vector{}, up{}, down{}, minus_up, minus_down;
  std::array<double, NU> value{};
  symmetric_eigen(NU, work[0].data(), value.data(), vector[0].data());
  for (int i = 0; i < NU; ++i)
    for (int j = 0; j < NU; ++j)
      for (int k = 0; k < NU; ++k)
        (value[k] > 0.0 ? up : down)[i][j] += vector[i][k] * value[k] * vector[j][k];
  minus_up = up, minus_down = down;
  for (auto* m : {&minus_up, &minus_down})
    for (auto& row : *m)
      for (double& x : row) x = -x;
  Side a = side(facet.element, rule, false), b = side(facet.neighbour, rule, false);
  if (minus.span.data || plus.span.data) expand(a), expand(b);
  couple(a, a, {&minus_down, 1});
  couple(a, b, {&down, 1});
  couple(b, b, {&up, 1});
  couple(b, a, {&minus_up, 1});
  return PatchStatus::solved;
}

#define CLEAVE_INSTANTIATE(D)                                                                          \
  template void PatchSolver<D>::assemble_volume(int);                                                  \
  template void PatchSolver<D>::assemble_inflow(const Patch<D>&, const Facet<D>&, const Solution<D>*); \
  template void PatchSolver<D>::assemble_vertical(const Facet<D>&, std::span<const Solution<D>>);      \
  template PatchStatus PatchSolver<D>::assemble_tilted(const Facet<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
