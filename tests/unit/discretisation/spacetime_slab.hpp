#pragma once
/// The whole method over a slab of time: front, patch solver and every check that a run can be held to, with
/// errors against an exact solution.

#include <gtest/gtest.h>

#include <cstdio>
#include <mutex>
#include <string>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_delaunay.hpp"
#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {

enum class Support { velocity, traction, silent };

/// A problem with an exact solution, smooth within each material, on a mesh of any size.
template <int D>
struct Slab {
  std::vector<Elastic<D>> materials;
  std::function<PointState<D>(int material, const Event<D>&)> exact;
  std::function<SpaceMeshInput<D>(int n)> mesh;
  Support support = Support::velocity;
  PitchOptions pitch;
  double end = 0.0;
};

/// What a run told. Errors are L2 norms over space and time, relative to the exact fields.
struct Measured {
  double v = 0.0, e = 0.0, u = 0.0;
  double h = 0.0;  ///< size of the mesh as the error sees it: mean of the simplices' sizes to the power p + 1
  std::int64_t patches = 0, tilted = 0;
  std::int64_t slides = 0;  ///< leaning poles on an interface of materials
};

/// The target that makes `exact` the solution on one boundary face.
template <int D>
TargetPtr<D> exact_target(const Slab<D>& slab, const Elastic<D>& m, int material, const Point<D>& normal) {
  const auto exact = slab.exact;
  if (slab.support == Support::velocity)
    return make_velocity<D>([=](const Event<D>& y) { return exact(material, y).v; });
  const bool silent = slab.support == Support::silent;
  const Matrix<D> z = m.impedance(normal);
  const auto field = [=](const Event<D>& y) {
    const PointState<D> state = exact(material, y);
    const auto stress = m.stress(state.strain);
    Vector<D> s{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        s[i] += stress[voigt<D>(i, j)] * normal[j];
        if (silent) s[i] += z[i][j] * state.v[j];
      }
    return s;
  };
  return silent ? make_silent<D>(field) : make_traction<D>(field);
}

/// (mean of h^(2 q))^(1 / 2 q) over a mesh, by volume, of the longest edges h: what an error that goes with
/// h^q in each simplex has in the L2 norm. Meshes of random points are not finer by the ratio of their
/// numbers n.
template <int D>
double size_of(const SpaceMesh<D>& mesh, int q) {
  double sum = 0.0, volume = 0.0;
  for (Simplex s = 0; s < mesh.simplex_count(); ++s) {
    std::array<Point<D>, D + 1> corner;
    double longest = 0.0;
    for (std::size_t i = 0; i <= D; ++i) {
      corner[i] = mesh.position()[static_cast<std::size_t>(mesh.simplex(s)[i])];
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(corner[i], corner[j]));
    }
    const double size = std::fabs(signed_volume<static_cast<std::size_t>(D)>(corner));
    volume += size;
    sum += size * std::pow(longest, 2.0 * q);
  }
  return std::pow(sum / volume, 0.5 / q);
}

