#include "spectral.hpp"

#include <algorithm>
#include <cmath>

#include "machine.hpp"

namespace cleave::bench {
namespace {

constexpr double lambda = 1.0 / 3.0, mu = 1.0 / 3.0, courant = 0.9;

}  // namespace

SpectralPlate::SpectralPlate(std::vector<double> lines_x, std::vector<double> lines_y)
    : lines_{std::move(lines_x), std::move(lines_y)} {
  const double r = std::sqrt(3.0 / 7.0), node[nodes] = {-1.0, -r, 0.0, r, 1.0},
               weight[nodes] = {0.1, 49.0 / 90.0, 64.0 / 90.0, 49.0 / 90.0, 0.1};
  for (int i = 0; i < nodes; ++i) {
    place_[i] = node[i], weight_[i] = weight[i];
    derivative_[i][i] = 0.0;
    for (int j = 0; j < nodes; ++j) {
      if (j == i) continue;
      double a = 1.0;
      for (int k = 0; k < nodes; ++k)
        a *= (k == i || k == j ? 1.0 : node[i] - node[k]) / (k == j ? 1.0 : node[j] - node[k]);
      derivative_[i][j] = a;
      derivative_[i][i] += 1.0 / (node[i] - node[j]);
    }
  }
  std::vector<double> mass[2];
  for (int d = 0; d < 2; ++d) {
    count_[d] = static_cast<int>(lines_[d].size()) - 1, width_[d] = count_[d] * degree + 1;
    at_[d].assign(static_cast<std::size_t>(width_[d]), 0.0);
    mass[d].assign(static_cast<std::size_t>(width_[d]), 0.0);
    for (int e = 0; e < count_[d]; ++e) {
      const double low = lines_[d][static_cast<std::size_t>(e)],
                   h = lines_[d][static_cast<std::size_t>(e) + 1] - low;
      for (int i = 0; i < nodes; ++i) {
        const auto k = static_cast<std::size_t>(e * degree + i);
        at_[d][k] = low + 0.5 * h * (node[i] + 1.0), mass[d][k] += 0.5 * h * weight[i];
      }
    }
  }
  for (const double my : mass[1])
    for (const double mx : mass[0]) mass_.push_back(mx * my);
  for (Field* f : {&u_, &v_, &f_, &g_})
    for (auto& c : *f) c.assign(mass_.size(), 0.0);
}

/// f -= K u.
void SpectralPlate::add_forces(const Field& u, Field& f) const {
  constexpr int N = nodes;
  const auto row = static_cast<std::size_t>(width_[0]);
  for (int ey = 0; ey < count_[1]; ++ey) {
    const double hy = lines_[1][static_cast<std::size_t>(ey) + 1] - lines_[1][static_cast<std::size_t>(ey)];
    for (int ex = 0; ex < count_[0]; ++ex) {
      const double hx = lines_[0][static_cast<std::size_t>(ex) + 1] - lines_[0][static_cast<std::size_t>(ex)];
      const double jx = 2.0 / hx, jy = 2.0 / hy, area = 0.25 * hx * hy;
      const std::size_t first =
          static_cast<std::size_t>(ey * degree) * row + static_cast<std::size_t>(ex * degree);
      double a[N][N], b[N][N], sx[N][N], sy[N][N], tx[N][N], ty[N][N];
      for (std::size_t j = 0; j < N; ++j)
        for (std::size_t i = 0; i < N; ++i)
          a[j][i] = u[0][first + j * row + i], b[j][i] = u[1][first + j * row + i];
      for (int j = 0; j < N; ++j)
        for (int i = 0; i < N; ++i) {
          double axx = 0.0, axy = 0.0, bxx = 0.0, bxy = 0.0;
          for (int k = 0; k < N; ++k) {
            axx += derivative_[i][k] * a[j][k], bxx += derivative_[i][k] * b[j][k];
            axy += derivative_[j][k] * a[k][i], bxy += derivative_[j][k] * b[k][i];
          }
          axx *= jx, bxx *= jx, axy *= jy, bxy *= jy;
          const double q = area * weight_[i] * weight_[j], sum = lambda * (axx + bxy);
          const double s1 = sum + 2.0 * mu * axx, s2 = sum + 2.0 * mu * bxy, s12 = mu * (axy + bxx);
          sx[j][i] = q * jx * s1, ty[j][i] = q * jy * s2, sy[j][i] = q * jx * s12, tx[j][i] = q * jy * s12;
        }
      for (std::size_t j = 0; j < N; ++j)
        for (std::size_t i = 0; i < N; ++i) {
          double r = 0.0, s = 0.0;
          for (std::size_t k = 0; k < N; ++k) {
            r += derivative_[k][i] * sx[j][k] + derivative_[k][j] * tx[k][i];
            s += derivative_[k][i] * sy[j][k] + derivative_[k][j] * ty[k][i];
          }
          f[0][first + j * row + i] -= r, f[1][first + j * row + i] -= s;
        }
    }
  }
}

void SpectralPlate::hold(Field& f) const {
  const auto nx = static_cast<std::size_t>(width_[0]), ny = static_cast<std::size_t>(width_[1]);
  for (std::size_t j = 0; j < ny; ++j) f[0][j * nx] = f[0][j * nx + nx - 1] = 0.0;
  for (std::size_t i = 0; i < nx; ++i) f[1][i] = f[1][(ny - 1) * nx + i] = 0.0;
}

/// Square of the largest frequency, by the power method.
double SpectralPlate::fastest() {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double x = static_cast<double>(i);
    u_[0][i] = std::sin(12.9898 * x), u_[1][i] = std::sin(78.233 * x + 1.0);
  }
  hold(u_);
  double square = 0.0;
  for (int round = 0; round < 60; ++round) {
    double size = 0.0;
    for (const auto& c : u_)
      for (const double x : c) size += x * x;
    size = 1.0 / std::sqrt(size);
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < mass_.size(); ++i) u_[d][i] *= size, f_[d][i] = 0.0;
    add_forces(u_, f_);
    square = 0.0;
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < mass_.size(); ++i) f_[d][i] /= -mass_[i];
    hold(f_);
    for (const auto& c : f_)
      for (const double x : c) square += x * x;
    u_ = f_;
  }
  return std::sqrt(square);
}

