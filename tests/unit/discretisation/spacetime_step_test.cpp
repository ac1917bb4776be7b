// V2 of the specification: a sudden traction on the end of a bar, the hardest wave for polynomials.
#include <gtest/gtest.h>

#include <cstdio>

#include "spacetime_waves.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

using enum LocalSpace;

struct Step {
  double mean_error;  ///< of the velocity behind the front being 1, over the bar
  double overshoot;   ///< largest velocity less 1
  double arrival;     ///< of half the velocity, as a distance from where it should be [cells]
  double width;       ///< from 90 to 10 per cent of the velocity [cells]
  double impulse;     ///< momentum against the impulse of the traction, relative
};

Step step(SpaceChoice space, int n) {
  Case<1> c;
  c.problem.materials = {unit_material<1>()};
  c.problem.spaces = {space};
  c.on(0, make_traction<1>([](const Event<1>&) { return Vector<1>{1.0}; }));
  c.on(1, make_traction<1>({}));
  March<1> run(box<1>({n}, {1.0}), c.problem);
  const double speed = std::sqrt(3.0), end = 0.5 / speed;
  run.march(end);
  EXPECT_EQ(run.failures, 0);
  EXPECT_LT(run.momentum, 1e-12);
  EXPECT_LT(run.energy, 1e-10);
  Step out{};
  const int points = 40;
  double last90 = 0.0, last50 = 0.0, last10 = 0.0, momentum = 0.0;
  for (int i = 0; i < n * points; ++i) {
    const double x = (i + 0.5) / (n * points);
    const double v = speed * run.solution[static_cast<std::size_t>(x * n)].at({x, end}).v[0];
    out.mean_error += std::fabs(v - (x < 0.5 ? 1.0 : 0.0)) / (n * points);
    out.overshoot = std::max(out.overshoot, v - 1.0);
    if (v > 0.9) last90 = x;
    if (v > 0.5) last50 = x;
    if (v > 0.1) last10 = x;
  }
  const SimplexRule& gauss = simplex_rule(1, 6);
  for (int e = 0; e < n; ++e)
    for (int q = 0; q < gauss.points; ++q) {
      const double x = (e + gauss.barycentric[static_cast<std::size_t>(2 * q)]) / n;
      momentum += gauss.weight[static_cast<std::size_t>(q)] / n *
                  run.solution[static_cast<std::size_t>(e)].at({x, end}).v[0];
    }
  out.arrival = (last50 - 0.5) * n;
  out.width = (last10 - last90) * n;
  out.impulse = momentum / end - 1.0;
  return out;
}

TEST(SpacetimeStep, ArrivesSharpAndConservesMomentum) {
  for (const SpaceChoice space :
       {SpaceChoice{three_field, 1}, SpaceChoice{three_field, 2}, SpaceChoice{three_field, 3},
        SpaceChoice{one_field, 3}, SpaceChoice{trefftz, 2}, SpaceChoice{trefftz, 3},
        SpaceChoice{trefftz, 4}}) {
    const int p = field_degree(space);
    std::vector<Step> all;
    for (const int n : {20, 40, 80}) {
      const Step s = step(space, n);
      std::printf(
          "step: space %d p %d n %2d  mean error %.2e, overshoot %.1f %%, arrival %+.2f h, width %.2f h\n",
          static_cast<int>(space.space), p, n, s.mean_error, 100 * s.overshoot, s.arrival, s.width);
      EXPECT_LT(s.overshoot, 0.12);
      EXPECT_LT(std::fabs(s.arrival), 1.0 / p);
      EXPECT_LT(s.width, p == 1 ? 5.0 : (p == 2 ? 3.0 : 2.0));
      EXPECT_LT(std::fabs(s.impulse), 1e-10);
      all.push_back(s);
    }
    const double order = std::log(all[0].mean_error / all[2].mean_error) / std::log(4.0);
    std::printf("step: space %d p %d order of the mean error %.2f\n", static_cast<int>(space.space), p,
                order);
    EXPECT_GT(order, p == 1 ? 0.6 : 0.75);
    EXPECT_LT(order, 1.1);
  }
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
