// What the patch solver asks of a facet: its points, its kind, the states on it, its star values.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "discretisation/spacetime/basis_facet.hpp"
#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// A facet whose speed is below this part of the fastest wave counts as vertical, and so does one whose N_t
/// is no more than rounding of the coordinates, seen against the element's own extent in space.
constexpr double vertical_speed = 1e-9, rounding = 1e-12;
/// Barycentric coordinates this close to those of a corner are that corner.
constexpr double same_corner = 1e-7;

template <int D>
double space_length(const Event<D>& normal) {
  double square = 0.0;
  for (int k = 0; k < D; ++k) square += normal[k] * normal[k];
  return std::sqrt(square);
}

}  // namespace

template <int D>
const FacetRule& PatchSolver<D>::facet_rule(int per_direction) const {
  struct Tables {
    Arena memory;
    std::array<FacetRule, largest_degree + 3> rule;
    Tables() {
      for (int n = 1; n < static_cast<int>(rule.size()); ++n) {
        FacetRule& r = rule[static_cast<std::size_t>(n)];
        r.rule = &simplex_rule(D, n);
        r.coordinate = take(memory, D + 1, r.rule->points);
        for (int q = 0; q < r.rule->points; ++q)
          for (int c = 0; c <= D; ++c)
            r.coordinate.row(c)[q] = r.rule->barycentric[static_cast<std::size_t>(q * (D + 1) + c)];
        r.weighted = take(memory, r.rule->points, Basis<D>::count);
        for (int q = 0; q < r.rule->points; ++q) {
          Basis<D>::get().evaluate(&r.rule->barycentric[static_cast<std::size_t>(q * (D + 1))],
                                   largest_degree, r.weighted.row(q));
          for (int c = 0; c < Basis<D>::count; ++c)
            r.weighted.row(q)[c] *= r.rule->weight[static_cast<std::size_t>(q)];
        }
      }
    }
  };
  static const Tables tables;
  return tables.rule[static_cast<std::size_t>(per_direction)];
}

template <int D>
int PatchSolver<D>::points_per_direction(const Facet<D>& facet, const Solution<D>* older) const {
  int degree = elements_[static_cast<std::size_t>(facet.element)].degree;
  if (facet.neighbour >= 0)
    degree = std::max(degree, elements_[static_cast<std::size_t>(facet.neighbour)].degree);
  if (older) degree = std::max(degree, older->degree);
  const bool bulk = facet.kind == FacetKind::inflow || facet.kind == FacetKind::outflow;
  return degree + (bulk || target(facet).linear() ? 1 : 2);
}

template <int D>
void PatchSolver<D>::facet_points(const Facet<D>& facet, const SimplexRule& rule) const {
  points_.assign(static_cast<std::size_t>(rule.points), Event<D>{});
  for (int q = 0; q < rule.points; ++q)
    for (int c = 0; c <= D; ++c)
      for (int k = 0; k <= D; ++k)
        points_[static_cast<std::size_t>(q)][k] +=
            rule.barycentric[static_cast<std::size_t>(q * (D + 1) + c)] * facet.corner[c][k];
}

template <int D>
void PatchSolver<D>::older_states(const Patch<D>& patch, const Facet<D>& facet,
                                  const Solution<D>* older) const {
  states_.assign(points_.size(), PointState<D>{});
  if (older) {
    older->at(points_, states_);
  } else if (problem_.initial) {
    const Simplex simplex = patch.elements[static_cast<std::size_t>(facet.element)].simplex;
    for (std::size_t q = 0; q < points_.size(); ++q) states_[q] = problem_.initial(simplex, points_[q]);
  }
}

