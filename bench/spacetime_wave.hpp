#pragma once
/// What the benchmarks of the spacetime method have in common: triangles over the unit square, the standing P
/// wave between rollers that the spectral-element reference solves too, and a front that carries it.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

#include "base/threads.hpp"
#include "discretisation/spacetime/patch_solver.hpp"
#include "discretisation/spacetime/quadrature.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "machine.hpp"

namespace cleave::bench {

using namespace discretisation::spacetime;

/// u = grad of cos(kx x) cos(ky y) up to the amplitude, in time cos(|k| t): rho = c_p = 1, lambda = mu = 1/3.
struct StandingWave {
  explicit StandingWave(double finer = 1.0)
      : kx(3.0 * std::numbers::pi * finer), ky(2.0 * std::numbers::pi * finer), omega(std::hypot(kx, ky)) {}
  double kx, ky, omega;

  PointState<2> operator()(const Event<2>& y) const {
    const double sx = std::sin(kx * y[0]), cx = std::cos(kx * y[0]), sy = std::sin(ky * y[1]),
                 cy = std::cos(ky * y[1]), ct = std::cos(omega * y[2]) / omega, st = -std::sin(omega * y[2]);
    PointState<2> s;
    s.u = {kx * sx * cy * ct, ky * cx * sy * ct};
    s.v = {kx * sx * cy * st, ky * cx * sy * st};
    s.strain = {kx * kx * cx * cy * ct, ky * ky * cx * cy * ct, -kx * ky * sx * sy * ct};
    return s;
  }
};

inline Elastic<2> unit_material() {
  Elastic<2> m;
  const std::string fault = make_isotropic<2>(1.0, 2.5 / 3.0, 0.25, PlaneKind::strain, m);
  if (!fault.empty()) std::abort();
  return m;
}

/// n x n squares of two triangles.
inline SpaceMeshInput<2> squares(int n) {
  SpaceMeshInput<2> in;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) in.vertex.push_back({double(i) / n, double(j) / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vertex a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      if ((i + j) % 2) {
        in.simplex.push_back({a, b, c}), in.simplex.push_back({a, c, d});
      } else {
        in.simplex.push_back({a, b, d}), in.simplex.push_back({b, c, d});
      }
    }
  in.material.assign(in.simplex.size(), 0);
  return in;
}

/// Halves triangles at their newest vertex until those that touch the square [low, high]^2 have legs of
/// h / 2^levels; the mesh stays conforming. Material 0 gets what is not smaller than h / 2, 1 and 2 two
/// generations each, 3 the rest.
inline SpaceMeshInput<2> refined(int n, double low, double high, int levels) {
  SpaceMeshInput<2> in = squares(n);
  for (auto& t : in.simplex) {  // newest vertex first: the one opposite the diagonal
    const auto length = [&](int i) {
      return distance(in.vertex[static_cast<std::size_t>(t[static_cast<std::size_t>((i + 1) % 3)])],
                      in.vertex[static_cast<std::size_t>(t[static_cast<std::size_t>((i + 2) % 3)])]);
    };
    int i = 0;
    while (length(i) < 1.2 / n) ++i;
    t = {t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>((i + 1) % 3)],
         t[static_cast<std::size_t>((i + 2) % 3)]};
  }
  std::map<std::pair<Vertex, Vertex>, std::size_t> left;  // triangle on the left of a directed edge
  std::vector<int> level(in.simplex.size(), 0);
  const auto enter = [&](std::size_t k) {
    for (std::size_t i = 0; i < 3; ++i) left[{in.simplex[k][i], in.simplex[k][(i + 1) % 3]}] = k;
  };
  for (std::size_t k = 0; k < in.simplex.size(); ++k) enter(k);
  const auto halve = [&](auto&& self, std::size_t k) -> void {
    const Vertex a = in.simplex[k][1], b = in.simplex[k][2];
    auto across = left.find({b, a});
    if (across != left.end() && in.simplex[across->second][1] != b) {
      self(self, across->second);
      across = left.find({b, a});
    }
    const auto mid = static_cast<Vertex>(in.vertex.size());
    const auto &x = in.vertex[static_cast<std::size_t>(a)], &y = in.vertex[static_cast<std::size_t>(b)];
    in.vertex.push_back({0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1])});
    const auto split = [&](std::size_t t) {
      const auto [top, from, to] = in.simplex[t];
      left.erase({from, to});
      in.simplex[t] = {mid, top, from};
      in.simplex.push_back({mid, to, top});
      level.push_back(++level[t]);
      enter(t), enter(in.simplex.size() - 1);
    };
    const std::size_t other = across == left.end() ? k : across->second;
    split(k);
    if (other != k) split(other);
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t k = 0; k < in.simplex.size(); ++k) {
      double least[2] = {1.0, 1.0}, most[2] = {0.0, 0.0};
      for (const Vertex v : in.simplex[k])
        for (std::size_t i = 0; i < 2; ++i) {
          const double c = in.vertex[static_cast<std::size_t>(v)][i];
          least[i] = std::min(least[i], c), most[i] = std::max(most[i], c);
        }
      if (level[k] >= 2 * levels || least[0] > high || least[1] > high || most[0] < low || most[1] < low)
        continue;
      halve(halve, k);
      again = true;
    }
  }
  in.material.clear();
  for (const int l : level) in.material.push_back(std::clamp((l - 1) / 2, 0, 3));
  return in;
}

