#include "solver/tents_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/threads.hpp"

namespace cleave::solver {
namespace {

using namespace discretisation::spacetime;

/// A simplex in equal parts. Points are those of a lattice, s >= y_1 >= .. >= y_D >= 0; parts are the
/// simplices of the lattice's cubes (one per order of the axes) that lie inside. Source: Edelsbrunner &
/// Grayson, Discrete Comput. Geom. 24 (2000) 707.
template <int D>
struct Subdivision {
  std::vector<std::array<double, D + 1>> point;  ///< barycentric
  std::vector<std::array<int, D + 1>> cell;      ///< oriented like the whole

  explicit Subdivision(int s) {
    std::map<std::array<int, D>, int> number;
    each_lattice_point(s, [&](const std::array<int, D>& y) {
      number[y] = static_cast<int>(point.size());
      std::array<double, D + 1> lambda;
      for (int k = 0; k <= D; ++k) {
        const int high = k == 0 ? s : y[k - 1], low = k == D ? 0 : y[k];
        lambda[k] = static_cast<double>(high - low) / s;
      }
      point.push_back(lambda);
    });
    std::array<int, D> order;
    for (int k = 0; k < D; ++k) order[k] = k;
    do {
      int swaps = 0;
      for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b) swaps += order[a] > order[b];
      each_lattice_point(s, [&](std::array<int, D> y) {
        std::array<int, D + 1> part;
        part[0] = number.at(y);
        for (int k = 0; k < D; ++k) {
          ++y[order[k]];
          const auto at = number.find(y);
          if (at == number.end()) return;
          part[k + 1] = at->second;
        }
        if (swaps % 2) std::swap(part[D - 1], part[D]);
        cell.push_back(part);
      });
    } while (std::next_permutation(order.begin(), order.end()));
  }

 private:
  template <class Visit>
  static void each_lattice_point(int s, const Visit& visit) {
    std::array<int, D> y{};
    const auto below = [&](auto&& self, int k, int most) -> void {
      if (k == D) return visit(y);
      for (y[k] = 0; y[k] <= most; ++y[k]) {
        const int now = y[k];
        self(self, k + 1, now);
        y[k] = now;
      }
    };
    below(below, 0, s);
  }
};

template <int D>
double strain_energy(const PlaceState<D>& place) {
  double sum = 0.0;
  for (int c = 0; c < strain_count<D>; ++c)
    sum += 0.5 * work_factor<D>(c) * place.stress[c] * place.state.strain[c];
  return sum;
}

/// Of the tensor in space, with the stress across the plane.
template <int D>
double von_mises(const PlaceState<D>& place) {
  const Voigt<D>& s = place.stress;
  const double third = D == 3 ? s[2] : place.across, a = s[0] - s[1], b = s[1] - third, c = third - s[0];
  double shear = 0.0;
  for (int k = D; k < strain_count<D>; ++k) shear += s[k] * s[k];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * shear);
}

}  // namespace

template <int D>
CellFields cells_at(const model::Model& model, const Body<D>& body, const Instant<D>& instant,
                    int subdivision) {
  const Subdivision<D> parts(std::max(1, subdivision));
  const auto simplices = static_cast<std::size_t>(body.mesh.simplex_count());
  const std::size_t points = simplices * parts.point.size(), cells = simplices * parts.cell.size();
  CellFields out;
  out.dimension = D;
  out.point.assign(3 * points, 0.0);
  out.cell.resize((D + 1) * cells);
  out.element.resize(cells);
  out.part.resize(cells);
  constexpr int stresses = strain_count<D>;
  const auto field = [&](const char* name, int size) {
    out.fields.push_back({name, size, std::vector<double>(static_cast<std::size_t>(size) * points, 0.0)});
  };
  field("displacement", 3);
  field("velocity", 3);
  field("stress", stresses);
  field("strain_energy_density", 1);
  if (D == 2) field("max_shear_stress", 1);
  if (D > 1) field("von_mises", 1);
  if (D == 2) field("stress_across", 1);

  base::for_each_range(simplices, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto s = static_cast<Simplex>(k);
      const auto& corner = body.mesh.simplex(s);
      for (std::size_t p = 0; p < parts.point.size(); ++p) {
        Point<D> x{};
        for (std::size_t c = 0; c <= D; ++c)
          for (std::size_t i = 0; i < D; ++i)
            x[i] += parts.point[p][c] * body.mesh.position()[static_cast<std::size_t>(corner[c])][i];
        const PlaceState<D> place = instant.at(s, x);
        const std::size_t at = k * parts.point.size() + p;
        std::copy_n(x.begin(), D, &out.point[3 * at]);
        std::copy_n(place.state.u.begin(), D, &out.fields[0].value[3 * at]);
        std::copy_n(place.state.v.begin(), D, &out.fields[1].value[3 * at]);
        std::copy_n(place.stress.begin(), stresses, &out.fields[2].value[stresses * at]);
        out.fields[3].value[at] = strain_energy(place);
        if constexpr (D == 2) {
          const Voigt<D>& stress = place.stress;
          out.fields[4].value[at] = std::hypot(0.5 * (stress[0] - stress[1]), stress[2]);
          out.fields[6].value[at] = place.across;
        }
        if constexpr (D > 1) out.fields[D == 2 ? 5 : 4].value[at] = von_mises<D>(place);
      }
      for (std::size_t c = 0; c < parts.cell.size(); ++c) {
        const std::size_t at = k * parts.cell.size() + c;
        out.element[at] = body.element_of_simplex[k];
        out.part[at] = model.parts[static_cast<std::size_t>(body.mesh.material(s))].id;
        for (std::size_t a = 0; a <= D; ++a)
          out.cell[(D + 1) * at + a] = static_cast<model::Index>(k * parts.point.size()) + parts.cell[c][a];
      }
    }
  });
  return out;
}

#define CLEAVE_INSTANTIATE(D) \
  template CellFields cells_at<D>(const model::Model&, const Body<D>&, const Instant<D>&, int);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::solver