template <int D>
double* PatchSolver<D>::older_modes(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older,
                                    int degree, int count, int first_row, int last_row) {
  constexpr int rows = D + NU;
  const int stride = padded(count);
  // The facet is one of the solution's element: find its corners there.
  std::array<int, D + 1> order{};
  int opposite = (D + 1) * (D + 2) / 2;
  bool found = older != nullptr;
  for (int i = 0; i <= D && found; ++i) {
    const auto lambda = older->map(facet.corner[static_cast<std::size_t>(i)]);
    int at = -1;
    for (int c = 0; c < D + 2; ++c) {
      if (std::fabs(lambda[static_cast<std::size_t>(c)] - 1.0) < same_corner) at = c;
      found = found && (at == c || std::fabs(lambda[static_cast<std::size_t>(c)]) < same_corner);
    }
    found = found && at >= 0;
    order[static_cast<std::size_t>(i)] = at;
    opposite -= at;
  }
  if (!found) {
    double* out = arena_.take(static_cast<std::size_t>(rows * stride));
    if (older) degree = std::max(degree, older->degree);
    const FacetRule& rule = facet_rule(degree + 1);
    facet_points(facet, *rule.rule);
    older_states(patch, facet, older);
    double value[rows];
    for (std::size_t q = 0; q < points_.size(); ++q) {
      std::copy_n(states_[q].u.data(), D, value);
      std::copy_n(states_[q].v.data(), D, value + D);
      std::copy_n(states_[q].strain.data(), strain_count<D>, value + 2 * D);
      for (int r = first_row; r < last_row; ++r)
        for (int c = 0; c < count; ++c)
          out[r * stride + c] += value[r] * rule.weighted.row(static_cast<int>(q))[c];
    }
    return out;
  }
  for (int& i : order) i -= i > opposite ? 1 : 0;
  const Block& modes = FacetBasis<D>::get().modes(opposite);
  const int n = polynomial_count(D + 1, older->degree),
            nu = polynomial_count(D + 1, older->displacement_degree);
  bool same_order = true;
  std::array<int, D + 1> back{};
  for (int i = 0; i <= D; ++i) {
    same_order = same_order && order[static_cast<std::size_t>(i)] == i;
    back[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] = i;
  }
  // Renumbering corners keeps orthonormality: the transpose of a table is that of the way back.
  const Block& turned = FacetBasis<D>::get().turned(back);
  double* out = arena_.take(static_cast<std::size_t>(rows * stride));
  const int known = opposite == 0 && !older->above.empty() ? polynomial_count(D, older->degree) : 0;
  alignas(64) double trace[padded(Basis<D>::count)];
  for (int r = first_row; r < last_row; ++r) {
    const double *coefficient = r < D ? older->displacement.data() + static_cast<std::ptrdiff_t>(r) * nu
                                      : older->fields.data() + static_cast<std::ptrdiff_t>(r - D) * n,
                 *from = trace;
    if (count <= known)
      from = older->above.data() + static_cast<std::ptrdiff_t>(r) * known;
    else
      multiply_vectors({modes.data, r < D ? nu : n, count, modes.stride}, coefficient, trace, 1);
    double* to = out + r * stride;
    if (same_order)
      std::copy_n(from, count, to);
    else
      multiply_vectors({turned.data, count, count, turned.stride}, from, to, 1);
    std::fill(to + count, to + stride, 0.0);
  }
  return out;
}

template <int D>
double* PatchSolver<D>::trace_modes(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older,
                                    int degree, int count, bool displacement) {
  constexpr int rows = D + NU;
  double* now =
      older_modes(patch, facet, older, degree, count, displacement ? 0 : D, displacement ? D : rows);
  if (displacement) return now;
  const Elastic<D>& m = *elements_[static_cast<std::size_t>(facet.element)].material;
  const int stride = padded(count);
  double* out = arena_.take_raw(static_cast<std::size_t>(rows * stride));
  const base::Lanes root(std::sqrt(m.density));
  for (int c = 0; c < stride; c += base::lane_count) {
    for (int i = D; i < 2 * D; ++i)
      (root * base::Lanes::load(now + i * stride + c)).store(out + i * stride + c);
    for (int i = 0; i < strain_count<D>; ++i) {
      base::Lanes sum(0.0);
      for (int j = 0; j < strain_count<D>; ++j)
        sum = fma(base::Lanes(m.to_energy[i][j]), base::Lanes::load(now + (2 * D + j) * stride + c), sum);
      sum.store(out + (2 * D + i) * stride + c);
    }
  }
  return out;
}

template <int D>
bool PatchSolver<D>::is_vertical(const Facet<D>& facet) const {
  if (facet.kind == FacetKind::boundary) return true;
  const ElementSpace<D>& space = elements_[static_cast<std::size_t>(facet.element)];
  const double tilt = std::fabs(facet.normal[D]);
  return tilt <= vertical_speed * space.material->fastest * space_length<D>(facet.normal) ||
         tilt <= rounding * (D + 1) * space.volume / (space.corner[D + 1][D] - space.corner[0][D]);
}

