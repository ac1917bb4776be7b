/// Stress intensities at the tips of cracks, from faces that have come apart as told.

#include <numbers>

#include "tents_rig.hpp"

namespace cleave::solver::test {
namespace {

constexpr double intensities[] = {3.0, -2.0, 5.0};  // K_I K_II K_III

struct TipWatcher final : Observer {
  std::vector<CrackTip> tips;
  void begin(const Frame& frame) override { tips.assign(frame.tips.begin(), frame.tips.end()); }
  void after_step(const Frame&) override {}
  void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}
};

/// A turn about the z axis.
template <int D>
Point<D> turned(Point<D> x, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), x0 = x[0], x1 = x[1];
  x[0] = c * x0 - s * x1;
  x[1] = s * x0 + c * x1;
  return x;
}

/// A unit square or cube with a crack across the last axis where low < x < high, turned about z: the jump of
/// displacement behind a tip, here at `tip`, is the one of `intensities`, with a next term, and a tip that
/// acts as if it lay elsewhere.
template <int D>
std::vector<CrackTip> tips_of(SpaceMeshInput<D> mesh, double low, double high, double tip, double angle,
                              bool isotropic = true) {
  const auto straight = mesh.vertex;
  for (std::size_t s = 0; s < mesh.simplex.size(); ++s)
    for (std::size_t i = 0; i <= D; ++i) {
      std::array<Vertex, D> face;
      std::size_t n = 0;
      bool inside = true;
      double side = 0.0;
      for (std::size_t c = 0; c <= D; ++c) {
        const Point<D>& x = straight[static_cast<std::size_t>(mesh.simplex[s][c])];
        if (c == i) {
          side = x[D - 1];
          continue;
        }
        face[n++] = mesh.simplex[s][c];
        inside = inside && std::abs(x[D - 1] - 0.5) < 1e-12 && x[0] > low - 1e-12 && x[0] < high + 1e-12;
      }
      if (inside && side > 0.5) mesh.crack.push_back(face);
    }
  for (auto& x : mesh.vertex) x = turned<D>(x, angle);
  Rig<D> rig(mesh, 0.01, 0.01);
  rig.space = {LocalSpace::three_field, 1};
  rig.model.precracks.emplace_back();
  rig.model.requests.nodout.every = 0.01;
  // Of the upper side; from (1) of the header, with E' = 8/9 and mu = 1/3 of the rig.
  const double way = tip > 0.5 * (low + high) ? 1.0 : -1.0;  // ahead
  rig.initial = [=](Simplex s, const Event<D>& y) {
    PointState<D> state;
    Point<D> place;
    std::copy_n(y.begin(), D, place.begin());
    const Point<D> x = turned<D>(place, -angle);
    const double r = way * (tip - x[0]);
    if (r < 1e-6) return state;
    double middle = 0.0;
    for (const Vertex v : mesh.simplex[static_cast<std::size_t>(s)])
      middle += straight[static_cast<std::size_t>(v)][D - 1] / (D + 1);
    const double root =
        (middle > 0.5 ? 0.5 : -0.5) * std::sqrt(r / (2.0 * std::numbers::pi)) * (1.0 - 0.7 * r + 0.002 / r);
    // Upper less lower side. In the plane a tip that points the other way has both its sides and its axes
    // turned round, so that signs stay.
    Point<D> jump{};
    jump[0] = root * intensities[1] * 8.0 / (8.0 / 9.0);
    jump[D - 1] = root * intensities[0] * 8.0 / (8.0 / 9.0);
    if constexpr (D == 3) jump[1] = -root * intensities[2] * 4.0 / (1.0 / 3.0);
    state.u = turned<D>(jump, angle);
    return state;
  };
  auto body = rig.body();
  body->problem.materials[0].isotropic = isotropic;
  TipWatcher watcher;
  auto state = rig.fresh();
  Wishes wishes;
  Observer* const observers[] = {&watcher};
  EXPECT_TRUE(make_tents<D>(rig.world, std::move(body), {})->advance(state, observers, wishes).status.ok);
  return watcher.tips;
}

/// A crack from the left side, turned.
TEST(TentsTips, IntensitiesInThePlane) {
  const double angle = 0.4;
  const auto tips = tips_of<2>(sample::grid(16), 0.0, 0.5, 0.5, angle);
  ASSERT_EQ(tips.size(), 1u);
  for (int mode = 0; mode < 2; ++mode) EXPECT_NEAR(tips[0].intensity[mode], intensities[mode], 1e-9);
  EXPECT_EQ(tips[0].intensity[2], 0.0);
  EXPECT_NEAR(tips[0].ahead[0], std::cos(angle), 1e-12);
  EXPECT_NEAR(tips[0].normal[1], std::cos(angle), 1e-12);
  EXPECT_NEAR(tips[0].far, 0.125, 1e-12);  // a quarter of the crack
}

/// From the right side the tip points the other way, and so does its normal.
TEST(TentsTips, SignsOfATipOnTheLeft) {
  const auto tips = tips_of<2>(sample::grid(16), 0.5, 1.0, 0.5, 0.0);
  ASSERT_EQ(tips.size(), 1u);
  EXPECT_NEAR(tips[0].ahead[0], -1.0, 1e-12);
  EXPECT_NEAR(tips[0].normal[1], -1.0, 1e-12);
  for (int mode = 0; mode < 2; ++mode) EXPECT_NEAR(tips[0].intensity[mode], intensities[mode], 1e-9);
}

TEST(TentsTips, IntensitiesInSpace) {
  const auto tips = tips_of<3>(sample::cube(4), 0.0, 0.5, 0.5, -0.3);
  ASSERT_EQ(tips.size(), 5u);  // also where the rim leaves the body
  for (const CrackTip& tip : tips) {
    for (int mode = 0; mode < 3; ++mode) EXPECT_NEAR(tip.intensity[mode], intensities[mode], 1e-9);
    EXPECT_NEAR(tip.ahead[0], std::cos(0.3), 1e-12);
    EXPECT_NEAR(tip.normal[2], 1.0, 1e-12);
  }
}

TEST(TentsTips, WhereTheyAre) {
  EXPECT_EQ(tips_of<2>(sample::grid(8), 0.25, 0.75, 0.75, 0.0).size(), 2u);
  EXPECT_EQ(tips_of<2>(sample::grid(8), 0.0, 1.0, 1.0, 0.0).size(), 0u);  // cut through
  EXPECT_EQ(tips_of<2>(sample::grid(8), 0.25, 0.75, 0.75, 0.0, false).size(), 0u);
}

}  // namespace
}  // namespace cleave::solver::test
