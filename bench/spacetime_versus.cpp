// The spacetime method against spectral elements: the standing P wave up to time 2 on a uniform mesh, the
// same with one spot refined 32-fold, and a step front along x. bench_spacetime_versus [CASE [REPEAT
// [FINER]]]: uniform, refined or front; 0 for tents that share nothing; in the refined case the wave and the
// coarse meshes are so much finer.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>

#include "spacetime_wave.hpp"
#include "spectral.hpp"

namespace {

using namespace cleave::bench;

constexpr double low = 0.51, spot = 0.02;  // the corner of the refined square, its side
constexpr int levels = 5;

/// Displacement error over the L2 norm of the initial amplitude, seconds.
std::pair<double, double> spectral_wave(SpectralPlate& plate, const StandingWave& wave, double end) {
  const double seconds = plate.run(
      end,
      [&](double x, double y) {
        const auto u = wave({x, y, 0.0}).u;
        return SpectralPlate::State{u[0], u[1]};
      },
      [](double, double) { return SpectralPlate::State{}; });
  double error = 0.0, all = 0.0;
  plate.each_node([&](double x, double y, const auto& u, const auto&, double mass) {
    const auto exact = wave({x, y, end}).u, start = wave({x, y, 0.0}).u;
    for (std::size_t i = 0; i < 2; ++i)
      error += mass * (u[i] - exact[i]) * (u[i] - exact[i]), all += mass * start[i] * start[i];
  });
  return {std::sqrt(error / all), seconds};
}

std::vector<double> even_lines(int n) {
  return graded_lines(n, 2.0, 2.0, 0);
}

/// Runs, and runs again with operators at hand where that does not take long.
void run(const char* name, const std::string& degrees, int n, double end, Runner& runner) {
  Outcome out = runner.run(end), again = out;
  if (out.cpu < 5.0) again = runner.run(end);
  runner.measure(end, out);
  std::printf(
      "%s P %s, %d squares, %d triangles: %lld patches, %.4f s, again %.4f s, error_u %.2e, energy %.2e\n",
      name, degrees.c_str(), n, runner.mesh().simplex_count(), static_cast<long long>(out.patches), out.cpu,
      again.cpu, out.displacement, out.energy);
  std::fflush(stdout);
}

void uniform(bool repeat) {
  const StandingWave wave;
  for (const int n : {12, 14, 16}) {
    SpectralPlate plate(even_lines(n), even_lines(n));
    double least = 1e9, error = 0.0;
    for (int trial = 0; trial < 5; ++trial) {
      const auto [e, seconds] = spectral_wave(plate, wave, 2.0);
      error = e, least = std::min(least, seconds);
    }
    std::printf("spectral %d squares, %d steps: %.4f s, error_u %.2e\n", n, plate.steps(), least, error);
  }
  for (const auto& [degree, n, end] :
       {std::tuple{4, 16, 2.0}, {5, 16, 2.0}, {6, 8, 2.0}, {6, 10, 2.0}, {6, 10, 20.0}}) {
    if (!repeat && end > 2.0) continue;
    Runner runner(squares(n), {{LocalSpace::trefftz, degree}});
    runner.repeat = repeat;
    run(end > 2.0 ? "uniform_to_20" : "uniform", std::to_string(degree), n, end, runner);
  }
}

/// The smallest elements of both are nearly as small. With steps as small as those want, degree 4 needs 8
/// squares where we need 10.
void refined_spot(bool repeat, int finer) {
  const StandingWave wave(finer);
  const double high = low + spot / finer;
  const int n = 8 * finer;
  SpectralPlate even(even_lines(n), even_lines(n));
  const double seconds = spectral_wave(even, wave, 2.0).second;
  const std::vector<double> lines = graded_lines(n, low, high, levels);
  SpectralPlate graded(lines, lines);
  const auto [error, graded_seconds] = spectral_wave(graded, wave, 2.0);
  const int leaves = quadtree_leaves(n, low, high, levels);
  std::printf(
      "spectral %d squares: %.4f s in %d steps; refined along lines, %d elements, %d steps: %.3f s, "
      "error_u %.2e; in a spot alone, %d elements: %.3f s\n",
      n, seconds, even.steps(), graded.elements(), graded.steps(), graded_seconds, error, leaves,
      seconds / even.elements() * leaves * graded.steps() / even.steps());
  std::fflush(stdout);
  for (const auto& degrees : {std::array{6, 3, 3, 3}, {6, 5, 3, 2}, {6, 4, 3, 2}}) {
    std::vector<SpaceChoice> spaces;
    std::string name;
    for (const int degree : degrees) {
      spaces.push_back({LocalSpace::trefftz, degree});
      name += std::to_string(degree);
    }
    if (finer > 1 && degrees[1] != 4) continue;
    Runner runner(refined(10 * finer, low, high, levels), spaces);
    runner.repeat = repeat;
    runner.wave = wave;
    run("refined", name, 10 * finer, 2.0, runner);
  }
}

/// Velocity one between 0.4 and 0.6: two fronts, each carrying one half.
double start_velocity(double x) {
  return x > 0.4 && x < 0.6 ? 1.0 : 0.0;
}
constexpr double way = 0.15;
/// At nodes: the mean at the jumps.
double nodal_velocity(double x) {
  return 0.5 * (start_velocity(x - 1e-9) + start_velocity(x + 1e-9));
}

/// What a front looks like: relative errors of the velocity, overshoot over the plateau, and from the last
/// place with nine tenths of the plateau to the last with one tenth.
struct Front1 {
  double absolute = 0.0, square = 0.0, all = 0.0, all_square = 0.0, most = 0.0, nine = 0.0, one = 0.0;
  void add(double x, double v, double weight) {
    const double exact = 0.5 * (start_velocity(x - way) + start_velocity(x + way));
    absolute += weight * std::fabs(v - exact), square += weight * (v - exact) * (v - exact);
    all += weight * std::fabs(exact), all_square += weight * exact * exact;
    most = std::max(most, v);
    if (v > 0.45) nine = std::max(nine, x);
    if (v > 0.05) one = std::max(one, x);
  }
  void print(const char* name, int degree, int n, double seconds) const {
    std::printf("front %s %d, %d squares: %.4f s, L1 %.3f, L2 %.3f, overshoot %.1f %%, width %.4f\n", name,
                degree, n, seconds, absolute / all, std::sqrt(square / all_square),
                100.0 * (most / 0.5 - 1.0), one - nine);
    std::fflush(stdout);
  }
};

void front(bool repeat) {
  for (int n = 10; n <= 160; n *= 2) {
    SpectralPlate plate(even_lines(n), even_lines(n));
    const double seconds = plate.run(
        way, [](double, double) { return SpectralPlate::State{}; },
        [](double x, double) {
          return SpectralPlate::State{nodal_velocity(x), 0.0};
        });
    Front1 look;
    plate.along_x(40, [&](double x, double v, double weight) { look.add(x, v, weight); });
    look.print("spectral", 4, n, seconds);
  }
  const SimplexRule& rule = simplex_rule(2, 12);
  for (const auto& [degree, most] : {std::pair{2, 80}, {3, 80}, {4, 40}})
    for (int n = 10; n <= most; n *= 2) {
      Runner runner(squares(n), {{LocalSpace::trefftz, degree}});
      runner.repeat = repeat;
      runner.initial = [](const Event<2>& y) {
        PointState<2> s;
        s.v[0] = 0.5 * (start_velocity(y[0] - y[2]) + start_velocity(y[0] + y[2]));
        s.strain[0] = 0.5 * (start_velocity(y[0] + y[2]) - start_velocity(y[0] - y[2]));
        return s;
      };
      double seconds = runner.run(way).cpu;
      seconds = std::min(seconds, runner.run(way).cpu);
      Front1 look;
      for (Simplex s = 0; s < runner.mesh().simplex_count(); ++s)
        for (int q = 0; q < rule.points; ++q) {
          Event<2> y{0.0, 0.0, way};
          for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 2; ++k)
              y[k] += rule.barycentric[static_cast<std::size_t>(q) * 3 + c] *
                      runner.mesh().position()[static_cast<std::size_t>(runner.mesh().simplex(s)[c])][k];
          look.add(y[0], runner.under(s).at(y).v[0],
                   rule.weight[static_cast<std::size_t>(q)] / runner.mesh().simplex_count());
        }
      look.print("trefftz", degree, n, seconds);
    }
}

}  // namespace

int main(int words, char** word) {
  const std::string only = words > 1 ? word[1] : "all";
  const bool repeat = words < 3 || std::atoi(word[2]) == 1;
  cleave::base::set_thread_count(1);
  std::printf("tents %s; seconds of one thread\n", repeat ? "repeat and share operators" : "stand alone");
  if (only == "all" || only == "uniform") uniform(repeat);
  if (only == "all" || only == "refined") refined_spot(repeat, words > 3 ? std::atoi(word[3]) : 1);
  if (only == "all" || only == "front") front(repeat);
}