template <int D>
const Target<D>& PatchSolver<D>::target(const Facet<D>& facet) const {
  if (facet.boundary < 0) {
    CLEAVE_ASSERT(facet.kind == FacetKind::interior, "a boundary facet needs its boundary face");
    return *bonded_;
  }
  const Target<D>* t = problem_.targets[static_cast<std::size_t>(facet.boundary)];
  CLEAVE_ASSERT(t != nullptr, "a boundary face without target");
  return *t;
}

template <int D>
Interface<D> PatchSolver<D>::interface_of(const Facet<D>& facet) const {
  Interface<D> f;
  const double length = space_length<D>(facet.normal);
  for (int k = 0; k < D; ++k) f.n[k] = facet.normal[k] / length;
  f.minus = elements_[static_cast<std::size_t>(facet.element)].material;
  f.z_minus = f.minus->impedance(f.n);
  if (facet.neighbour >= 0) {
    f.plus = elements_[static_cast<std::size_t>(facet.neighbour)].material;
    f.z_plus = f.plus == f.minus ? f.z_minus : f.plus->impedance(f.n);
  }
  return f;
}

template <int D>
auto PatchSolver<D>::scaled_flux(const Facet<D>& facet) const -> Matrix<NU> {
  const Elastic<D>& m = *elements_[static_cast<std::size_t>(facet.element)].material;
  Matrix<NU> a{};
  for (int i = 0; i < NU; ++i) a[i][i] = facet.normal[D];
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < strain_count<D>; ++k) {
        a[i][D + k] -= facet.normal[j] * m.flux[j][i][k];
        a[D + k][i] -= facet.normal[j] * m.flux[j][i][k];
      }
  return a;
}

template <int D>
double PatchSolver<D>::star_values(const Facet<D>& facet, std::span<const Solution<D>> solution) const {
  const Target<D>& law = target(facet);
  const Interface<D> face = interface_of(facet);
  facet_points(facet, *facet_rule(points_per_direction(facet)).rule);
  for (Event<D>& y : points_)
    for (int k = 0; k <= D; ++k) y[k] += origin_[k];
  traces_.assign(points_.size(), Traces<D>{});
  for (int k = 0; k < (facet.neighbour >= 0 ? 2 : 1) && !solution.empty(); ++k) {
    const Solution<D>& from = solution[static_cast<std::size_t>(k == 0 ? facet.element : facet.neighbour)];
    states_.resize(points_.size());
    from.at(points_, states_);
    for (std::size_t q = 0; q < points_.size(); ++q) {
      const Voigt<D> stress = from.material->stress(states_[q].strain);
      Vector<D> s{};
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) s[i] += stress[voigt<D>(i, j)] * face.n[j];
      Traces<D>& t = traces_[q];
      (k == 0 ? t.v_minus : t.v_plus) = states_[q].v;
      (k == 0 ? t.s_minus : t.s_plus) = s;
      (k == 0 ? t.u_minus : t.u_plus) = states_[q].u;
    }
  }
  maps_.assign(law.linear() ? 1 : points_.size(), StarMap<D>{});
  loads_.assign(points_.size(), Star<D>{});
  law.star(face, points_, traces_, maps_, loads_);
  return space_length<D>(facet.normal);
}

#define CLEAVE_INSTANTIATE(D)                                                                             \
  template const FacetRule& PatchSolver<D>::facet_rule(int) const;                                        \
  template int PatchSolver<D>::points_per_direction(const Facet<D>&, const Solution<D>*) const;           \
  template void PatchSolver<D>::facet_points(const Facet<D>&, const SimplexRule&) const;                  \
  template void PatchSolver<D>::older_states(const Patch<D>&, const Facet<D>&, const Solution<D>*) const; \
  template double* PatchSolver<D>::older_modes(const Patch<D>&, const Facet<D>&, const Solution<D>*, int, \
                                               int, int, int);                                            \
  template double* PatchSolver<D>::trace_modes(const Patch<D>&, const Facet<D>&, const Solution<D>*, int, \
                                               int, bool);                                                \
  template bool PatchSolver<D>::is_vertical(const Facet<D>&) const;                                       \
  template const Target<D>& PatchSolver<D>::target(const Facet<D>&) const;                                \
  template Interface<D> PatchSolver<D>::interface_of(const Facet<D>&) const;                              \
  template auto PatchSolver<D>::scaled_flux(const Facet<D>&) const->Matrix<NU>;                           \
  template double PatchSolver<D>::star_values(const Facet<D>&, std::span<const Solution<D>>) const;
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
