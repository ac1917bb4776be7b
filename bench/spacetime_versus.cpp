// The spacetime method where spectral elements are at their best, and where they are not: the standing P wave
// up to time 2 on a uniform mesh, the same with one region refined 32-fold, and a step front along x.
// bench_spacetime_versus [REPEAT]: 0 for tents that share nothing.
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "spacetime_wave.hpp"

namespace {

using namespace cleave::bench;

/// Gauss-Lobatto spectral elements of degree 4 on the line, the scheme of order 4 of the reference. Relative
/// L2 error of the velocity of a step that runs for `end`, from a smooth-free start (exact data at nodes).
double spectral_front(int n, double end, const std::function<double(double)>& velocity) {
  constexpr int p = 4;
  const double r = std::sqrt(3.0 / 7.0), node[p + 1] = {-1.0, -r, 0.0, r, 1.0},
               weight[p + 1] = {0.1, 49.0 / 90.0, 64.0 / 90.0, 49.0 / 90.0, 0.1};
  double d[p + 1][p + 1];
  for (int i = 0; i <= p; ++i) {
    d[i][i] = 0.0;
    for (int j = 0; j <= p; ++j) {
      if (j == i) continue;
      double a = 1.0;
      for (int k = 0; k <= p; ++k)
        a *= (k == i || k == j ? 1.0 : node[i] - node[k]) / (k == j ? 1.0 : node[j] - node[k]);
      d[i][j] = a;
      d[i][i] += 1.0 / (node[i] - node[j]);
    }
  }
  const double h = 1.0 / n;
  const auto m = static_cast<std::size_t>(n * p + 1);
  std::vector<double> x(m), mass(m, 0.0), u(m, 0.0), v(m), f(m), g(m);
  for (int e = 0; e < n; ++e)
    for (int i = 0; i <= p; ++i) {
      const auto at = static_cast<std::size_t>(e * p + i);
      x[at] = h * (e + 0.5 * (node[i] + 1.0)), mass[at] += 0.5 * h * weight[i];
    }
  const auto acceleration = [&](const std::vector<double>& from, std::vector<double>& to) {
    std::fill(to.begin(), to.end(), 0.0);
    for (int e = 0; e < n; ++e) {
      const auto o = static_cast<std::size_t>(e * p);
      double s[p + 1];
      for (std::size_t i = 0; i <= p; ++i) {
        s[i] = 0.0;
        for (std::size_t k = 0; k <= p; ++k) s[i] += d[i][k] * from[o + k];
        s[i] *= 2.0 / h * weight[i];
      }
      for (std::size_t i = 0; i <= p; ++i)
        for (std::size_t k = 0; k <= p; ++k) to[o + i] -= d[k][i] * s[k];
    }
    for (std::size_t i = 0; i < m; ++i) to[i] /= mass[i];
    to[0] = to[m - 1] = 0.0;
  };
  // A step of velocity between ends that stay at rest; displacement by exact integration of d'Alembert.
  for (std::size_t i = 0; i < m; ++i) v[i] = velocity(x[i]);
  const int steps = static_cast<int>(std::ceil(end * n / 0.22));
  const double dt = end / steps;
  for (int s = 0; s <= steps; ++s) {  // velocity half a step behind, but at the ends
    acceleration(u, f);
    acceleration(f, g);
    const double share = s == 0 || s == steps ? 0.5 * dt : dt;
    for (std::size_t i = 0; i < m; ++i) v[i] += share * (f[i] + dt * dt / 12.0 * g[i]);
    if (s < steps)
      for (std::size_t i = 0; i < m; ++i) u[i] += dt * v[i];
  }
  double error = 0.0, all = 0.0;
  const SimplexRule& rule = simplex_rule(1, 12);
  for (int e = 0; e < n; ++e)
    for (int q = 0; q < rule.points; ++q) {
      const double z = 2.0 * rule.barycentric[static_cast<std::size_t>(2 * q)] - 1.0,
                   at = h * (e + 0.5 * (z + 1.0));
      double value = 0.0;
      for (int i = 0; i <= p; ++i) {
        double shape = 1.0;
        for (int k = 0; k <= p; ++k)
          if (k != i) shape *= (z - node[k]) / (node[i] - node[k]);
        value += shape * v[static_cast<std::size_t>(e * p + i)];
      }
      const double exact = 0.5 * (velocity(at - end) + velocity(at + end));
      const double w = h * rule.weight[static_cast<std::size_t>(q)];
      error += w * (value - exact) * (value - exact), all += w * exact * exact;
    }
  return std::sqrt(error / all);
}

void print(const char* name, int degree, int n, const Runner& runner, const Outcome& out) {
  std::printf("%s %d %d %d %lld %.4f %.3e %.3e\n", name, degree, n, runner.mesh().simplex_count(),
              static_cast<long long>(out.patches), out.cpu, out.displacement, out.energy);
  std::fflush(stdout);
}

}  // namespace

int main(int words, char** word) {
  const bool repeat = words < 2 || std::atoi(word[1]) == 1;
  cleave::base::set_thread_count(1);
  std::printf("tents %s\ncase P n triangles patches seconds error_u error_energy\n",
              repeat ? "repeat and share operators" : "stand alone");
  for (const auto& [degree, n, end] : {std::tuple{4, 16, 2.0},
                                       {5, 8, 2.0},
                                       {5, 16, 2.0},
                                       {6, 6, 2.0},
                                       {6, 8, 2.0},
                                       {6, 10, 2.0},
                                       {6, 10, 20.0}}) {
    if (!repeat && end > 2.0) continue;
    Runner runner(squares(n), {{LocalSpace::trefftz, degree}});
    runner.repeat = repeat;
    Outcome out = runner.run(end);
    runner.measure(end, out);
    print(end > 2.0 ? "uniform_to_20" : "uniform", degree, n, runner, out);
  }
  for (const auto& [n, fine] : {std::pair{8, 2}, {8, 3}, {10, 3}}) {
    if (!repeat && n > 8) continue;
    Runner runner(refined(n, 0.51, 0.53, 5), {{LocalSpace::trefftz, 6}, {LocalSpace::trefftz, fine}});
    runner.repeat = repeat;
    Outcome out = runner.run(2.0);
    runner.measure(2.0, out);
    print(fine == 2 ? "refined_2" : "refined_3", 6, n, runner, out);
  }
  // Velocity one between 0.4 and 0.6: two fronts.
  const auto velocity = [](double x) { return x > 0.4 && x < 0.6 ? 1.0 : 0.0; };
  const double way = 0.15;
  for (int n = 10; n <= 640; n *= 2)
    std::printf("front_spectral 4 %d error_v %.4f\n", n, spectral_front(n, way, velocity));
  for (const int degree : {2, 3, 4})
    for (int n = 10; n <= (degree == 2 ? 80 : 40); n *= 2) {
      Runner runner(squares(n), {{LocalSpace::trefftz, degree}});
      runner.repeat = repeat;
      const auto exact = [&](const Event<2>& y) {
        PointState<2> s;
        s.v[0] = 0.5 * (velocity(y[0] - y[2]) + velocity(y[0] + y[2]));
        s.strain[0] = 0.5 * (velocity(y[0] + y[2]) - velocity(y[0] - y[2]));
        return s;
      };
      runner.initial = exact;
      Outcome out = runner.run(way);
      runner.measure(way, exact, 1.0, out);
      print("front", degree, n, runner, out);
    }
}
