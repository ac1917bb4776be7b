// V1 of the specification: tables of convergence of the whole method, three meshes and more, every space,
// good and unstructured meshes, vertical and inclined poles, one and two materials, isotropic or not.
#include "spacetime_meshes.hpp"
#include "spacetime_slab.hpp"

namespace cleave::discretisation::spacetime::test {
namespace {

using enum LocalSpace;

template <int D>
SpaceMeshInput<D> structured(int n) {
  if constexpr (D == 1) return sample::line(n);
  if constexpr (D == 2) return sample::grid(n);
  if constexpr (D == 3) return sample::cube(n);
}

/// P and S waves through the unit box.
template <int D>
Slab<D> plane_waves(double k, double end) {
  Slab<D> slab;
  slab.materials = {unit_material<D>()};
  slab.exact = [list = smooth_waves<D>(k)](int, const Event<D>& y) { return waves<D>(list, y); };
  slab.mesh = structured<D>;
  slab.end = end;
  return slab;
}

// The window is 0.25 below the order, and 0.5 above it (see docs/spacetime-verification.md). High degrees
// come to their order late: where four elements of a wave do not do, the meshes are twice as fine.

/// Each space at degrees 1 .. `highest` of velocity and strain, p + 1 of which is the order. The displacement
/// has p + 1 as well with three fields and P + 1 with one (less on coarse meshes for P = 2), but P with
/// Trefftz functions: their rigid motions carry on the errors of older elements.
template <int D>
void expect_all_spaces(const char* name, const Slab<D>& slab, int highest, const std::vector<int>& meshes,
                       int lowest = 1) {
  for (int p = lowest; p <= highest; ++p) {
    const double order = p + 1;
    expect_orders<D>(name, slab, {three_field, p}, meshes, {order, order});
    expect_orders<D>(name, slab, {one_field, p + 1}, meshes, {order, order + (p == 1 ? 0.4 : 0.7)});
    expect_orders<D>(name, slab, {trefftz, p + 1}, meshes, {order, order});
  }
}

const double pi = std::numbers::pi;

/// Delaunay meshes of random points, each with its own.
std::function<SpaceMeshInput<2>(int)> unstructured(double seam = -1.0) {
  return [=](int n) {
    auto in = sample::scattered<2>(n, 0.75, 7, seam);
    return seam > 0.0 ? sample::two_materials<2>(in, seam) : in;
  };
}

/// Those of 2 points to a side, halved.
std::function<SpaceMeshInput<2>(int)> halved(double seam) {
  return [=](int n) { return sample::nested(unstructured(seam), 2, n); };
}

TEST(SpacetimeConvergence, Line) {
  auto slab = plane_waves<1>(2.0 * pi, 0.5);
  expect_all_spaces("line", slab, 4, {8, 16, 32, 64});
  slab.mesh = [](int n) { return sample::line(n, 0.3, 5); };
  slab.pitch.smoothing = 0.3;
  expect_all_spaces("line, jittered, inclined poles", slab, 4, {8, 16, 32, 64});
}

TEST(SpacetimeConvergence, SlowSquare) {
  expect_all_spaces("square", plane_waves<2>(2.0 * pi, 0.5), 4, {2, 4, 8});
}

TEST(SpacetimeConvergence, SlowSquareInclined) {
  auto slab = plane_waves<2>(2.0 * pi, 0.5);
  slab.mesh = [](int n) { return sample::nested([](int m) { return sample::grid(m, 0.2, 3); }, 2, n); };
  slab.pitch.smoothing = 0.3;
  expect_all_spaces("square, jittered, inclined poles", slab, 2, {2, 4, 8});
  // Orders of high degrees come late.
  expect_all_spaces("square, jittered, inclined poles", slab, 3, {4, 8, 16}, 3);
}

TEST(SpacetimeConvergence, SlowDelaunay) {
  auto slab = plane_waves<2>(2.0 * pi, 0.5);
  slab.mesh = unstructured();
  expect_all_spaces("Delaunay", slab, 4, {4, 8, 16});
}

TEST(SpacetimeConvergence, SlowDelaunayInclined) {
  auto slab = plane_waves<2>(2.0 * pi, 0.5);
  slab.mesh = unstructured();
  slab.pitch.smoothing = 0.3;
  expect_all_spaces("Delaunay, inclined poles", slab, 3, {4, 8, 16});
}

/// Three dimensions are dear: degree 1 for all spaces, 2 for Trefftz, as far as meshes go in seconds.
TEST(SpacetimeConvergence, SlowCube) {
  auto slab = plane_waves<3>(3.0, 0.25);
  expect_all_spaces("cube", slab, 1, {2, 4, 6});
  expect_orders<3>("cube", slab, {trefftz, 3}, {1, 2, 3}, {3.0, 3.0});
  slab.mesh = [](int n) { return sample::cube(n, 0.15, 3); };
  slab.pitch.smoothing = 0.3;
  expect_orders<3>("cube, jittered, inclined poles", slab, {trefftz, 2}, {2, 3, 4}, {2.0, 2.0});
}

/// Boundaries that take part: tractions; or silent ones through which the exact waves come in.
TEST(SpacetimeConvergence, TractionsAndIncidentWaves) {
  for (const Support support : {Support::traction, Support::silent}) {
    auto slab = plane_waves<2>(2.0 * pi, 0.5);
    slab.support = support;
    const char* name = support == Support::silent ? "square, incident waves" : "square, tractions";
    expect_all_spaces(name, slab, 2, {2, 4, 8});
  }
}

TEST(SpacetimeConvergence, PlaneStress) {
  Slab<2> slab;
  slab.materials.resize(1);
  Elastic<2>& m = slab.materials[0];
  ASSERT_EQ(make_isotropic<2>(2.0, 3.0, 0.3, PlaneKind::stress, m), "");
  // A sheet carries longitudinal waves at sqrt(E / (1 - nu^2) / rho).
  const double speed = std::sqrt(3.0 / (1.0 - 0.09) / 2.0);
  const std::vector<PlaneWave<2>> list = {{{0.6, 0.8}, {0.6, 0.8}, speed, 5.0}};
  slab.exact = [list](int, const Event<2>& y) { return waves<2>(list, y); };
  slab.mesh = structured<2>;
  slab.end = 0.5;
  expect_all_spaces("plane stress", slab, 2, {2, 4, 8});
}

/// The two plane waves of a sheet with directions, at an angle to them; and the three of a solid.
template <int D>
Slab<D> anisotropic_waves(const Matrix<strain_count<D>>& stiffness, double density, Vector<D> n, double k) {
  Slab<D> slab;
  slab.materials.resize(1);
  Elastic<D>& m = slab.materials[0];
  EXPECT_EQ(make_anisotropic<D>(density, stiffness, m), "");
  std::vector<PlaneWave<D>> list;
  // Christoffel matrix from the stresses of unit strains n a; its eigenvectors by Jacobi rotations.
  Matrix<D> g{}, axes{};
  for (int j = 0; j < D; ++j) {
    axes[j][j] = 1.0;
    Voigt<D> strain{};
    for (int i = 0; i < D; ++i) strain[voigt<D>(i, j)] += (i == j ? 1.0 : 0.5) * n[i];
    const auto stress = m.stress(strain);
    for (int i = 0; i < D; ++i)
      for (int l = 0; l < D; ++l) g[i][j] += stress[voigt<D>(i, l)] * n[l];
  }
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < D; ++p)
      for (int q = p + 1; q < D; ++q) {
        const double angle = 0.5 * std::atan2(2.0 * g[p][q], g[q][q] - g[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (auto* a : {&g, &axes})
          for (int i = 0; i < D; ++i) {
            const double x = (*a)[i][p], y = (*a)[i][q];
            (*a)[i][p] = c * x - s * y, (*a)[i][q] = s * x + c * y;
          }
        for (int i = 0; i < D; ++i) {
          const double x = g[p][i], y = g[q][i];
          g[p][i] = c * x - s * y, g[q][i] = s * x + c * y;
        }
      }
  for (int w = 0; w < D; ++w) {
    Vector<D> a{};
    for (int i = 0; i < D; ++i) a[i] = axes[i][w] / (1.0 + w);
    list.push_back({n, a, std::sqrt(g[w][w] / density), k});
  }
  slab.exact = [list](int, const Event<D>& y) { return waves<D>(list, y); };
  slab.mesh = structured<D>;
  return slab;
}

TEST(SpacetimeConvergence, SlowOrthotropic) {
  // A sheet of fibres at an angle: no term of the stiffness is zero.
  auto sheet = anisotropic_waves<2>({{{10.0, 2.0, 0.5}, {2.0, 4.0, 0.2}, {0.5, 0.2, 1.5}}}, 1.3,
                                    {std::cos(0.6), std::sin(0.6)}, 5.0);
  sheet.end = 0.3;
  expect_all_spaces("orthotropic", sheet, 2, {2, 4, 8});
  sheet.mesh = unstructured();
  sheet.pitch.smoothing = 0.3;
  expect_all_spaces("orthotropic, Delaunay, inclined", sheet, 2, {4, 8, 16});
}

/// A P wave that meets the plane between two solids at an angle: waves of both kinds turn back and go on.
/// All are real below the critical angle. D > 1.
template <int D>
Slab<D> oblique_interface(double seam, double angle, double k) {
  Slab<D> slab;
  slab.materials.resize(2);
  EXPECT_EQ(make_isotropic<D>(1.0, 2.5, 0.25, PlaneKind::strain, slab.materials[0]), "");
  EXPECT_EQ(make_isotropic<D>(2.2, 14.0, 0.3, PlaneKind::strain, slab.materials[1]), "");
  // The plane of incidence is spanned by x_0 and m.
  Vector<D> m{};
  if constexpr (D == 2) m = {0.0, 1.0};
  if constexpr (D == 3) m = {0.0, 0.6, 0.8};
  const auto in_plane = [&](double x, double along) {
    Vector<D> a{};
    a[0] = x;
    for (int i = 1; i < D; ++i) a[i] = along * m[i];
    return a;
  };
  const auto speeds = [&](int material) {
    Vector<D> x{};
    x[0] = 1.0;
    const auto c = slab.materials[static_cast<std::size_t>(material)].speeds(x);
    return std::array<double, 2>{c[D - 1], c[0]};
  };
  // Snell: one frequency and one slowness along the plane.
  const double slowness = std::sin(angle) / speeds(0)[0], frequency = k * speeds(0)[0];
  std::vector<PlaneWave<D>> wave;
  std::vector<int> side;
  const auto add = [&](int material, int kind, double direction) {
    const double c = speeds(material)[static_cast<std::size_t>(kind)], s = slowness * c;
    const double x = direction * std::sqrt(1.0 - s * s);
    wave.push_back({in_plane(x, s), kind == 0 ? in_plane(x, s) : in_plane(-s, x), c, frequency / c});
    side.push_back(material);
  };
  add(0, 0, 1.0), add(0, 0, -1.0), add(0, 1, -1.0), add(1, 0, 1.0), add(1, 1, 1.0);
  // Displacement and traction along x_0 and m agree at the plane: four equations for four amplitudes.
  std::array<std::array<double, 5>, 4> a{};
  for (std::size_t w = 0; w < 5; ++w) {
    const PlaneWave<D>& p = wave[w];
    Voigt<D> strain{};
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) strain[voigt<D>(i, j)] = 0.5 * p.k * (p.a[i] * p.n[j] + p.a[j] * p.n[i]);
    const auto stress = slab.materials[static_cast<std::size_t>(side[w])].stress(strain);
    const double sign = side[w] == 0 ? 1.0 : -1.0;
    a[0][w] = sign * p.a[0], a[2][w] = sign * stress[0];
    for (int i = 1; i < D; ++i)
      a[1][w] += sign * p.a[i] * m[i], a[3][w] += sign * stress[voigt<D>(0, i)] * m[i];
  }
  for (std::size_t j = 1; j < 5; ++j) {  // column 0 is the right-hand side
    std::size_t best = j - 1;
    for (std::size_t i = j; i < 4; ++i)
      if (std::fabs(a[i][j]) > std::fabs(a[best][j])) best = i;
    std::swap(a[j - 1], a[best]);
    for (std::size_t i = 0; i < 4; ++i) {
      const double f = a[i][j] / a[j - 1][j];
      for (std::size_t l = 0; l < 5 && i != j - 1; ++l) a[i][l] -= f * a[j - 1][l];
    }
  }
  for (std::size_t w = 1; w < 5; ++w)
    for (double& x : wave[w].a) x *= -a[w - 1][0] / a[w - 1][w];
  slab.exact = [=](int material, Event<D> y) {
    y[0] -= seam;
    std::vector<PlaneWave<D>> here;
    for (std::size_t w = 0; w < 5; ++w)
      if (side[w] == material) here.push_back(wave[w]);
    return waves<D>(here, y);
  };
  slab.mesh = [=](int n) { return sample::two_materials<D>(structured<D>(n), seam); };
  return slab;
}

/// Fibres at +40 degrees to x_0 meet others at -25 degrees in the plane x_0 = seam: a wave that comes along
/// x_0 turns back and goes on as both waves of either sheet. What arrives is split by the impedances, s = -+
/// Z v for waves to the right and left: v_on = 2 (Z- + Z+)^-1 Z- v_in.
Slab<2> fibres_crossing(double seam, double frequency) {
  Slab<2> slab;
  slab.materials.resize(2);
  EXPECT_EQ(
      make_anisotropic<2>(1.3, {{{7.0, 2.5, 1.6}, {2.5, 5.0, 0.9}, {1.6, 0.9, 2.0}}}, slab.materials[0]), "");
  EXPECT_EQ(
      make_anisotropic<2>(0.9, {{{9.0, 1.5, -1.4}, {1.5, 4.0, -0.5}, {-1.4, -0.5, 1.7}}}, slab.materials[1]),
      "");
  std::array<std::vector<PlaneWave<2>>, 2> wave;
  std::array<Matrix<2>, 2> z;
  std::array<std::array<Vector<2>, 2>, 2> mode;
  std::array<std::array<double, 2>, 2> speed;
  for (std::size_t m = 0; m < 2; ++m) {
    z[m] = slab.materials[m].impedance({1.0, 0.0});
    const double angle = 0.5 * std::atan2(2.0 * z[m][0][1], z[m][0][0] - z[m][1][1]);
    mode[m] = {{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}}};
    for (std::size_t w = 0; w < 2; ++w) {
      const auto& a = mode[m][w];
      speed[m][w] =
          (a[0] * (z[m][0][0] * a[0] + z[m][0][1] * a[1]) + a[1] * (z[m][1][0] * a[0] + z[m][1][1] * a[1])) /
          slab.materials[m].density;
    }
  }
  // Both waves come in, the second one smaller.
  Vector<2> in{};
  for (std::size_t w = 0; w < 2; ++w)
    for (std::size_t i = 0; i < 2; ++i) in[i] += mode[0][w][i] / (1.0 + static_cast<double>(w));
  Matrix<2> sum{};
  Vector<2> push{}, on{}, back{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      sum[i][j] = z[0][i][j] + z[1][i][j], push[i] += 2.0 * z[0][i][j] * in[j];
  const Matrix<2> mobility = inverse<2>(sum);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) on[i] += mobility[i][j] * push[j];
    back[i] = on[i] - in[i];
  }
  const auto add = [&](std::size_t m, double direction, const Vector<2>& v) {
    for (std::size_t w = 0; w < 2; ++w) {
      const double size = v[0] * mode[m][w][0] + v[1] * mode[m][w][1], c = speed[m][w];
      wave[m].push_back({{direction, 0.0}, {size * mode[m][w][0], size * mode[m][w][1]}, c, frequency / c});
    }
  };
  add(0, 1.0, in), add(0, -1.0, back), add(1, 1.0, on);
  slab.exact = [=](int material, Event<2> y) {
    y[0] -= seam;
    return waves<2>(wave[static_cast<std::size_t>(material)], y);
  };
  slab.end = 0.4;
  return slab;
}