/// Runs and checks: momentum of each element within 1e-12, energy of each patch within 1e-10 and of the whole
/// run within 1e-11, volumes, causality, and no energy made.
template <int D>
Measured run(const Slab<D>& slab, SpaceChoice space, int n) {
  Measured out;
  SpaceMeshInput<D> input = slab.mesh(n);
  input.speed.clear();
  for (const auto& m : slab.materials) {
    double slowest = m.fastest;
    for (int i = 0; i < 90; ++i) {
      Vector<D> along{};
      along[0] = std::cos(i * std::numbers::pi / 90);
      if constexpr (D > 1) along[1 + i % (D - 1)] = std::sin(i * std::numbers::pi / 90);
      if (D > 1 || i == 0) slowest = std::min(slowest, m.speeds(along)[0]);
    }
    input.speed.push_back({m.fastest, slowest});
  }
  SpaceMesh<D> mesh;
  const MeshFault fault = mesh.build(input);
  EXPECT_TRUE(fault.ok) << fault.what;
  if (!fault.ok) return out;

  Problem<D> problem;
  problem.materials = slab.materials;
  problem.spaces.assign(slab.materials.size(), space);
  problem.initial = [&](Simplex s, const Event<D>& y) { return slab.exact(mesh.material(s), y); };
  std::vector<TargetPtr<D>> targets;
  for (const auto& face : mesh.boundary()) {
    const int material = mesh.material(face.simplex);
    targets.push_back(
        exact_target<D>(slab, slab.materials[static_cast<std::size_t>(material)], material, face.normal));
    problem.targets.push_back(targets.back().get());
  }

  const Pitcher<D> pitcher(mesh, slab.pitch);
  Front<D> front = pitcher.level_front(0.0);
  const auto cells = static_cast<std::size_t>(mesh.simplex_count());
  std::vector<Solution<D>> under(cells);
  std::vector<std::array<double, 6>> square(cells);  // of errors and fields, by simplex: fixed order of sums
  std::vector<double> volume(cells);
  std::mutex guard;
  std::vector<std::unique_ptr<PatchSolver<D>>> idle;
  double momentum = 0.0, energy = 0.0, gained = 0.0, worked = 0.0, dissipated = 0.0, least = 0.0, size = 0.0;

  const auto solve = [&](const Patch<D>& patch) -> Verdict {
    std::unique_ptr<PatchSolver<D>> solver;
    {
      const std::lock_guard lock(guard);
      if (!idle.empty()) solver = std::move(idle.back()), idle.pop_back();
    }
    if (!solver) solver = std::make_unique<PatchSolver<D>>(problem);
    std::vector<const Solution<D>*> older(patch.facets.size(), nullptr);
    std::int64_t tilted = 0;
    for (std::size_t f = 0; f < older.size(); ++f) {
      const Facet<D>& facet = patch.facets[f];
      const auto s =
          static_cast<std::size_t>(patch.elements[static_cast<std::size_t>(facet.element)].simplex);
      if (facet.kind == FacetKind::inflow && under[s].material) older[f] = &under[s];
      tilted += facet.kind == FacetKind::interior && facet.normal[D] > 1e-9 * norm(facet.normal);
    }
    bool mixed = false, upright = true;
    for (const Facet<D>& facet : patch.facets) {
      if (facet.kind != FacetKind::interior) continue;
      const auto& one = patch.elements[static_cast<std::size_t>(facet.element)];
      const auto& other = patch.elements[static_cast<std::size_t>(facet.neighbour)];
      if (one.material == other.material) continue;
      mixed = true;
      upright = upright && std::fabs(facet.normal[D]) <= 1e-9 * norm(facet.normal);
    }
    double lean = 0.0;
    for (int k = 0; k < D; ++k) lean += std::fabs(patch.top[k] - patch.foot[k]);
    std::vector<Solution<D>> solution(patch.elements.size());
    const PatchStatus status = solver->solve(patch, older, solution);
    if (status != PatchStatus::solved) return {.kind = Verdict::fail, .what = "a patch was not solved"};
    Verify check;
    solver->verify(patch, older, solution, check);
    const SimplexRule& rule = simplex_rule(D + 1, field_degree(space) + 2);
    for (std::size_t c = 0; c < solution.size(); ++c) {
      const PatchElement<D>& element = patch.elements[c];
      const auto s = static_cast<std::size_t>(element.simplex);
      volume[s] += element.volume;
      for (int q = 0; q < rule.points; ++q) {
        Event<D> y{};
        for (int i = 0; i < D + 2; ++i)
          for (int k = 0; k <= D; ++k)
            y[k] += rule.barycentric[static_cast<std::size_t>(q * (D + 2) + i)] * element.corner[i][k];
        const PointState<D> a = solution[c].at(y), b = slab.exact(element.material, y);
        const double w = rule.weight[static_cast<std::size_t>(q)] * element.volume;
        for (int i = 0; i < D; ++i) {
          square[s][0] += w * std::pow(a.v[i] - b.v[i], 2), square[s][3] += w * std::pow(b.v[i], 2);
          square[s][2] += w * std::pow(a.u[i] - b.u[i], 2), square[s][5] += w * std::pow(b.u[i], 2);
        }
        for (int i = 0; i < strain_count<D>; ++i) {
          square[s][1] += w * work_factor<D>(i) * std::pow(a.strain[i] - b.strain[i], 2);
          square[s][4] += w * work_factor<D>(i) * std::pow(b.strain[i], 2);
        }
      }
      under[s] = std::move(solution[c]);
    }
    const std::lock_guard lock(guard);
    idle.push_back(std::move(solver));
    out.tilted += tilted;
    out.slides += mixed && lean > 0.0;
    EXPECT_TRUE(upright) << "a facet between two materials leans";
    momentum = std::max(momentum, check.momentum);
    energy = std::max(energy, check.energy);
    gained += check.front_energy, worked += check.boundary_work, dissipated += check.dissipation;
    size += std::fabs(check.front_energy);
    for (const double d : check.element_dissipation) least = std::min(least, d);
    return Verdict{};
  };
  base::set_thread_count(2);
  const FrontStatus status = Scheduler<D>(pitcher, {.verify = true}).advance(front, slab.end, solve);
  base::set_thread_count(1);
  EXPECT_TRUE(status.ok) << status.what;
  out.patches = status.patches;
  EXPECT_LT(momentum, 1e-12);
  EXPECT_LT(energy, 1e-10);
  double total = 0.0;
  std::array<double, 6> sum{};
  for (std::size_t s = 0; s < cells; ++s) {
    total += volume[s];
    for (std::size_t i = 0; i < 6; ++i) sum[i] += square[s][i];
  }
  EXPECT_NEAR(total, mesh.volume() * slab.end, 1e-12 * total);
  size += sum[3] * slab.materials[0].density / slab.end;  // mean kinetic energy, twice
  EXPECT_NEAR(gained, worked - dissipated, 1e-11 * size);
  EXPECT_GE(least, -1e-14 * size);
  EXPECT_EQ(out.tilted > 0, slab.pitch.smoothing > 0.0);
  // On the coarsest meshes nothing but corners may lie on the interface.
  if (D > 1 && n > 2) {
    EXPECT_EQ(out.slides > 0, slab.pitch.smoothing > 0.0 && slab.materials.size() > 1);
  }
  out.h = size_of(mesh, field_degree(space) + 1);
  out.v = std::sqrt(sum[0] / sum[3]), out.e = std::sqrt(sum[1] / sum[4]), out.u = std::sqrt(sum[2] / sum[5]);
  return out;
}

