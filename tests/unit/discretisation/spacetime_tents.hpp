#pragma once
/// A small front for the tests of the patch solver: a box of simplices, pitched lowest vertex first with a
/// bound on the time difference along edges, vertical or inclined poles. D = 1, 2 or 3.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "discretisation/spacetime/patch_solver.hpp"
#include "discretisation/spacetime/quadrature.hpp"

namespace cleave::discretisation::spacetime::test {

template <int D>
struct Mesh {
  std::vector<Vector<D>> x;
  std::vector<std::array<int, D + 1>> cell;
  std::vector<int> part;
  double edge = 0.0;  ///< time differences along edges up to chi edge / c keep every cell causal
};

/// The unit box in n^D cubes, each cut into simplices that share its diagonal (Kuhn), stretched by `size`.
template <int D>
Mesh<D> box(std::array<int, D> n, Vector<D> size) {
  Mesh<D> m;
  std::array<int, D> stride{};
  int count = 1;
  for (int k = 0; k < D; ++k) stride[k] = count, count *= n[k] + 1;
  for (int v = 0; v < count; ++v) {
    Vector<D> x{};
    for (int k = 0; k < D; ++k) x[k] = size[k] * (v / stride[k] % (n[k] + 1)) / n[k];
    m.x.push_back(x);
  }
  for (int v = 0; v < count; ++v) {
    bool inside = true;
    for (int k = 0; k < D; ++k) inside = inside && v / stride[k] % (n[k] + 1) < n[k];
    if (!inside) continue;
    std::array<int, D> order{};
    for (int k = 0; k < D; ++k) order[k] = k;
    do {
      std::array<int, D + 1> cell{v};
      for (int k = 0; k < D; ++k) cell[k + 1] = cell[k] + stride[order[k]];
      m.cell.push_back(cell);
      m.part.push_back(0);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  m.edge = 1e300;
  for (int k = 0; k < D; ++k) m.edge = std::min(m.edge, size[k] / n[k] / std::sqrt(double(D)));
  return m;
}

inline double determinant(std::vector<std::vector<double>> a) {
  double det = 1.0;
  const std::size_t n = a.size();
  for (std::size_t j = 0; j < n; ++j) {
    std::size_t best = j;
    for (std::size_t i = j; i < n; ++i)
      if (std::fabs(a[i][j]) > std::fabs(a[best][j])) best = i;
    if (a[best][j] == 0.0) return 0.0;
    if (best != j) std::swap(a[best], a[j]), det = -det;
    det *= a[j][j];
    for (std::size_t i = j + 1; i < n; ++i)
      for (std::size_t k = n; k-- > j;) a[i][k] -= a[i][j] / a[j][j] * a[j][k];
  }
  return det;
}

template <int D>
Event<D> area_vector(const std::array<Event<D>, D + 1>& y, const Event<D>& opposite) {
  Event<D> n{};
  double factorial = 1.0;
  for (int k = 2; k <= D; ++k) factorial *= k;
  for (int k = 0; k <= D; ++k) {
    std::vector<std::vector<double>> a(D, std::vector<double>(D));
    for (int i = 0; i < D; ++i)
      for (int j = 0, c = 0; j <= D; ++j)
        if (j != k) a[i][c++] = y[i + 1][j] - y[0][j];
    n[k] = (k % 2 ? -1.0 : 1.0) * determinant(a) / factorial;
  }
  double side = 0.0;
  for (int k = 0; k <= D; ++k) side += n[k] * (opposite[k] - y[0][k]);
  if (side > 0.0)
    for (double& x : n) x = -x;
  return n;
}

/// Marches a problem to its end and sums what the tests assert.
template <int D>
class March {
 public:
  March(Mesh<D> mesh, Problem<D> problem)
      : mesh_(std::move(mesh)), problem_(std::move(problem)), solver_(problem_) {
    time_.assign(mesh_.x.size(), 0.0);
    home_ = mesh_.x;
    star_.resize(mesh_.x.size());
    for (std::size_t c = 0; c < mesh_.cell.size(); ++c)
      for (int v : mesh_.cell[c]) star_[static_cast<std::size_t>(v)].push_back(static_cast<int>(c));
    solution.resize(mesh_.cell.size());
    solved_.assign(mesh_.cell.size(), false);
    for (const auto& m : problem_.materials) fastest_ = std::max(fastest_, m.fastest);
  }

  double sway = 0.0;  ///< inclined poles: largest displacement of a vertex over the edge length
  double chi = 0.9;
  std::function<PointState<D>(const Event<D>&)> exact;  ///< errors are measured against this
  std::function<SpaceChoice(int)> choose;               ///< local space of a cell
  std::vector<Solution<D>> solution;                    ///< under the front, by cell

  double momentum = 0.0, energy = 0.0, volume = 0.0, dissipation = 0.0, boundary_work = 0.0,
         front_energy = 0.0;
  double error_v = 0.0, error_e = 0.0, error_u = 0.0;  ///< L2 norms over space and time
  int patches = 0, failures = 0, tilted = 0, iterations = 0;

  void march(double end) {
    while (true) {
      const auto lowest =
          static_cast<std::size_t>(std::min_element(time_.begin(), time_.end()) - time_.begin());
      if (time_[lowest] >= end) break;
      pitch(static_cast<int>(lowest), end);
    }
    error_v = std::sqrt(error_v), error_e = std::sqrt(error_e), error_u = std::sqrt(error_u);
  }
  const PatchSolver<D>& solver() const { return solver_; }
  PatchSolver<D>& solver() { return solver_; }

 private:
  void pitch(int v, double end) {
    double top = 1e300;
    for (int c : star_[static_cast<std::size_t>(v)])
      for (int w : mesh_.cell[static_cast<std::size_t>(c)])
        if (w != v) top = std::min(top, time_[static_cast<std::size_t>(w)]);
    const double foot = time_[static_cast<std::size_t>(v)];
    top += chi * (1.0 - 4.0 * sway) * mesh_.edge / fastest_;
    if (top >= end)
      top = end;
    else if (end - top < 0.3 * (top - foot))
      top = (foot + end) / 2;
    Patch<D> patch = tent(v, top, moved(v));
    solve(patch);
    time_[static_cast<std::size_t>(v)] = top;
    for (int k = 0; k < D; ++k) mesh_.x[static_cast<std::size_t>(v)][k] = patch.top[k];
  }

  /// Interior vertices sway about their home; those on the boundary stand still.
  Vector<D> moved(int v) {
    Vector<D> x = home_[static_cast<std::size_t>(v)];
    for (const Vector<D>& other : {lower(), upper()})
      for (int k = 0; k < D; ++k)
        if (std::fabs(x[k] - other[k]) < 1e-12) return x;
    ++turn_;
    for (int k = 0; k < D; ++k) x[k] += sway * mesh_.edge * std::sin(1.7 * v + 2.3 * turn_ + 1.1 * k);
    return x;
  }
  Vector<D> lower() const { return home_.front(); }
  Vector<D> upper() const { return home_.back(); }

  Patch<D> tent(int v, double top, Vector<D> x) {
    const auto event = [&](int w) {
      Event<D> y{};
      for (int k = 0; k < D; ++k) y[k] = mesh_.x[static_cast<std::size_t>(w)][k];
      y[D] = time_[static_cast<std::size_t>(w)];
      return y;
    };
    Patch<D> p;
    p.pole = v;
    p.foot = event(v);
    for (int k = 0; k < D; ++k) p.top[k] = x[k];
    p.top[D] = top;
    std::map<std::vector<int>, std::size_t> shared;
    std::vector<Facet<D>> with_pole;
    for (int c : star_[static_cast<std::size_t>(v)]) {
      PatchElement<D> e;
      e.simplex = c;
      e.material = mesh_.part[static_cast<std::size_t>(c)];
      e.corner[0] = p.foot;
      e.corner[D + 1] = p.top;
      std::vector<int> other;
      for (int w : mesh_.cell[static_cast<std::size_t>(c)])
        if (w != v) other.push_back(w);
      std::sort(other.begin(), other.end());
      for (int k = 0; k < D; ++k) e.corner[k + 1] = event(other[static_cast<std::size_t>(k)]);
      std::vector<std::vector<double>> edges(D + 1, std::vector<double>(D + 1));
      double factorial = 1.0;
      for (int i = 0; i <= D; ++i) {
        factorial *= i + 1;
        for (int k = 0; k <= D; ++k) edges[i][k] = e.corner[i + 1][k] - e.corner[0][k];
      }
      e.volume = std::fabs(determinant(edges)) / factorial;
      volume += e.volume;
      const int index = static_cast<int>(p.elements.size());
      for (int skip = D + 1; skip >= 0; --skip) {
        Facet<D> f;
        f.element = index;
        for (int i = 0, at = 0; i < D + 2; ++i)
          if (i != skip) f.corner[at++] = e.corner[i];
        f.normal = area_vector<D>(f.corner, e.corner[skip]);
        if (skip == D + 1 || skip == 0) {
          f.kind = skip == 0 ? FacetKind::outflow : FacetKind::inflow;
          p.facets.push_back(f);
          continue;
        }
        std::vector<int> key = other;
        key.erase(key.begin() + skip - 1);
        if (const auto found = shared.find(key); found != shared.end()) {
          with_pole[found->second].neighbour = index;
          with_pole[found->second].kind = FacetKind::interior;
          with_pole[found->second].boundary = -1;
          continue;
        }
        shared[key] = with_pole.size();
        f.kind = FacetKind::boundary;
        for (int k = 0; k < D; ++k)
          for (int end = 0; end < 2; ++end) {
            bool on = true;
            for (const auto& y : f.corner) on = on && std::fabs(y[k] - (end ? upper() : lower())[k]) < 1e-12;
            if (on) f.boundary = 2 * k + end;
          }
        with_pole.push_back(f);
      }
      p.elements.push_back(e);
    }
    p.facets.insert(p.facets.end(), with_pole.begin(), with_pole.end());
    return p;
  }

  void solve(const Patch<D>& patch) {
    std::vector<const Solution<D>*> older(patch.facets.size(), nullptr);
    for (std::size_t f = 0; f < older.size(); ++f) {
      const Facet<D>& facet = patch.facets[f];
      const auto cell =
          static_cast<std::size_t>(patch.elements[static_cast<std::size_t>(facet.element)].simplex);
      if (facet.kind == FacetKind::inflow && solved_[cell]) older[f] = &solution[cell];
      tilted += facet.kind == FacetKind::interior && std::fabs(facet.normal[D]) > 1e-9;
    }
    std::vector<Solution<D>> out(patch.elements.size());
    std::vector<SpaceChoice> choices;
    if (choose)
      for (const auto& e : patch.elements) choices.push_back(choose(e.simplex));
    failures += solver_.solve(patch, older, out, choices) != PatchStatus::solved;
    iterations = std::max(iterations, solver_.iterations());
    Verify check;
    solver_.verify(patch, older, out, check);
    momentum = std::max(momentum, check.momentum);
    energy = std::max(energy, check.energy);
    dissipation += check.dissipation;
    boundary_work += check.boundary_work;
    front_energy += check.front_energy;
    ++patches;
    if (exact)
      for (std::size_t e = 0; e < out.size(); ++e) measure(patch.elements[e], out[e]);
    for (std::size_t e = 0; e < out.size(); ++e) {
      const auto cell = static_cast<std::size_t>(patch.elements[e].simplex);
      solution[cell] = std::move(out[e]);
      solved_[cell] = true;
    }
  }

  void measure(const PatchElement<D>& e, const Solution<D>& s) {
    const SimplexRule& rule = simplex_rule(D + 1, std::min(s.displacement_degree + 2, 8));
    for (int q = 0; q < rule.points; ++q) {
      Event<D> y{};
      for (int c = 0; c < D + 2; ++c)
        for (int k = 0; k <= D; ++k)
          y[k] += rule.barycentric[static_cast<std::size_t>(q * (D + 2) + c)] * e.corner[c][k];
      const PointState<D> a = s.at(y), b = exact(y);
      const double w = rule.weight[static_cast<std::size_t>(q)] * e.volume;
      for (int i = 0; i < D; ++i) {
        error_v += w * std::pow(a.v[i] - b.v[i], 2);
        error_u += w * std::pow(a.u[i] - b.u[i], 2);
      }
      for (int c = 0; c < strain_count<D>; ++c)
        error_e += w * work_factor<D>(c) * std::pow(a.strain[c] - b.strain[c], 2);
    }
  }

  Mesh<D> mesh_;
  Problem<D> problem_;
  PatchSolver<D> solver_;
  std::vector<double> time_;
  std::vector<Vector<D>> home_;
  std::vector<std::vector<int>> star_;
  std::vector<bool> solved_;
  double fastest_ = 0.0;
  int turn_ = 0;
};

}  // namespace cleave::discretisation::spacetime::test