TEST(SpacetimeConvergence, SlowObliqueInterface) {
  auto slab = oblique_interface<2>(0.5, 0.35, 5.0);
  slab.end = 0.5;
  expect_all_spaces("two materials, oblique", slab, 2, {2, 4, 8});
  expect_all_spaces("two materials, oblique", slab, 3, {4, 8, 16}, 3);
  slab.mesh = unstructured(0.5);
  expect_all_spaces("two materials, oblique, Delaunay", slab, 3, {4, 8, 16});
}

/// Poles on the interface lean along it, those inside lean any way: facets between the materials stay
/// upright, and so do those of the boundary; all others of such a patch are tilted.
TEST(SpacetimeConvergence, SlowObliqueInterfaceInclined) {
  auto slab = oblique_interface<2>(0.5, 0.35, 5.0);
  slab.end = 0.5;
  slab.mesh = halved(0.5);
  slab.pitch.smoothing = 0.3;
  expect_all_spaces("two materials, inclined poles", slab, 2, {2, 4, 8});
}

/// Two sheets of fibres that run across each other, under a wave along x_0: the impedances do not commute.
TEST(SpacetimeConvergence, SlowAnisotropicInterfaceInclined) {
  auto slab = fibres_crossing(0.5, 5.0);
  slab.mesh = halved(0.5);
  slab.pitch.smoothing = 0.3;
  expect_all_spaces("two sheets of fibres, inclined", slab, 2, {2, 4, 8});
}

