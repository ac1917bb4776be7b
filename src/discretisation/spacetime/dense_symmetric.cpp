#include <algorithm>
#include <cmath>

#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {

using base::lane_count;
using base::Lanes;

bool cholesky(const Block& a) {
  const int n = a.rows;
  for (int k = 0; k < n; ++k) {
    double* pivot = a.row(k);
    if (!(pivot[k] > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(pivot[k]);
    for (int j = 0; j < k; ++j) pivot[j] = 0.0;
    for (int j = k / lane_count * lane_count; j < a.stride; j += lane_count)
      (Lanes::load(pivot + j) * Lanes(inverse)).store(pivot + j);
    for (int i = k + 1; i < n; ++i) {
      const int from = i / lane_count * lane_count;
      axpy(a.stride - from, -pivot[i], pivot + from, a.row(i) + from);
    }
  }
  return true;
}

void invert_upper(const Block& u, const Block& out) {
  for (int i = u.rows - 1; i >= 0; --i) {
    double* row = out.row(i);
    row[i] = 1.0;
    for (int k = i + 1; k < u.rows; ++k) {
      const int from = k / lane_count * lane_count;
      axpy(u.stride - from, -u.row(i)[k], out.row(k) + from, row + from);
    }
    const double inverse = 1.0 / u.row(i)[i];
    for (int j = 0; j < u.stride; ++j) row[j] *= inverse;
  }
}

void symmetric_eigen(int n, double* a, double* value, double* vector) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) vector[i * n + j] = i == j ? 1.0 : 0.0;
  for (int sweep = 0; sweep < 60; ++sweep) {
    double off = 0.0, all = 0.0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) (i == j ? all : off) += a[i * n + j] * a[i * n + j];
    if (off <= 1e-34 * all || off == 0.0) break;
    for (int p = 0; p < n; ++p)
      for (int q = p + 1; q < n; ++q) {
        if (a[p * n + q] == 0.0) continue;
        const double theta = (a[q * n + q] - a[p * n + p]) / (2.0 * a[p * n + q]);
        const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (int k = 0; k < n; ++k) {
          const double x = a[k * n + p], y = a[k * n + q];
          a[k * n + p] = c * x - s * y, a[k * n + q] = s * x + c * y;
        }
        for (int k = 0; k < n; ++k) {
          const double x = a[p * n + k], y = a[q * n + k];
          a[p * n + k] = c * x - s * y, a[q * n + k] = s * x + c * y;
        }
        for (int k = 0; k < n; ++k) {
          const double x = vector[k * n + p], y = vector[k * n + q];
          vector[k * n + p] = c * x - s * y, vector[k * n + q] = s * x + c * y;
        }
      }
  }
  for (int i = 0; i < n; ++i) value[i] = a[i * n + i];
}

}  // namespace cleave::discretisation::spacetime
