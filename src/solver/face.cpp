#include "solver/face.hpp"

namespace cleave::solver {

using Vector = base::Vec3<double>;

std::array<Vector, 4> face_vectors(const model::Segment& face, std::span<const double> position) {
  Vector x[4];
  for (int a = 0; a < 4; ++a) {
    const double* p = &position[3 * static_cast<std::size_t>(face.node[a])];
    x[a] = {p[0], p[1], p[2]};
  }
  const Vector zero{0, 0, 0};
  if (is_triangle(face)) {
    const Vector third = (1.0 / 6.0) * base::cross(x[1] - x[0], x[2] - x[0]);
    return {third, third, third, zero};
  }
  constexpr double g = 0.57735026918962576451;  // 1 / sqrt(3)
  constexpr double xi_of[4] = {-1, 1, 1, -1}, eta_of[4] = {-1, -1, 1, 1};
  std::array<Vector, 4> out{zero, zero, zero, zero};
  for (int q = 0; q < 4; ++q) {
    const double xi = g * xi_of[q], eta = g * eta_of[q];
    double shape[4];
    Vector along_xi = zero, along_eta = zero;
    for (int a = 0; a < 4; ++a) {
      shape[a] = 0.25 * (1.0 + xi_of[a] * xi) * (1.0 + eta_of[a] * eta);
      along_xi = along_xi + (0.25 * xi_of[a] * (1.0 + eta_of[a] * eta)) * x[a];
      along_eta = along_eta + (0.25 * eta_of[a] * (1.0 + xi_of[a] * xi)) * x[a];
    }
    const Vector area = base::cross(along_xi, along_eta);
    for (int a = 0; a < 4; ++a)
      out[static_cast<std::size_t>(a)] = out[static_cast<std::size_t>(a)] + shape[a] * area;
  }
  return out;
}

}  // namespace cleave::solver
