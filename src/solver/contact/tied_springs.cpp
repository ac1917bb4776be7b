#include "solver/contact/tied_springs.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/overlap.hpp"
#include "solver/contact/search.hpp"
#include "solver/contact/ties.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;

constexpr double stiffer = 4.0;  // as for faces against faces

/// Corners of a face from their middle; a triangle repeats its third, whose second arm is zero. (Loops over
/// four whatever the shape: GCC 12 vectorises one over three or four corners wrongly.)
void arms(std::span<const double> position, const Index node[4], Vector (&arm)[4]) {
  const double last = node[3] == node[2] ? 0.0 : 1.0;
  const double weight[4] = {1.0, 1.0, 1.0, last};
  Vector middle{0, 0, 0};
  for (int k = 0; k < 4; ++k) middle = middle + (weight[k] / (3.0 + last)) * vector_at(position, node[k]);
  for (int k = 0; k < 4; ++k) arm[k] = weight[k] * (vector_at(position, node[k]) - middle);
}

/// Sum of |r|^2 1 - r r over the corners [length^2].
base::Sym3<double> inertia_of(const Vector (&arm)[4]) {
  base::Sym3<double> j{0, 0, 0, 0, 0, 0};
  for (const Vector& r : arm) {
    j.xx += r.y * r.y + r.z * r.z;
    j.yy += r.x * r.x + r.z * r.z;
    j.zz += r.x * r.x + r.y * r.y;
    j.xy -= r.x * r.y;
    j.yz -= r.y * r.z;
    j.zx -= r.z * r.x;
  }
  return j;
}

/// J^-1 m by cofactors.
Vector solve(const base::Sym3<double>& j, const Vector& m) {
  const Vector a{j.xx, j.xy, j.zx}, b{j.xy, j.yy, j.yz}, c{j.zx, j.yz, j.zz};
  const double det = dot(a, cross(b, c));
  if (!(det > 0.0)) return {0, 0, 0};
  return (1.0 / det) * Vector{dot(m, cross(b, c)), dot(a, cross(m, c)), dot(a, cross(b, m))};
}

/// A spring between two points at the start.
Spring make_spring(std::span<const double> position, const Index a[4], const double wa[4], const Index b[4],
                   const double wb[4], double stiffness, double area) {
  Spring spring{};
  Vector gap{0, 0, 0};
  for (int k = 0; k < 4; ++k) {
    spring.touch.a[k] = a[k];
    spring.touch.b[k] = b[k];
    spring.touch.wa[k] = wa[k];
    spring.touch.wb[k] = wb[k];
    gap = gap + wa[k] * vector_at(position, a[k]) - wb[k] * vector_at(position, b[k]);
  }
  spring.touch.stiffness = stiffness;
  spring.touch.area = area;
  const Frame3 frame = frame_of(position, spring.touch.b);
  spring.rest = {dot(gap, frame.e1), dot(gap, frame.e2), dot(gap, frame.n)};
  return spring;
}

/// Nodes: the springs of a face share its stiffness.
std::vector<Spring> node_springs(const discretisation::World& world, const model::Contact& contact,
                                 const Surface& b, deck::Diagnostics& diagnostics) {
  const std::span<const double> position(world.model->mesh.nodes.position);
  std::vector<Tie> ties = find_ties(world, contact, diagnostics);
  std::erase_if(ties, [&](const Tie& tie) { return joined(world, tie); });
  std::vector<double> count(b.faces().size(), 0.0);
  for (const Tie& tie : ties) count[static_cast<std::size_t>(tie.face)] += 1.0;
  std::vector<Spring> springs;
  for (const Tie& tie : ties) {
    const Face& face = b.faces()[static_cast<std::size_t>(tie.face)];
    const double share = 1.0 / count[static_cast<std::size_t>(tie.face)];
    const Index node[4] = {tie.node, tie.node, tie.node, tie.node};
    constexpr double whole[4] = {1, 0, 0, 0};
    springs.push_back(make_spring(
        position, node, whole, tie.corner, tie.weight,
        share * stiffer * world.model->control.contact.stiffness * contact.scale_b * face.stiffness,
        share * face.area));
  }
  return springs;
}

/// Do all corners of a face belong to one body?
bool rigid(const discretisation::World& world, const Face& face) {
  if (world.body_of_node.empty()) return false;
  const auto body = [&](std::size_t k) { return world.body_of_node[static_cast<std::size_t>(face.node[k])]; };
  return body(0) >= 0 && body(1) == body(0) && body(2) == body(0) && body(3) == body(0);
}