double SpectralPlate::run(double end, const Start& displacement, const Start& velocity) {
  const double largest = courant * std::sqrt(12.0) / std::sqrt(1.02 * fastest());
  steps_ = static_cast<int>(std::ceil(end / largest));
  const double dt = end / steps_;
  for (std::size_t j = 0, at = 0; j < at_[1].size(); ++j)
    for (std::size_t i = 0; i < at_[0].size(); ++i, ++at)
      for (std::size_t d = 0; d < 2; ++d) {
        u_[d][at] = displacement(at_[0][i], at_[1][j])[d];
        v_[d][at] = velocity(at_[0][i], at_[1][j])[d];
      }
  const double start = cpu_seconds();
  for (int s = 0; s <= steps_; ++s) {  // velocity half a step behind, but at the ends
    for (int d = 0; d < 2; ++d) {
      std::fill(f_[d].begin(), f_[d].end(), 0.0);
      std::fill(g_[d].begin(), g_[d].end(), 0.0);
    }
    const double share = s == 0 || s == steps_ ? 0.5 * dt : dt;
    add_forces(u_, f_);
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < mass_.size(); ++i) f_[d][i] /= mass_[i];
    hold(f_);
    add_forces(f_, g_);
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < mass_.size(); ++i) g_[d][i] /= mass_[i];
    hold(g_);
    for (int d = 0; d < 2; ++d)
      for (std::size_t i = 0; i < mass_.size(); ++i) {
        v_[d][i] += share * (f_[d][i] + dt * dt / 12.0 * g_[d][i]);
        if (s < steps_) u_[d][i] += dt * v_[d][i];
      }
  }
  return cpu_seconds() - start;
}

void SpectralPlate::each_node(
    const std::function<void(double, double, const State&, const State&, double)>& visit) const {
  for (std::size_t j = 0, at = 0; j < at_[1].size(); ++j)
    for (std::size_t i = 0; i < at_[0].size(); ++i, ++at)
      visit(at_[0][i], at_[1][j], {u_[0][at], u_[1][at]}, {v_[0][at], v_[1][at]}, mass_[at]);
}

void SpectralPlate::along_x(int points, const std::function<void(double, double, double)>& visit) const {
  for (int e = 0; e < count_[0]; ++e)
    for (int q = 0; q < points; ++q) {
      const double z = 2.0 * (q + 0.5) / points - 1.0;
      const double low = lines_[0][static_cast<std::size_t>(e)],
                   h = lines_[0][static_cast<std::size_t>(e) + 1] - low;
      double value = 0.0;
      for (int i = 0; i < nodes; ++i) {
        double shape = 1.0;
        for (int k = 0; k < nodes; ++k)
          if (k != i) shape *= (z - place_[k]) / (place_[i] - place_[k]);
        value += shape * v_[0][static_cast<std::size_t>(e * degree + i)];
      }
      visit(low + 0.5 * h * (z + 1.0), value, h / points);
    }
}

std::vector<double> graded_lines(int n, double low, double high, int levels) {
  std::vector<double> lines;
  const auto divide = [&](auto&& self, double from, double to, int level) -> void {
    if (level < levels && from <= high && to >= low) {
      self(self, from, 0.5 * (from + to), level + 1);
      self(self, 0.5 * (from + to), to, level + 1);
    } else {
      lines.push_back(to);
    }
  };
  lines.push_back(0.0);
  for (int i = 0; i < n; ++i) divide(divide, double(i) / n, double(i + 1) / n, 0);
  return lines;
}

int quadtree_leaves(int n, double low, double high, int levels) {
  int leaves = n * n;
  for (int level = 0; level < levels; ++level) {
    const int m = n << level;  // a cell that touches the spot is replaced by four
    const int touching =
        static_cast<int>(std::floor(high * m)) - static_cast<int>(std::ceil(low * m) - 1.0) + 1;
    leaves += 3 * touching * touching;
  }
  return leaves;
}

}  // namespace cleave::bench
