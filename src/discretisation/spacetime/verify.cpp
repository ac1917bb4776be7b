#include "discretisation/spacetime/verify.hpp"

#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/patch_solver.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Momentum flux p N_t - sigma N_x and energy 1/2 U A_N U of a state through an area vector.
template <int D>
struct Flux {
  Vector<D> momentum{};
  double energy = 0.0;
  Flux(const Elastic<D>& m, const PointState<D>& state, const Event<D>& normal) {
    const Voigt<D> stress = m.stress(state.strain);
    double density = 0.0;
    for (int i = 0; i < D; ++i) {
      density += 0.5 * m.density * state.v[i] * state.v[i];
      momentum[i] = m.density * state.v[i] * normal[D];
      for (int j = 0; j < D; ++j) {
        momentum[i] -= stress[voigt<D>(i, j)] * normal[j];
        energy -= state.v[i] * stress[voigt<D>(i, j)] * normal[j];
      }
    }
    for (int c = 0; c < strain_count<D>; ++c)
      density += 0.5 * work_factor<D>(c) * stress[c] * state.strain[c];
    energy += density * normal[D];
  }
};

template <int D>
PointState<D> difference(const PointState<D>& a, const PointState<D>& b) {
  PointState<D> d;
  for (int i = 0; i < D; ++i) d.v[i] = a.v[i] - b.v[i];
  for (int c = 0; c < strain_count<D>; ++c) d.strain[c] = a.strain[c] - b.strain[c];
  return d;
}

}  // namespace

