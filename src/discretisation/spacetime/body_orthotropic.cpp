/// Stiffness of orthotropic parts along their material axes, turned into the axes of the body.

#include "discretisation/spacetime/body_steps.hpp"
#include "model/elasticity.hpp"

namespace cleave::discretisation::spacetime {
namespace {

using Axes = Matrix<3>;  ///< rows a, b, c in global components

/// Components along the material axes to global ones; both hold tensor components by pairs of indices.
Matrix<6> turned(const Matrix<6>& local, const Axes& axes) {
  Matrix<6> out{};
  static constexpr int pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
  for (int p = 0; p < 6; ++p)
    for (int q = 0; q < 6; ++q)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              out[p][q] += axes[a][pair[p][0]] * axes[b][pair[p][1]] * axes[c][pair[q][0]] *
                           axes[d][pair[q][1]] * local[voigt<3>(a, b)][voigt<3>(c, d)];
  return out;
}

/// Stiffness, and the compliance as a tensor, along the material axes.
void along_axes(const model::Elasticity& m, Matrix<6>& stiffness, Matrix<6>& compliance) {
  const auto& e = m.modulus;
  Matrix<3> s{};
  for (int k = 0; k < 3; ++k) s[k][k] = 1.0 / e[k];
  s[0][1] = s[1][0] = -m.poisson_ba / e[1];
  s[0][2] = s[2][0] = -m.poisson_ca / e[2];
  s[1][2] = s[2][1] = -m.poisson_cb / e[2];
  const Matrix<3> c = inverse<3>(s);
  const double shear[] = {m.shear_ab, m.shear_bc, m.shear_ca};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) stiffness[i][j] = 0.5 * (c[i][j] + c[j][i]), compliance[i][j] = s[i][j];
    stiffness[3 + i][3 + i] = shear[i];
    compliance[3 + i][3 + i] = 0.25 / shear[i];
  }
}

/// In the plane: a along `a`, b to its left, c along z; turned by an angle to the left.
Axes in_plane(double ax, double ay, double angle) {
  const double size = std::hypot(ax, ay), c = std::cos(angle), s = std::sin(angle);
  const double x = (c * ax - s * ay) / size, y = (s * ax + c * ay) / size;
  return {{{x, y, 0.0}, {-y, x, 0.0}, {0.0, 0.0, 1.0}}};
}

/// Direction from node 1 to node 2 of the elements of a part. False if it is not that of all of them.
bool common_edge(const model::Model& model, model::Index part, std::array<double, 2>& direction) {
  bool first = true;
  for (const auto* groups : {&model.mesh.shells, &model.mesh.beams})
    for (const model::Elements& group : *groups) {
      const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
      for (std::size_t e = 0; e < group.count(); ++e) {
        if (group.part[e] != part) continue;
        const auto at = [&](std::size_t a, std::size_t k) {
          return model.mesh.nodes.position[3 * static_cast<std::size_t>(group.node[e * n + a]) + k];
        };
        double x = at(1, 0) - at(0, 0), y = at(1, 1) - at(0, 1);
        const double size = std::hypot(x, y);
        x /= size, y /= size;
        if (first) direction = {x, y}, first = false;
        if (std::fabs(x * direction[1] - y * direction[0]) > 1e-6) return false;
      }
    }
  return !first;
}

}  // namespace

template <int D>
std::string make_orthotropic(const model::Model& model, model::Index part, PlaneKind plane, Elastic<D>& out) {
  const model::Part& of = model.parts[static_cast<std::size_t>(part)];
  const model::Elasticity& m = *of.elastic;
  Axes axes{};
  if (m.axes == model::Elasticity::Axes::frame) {
    for (std::size_t k = 0; k < 3; ++k) axes[k] = {m.frame.axis[k].x, m.frame.axis[k].y, m.frame.axis[k].z};
  } else if (m.axes == model::Elasticity::Axes::across) {
    axes = in_plane(m.reference.y, -m.reference.x, m.angle);
  } else {
    std::array<double, 2> edge{1.0, 0.0};
    if (!common_edge(model, part, edge))
      return "its material axes follow node 1 to node 2 of each element (AOPT 0), which are not parallel; "
             "give "
             "them by AOPT 2 or 3";
    axes = in_plane(edge[0], edge[1], m.angle);
  }
  Matrix<6> c{}, s{};
  along_axes(m, c, s);
  c = turned(c, axes);
  s = turned(s, axes);

  Matrix<strain_count<D>> stiffness{};
  if constexpr (D == 3) stiffness = c;
  if constexpr (D < 3) {
    // Motion stays in the plane or on the line only where it is one of symmetry.
    double largest = 0.0, coupling = 0.0;
    for (int p = 0; p < 6; ++p) largest = std::max(largest, c[p][p]);
    if constexpr (D == 2)
      for (const int p : {0, 1, 2, 3})
        coupling = std::max({coupling, std::fabs(c[p][4]), std::fabs(c[p][5])});
    if constexpr (D == 1)
      if (plane == PlaneKind::strain) coupling = std::max(std::fabs(c[0][3]), std::fabs(c[0][5]));
    if (coupling > 1e-9 * largest)
      return D == 2
                 ? "one of its material axes must stand across the plane: pulled in it, the body would shear "
                   "out of it"
                 : "one of its material axes must lie along the line: pulled, the body would shear across it";
    static constexpr int inside[] = {0, 1, 3};
    for (std::size_t p = 0; p < strain_count<D>; ++p)
      for (std::size_t q = 0; q < strain_count<D>; ++q) {
        const int i = inside[p], j = inside[q];
        stiffness[p][q] = plane == PlaneKind::strain ? c[i][j]
                          : D == 1                   ? 1.0 / s[0][0]
                                                     : c[i][j] - c[i][2] * c[2][j] / c[2][2];
      }
  }
  const std::string wrong = make_anisotropic<D>(of.density, stiffness, out);
  if constexpr (D == 2)
    if (wrong.empty() && plane == PlaneKind::strain) out.across = {c[2][0], c[2][1], c[2][3]};
  return wrong;
}

template std::string make_orthotropic<1>(const model::Model&, model::Index, PlaneKind, Elastic<1>&);
template std::string make_orthotropic<2>(const model::Model&, model::Index, PlaneKind, Elastic<2>&);
template std::string make_orthotropic<3>(const model::Model&, model::Index, PlaneKind, Elastic<3>&);

}  // namespace cleave::discretisation::spacetime
