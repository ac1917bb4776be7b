// V17 of the specification: meshes as bad as random points make them. No front may stall, and every tent must
// be as high as was promised.
#include "spacetime_account.hpp"

namespace cleave::discretisation::spacetime::sample {
namespace {

/// Least altitude over longest edge of any simplex: 0.87 (triangle) and 0.82 (tetrahedron) when regular.
template <int D>
double flattest(const SpaceMeshInput<D>& in) {
  double least = 1.0;
  for (const auto& cell : in.simplex) {
    const auto x = [&](std::size_t i) { return in.vertex[static_cast<std::size_t>(cell[i])]; };
    double longest = 0.0;
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(x(i), x(j)));
    for (std::size_t i = 0; i <= D; ++i) {
      std::array<Point<D>, D> face;
      for (std::size_t j = 0, to = 0; j <= D; ++j)
        if (j != i) face[to++] = x(j);
      least = std::min(least, foot_of<D, D>(x(i), face, {}).height / longest);
    }
  }
  return least;
}

constexpr double all_eps[] = {0.1, 0.2, 0.3, 0.4, 0.5};

TEST(SpacetimeTorture, SlowRandomTriangles) {
  double angle = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto plain = delaunay(250, seed), bent = spoiled<2>(delaunay(120, seed), 0.3, 1.2);
    const auto two = two_materials<2>(delaunay(120, seed + 100), 0.1);
    angle = std::max({angle, largest_angle(plain), largest_angle(bent)});
    for (const Progress progress : {Progress::high_mid, Progress::subsimplex, Progress::budget})
      for (const double eps : all_eps) {
        const PitchOptions options{.progress = progress, .eps = eps};
        const std::string name = std::string(word(progress)) + ", seed " + std::to_string(seed);
        expect_whole_slab<2>(plain, options, 0.05, ("random, " + name).c_str(), seed == 1);
        expect_whole_slab<2>(bent, options, 0.02, ("random, sheared, " + name).c_str(), seed == 1);
        expect_whole_slab<2>(two, options, 0.04, ("random, two materials, " + name).c_str(), seed == 1);
      }
  }
  std::printf("largest angle %.2f degrees\n", angle);
  EXPECT_GT(angle, 177.0);
}

TEST(SpacetimeTorture, SlowRandomTetrahedra) {
  double flat = 1.0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto plain = scattered<3>(3, 0.3, seed), bent = spoiled<3>(scattered<3>(3, 0.5, seed), 0.4, 0.7);
    flat = std::min({flat, flattest<3>(plain), flattest<3>(bent)});
    for (const double eps : all_eps) {
      const std::string name = "seed " + std::to_string(seed);
      expect_whole_slab<3>(plain, {.eps = eps}, 0.05, ("random tetrahedra, " + name).c_str(), seed == 1);
      expect_whole_slab<3>(bent, {.eps = eps}, 0.02, ("sheared tetrahedra, " + name).c_str(), seed == 1);
    }
  }
  std::printf("flattest tetrahedron: least altitude over longest edge %.2e\n", flat);
  EXPECT_LT(flat, 0.02);
}

/// Poles that move on such meshes: volumes, causality and bounds hold all the same.
TEST(SpacetimeTorture, InclinedPolesOnRandomMeshes) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const Progress progress : {Progress::high_mid, Progress::subsimplex, Progress::budget}) {
      const PitchOptions options{.progress = progress, .smoothing = 0.3};
      expect_whole_slab<2>(delaunay(150, seed), options, 0.08, "random, inclined", false);
    }
  expect_whole_slab<3>(scattered<3>(3, 0.4, 5), {.smoothing = 0.3}, 0.05, "random, inclined", false);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::sample
