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
  // Sides and warp of x(xi, eta) = c + u xi + v eta + w xi eta. Opposite corners are added first: the warp of
  // a parallelogram is then zero to the bit, and its corners get the same vector.
  const Vector even = x[0] + x[2], odd = x[1] + x[3], forward = x[2] - x[0], across = x[1] - x[3];
  const Vector u = 0.25 * (forward + across), v = 0.25 * (forward - across), w = 0.25 * (even - odd);
  // n dA = (u + w eta) x (v + w xi): constant, along xi and along eta, of which a shape function sees a
  // third.
  constexpr double xi_of[4] = {-1, 1, 1, -1}, eta_of[4] = {-1, -1, 1, 1};
  const Vector mean = base::cross(u, v);
  const Vector along_xi = (1.0 / 3.0) * base::cross(u, w), along_eta = (1.0 / 3.0) * base::cross(w, v);
  std::array<Vector, 4> out;
  for (std::size_t a = 0; a < 4; ++a) out[a] = mean + xi_of[a] * along_xi + eta_of[a] * along_eta;
  return out;
}

}  // namespace cleave::solver