std::vector<Spring> face_springs(const discretisation::World& world, const model::Contact& contact,
                                 const Surface& a, const Surface& b) {
  const model::Model& model = *world.model;
  const std::span<const double> position(model.mesh.nodes.position);
  const auto corners = [&](const Face& face, Vector x[4]) {
    for (std::size_t i = 0; i < 4; ++i) x[i] = vector_at(position, face.node[i]);
  };
  std::vector<Bounds> boxes;
  const auto box_of = [](const Vector x[4], double grow) {
    Bounds box = Bounds::nothing();
    for (int i = 0; i < 4; ++i) box.add({{x[i].x, x[i].y, x[i].z}, {x[i].x, x[i].y, x[i].z}});
    box.grow(grow);
    return box;
  };
  for (const Face& face : b.faces()) {
    Vector x[4];
    corners(face, x);
    boxes.push_back(box_of(x, 0.0));
  }
  Tree tree;
  tree.build(boxes);
  std::vector<Spring> springs;
  for (const Face& one : a.faces()) {
    Vector x[4];
    corners(one, x);
    // The surfaces may be apart: by half an element here, or by the distance given.
    const double reach = contact.tie_distance > 0.0 ? contact.tie_distance : 0.5 * std::sqrt(one.area);
    std::vector<std::int32_t> near;
    tree.query(box_of(x, reach), [&](std::int32_t f) { near.push_back(f); });
    std::sort(near.begin(), near.end());
    for (const std::int32_t f : near) {
      const Face& other = b.faces()[static_cast<std::size_t>(f)];
      if (contact.joins && rigid(world, other)) continue;  // its nodes are the body's already
      Vector y[4];
      corners(other, y);
      Overlap shared;
      std::vector<SharedPoint> points;
      if (!shared.share(x, y)) continue;
      shared.points(points);
      const double modulus = stiffer * model.control.contact.stiffness *
                             std::min(contact.scale_a * one.stiffness / one.area,
                                      contact.scale_b * other.stiffness / other.area);
      for (const SharedPoint& point : points)
        if (std::abs(point.gap) <= reach)
          springs.push_back(make_spring(position, one.node.data(), point.wa, other.node.data(), point.wb,
                                        modulus * point.area, point.area));
    }
  }
  return springs;
}

}  // namespace

Frame3 frame_of(std::span<const double> position, const Index node[4]) {
  const Vector a = vector_at(position, node[0]), b = vector_at(position, node[1]);
  const Vector c = vector_at(position, node[2]), d = vector_at(position, node[3]);
  Vector n = cross(c - a, d - b);
  n = (1.0 / norm(n)) * n;
  Vector e = b - a;
  e = e - dot(e, n) * n;
  e = (1.0 / norm(e)) * e;
  return {e, cross(n, e), n};
}

void couple_of(std::span<const double> position, const Index node[4], const Vector& moment,
               Vector (&force)[4]) {
  Vector arm[4];
  arms(position, node, arm);
  const Vector turn = solve(inertia_of(arm), moment);
  for (int k = 0; k < 4; ++k) force[k] = cross(turn, arm[k]);
}

void couple_bound(std::span<const double> position, const Index node[4], double (&bound)[4]) {
  Vector arm[4];
  arms(position, node, arm);
  const base::Sym3<double> j = inertia_of(arm);
  // The norm of the inverse is at most the sum of what it makes of the axes.
  double inverse = 0.0;
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}})
    inverse += dot(solve(j, axis), solve(j, axis));
  for (int k = 0; k < 4; ++k) bound[k] = std::sqrt(inverse) * norm(arm[k]);
}

std::vector<Spring> find_springs(const discretisation::World& world, const model::Contact& contact,
                                 const Surface& a, const Surface& b, deck::Diagnostics& diagnostics) {
  const bool nodes = contact.keyword.find("NODES_TO_SURFACE") != std::string::npos;
  if (nodes) return node_springs(world, contact, b, diagnostics);
  std::vector<Spring> springs = face_springs(world, contact, a, b);
  if (springs.empty() && !contact.joins)
    diagnostics.error(contact.place, contact.keyword, "SURFA",
                      "no face of tied contact " + std::to_string(contact.id) + " lies over a face of side B",
                      "the surfaces must be less than half an element apart and look at each other");
  return springs;
}

}  // namespace cleave::solver
