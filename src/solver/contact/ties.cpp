#include "solver/contact/ties.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/closest.hpp"
#include "solver/contact/search.hpp"

namespace cleave::solver {
namespace {

constexpr double within = 0.05;  // of the shorter diagonal

double reach_of(const Face& face, const Vector x[4], const model::Contact& contact) {
  if (contact.tie_distance > 0.0) return contact.tie_distance;
  if (contact.offset) return 0.5 * std::sqrt(face.area);
  const double first = norm(x[2] - x[0]), second = norm(x[3] - x[1]);
  return within * (face.corners() == 3 ? std::max(first, second) : std::min(first, second));
}

/// With an offset a node must lie over the face, not beside it: the way to its closest point runs along the
/// normal, but for 5 % of the face's size.
bool over(const Face& face, std::span<const double> position, const Vector& way) {
  const Vector area = area_normal(face, position);
  const Vector normal = (1.0 / norm(area)) * area;
  return norm(way - base::dot(way, normal) * normal) <= within * std::sqrt(face.area);
}

}  // namespace

std::vector<Tie> find_ties(const discretisation::World& world, const model::Contact& contact,
                           deck::Diagnostics& diagnostics) {
  const Surface surface(world, contact, contact.b, false, true, diagnostics);
  const std::span<const double> position(world.model->mesh.nodes.position);
  std::vector<Bounds> boxes;
  for (const Face& face : surface.faces()) {
    Bounds box = Bounds::nothing();
    Vector x[4];
    for (std::size_t a = 0; a < 4; ++a) {
      x[a] = vector_at(position, face.node[a]);
      box.add({{x[a].x, x[a].y, x[a].z}, {x[a].x, x[a].y, x[a].z}});
    }
    box.grow(reach_of(face, x, contact));
    boxes.push_back(box);
  }
  Tree tree;
  tree.build(boxes);
  std::vector<Tie> ties;
  std::size_t loose = 0;
  for (const Index node : contact.a.nodes) {
    if (std::binary_search(surface.nodes().begin(), surface.nodes().end(), node)) continue;
    const Vector p = vector_at(position, node);
    double least = 1e300;
    std::int32_t best = -1;
    Closest place{};
    tree.query({{p.x, p.y, p.z}, {p.x, p.y, p.z}}, [&](std::int32_t f) {
      const Face& face = surface.faces()[static_cast<std::size_t>(f)];
      Vector x[4];
      for (std::size_t a = 0; a < 4; ++a) x[a] = vector_at(position, face.node[a]);
      const Closest c = closest_point(face, x, p);
      const double distance = norm(p - c.point);
      if (distance > reach_of(face, x, contact) || (contact.offset && !over(face, position, p - c.point)))
        return;
      if (distance > least || (distance == least && f > best)) return;
      least = distance;
      best = f;
      place = c;
    });
    if (best < 0) {
      ++loose;
      continue;
    }
    Tie tie{node, {}, {}, {}, best};
    const Face& face = surface.faces()[static_cast<std::size_t>(best)];
    for (std::size_t a = 0; a < 4; ++a) {
      tie.corner[a] = face.node[a];
      tie.weight[a] = place.weight[a];
    }
    // The node keeps its distance from the point, within roundoff of zero where surfaces lie on each other.
    Vector at{0, 0, 0};
    for (std::size_t a = 0; a < 4; ++a) at = at + tie.weight[a] * vector_at(position, tie.corner[a]);
    const Vector offset = p - at;
    tie.offset[0] = offset.x;
    tie.offset[1] = offset.y;
    tie.offset[2] = offset.z;
    ties.push_back(tie);
  }
  if (ties.empty())
    diagnostics.error(contact.place, contact.keyword, "SURFA",
                      "no node of tied contact " + std::to_string(contact.id) + " is near a face of side B",
                      "the surfaces must lie within 5 % of a face's size (_OFFSET: half of it); SAST below 0 "
                      "gives another distance");
  else if (loose > 0)
    diagnostics.note(contact.place, contact.keyword, "SURFA",
                     std::to_string(ties.size()) + " nodes of tied contact " + std::to_string(contact.id) +
                         " are tied, " + std::to_string(loose) + " are too far away");
  return ties;
}

}  // namespace cleave::solver