struct Outcome {
  bool ok = false;
  std::int64_t patches = 0, elements = 0;
  double cpu = 0.0, wall = 0.0;          ///< of the advance [s]
  double displacement = 0.0;             ///< L2 error at the end over the L2 norm of the initial amplitude
  double energy = 0.0;                   ///< energy norm of the error over that of the solution
  double momentum = 0.0, balance = 0.0;  ///< worst residuals when verified
};

/// One run. `spaces` by material of the mesh; all materials are the unit material.
class Runner {
 public:
  Runner(SpaceMeshInput<2> input, std::vector<SpaceChoice> spaces) {
    const Elastic<2> m = unit_material();
    input.speed.assign(spaces.size(), {m.fastest, std::sqrt(1.0 / 3.0)});
    problem_.materials.assign(spaces.size(), m);
    problem_.spaces = std::move(spaces);
    const MeshFault fault = mesh_.build(input);
    if (!fault.ok) std::fprintf(stderr, "%s\n", fault.what.c_str()), std::abort();
    roller_ = make_symmetry<2>();
    problem_.targets.assign(mesh_.boundary().size(), roller_.get());
    problem_.initial = [this](Simplex, const Event<2>& y) { return initial ? initial(y) : wave(y); };
  }
  Problem<2>& problem() { return problem_; }
  const Solution<2>& under(Simplex s) const { return under_[static_cast<std::size_t>(s)]; }
  StandingWave wave;
  const SpaceMesh<2>& mesh() const { return mesh_; }
  std::function<PointState<2>(const Event<2>&)> initial;  ///< instead of the standing wave
  bool repeat = false;                                    ///< tents repeat and share operators
  int together = 64;                                      ///< and are solved together

  /// @param solve false: only the front, no fields
  Outcome run(double end, bool solve = true, ScheduleRecord* record = nullptr, bool verify = false) {
    PitchOptions options;
    options.repeat = repeat;
    const Pitcher<2> pitcher(mesh_, options);
    Front<2> front = pitcher.level_front(0.0);
    under_.assign(static_cast<std::size_t>(mesh_.simplex_count()), {});
    Outcome out;
    elements_ = 0;
    const double cpu = cpu_seconds(), wall = wall_seconds();
    const FrontStatus status =
        Scheduler<2>(pitcher, {.verify = false, .together = pitcher.repeats() && !record ? together : 1})
            .advance_several(
                front, end,
                [&](std::span<const Patch<2>> patches, std::span<Verdict> verdicts) {
                  for (const Patch<2>& patch : patches)
                    elements_.fetch_add(static_cast<std::int64_t>(patch.elements.size()),
                                        std::memory_order_relaxed);
                  if (solve) some(patches, verdicts, verify, out);
                },
                record);
    out.cpu = cpu_seconds() - cpu, out.wall = wall_seconds() - wall;
    out.ok = status.ok;
    out.elements = elements_;
    out.patches = status.patches;
    return out;
  }

