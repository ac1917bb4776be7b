/// Nodes against faces: every node of one side looks for the closest face of the other that it faces.

#include <algorithm>
#include <memory>

#include "solver/contact/candidates.hpp"
#include "solver/contact/closest.hpp"
#include "solver/contact/finders.hpp"

namespace cleave::solver {
namespace {

using base::dot;

constexpr std::size_t grain = 128;
constexpr double facing = -0.2;      // cosine below which two normals look at each other
constexpr double reach_depth = 0.5;  // of the thickness behind a face: deeper is on the other side
constexpr double keep_depth = 1.0;   // the same for a node that touched it in the step before

class NodeFinder final : public Gauge {
 public:
  NodeFinder(const NodeSides& sides, const model::Contact& contact, double factor, int rule)
      : nodes_(sides.nodes),
        of_nodes_(sides.of_nodes),
        faces_(sides.faces),
        contact_(contact),
        reverse_(sides.reverse),
        single_(sides.single),
        node_factor_(factor * (sides.reverse ? contact.scale_b : contact.scale_a)),
        face_factor_(factor * (sides.reverse || sides.single ? contact.scale_a : contact.scale_b)),
        rule_(rule) {}

  void start(const discretisation::State& state) override {
    of_nodes_->start(state);
    faces_->start(state);
  }
  void erode(std::span<const model::Id> eroded) override {
    of_nodes_->erode(eroded);
    faces_->erode(eroded);
  }
  const Face& face(std::int32_t number) const override {
    return faces_->faces()[static_cast<std::size_t>(number)];
  }

  const Face* face_of_a(const Touch& touch) const override {
    const auto around = of_nodes_->faces_at(touch.a[0]);
    return around.empty() ? nullptr : &of_nodes_->faces()[static_cast<std::size_t>(around.front())];
  }

  void find(const Moment& now, const Past& past, std::vector<Touch>& out) override {
    if (!near_.hold(now, *of_nodes_, *faces_)) sort(now);
    near_.touches(grain, out, [&](Index node, std::span<const std::int32_t> faces, std::vector<Touch>& to) {
      look(now, past, node, faces, to);
    });
  }

  void gaps(const Moment& now, std::span<double> gap) override {
    if (!near_.hold(now, *of_nodes_, *faces_)) sort(now);
    for (const std::int32_t f : of_nodes_->active())
      for (const Index node : face_of_nodes(f).node) {
        double& least = gap[static_cast<std::size_t>(node)];
        least = std::min(least, face_of_nodes(f).thickness);
      }
    near_.each([&](Index node, std::span<const std::int32_t> near) {
      const Slave slave = slave_at(now, node);
      Closest place{};
      const std::int32_t f = closest(now, slave, near, place);
      if (f < 0) return;
      Touch touch;
      std::copy(place.weight, place.weight + 4, touch.wb);
      const double way = penetrates(now, slave, f, place, touch)
                             ? -touch.depth
                             : norm(slave.at - place.point) - slave.offset - face(f).offset;
      double& least = gap[static_cast<std::size_t>(node)];
      least = std::min(least, way);
    });
  }
  void add_areas(const Moment& now, std::span<Vector> area) const override {
    for (const std::int32_t f : of_nodes_->active()) {
      const Face& face = of_nodes_->faces()[static_cast<std::size_t>(f)];
      const Vector share = (1.0 / face.corners()) * area_normal(face, now.position);
      for (int k = 0; k < face.corners(); ++k) {
        Vector& sum = area[static_cast<std::size_t>(face.node[static_cast<std::size_t>(k)])];
        sum = sum + share;
      }
    }
  }

 private:
  const Face& face_of_nodes(std::int32_t f) const { return of_nodes_->faces()[static_cast<std::size_t>(f)]; }
  std::span<const Index> slaves() const { return nodes_.empty() ? of_nodes_->nodes() : nodes_; }

  /// Lists the faces each node may meet while the boxes hold.
  void sort(const Moment& now) {
    const auto& active = faces_->active();
    double size = 0.0;
    for (const std::int32_t f : active) size += std::sqrt(face(f).area);
    size /= std::max<double>(1.0, static_cast<double>(active.size()));
    near_.place(now, united(slaves(), faces_->nodes()), 0.1 * size, 0.5 * size, *of_nodes_, *faces_);
    near_.things_reach(of_nodes_->largest_offset());
    near_.list(
        slaves(), *faces_, keep_depth, 1024, [&](Index node) { return near_.reach().box(node); },
        [&](Index node, std::int32_t f) { return !single_ || !own(node, face(f)); });
  }

