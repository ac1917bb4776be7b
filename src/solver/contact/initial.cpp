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

/// Who penetrates how deep, the deepest first.
class Listed {
 public:
  explicit Listed(const model::Contact& contact) : contact_(contact) {}
  void add(model::Id node, double depth) { list_.push_back({node, depth}); }
  bool empty() const { return list_.empty(); }

  /// "3 nodes of contact 1 penetrate at the start, by up to 0.1; node (depth): 7 (0.1), 9 (0.05)".
  std::string text(std::size_t most) {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const One& x, const One& y) { return x.depth > y.depth; });
    std::string text = std::to_string(list_.size()) + " nodes of contact " + std::to_string(contact_.id) +
                       " penetrate at the start, by up to " + text_of(list_.front().depth) +
                       "; node (depth): ";
    for (std::size_t i = 0; i < std::min(most, list_.size()); ++i)
      text += (i == 0 ? "" : ", ") + std::to_string(list_[i].node) + " (" + text_of(list_[i].depth) + ")";
    return text + (list_.size() > most ? " and others" : "");
  }

 private:
  struct One {
    model::Id node;
    double depth;
  };
  const model::Contact& contact_;
  std::vector<One> list_;
};

constexpr std::size_t few = 5, many = 100;  // nodes to be listed

/// What the finders see before anything moves.
struct Start {
  std::vector<double> still, mass;
  explicit Start(const model::Model& model)
      : still(model.mesh.nodes.position.size(), 0.0), mass(model.mesh.nodes.count(), 1.0) {}
  Moment moment(const model::Model& model) const {
    return {0.0, 0.0, 0.0, model.mesh.nodes.position, still, mass};
  }
};

bool only_lies_on(const Touch& touch) {
  return touch.depth < 1e-6 * std::sqrt(touch.area);
}

}  // namespace

void move_out(model::Model& model, const model::Contact& contact,
              const std::vector<std::unique_ptr<Gauge>>& finders, deck::Diagnostics& diagnostics) {
  const Start start(model);
  Listed listed(contact);
  // One side after the other, so that what the first has cleared is not cleared twice.
  for (const auto& finder : finders) {
    std::vector<Touch> touches;
    finder->find(start.moment(model), Past({}), touches);
    for (const Touch& touch : touches) {
      if (only_lies_on(touch)) continue;
      double* x = &model.mesh.nodes.position[3 * static_cast<std::size_t>(touch.a[0])];
      x[0] += touch.depth * touch.normal.x;
      x[1] += touch.depth * touch.normal.y;
      x[2] += touch.depth * touch.normal.z;
      listed.add(model.mesh.nodes.id[static_cast<std::size_t>(touch.a[0])], touch.depth);
    }
  }
  if (!listed.empty())
    diagnostics.warning(contact.place, contact.keyword, "IGNORE", listed.text(few),
                        "they were moved to the surface (IGNORE 0); 1 leaves them where they are");
}

void report_initial(const model::Model& model, const model::Contact& contact,
                    const std::vector<std::unique_ptr<Gauge>>& finders, deck::Diagnostics& diagnostics) {
  const Start start(model);
  std::vector<Touch> touches;
  std::vector<Index> known;
  for (const auto& finder : finders) finder->find(start.moment(model), Past({}), touches);
  Listed listed(contact);
  for (const Touch& touch : touches) {
    known.push_back(touch.a[0]);
    if (!only_lies_on(touch))
      listed.add(model.mesh.nodes.id[static_cast<std::size_t>(touch.a[0])], touch.depth);
  }
  std::sort(known.begin(), known.end());
  if (!listed.empty()) {
    const std::string text = listed.text(contact.ignore == 2 ? many : few);
    const std::string hint =
        "these depths count as touching: no force comes from them, and nodes are not moved";
    if (contact.ignore == 1)
      diagnostics.note(contact.place, contact.keyword, "IGNORE", text + "; " + hint);
    else
      diagnostics.warning(contact.place, contact.keyword, "IGNORE", text, hint);
  }
  if (contact.search == model::Contact::Search::single) return;
  if (!contact.b.parts.empty()) refuse_deep(model, contact, contact.a.nodes, contact.b, known, diagnostics);
  if (!contact.a.parts.empty() && !contact.b.nodes.empty())
    refuse_deep(model, contact, contact.b.nodes, contact.a, known, diagnostics);
}

}  // namespace cleave::solver