TEST(SpacetimeConvergence, SlowTetrahedra) {
  auto slab = plane_waves<3>(3.0, 0.15);
  slab.mesh = [](int n) { return sample::scattered<3>(n, 0.75, 7); };
  expect_orders<3>("Delaunay tetrahedra", slab, {trefftz, 2}, {2, 3, 4}, {2.0, 2.0});
  auto seam = oblique_interface<3>(0.5, 0.35, 3.0);
  seam.end = 0.15;
  expect_orders<3>("cube, two materials, oblique", seam, {trefftz, 2}, {2, 4, 6}, {2.0, 2.0});
}

/// A standing wave in a bar of two materials, held at its ends.
TEST(SpacetimeConvergence, StandingWaveInTwoMaterials) {
  Slab<1> slab;
  slab.materials.resize(2);
  ASSERT_EQ(make_isotropic<1>(1.0, 1.0, 0.0, PlaneKind::stress, slab.materials[0]), "");  // Z = 1, c = 1
  ASSERT_EQ(make_isotropic<1>(2.0, 8.0, 0.3, PlaneKind::stress, slab.materials[1]), "");  // Z = 4, c = 2
  const double seam = 0.5;
  // u = a sin(w x / c) on either side, from its end; displacement and force agree at the seam.
  const auto misfit = [&](double w) {
    return std::cos(w * seam) * std::sin(w * (1 - seam) / 2.0) +
           4.0 * std::sin(w * seam) * std::cos(w * (1 - seam) / 2.0);
  };
  double low = 5.0, high = 8.0;
  ASSERT_LT(misfit(low) * misfit(high), 0.0);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (misfit(low) * misfit(middle) <= 0.0 ? high : low) = middle;
  }
  const double w = low, right = std::sin(w * seam) / std::sin(w * (1 - seam) / 2.0);
  slab.exact = [=](int material, const Event<1>& y) {
    const double c = material == 0 ? 1.0 : 2.0, amplitude = material == 0 ? 1.0 : right;
    const double from = material == 0 ? y[0] : 1.0 - y[0], sign = material == 0 ? 1.0 : -1.0;
    PointState<1> s;
    s.u = {amplitude * std::sin(w * from / c) * std::cos(w * y[1])};
    s.v = {-w * amplitude * std::sin(w * from / c) * std::sin(w * y[1])};
    s.strain = {sign * w / c * amplitude * std::cos(w * from / c) * std::cos(w * y[1])};
    return s;
  };
  slab.mesh = [=](int n) { return sample::two_materials<1>(sample::line(n), seam); };
  slab.end = 1.5;
  expect_all_spaces("standing wave, two materials", slab, 4, {8, 16, 32, 64});
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::test