  /// Does the node belong to the face, or to the solid behind it?
  bool own(Index node, const Face& target) const {
    if (std::find(target.node.begin(), target.node.end(), node) != target.node.end()) return true;
    for (const std::int32_t f : of_nodes_->faces_at(node))
      if (of_nodes_->faces()[static_cast<std::size_t>(f)].element == target.element) return true;
    return false;
  }

  static Vector unit(const Vector& v) {
    const double size = norm(v);
    return size > 0.0 ? (1.0 / size) * v : v;
  }

  /// What is known of a node while it looks at its faces.
  struct Slave {
    Index node;
    Vector at;
    Vector normal[16];  // of the faces around it
    int normals = 0;
    double stiffness = 1e300;
    double offset = 0.0;  // of the surface from the node [length]
  };

  /// Does any face around the node look at a face with this normal?
  static bool faces(const Slave& slave, const Vector& normal) {
    if (slave.normals == 0) return true;
    for (int i = 0; i < slave.normals; ++i)
      if (dot(slave.normal[i], normal) < facing) return true;
    return false;
  }

  Slave slave_at(const Moment& now, Index node) const {
    Slave slave{node, vector_at(now.position, node), {}, 0, 1e300, 0.0};
    for (const std::int32_t f : of_nodes_->faces_at(slave.node)) {
      const Face& around = of_nodes_->faces()[static_cast<std::size_t>(f)];
      slave.stiffness = std::min(slave.stiffness, around.stiffness);
      slave.offset = std::max(slave.offset, around.offset);
      if (slave.normals < 16) slave.normal[slave.normals++] = unit(area_normal(around, now.position));
    }
    return slave;
  }

  /// The closest of the faces that look at the node, with the place on it; -1 for none.
  std::int32_t closest(const Moment& now, const Slave& slave, std::span<const std::int32_t> near,
                       Closest& place) const {
    double least = 1e300;
    std::int32_t best = -1;
    for (const std::int32_t f : near) {
      const Face& target = face(f);
      const Vector normal = unit(area_normal(target, now.position));
      if (!faces(slave, normal)) continue;
      Vector corner[4];
      for (int a = 0; a < 4; ++a)
        corner[a] = vector_at(now.position, target.node[static_cast<std::size_t>(a)]);
      const Closest c = closest_point(target, corner, slave.at);
      const Vector to = slave.at - c.point;
      const double distance = dot(to, to);
      if (distance >= least) continue;
      // Of a shell that the node could meet from either side, the side on which it is.
      if (target.shell && faces(slave, -1.0 * normal) && dot(to, normal) < 0.0) continue;
      least = distance;
      best = f;
      place = c;
    }
    return best;
  }

  void look(const Moment& now, const Past& past, Index node, std::span<const std::int32_t> near,
            std::vector<Touch>& out) const {
    if (!(now.mass[static_cast<std::size_t>(node)] > 0.0)) return;
    const Slave slave = slave_at(now, node);
    Closest place{};
    const std::int32_t best = closest(now, slave, near, place);
    if (best < 0) return;
    Touch touch;
    std::copy(place.weight, place.weight + 4, touch.wb);
    if (!penetrates(now, slave, best, place, touch)) return;
    if (touch.depth > release_depth(contact_, face(best).thickness)) return;

    touch.key[0] = slave.node + (reverse_ ? static_cast<std::int64_t>(now.mass.size()) : 0);
    touch.key[1] = 0;
    const Face& target = face(best);
    for (int a = 0; a < 4; ++a) {
      touch.a[a] = slave.node;
      touch.wa[a] = a == 0 ? 1.0 : 0.0;
      touch.b[a] = target.node[static_cast<std::size_t>(a)];
    }
    touch.face = best;
    touch.reverse = reverse_;
    // Behind the middle of a shell is its other side.
    const double reach = target.shell ? slave.offset + target.offset : reach_depth * target.thickness;
    if (touch.depth > reach) {
      // So deep only if it was in touch before, or has just come through.
      const double came = -touch.depth - dot(relative(touch, now.velocity), touch.normal) * now.step_before;
      const bool was = past.find(touch.key) != nullptr;
      const bool start = now.step_before == 0.0 && !single_;
      if (!was && !start && came < 0.0) return;
      if (start && (target.shell || touch.depth > keep_depth * target.thickness)) return;
    }
    const double of_node = node_factor_ * slave.stiffness, of_face = face_factor_ * target.stiffness;
    const bool has_node = slave.normals > 0;
    const int rule = reverse_ && rule_ != 1 ? 5 - rule_ : rule_;  // 2 and 3 name sides of the card
    touch.stiffness = !has_node || rule == 2 ? of_face : rule == 3 ? of_node : std::min(of_node, of_face);
    touch.area = target.area;
    if (has_node) {
      touch.area = 0.0;
      for (const std::int32_t f : of_nodes_->faces_at(slave.node)) {
        const Face& around = of_nodes_->faces()[static_cast<std::size_t>(f)];
        touch.area += around.area / around.corners();
      }
    }
    out.push_back(touch);
  }