  /// Fills the errors of an outcome at the level front.
  void measure(double end, const std::function<PointState<2>(const Event<2>&)>& exact, double amplitude,
               Outcome& out) const {
    double u = 0.0, e = 0.0, all = 0.0;
    const SimplexRule& rule = simplex_rule(2, 8);
    for (Simplex s = 0; s < mesh_.simplex_count(); ++s) {
      const Elastic<2>& m = problem_.materials[0];
      const auto& simplex = mesh_.simplex(s);
      std::array<Point<2>, 3> x;
      for (std::size_t c = 0; c < 3; ++c) x[c] = mesh_.position()[static_cast<std::size_t>(simplex[c])];
      const double area = signed_volume<2>(x);
      for (int q = 0; q < rule.points; ++q) {
        Event<2> y{0.0, 0.0, end};
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t k = 0; k < 2; ++k)
            y[k] += rule.barycentric[static_cast<std::size_t>(q) * 3 + c] * x[c][k];
        const PointState<2> a = under_[static_cast<std::size_t>(s)].at(y), b = exact(y);
        const double w = area * rule.weight[static_cast<std::size_t>(q)];
        Voigt<2> d;
        for (std::size_t k = 0; k < 3; ++k) d[k] = a.strain[k] - b.strain[k];
        const Voigt<2> sd = m.stress(d), sb = m.stress(b.strain);
        for (std::size_t k = 0; k < 2; ++k) {
          u += w * std::pow(a.u[k] - b.u[k], 2);
          e += w * m.density * std::pow(a.v[k] - b.v[k], 2), all += w * m.density * b.v[k] * b.v[k];
        }
        for (int k = 0; k < 3; ++k) {
          const auto i = static_cast<std::size_t>(k);
          e += w * work_factor<2>(k) * sd[i] * d[i], all += w * work_factor<2>(k) * sb[i] * b.strain[i];
        }
      }
    }
    out.displacement = std::sqrt(u) / amplitude, out.energy = std::sqrt(e / all);
  }
  void measure(double end, Outcome& out) const {
    // The mean square of the amplitude of the standing wave is 1/4.
    measure(end, wave, 0.5, out);
  }

 private:
  struct Worker {
    PatchSolver<2> solver;
    std::vector<std::vector<const Solution<2>*>> older;
    std::vector<std::vector<Solution<2>>> out;
    std::vector<PatchJob<2>> jobs;
    explicit Worker(const Problem<2>& p) : solver(p) {}
  };

  void some(std::span<const Patch<2>> patches, std::span<Verdict> verdicts, bool verify, Outcome& outcome) {
    std::unique_ptr<Worker> w;
    {
      const std::lock_guard lock(guard_);
      if (!idle_.empty()) w = std::move(idle_.back()), idle_.pop_back();
    }
    if (!w) w = std::make_unique<Worker>(problem_);
    if (w->out.size() < patches.size()) w->out.resize(patches.size()), w->older.resize(patches.size());
    w->jobs.clear();
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Patch<2>& patch = patches[k];
      w->older[k].assign(patch.facets.size(), nullptr);
      for (std::size_t f = 0; f < patch.facets.size(); ++f) {
        const Facet<2>& facet = patch.facets[f];
        const Solution<2>& below =
            under_[static_cast<std::size_t>(patch.elements[static_cast<std::size_t>(facet.element)].simplex)];
        if (facet.kind == FacetKind::inflow && below.material) w->older[k][f] = &below;
      }
      if (w->out[k].size() < patch.elements.size()) w->out[k].resize(patch.elements.size());
      w->jobs.push_back(
          {.patch = &patch, .older = w->older[k], .out = {w->out[k].data(), patch.elements.size()}});
    }
    w->solver.solve(w->jobs);
    Verify check, worst;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const PatchJob<2>& job = w->jobs[k];
      if (job.status != PatchStatus::solved) verdicts[k].kind = Verdict::fail;
      if (verify) w->solver.verify(patches[k], job.older, job.out, check);
      worst.momentum = std::max(worst.momentum, check.momentum);
      worst.energy = std::max(worst.energy, check.energy);
      for (std::size_t e = 0; e < job.out.size(); ++e)
        std::swap(under_[static_cast<std::size_t>(patches[k].elements[e].simplex)], job.out[e]);
    }
    const std::lock_guard lock(guard_);
    idle_.push_back(std::move(w));
    outcome.momentum = std::max(outcome.momentum, worst.momentum);
    outcome.balance = std::max(outcome.balance, worst.energy);
  }

  SpaceMesh<2> mesh_;
  Problem<2> problem_;
  TargetPtr<2> roller_;
  std::vector<Solution<2>> under_;
  std::atomic<std::int64_t> elements_{0};
  std::mutex guard_;
  std::vector<std::unique_ptr<Worker>> idle_;
};

}  // namespace cleave::bench
