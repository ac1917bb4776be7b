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

std::array<Vector, 6> face_vectors(const std::array<model::Index, 6>& face,
                                   std::span<const double> position) {
  Vector x[6];
  for (std::size_t a = 0; a < 6; ++a) {
    const double* p = &position[3 * static_cast<std::size_t>(face[a])];
    x[a] = {p[0], p[1], p[2]};
  }
  // Two orbits of three points each: barycentric coordinates (1 - 2 g, g, g).
  constexpr double place[2] = {0.445948490915964886318329253883, 0.091576213509770743459571463402};
  constexpr double weight[2] = {0.223381589678011465819499253937, 0.109951743655321867513834079397};
  std::array<Vector, 6> out;
  out.fill({0, 0, 0});
  for (int orbit = 0; orbit < 2; ++orbit)
    for (int corner = 0; corner < 3; ++corner) {
      double l[3] = {place[orbit], place[orbit], place[orbit]};
      l[corner] = 1.0 - 2.0 * place[orbit];
      // Shape functions, and their derivatives along l1 and l2 with l0 = 1 - l1 - l2.
      const double n[6] = {l[0] * (2 * l[0] - 1), l[1] * (2 * l[1] - 1), l[2] * (2 * l[2] - 1),
                           4 * l[0] * l[1],       4 * l[1] * l[2],       4 * l[2] * l[0]};
      const double along_1[6] = {1 - 4 * l[0], 4 * l[1] - 1, 0.0, 4 * (l[0] - l[1]), 4 * l[2], -4 * l[2]};
      const double along_2[6] = {1 - 4 * l[0], 0.0, 4 * l[2] - 1, -4 * l[1], 4 * l[1], 4 * (l[0] - l[2])};
      Vector u{0, 0, 0}, v{0, 0, 0};
      for (int a = 0; a < 6; ++a) {
        u = u + along_1[a] * x[a];
        v = v + along_2[a] * x[a];
      }
      const Vector normal = (0.5 * weight[orbit]) * base::cross(u, v);
      for (std::size_t a = 0; a < 6; ++a) out[a] = out[a] + n[a] * normal;
    }
  return out;
}

}  // namespace cleave::solver
