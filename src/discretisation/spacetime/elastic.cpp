#include "discretisation/spacetime/elastic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.hpp"
#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// f applied to the eigenvalues of a symmetric matrix.
template <int N, class Function>
Matrix<N> spectral(const Matrix<N>& a, Function f) {
  Matrix<N> work = a, vector{}, out{};
  std::array<double, N> value{};
  symmetric_eigen(N, work[0].data(), value.data(), vector[0].data());
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k) out[i][j] += vector[i][k] * f(value[k]) * vector[j][k];
  return out;
}

template <int N>
std::array<double, N> eigenvalues(const Matrix<N>& a) {
  Matrix<N> work = a, vector{};
  std::array<double, N> value{};
  symmetric_eigen(N, work[0].data(), value.data(), vector[0].data());
  std::sort(value.begin(), value.end());
  return value;
}

template <int D>
Matrix<D> christoffel(const Elastic<D>& m, const Vector<D>& n) {
  Matrix<D> g{};
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k)
      for (int j = 0; j < D; ++j)
        for (int l = 0; l < D; ++l) g[i][k] += m.stiffness[voigt<D>(i, j)][voigt<D>(k, l)] * n[j] * n[l];
  return g;
}

/// Largest phase speed: sampled over directions, then climbed from the best one.
template <int D>
double fastest_speed(const Elastic<D>& m) {
  const auto speed = [&](const Vector<D>& n) { return m.speeds(n)[D - 1]; };
  if constexpr (D == 1) return speed({1.0});
  const double pi = std::numbers::pi;
  const auto direction = [](double a, double b) {
    if constexpr (D == 2) return Vector<D>{std::cos(a), std::sin(a)};
    if constexpr (D == 3) return Vector<D>{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    return Vector<D>{};
  };
  double best = 0.0, at_a = 0.0, at_b = 0.0, step = pi / 36;
  for (int i = 0; i < 36; ++i)
    for (int j = 0; j < (D == 3 ? 19 : 1); ++j) {
      const double a = i * step, b = D == 3 ? (j - 9) * step : 0.0, c = speed(direction(a, b));
      if (c > best) best = c, at_a = a, at_b = b;
    }
  for (; step > 1e-9; step *= 0.5)
    for (const auto& move :
         {std::array{step, 0.0}, std::array{-step, 0.0}, std::array{0.0, step}, std::array{0.0, -step}}) {
      const double b = D == 3 ? at_b + move[1] : 0.0, c = speed(direction(at_a + move[0], b));
      if (c > best) best = c, at_a += move[0], at_b = b;
    }
  return best;
}

/// Everything that follows from density and stiffness.
template <int D>
std::string derive(Elastic<D>& m) {
  constexpr int n = strain_count<D>;
  if (!(m.density > 0.0)) return "density must be positive";
  Matrix<n> energy{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) energy[i][j] = work_factor<D>(i) * m.stiffness[i][j] * work_factor<D>(j);
  if (!square_root<n>(energy, m.to_energy, m.from_energy)) return "stiffness is not positive definite";
  // sigma = C W E = W^-1 (W C W) E = W^-1 to_energy E_w
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < n; ++k) {
        const int c = voigt<D>(i, j);
        m.flux[j][i][k] = m.to_energy[c][k] / (work_factor<D>(c) * std::sqrt(m.density));
      }
  m.fastest = fastest_speed(m);
  return {};
}

}  // namespace

template <int N>
bool square_root(const Matrix<N>& a, Matrix<N>& root, Matrix<N>& inverse) {
  const auto value = eigenvalues<N>(a);
  if (!(value[0] > 1e-14 * value[N - 1])) return false;
  root = spectral<N>(a, [](double x) { return std::sqrt(x); });
  inverse = spectral<N>(a, [](double x) { return 1.0 / std::sqrt(x); });
  return true;
}

template <int N>
Matrix<N> inverse(const Matrix<N>& a) {
  Matrix<N> out{};
  if constexpr (N == 1) {
    out[0][0] = 1.0 / a[0][0];
  } else if constexpr (N == 2) {
    const double d = 1.0 / (a[0][0] * a[1][1] - a[0][1] * a[1][0]);
    out = {{{d * a[1][1], -d * a[0][1]}, {-d * a[1][0], d * a[0][0]}}};
  } else {
    static_assert(N == 3);
    double d = 0.0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int k = (j + 1) % 3, l = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
        out[i][j] = a[k][p] * a[l][q] - a[k][q] * a[l][p];
      }
    for (int k = 0; k < 3; ++k) d += a[0][k] * out[k][0];
    for (auto& row : out)
      for (double& x : row) x /= d;
  }
  return out;
}