/// Where the order must lie.
struct Window {
  double field = 0.0;         ///< of velocity and strain
  double displacement = 0.0;  ///< least, of the displacement
  double below = 0.25, above = 0.5;
};

/// Prints the table of a series of meshes and asserts the orders of the finest two, or the mean of the finest
/// three when there are four: the pattern of tents, and with it the error, changes a little from mesh to
/// mesh.
template <int D>
void expect_orders(const char* name, const Slab<D>& slab, SpaceChoice space, std::vector<int> meshes,
                   Window window) {
  std::vector<Measured> all;
  std::array<double, 3> order{};
  const char* words[] = {"one field", "three fields", "Trefftz"};
  for (const int n : meshes) {
    all.push_back(run(slab, space, n));
    const Measured& b = all.back();
    std::printf("%-34s %-12s degree %d n %2d h %.4f  %6lld tents  v %.2e E %.2e u %.2e", name,
                words[static_cast<int>(space.space)], space.degree, n, b.h, static_cast<long long>(b.patches),
                b.v, b.e, b.u);
    const auto orders_since = [&](std::size_t back) {
      const Measured& a = all[all.size() - 1 - back];
      const double r = std::log(a.h / b.h);
      return std::array<double, 3>{std::log(a.v / b.v) / r, std::log(a.e / b.e) / r, std::log(a.u / b.u) / r};
    };
    if (all.size() > 1) {
      const auto last = orders_since(1);
      std::printf("  orders %.2f %.2f %.2f", last[0], last[1], last[2]);
      order = orders_since(all.size() > 3 ? 2 : 1);
    }
    std::printf("\n");
  }
  const std::string what = std::string(name) + ", " + words[static_cast<int>(space.space)] + ", degree " +
                           std::to_string(space.degree);
  for (const std::size_t i : {0, 1}) {
    EXPECT_GT(order[i], window.field - window.below) << what;
    EXPECT_LT(order[i], window.field + window.above) << what;
  }
  EXPECT_GT(order[2], window.displacement - window.below) << what;
}

}  // namespace cleave::discretisation::spacetime::test
