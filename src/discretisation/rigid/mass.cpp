#include "discretisation/rigid/mass.hpp"

#include <array>
#include <cmath>

#include "base/assert.hpp"

namespace cleave::discretisation {

using base::cross;
using base::dot;
using base::Sym3;
using model::Shape;
using model::Vector;

namespace {

/// r^2 1 - r r^T.
Sym3<double> inertia_of(const Vector& r) {
  return {r.y * r.y + r.z * r.z,
          r.z * r.z + r.x * r.x,
          r.x * r.x + r.y * r.y,
          -r.x * r.y,
          -r.y * r.z,
          -r.z * r.x};
}

struct Point {
  double at, weight;
};
const double g3 = std::sqrt(0.6);
const std::array<Point, 3> gauss3{{{-g3, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {g3, 5.0 / 9.0}}};
const double a5 = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0,
             b5 = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
const double wa5 = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0, wb5 = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
const std::array<Point, 5> gauss5{{{-b5, wb5}, {-a5, wa5}, {0.0, 128.0 / 225.0}, {a5, wa5}, {b5, wb5}}};

/// Sums mass, first and second moments about a point near the element, then shifts to the centre.
class Integral {
 public:
  explicit Integral(const Vector& about) : about_(about) {}
  void add(const Vector& x, double mass) {
    const Vector r = x - about_;
    mass_ += mass;
    first_ = first_ + mass * r;
    second_ = second_ + mass * inertia_of(r);
  }
  /// Inertia beyond that of the points.
  void add_tensor(const Sym3<double>& tensor) { second_ = second_ + tensor; }
  RigidMass result() const {
    if (!(mass_ > 0.0)) return {};
    const Vector r = (1.0 / mass_) * first_;
    return {mass_, about_ + r, second_ - mass_ * inertia_of(r)};
  }

 private:
  Vector about_;
  double mass_ = 0.0;
  Vector first_{0, 0, 0};
  Sym3<double> second_{0, 0, 0, 0, 0, 0};
};

struct Mapped {
  Vector x{0, 0, 0}, d[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  void add(const Vector& corner, double n, double dr, double ds, double dt) {
    x = x + n * corner;
    d[0] = d[0] + dr * corner;
    d[1] = d[1] + ds * corner;
    d[2] = d[2] + dt * corner;
  }
  double jacobian() const { return dot(d[0], cross(d[1], d[2])); }
};

Mapped map_hex(std::span<const Vector> corner, double r, double s, double t) {
  static constexpr double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Mapped at;
  for (std::size_t a = 0; a < 8; ++a) {
    const double p = 1 + sign[a][0] * r, q = 1 + sign[a][1] * s, w = 1 + sign[a][2] * t;
    at.add(corner[a], 0.125 * p * q * w, 0.125 * sign[a][0] * q * w, 0.125 * sign[a][1] * p * w,
           0.125 * sign[a][2] * p * q);
  }
  return at;
}

/// Quadratic tetrahedron by its volume coordinates; edges 12 23 31 14 24 34.
Mapped map_tet10(std::span<const Vector> corner, double r, double s, double t) {
  const double u[4] = {1 - r - s - t, r, s, t};
  static constexpr double du[4][3] = {{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  static constexpr int edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  Mapped at;
  for (std::size_t a = 0; a < 4; ++a) {
    const double slope = 4 * u[a] - 1;
    at.add(corner[a], u[a] * (2 * u[a] - 1), slope * du[a][0], slope * du[a][1], slope * du[a][2]);
  }
  for (std::size_t e = 0; e < 6; ++e) {
    const int a = edge[e][0], b = edge[e][1];
    const auto d = [&](int k) { return 4 * (u[a] * du[b][k] + u[b] * du[a][k]); };
    at.add(corner[4 + e], 4 * u[a] * u[b], d(0), d(1), d(2));
  }
  return at;
}

}  // namespace

RigidMass& RigidMass::operator+=(const RigidMass& other) {
  if (!(other.mass > 0.0)) return *this;
  if (!(mass > 0.0)) return *this = other;
  const double whole = mass + other.mass;
  const Vector apart = other.centre - centre;
  tensor = tensor + other.tensor + (mass * other.mass / whole) * inertia_of(apart);
  centre = centre + (other.mass / whole) * apart;
  mass = whole;
  return *this;
}

RigidMass point_mass(double mass, const Vector& at) {
  return {mass, at, {0, 0, 0, 0, 0, 0}};
}

RigidMass solid_mass(Shape shape, std::span<const Vector> corner, double density) {
  Integral sum(corner[0]);
  if (shape == Shape::hex8 || shape == Shape::penta6) {
    std::array<Vector, 8> hex;
    constexpr std::size_t wedge[8] = {0, 1, 2, 2,
                                      3, 4, 5, 5};  // a wedge is a hexahedron with two edges closed
    for (std::size_t a = 0; a < 8; ++a) hex[a] = corner[shape == Shape::hex8 ? a : wedge[a]];
    for (const Point& r : gauss3)
      for (const Point& s : gauss3)
        for (const Point& t : gauss3) {
          const Mapped at = map_hex(hex, r.at, s.at, t.at);
          sum.add(at.x, density * r.weight * s.weight * t.weight * at.jacobian());
        }
    return sum.result();
  }
  CLEAVE_ASSERT(shape == Shape::tet4 || shape == Shape::tet10, "no solid");
  std::array<Vector, 10> tet;
  for (std::size_t a = 0; a < 4; ++a) tet[a] = corner[a];
  constexpr int edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (std::size_t e = 0; e < 6; ++e)
    tet[4 + e] = shape == Shape::tet10 ? corner[4 + e]
                                       : 0.5 * (corner[static_cast<std::size_t>(edge[e][0])] +
                                                corner[static_cast<std::size_t>(edge[e][1])]);
  for (const Point& p : gauss5)
    for (const Point& q : gauss5)
      for (const Point& w : gauss5) {
        // The cube collapsed onto the tetrahedron: r, then s within 1 - r, then t within 1 - r - s.
        const double a = 0.5 * (1 + p.at), b = 0.5 * (1 + q.at), c = 0.5 * (1 + w.at);
        const double s = b * (1 - a), t = c * (1 - a) * (1 - b);
        const double weight = 0.125 * p.weight * q.weight * w.weight * (1 - a) * (1 - a) * (1 - b);
        const Mapped at = map_tet10(tet, a, s, t);
        sum.add(at.x, density * weight * at.jacobian());
      }
  return sum.result();
}

RigidMass shell_mass(Shape shape, std::span<const Vector> corner, double density, double thickness,
                     double on_it) {
  Integral sum(corner[0]);
  const Vector quad[4] = {corner[0], corner[1], corner[2], corner[shape == Shape::tri3 ? 2 : 3]};
  static constexpr double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const Point& r : gauss3)
    for (const Point& s : gauss3) {
      Vector x{0, 0, 0}, dr{0, 0, 0}, ds{0, 0, 0};
      for (int a = 0; a < 4; ++a) {
        const double p = 1 + sign[a][0] * r.at, q = 1 + sign[a][1] * s.at;
        x = x + (0.25 * p * q) * quad[a];
        dr = dr + (0.25 * sign[a][0] * q) * quad[a];
        ds = ds + (0.25 * sign[a][1] * p) * quad[a];
      }
      const Vector normal = cross(dr, ds);
      const double jacobian = std::sqrt(dot(normal, normal)), area = r.weight * s.weight * jacobian;
      if (!(jacobian > 0.0)) continue;
      sum.add(x, area * (density * thickness + on_it));
      const double lever = std::sqrt(area * density * thickness * thickness * thickness / 12.0);
      sum.add_tensor(inertia_of((lever / jacobian) * normal));
    }
  return sum.result();
}

}  // namespace cleave::discretisation