  /// Is the point behind the surface? Fills in normal and depth.
  bool penetrates(const Moment& now, const Slave& slave, std::int32_t f, const Closest& place,
                  Touch& touch) const {
    const Face& target = face(f);
    const Vector to = slave.at - place.point;
    const double apart = slave.offset + target.offset;  // of the nodes where the surfaces meet
    if (place.inside()) {
      // On a fold of a warped face the way to the closest point is along neither of its pieces.
      touch.normal = unit(place.normal);
      touch.depth = apart - dot(to, touch.normal);
      if (touch.depth > 1e-9 * target.thickness && apart == 0.0) {
        touch.depth = norm(to);
        touch.normal = (-1.0 / touch.depth) * to;
      }
      return touch.depth > 0.0;
    }
    // On an edge or a corner: what do the faces around it say together?
    Vector sum = unit(area_normal(target, now.position));
    bool border = false;
    const Vector own_normal = sum;
    const auto join = [&](std::int32_t g) {
      const Vector n = unit(area_normal(face(g), now.position));
      if (face(g).shell && dot(n, own_normal) < 0.0) return;  // the other side of a shell
      if (faces(slave, n))
        sum = sum + n;
      else
        border = true;
    };
    if (place.edge >= 0) {
      const std::int32_t g = faces_->neighbour(f, place.edge);
      if (g >= 0)
        join(g);
      else
        border = true;
    } else {
      const Index corner = target.node[static_cast<std::size_t>(place.corner)];
      for (const std::int32_t g : faces_->faces_at(corner)) {
        if (g != f) join(g);
        const Face& around = face(g);
        for (int e = 0; e < around.corners(); ++e) {
          const bool ends = around.node[static_cast<std::size_t>(e)] == corner ||
                            around.node[static_cast<std::size_t>((e + 1) % around.corners())] == corner;
          if (ends && faces_->neighbour(g, e) < 0) border = true;
        }
      }
    }
    const Vector n = unit(sum);
    const double height = dot(to, n);
    if (height >= apart) return false;
    const double distance = norm(to);
    const Vector beside = to - height * n;
    // Beyond the rim of what it can meet: a face reaches a little beyond its edges.
    if (border && norm(beside) > (contact_.extension - 1.0) * std::sqrt(target.area)) return false;
    const bool at_rim = border || apart > 0.0 || distance < 1e-9 * target.thickness;
    if (at_rim) shift(now, target, beside, n, touch.wb);
    touch.normal = at_rim ? n : (-1.0 / distance) * to;
    touch.depth = at_rim ? apart - height : distance;
    return true;
  }

  /// Moves the weighted point of a face by a vector across the normal, so that the force still passes through
  /// the node: the change of each weight is linear in the place of its corner.
  static void shift(const Moment& now, const Face& target, const Vector& by, const Vector& n, double w[4]) {
    const int count = target.corners();
    Vector x[4], middle{0, 0, 0};
    for (int a = 0; a < count; ++a) {
      x[a] = vector_at(now.position, target.node[static_cast<std::size_t>(a)]);
      middle = middle + (1.0 / count) * x[a];
    }
    Vector e1 = x[1] - x[0];
    e1 = unit(e1 - dot(e1, n) * n);
    const Vector e2 = base::cross(n, e1);
    double m11 = 0.0, m12 = 0.0, m22 = 0.0;
    for (int a = 0; a < count; ++a) {
      const double u = dot(x[a] - middle, e1), v = dot(x[a] - middle, e2);
      m11 += u * u;
      m12 += u * v;
      m22 += v * v;
    }
    const double det = m11 * m22 - m12 * m12, b1 = dot(by, e1), b2 = dot(by, e2);
    if (!(det > 0.0)) return;
    const double g1 = (m22 * b1 - m12 * b2) / det, g2 = (m11 * b2 - m12 * b1) / det;
    for (int a = 0; a < count; ++a) w[a] += g1 * dot(x[a] - middle, e1) + g2 * dot(x[a] - middle, e2);
  }

  std::vector<Index> nodes_;  // of a node set; empty: those of the surface
  std::shared_ptr<Surface> of_nodes_, faces_;
  const model::Contact& contact_;
  bool reverse_, single_;
  double node_factor_, face_factor_;
  int rule_;
  Candidates near_;
};

}  // namespace

std::unique_ptr<Gauge> make_node_finder(const NodeSides& sides, const model::Contact& contact, double factor,
                                        int rule) {
  return std::make_unique<NodeFinder>(sides, contact, factor, rule);
}

}  // namespace cleave::solver
