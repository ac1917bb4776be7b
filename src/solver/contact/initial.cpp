/// What lies within other bodies at the start: said, or refused.

#include <algorithm>
#include <cstdio>

#include "model/solid_shape.hpp"
#include "solver/contact/closest.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/search.hpp"

namespace cleave::solver {
namespace {

/// Is a point inside a solid, by the planes of its sides?
bool inside(const model::Elements& group, std::size_t element, std::span<const double> position,
            const Vector& p) {
  const Index* node = &group.node[static_cast<std::size_t>(model::nodes_of(group.shape)) * element];
  for (const auto& side : model::faces_of(group.shape)) {
    Vector x[4], middle{0, 0, 0};
    for (std::size_t a = 0; a < 4; ++a) {
      x[a] = vector_at(position, node[side[a]]);
      middle = middle + 0.25 * x[a];
    }
    const Vector normal = base::cross(x[2] - x[0], x[3] - x[1]);
    if (base::dot(p - middle, normal) > 0.0) return false;
  }
  return true;
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Tells which points lie on faces: nearer than 2 % of the size of a face.
class OnFaces {
 public:
  OnFaces(std::span<const model::Segment> faces, std::span<const double> position)
      : faces_(faces), position_(position) {
    std::vector<Bounds> boxes;
    for (const model::Segment& face : faces) {
      Bounds box = Bounds::nothing();
      for (const Index node : face.node) {
        const Vector x = vector_at(position, node);
        box.add({{x.x, x.y, x.z}, {x.x, x.y, x.z}});
      }
      box.grow(near * size_of(face));
      boxes.push_back(box);
    }
    tree_.build(boxes);
  }
  bool hold(const Vector& p) const {
    bool on = false;
    tree_.query({{p.x, p.y, p.z}, {p.x, p.y, p.z}}, [&](std::int32_t f) {
      const model::Segment& segment = faces_[static_cast<std::size_t>(f)];
      Face face;
      Vector x[4];
      for (std::size_t a = 0; a < 4; ++a) {
        face.node[a] = segment.node[a];
        x[a] = vector_at(position_, segment.node[a]);
      }
      on = on || norm(p - closest_point(face, x, p).point) < near * size_of(segment);
    });
    return on;
  }

 private:
  static constexpr double near = 0.02;
  double size_of(const model::Segment& face) const {
    return norm(vector_at(position_, face.node[2]) - vector_at(position_, face.node[0]));
  }
  std::span<const model::Segment> faces_;
  std::span<const double> position_;
  Tree tree_;
};

/// Nodes in solids of the given parts that no touch accounts for.
void refuse_deep(const model::Model& model, const model::Contact& contact, std::span<const Index> nodes,
                 const model::ContactSide& other, const std::vector<Index>& known,
                 deck::Diagnostics& diagnostics) {
  const std::span<const double> position(model.mesh.nodes.position);
  struct Where {
    std::size_t group, element;
  };
  std::vector<Bounds> boxes;
  std::vector<Where> where;
  for (std::size_t g = 0; g < model.mesh.solids.size(); ++g) {
    const model::Elements& group = model.mesh.solids[g];
    const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (!std::binary_search(other.parts.begin(), other.parts.end(), group.part[e])) continue;
      Bounds box = Bounds::nothing();
      for (std::size_t a = 0; a < n; ++a) {
        const Vector x = vector_at(position, group.node[n * e + a]);
        box.add({{x.x, x.y, x.z}, {x.x, x.y, x.z}});
      }
      boxes.push_back(box);
      where.push_back({g, e});
    }
  }
  Tree tree;
  tree.build(boxes);
  const OnFaces surface(other.segments, position);
  std::size_t count = 0;
  for (const Index node : nodes) {
    if (std::binary_search(known.begin(), known.end(), node)) continue;
    const Vector p = vector_at(position, node);
    model::Id in = 0;
    tree.query({{p.x, p.y, p.z}, {p.x, p.y, p.z}}, [&](std::int32_t item) {
      const Where at = where[static_cast<std::size_t>(item)];
      const model::Elements& group = model.mesh.solids[at.group];
      const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
      const Index* own = &group.node[n * at.element];
      if (std::find(own, own + n, node) != own + n || !inside(group, at.element, position, p)) return;
      if (in == 0 || group.id[at.element] < in) in = group.id[at.element];
    });
    if (in == 0 || surface.hold(p) || ++count > 5) continue;
    diagnostics.error(contact.place, contact.keyword, "IGNORE",
                      "at the start node " +
                          std::to_string(model.mesh.nodes.id[static_cast<std::size_t>(node)]) +
                          " of contact " + std::to_string(contact.id) + " lies deep in element " +
                          std::to_string(in) + " of the other side, more than an element below its surface",
                      "move the bodies apart; smaller penetrations are allowed and listed");
  }
}

}  // namespace

void report_initial(const model::Model& model, const model::Contact& contact,
                    const std::vector<std::unique_ptr<Finder>>& finders, deck::Diagnostics& diagnostics) {
  const std::vector<double> still(model.mesh.nodes.position.size(), 0.0), mass(model.mesh.nodes.count(), 1.0);
  const Moment now{0.0, 0.0, 0.0, model.mesh.nodes.position, still, mass};
  std::vector<Touch> touches;
  std::vector<Index> known;
  for (const auto& finder : finders) finder->find(now, Past({}), touches);
  double deepest = 0.0;
  std::string listed;
  std::size_t count = 0;
  std::sort(touches.begin(), touches.end(), [](const Touch& x, const Touch& y) { return x.depth > y.depth; });
  for (const Touch& touch : touches) {
    known.push_back(touch.a[0]);
    const double size = std::sqrt(touch.area);
    if (touch.depth < 1e-6 * size) continue;  // they lie on each other
    ++count;
    deepest = std::max(deepest, touch.depth);
    if (count <= 5)
      listed += (listed.empty() ? "" : ", ") +
                std::to_string(model.mesh.nodes.id[static_cast<std::size_t>(touch.a[0])]) + " (" +
                text_of(touch.depth) + ")";
  }
  std::sort(known.begin(), known.end());
  if (count > 0)
    diagnostics.warning(contact.place, contact.keyword, "IGNORE",
                        std::to_string(count) + " nodes of contact " + std::to_string(contact.id) +
                            " penetrate at the start, by up to " + text_of(deepest) +
                            "; node (depth): " + listed + (count > 5 ? " and others" : ""),
                        "these depths count as touching: no force comes from them, and nodes are not moved");
  if (contact.search == model::Contact::Search::single) return;
  if (!contact.b.parts.empty()) refuse_deep(model, contact, contact.a.nodes, contact.b, known, diagnostics);
  if (!contact.a.parts.empty() && !contact.b.nodes.empty())
    refuse_deep(model, contact, contact.b.nodes, contact.a, known, diagnostics);
}

}  // namespace cleave::solver