template <int D>
Voigt<D> Elastic<D>::stress(const Voigt<D>& strain) const {
  Voigt<D> s{};
  for (int i = 0; i < strain_count<D>; ++i)
    for (int j = 0; j < strain_count<D>; ++j) s[i] += stiffness[i][j] * work_factor<D>(j) * strain[j];
  return s;
}

template <int D>
Matrix<D> Elastic<D>::impedance(const Vector<D>& n) const {
  if (isotropic) {  // rho c_d n n + rho c_s (1 - n n), without an eigenproblem
    const double zd = std::sqrt(density * stiffness[0][0]);
    const double zs = D == 1 ? 0.0 : std::sqrt(density * stiffness[strain_count<D> - 1][strain_count<D> - 1]);
    Matrix<D> z{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) z[i][j] = (i == j ? zs : 0.0) + (zd - zs) * n[i] * n[j];
    return z;
  }
  Matrix<D> g = christoffel<D>(*this, n);
  for (auto& row : g)
    for (double& x : row) x *= density;
  return spectral<D>(g, [](double x) { return std::sqrt(x); });
}

template <int D>
Vector<D> Elastic<D>::speeds(const Vector<D>& n) const {
  Vector<D> c = eigenvalues<D>(christoffel<D>(*this, n));
  for (double& x : c) x = std::sqrt(std::max(x, 0.0) / density);
  return c;
}

template <int D>
double Elastic<D>::stress_across(const Voigt<D>& strain) const {
  double sum = 0.0;
  for (int c = 0; c < strain_count<D>; ++c) sum += across[c] * work_factor<D>(c) * strain[c];
  return sum;
}

template <int D>
std::string make_isotropic(double density, double young, double poisson, PlaneKind plane, Elastic<D>& out) {
  if (!(young > 0.0)) return "Young's modulus must be positive";
  if (!(poisson > -1.0 && poisson < 0.5)) return "Poisson's ratio must lie between -1 and 1/2";
  CLEAVE_ASSERT(D < 3 || plane == PlaneKind::strain, "plane stress has no meaning in three dimensions");
  const double shear = young / (2.0 * (1.0 + poisson));
  double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  if (plane == PlaneKind::stress)
    lambda = D == 1 ? young - 2.0 * shear : 2.0 * lambda * shear / (lambda + 2.0 * shear);
  out = {};
  out.density = density;
  out.isotropic = true;
  for (int i = 0; i < strain_count<D>; ++i)
    for (int j = 0; j < strain_count<D>; ++j) {
      if (i < D && j < D) out.stiffness[i][j] = lambda + (i == j ? 2.0 * shear : 0.0);
      if (i >= D && i == j) out.stiffness[i][j] = shear;
    }
  if constexpr (D == 2)
    if (plane == PlaneKind::strain) out.across = {lambda, lambda, 0.0};
  return derive(out);
}

template <int D>
std::string make_anisotropic(double density, const Matrix<strain_count<D>>& stiffness, Elastic<D>& out) {
  double largest = 0.0, asymmetry = 0.0;
  for (int i = 0; i < strain_count<D>; ++i)
    for (int j = 0; j < strain_count<D>; ++j) {
      largest = std::max(largest, std::fabs(stiffness[i][j]));
      asymmetry = std::max(asymmetry, std::fabs(stiffness[i][j] - stiffness[j][i]));
    }
  if (!(asymmetry <= 1e-9 * largest)) return "stiffness is not symmetric";
  out = {};
  out.density = density;
  out.stiffness = stiffness;
  return derive(out);
}

#define CLEAVE_INSTANTIATE(D)                                                                    \
  template struct Elastic<D>;                                                                    \
  template std::string make_isotropic<D>(double, double, double, PlaneKind, Elastic<D>&);        \
  template std::string make_anisotropic<D>(double, const Matrix<strain_count<D>>&, Elastic<D>&); \
  template Matrix<D> inverse<D>(const Matrix<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