template <int D>
void PatchSolver<D>::verify(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                            std::span<const Solution<D>> solution, Verify& out) {
  // It need not be the patch solved last.
  if (elements_.size() < patch.elements.size()) elements_.resize(patch.elements.size());
  for (std::size_t e = 0; e < patch.elements.size(); ++e) {
    ElementSpace<D>& space = elements_[e];
    space.material = solution[e].material, space.degree = solution[e].degree;
    space.corner = patch.elements[e].corner, space.volume = patch.elements[e].volume;
  }
  out = {};
  out.element_dissipation.assign(patch.elements.size(), 0.0);
  std::vector<Vector<D>> residual(patch.elements.size(), Vector<D>{});
  double largest_flux = 0.0, old_energy = 0.0, new_energy = 0.0;
  const auto add = [&](int e, const Vector<D>& flux, double sign) {
    for (int i = 0; i < D; ++i) residual[static_cast<std::size_t>(e)][i] += sign * flux[i];
  };
  for (std::size_t f = 0; f < patch.facets.size(); ++f) {
    const Facet<D>& facet = patch.facets[f];
    if (listed_before(facet)) continue;
    const auto e = static_cast<std::size_t>(facet.element);
    const SimplexRule& rule = *facet_rule(points_per_direction(facet, older[f])).rule;
    facet_points(facet, rule);
    Vector<D> total{};  // through the facet, outward from its element
    double size = 0.0;
    if (facet.kind == FacetKind::inflow || facet.kind == FacetKind::outflow) {
      other_states_.resize(points_.size());
      solution[e].at(points_, other_states_);
      if (facet.kind == FacetKind::inflow) older_states(patch, facet, older[f]);
      for (std::size_t q = 0; q < points_.size(); ++q) {
        const PointState<D>& star = facet.kind == FacetKind::inflow ? states_[q] : other_states_[q];
        const Flux<D> flux(*solution[e].material, star, facet.normal);
        for (int i = 0; i < D; ++i) {
          total[i] += rule.weight[q] * flux.momentum[i];
          size += rule.weight[q] * std::fabs(flux.momentum[i]);
        }
        (facet.kind == FacetKind::inflow ? old_energy : new_energy) +=
            rule.weight[q] * std::fabs(flux.energy);
        if (facet.kind == FacetKind::inflow)
          out.element_dissipation[e] -=
              rule.weight[q] *
              Flux<D>(*solution[e].material, difference(states_[q], other_states_[q]), facet.normal).energy;
      }
    } else if (is_vertical(facet)) {
      const double area = star_values(facet, solution);
      for (std::size_t q = 0; q < points_.size(); ++q) {
        const Traces<D>& t = traces_[q];
        const Star<D> star = maps_[maps_.size() == 1 ? 0 : q].apply(t, loads_[q]);
        const double weight = area * rule.weight[q];
        for (int i = 0; i < D; ++i) {
          total[i] -= weight * star.s[i];
          size += weight * std::fabs(star.s[i]);
          out.element_dissipation[e] +=
              weight * (t.v_minus[i] - star.v_minus[i]) * (t.s_minus[i] - star.s[i]);
          if (facet.neighbour >= 0) {
            out.element_dissipation[static_cast<std::size_t>(facet.neighbour)] -=
                weight * (t.v_plus[i] - star.v_plus[i]) * (t.s_plus[i] - star.s[i]);
            out.interface_work += weight * star.s[i] * (star.v_plus[i] - star.v_minus[i]);
          } else {
            out.boundary_work += weight * star.s[i] * star.v_minus[i];
          }
        }
      }
    } else {
      // A_N^+ w- + A_N^- w+ in energy-scaled fields; the first D rows times sqrt(rho) are the momentum flux.
      const Elastic<D>& m = *solution[e].material;
      Matrix<NU> work = scaled_flux(facet), vector{};
      std::array<double, NU> value{};
      symmetric_eigen(NU, work[0].data(), value.data(), vector[0].data());
      states_.resize(points_.size());
      other_states_.resize(points_.size());
      solution[e].at(points_, states_);
      solution[static_cast<std::size_t>(facet.neighbour)].at(points_, other_states_);
      for (std::size_t q = 0; q < points_.size(); ++q) {
        std::array<double, NU> w[2] = {};
        for (int k = 0; k < 2; ++k) {
          const PointState<D>& s = k == 0 ? states_[q] : other_states_[q];
          for (int i = 0; i < D; ++i) w[k][i] = std::sqrt(m.density) * s.v[i];
          for (int c = 0; c < strain_count<D>; ++c)
            for (int d = 0; d < strain_count<D>; ++d) w[k][D + c] += m.to_energy[c][d] * s.strain[d];
        }
        for (int k = 0; k < NU; ++k) {
          double a = 0.0, b = 0.0;
          for (int i = 0; i < NU; ++i) a += vector[i][k] * w[0][i], b += vector[i][k] * w[1][i];
          const double upwind = value[k] > 0.0 ? a : b;
          for (int i = 0; i < D; ++i) {
            const double part = rule.weight[q] * vector[i][k] * value[k] * upwind * std::sqrt(m.density);
            total[i] += part;
            size += std::fabs(part);
          }
          const double loss = 0.5 * rule.weight[q] * std::fabs(value[k]) * (a - b) * (a - b);
          out.element_dissipation[static_cast<std::size_t>(value[k] < 0.0 ? facet.element
                                                                          : facet.neighbour)] += loss;
        }
      }
    }
    largest_flux = std::max(largest_flux, size);
    add(facet.element, total, 1.0);
    if (facet.neighbour >= 0) add(facet.neighbour, total, -1.0);
  }
  for (std::size_t e = 0; e < patch.elements.size() && problem_.body_force; ++e) {
    const SimplexRule& rule = simplex_rule(D + 1, elements_[e].degree + body_points);
    for (int q = 0; q < rule.points; ++q) {
      Event<D> y{};
      for (int c = 0; c < D + 2; ++c)
        for (int i = 0; i <= D; ++i)
          y[i] +=
              rule.barycentric[static_cast<std::size_t>(q * (D + 2) + c)] * patch.elements[e].corner[c][i];
      const Vector<D> b = problem_.body_force(y);
      const double scale =
          rule.weight[static_cast<std::size_t>(q)] * patch.elements[e].volume * solution[e].material->density;
      const PointState<D> s = solution[e].at(y);
      for (int i = 0; i < D; ++i) {
        residual[e][i] -= scale * b[i];
        out.body_work += scale * b[i] * s.v[i];
      }
    }
  }
  for (const Vector<D>& r : residual)
    for (const double x : r)
      out.momentum = std::max(out.momentum, largest_flux > 0.0 ? std::fabs(x) / largest_flux : 0.0);
  for (const double e : out.element_dissipation) out.dissipation += e;
  out.front_energy = new_energy - old_energy;
  const double size =
      std::max({old_energy, new_energy, std::fabs(out.boundary_work), std::fabs(out.body_work)});
  const double rest =
      out.front_energy - out.boundary_work + out.interface_work - out.body_work + out.dissipation;
  out.energy = size > 0.0 ? std::fabs(rest) / size : 0.0;
}

#define CLEAVE_INSTANTIATE(D)                                                                \
  template void PatchSolver<D>::verify(const Patch<D>&, std::span<const Solution<D>* const>, \
                                       std::span<const Solution<D>>, Verify&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
