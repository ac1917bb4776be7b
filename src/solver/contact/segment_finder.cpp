/// Faces against faces (SOFT 2): the forces of an energy of the polygon that two faces share.

#include <algorithm>
#include <memory>

#include "solver/contact/candidates.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/gate.hpp"
#include "solver/contact/neighbours.hpp"
#include "solver/contact/overlap.hpp"

namespace cleave::solver {
namespace {

constexpr std::size_t grain = 8;     // faces that touch are few and stand together in the list
constexpr double reach_depth = 0.5;  // of the mean thickness of both: deeper is another side of the body
constexpr double keep_depth = 1.0;
constexpr double stiffer = 4.0;  // than a node's spring; the step of the elements leaves room for it

constexpr double hard_depth = 0.07;  // of the mean thickness: there the pressure is twice e times the depth,
                                     // and at 5 % of it one and a half times

class SegmentFinder final : public Finder {
 public:
  SegmentFinder(std::shared_ptr<Surface> a, std::shared_ptr<Surface> b, const model::Contact& contact,
                double factor, int rule)
      : a_(std::move(a)),
        b_(std::move(b)),
        contact_(contact),
        single_(a_ == b_),
        factor_a_(stiffer * factor * contact.scale_a),
        factor_b_(stiffer * factor * (a_ == b_ ? contact.scale_a : contact.scale_b)),
        rule_(rule) {}

  void start(const discretisation::State& state) override {
    a_->start(state);
    if (!single_) b_->start(state);
  }
  void erode(std::span<const model::Id> eroded) override {
    a_->erode(eroded);
    b_->erode(eroded);
  }
  const Face& face(std::int32_t number) const override {
    return b_->faces()[static_cast<std::size_t>(number)];
  }

  const Face* face_of_a(const Touch& touch) const override {
    return &face_a(static_cast<std::int32_t>(touch.key[0]));
  }

  void find(const Moment& now, const Past& past, std::vector<Touch>& out) override {
    if (!near_.hold(now, *a_, *b_)) sort(now);
    near_.touches(grain, out,
                  [&](std::int32_t f, std::span<const std::int32_t> faces, std::vector<Touch>& to) {
                    look(now, past, f, faces, to);
                  });
  }

 private:
  const Face& face_a(std::int32_t number) const { return a_->faces()[static_cast<std::size_t>(number)]; }

  static bool joined(const Face& one, const Face& other) {
    if (one.element == other.element || (one.rigid && one.part == other.part)) return true;
    for (const Index node : one.node)
      if (std::find(other.node.begin(), other.node.end(), node) != other.node.end()) return true;
    return false;
  }

  void sort(const Moment& now) {
    const auto &as = a_->active(), &bs = b_->active();
    double size = 0.0;
    for (const std::int32_t f : as) size += std::sqrt(face_a(f).area);
    for (const std::int32_t f : bs) size += std::sqrt(face(f).area);
    size /= std::max<double>(1.0, static_cast<double>(as.size() + bs.size()));
    constexpr double half = 0.5 * keep_depth;  // each of two faces brings its own
    near_.place(now, united(a_->nodes(), b_->nodes()), 0.05 * size, 0.4 * size, *a_, *b_);
    near_.things_reach(a_->largest_offset());
    near_.list(
        as, *b_, half, 256, [&](std::int32_t f) { return near_.box(face_a(f), half); },
        [&](std::int32_t f, std::int32_t g) { return !single_ || (g > f && !joined(face_a(f), face(g))); });
  }

  /// Where the corners of the surface are: those of a shell lie half of it outside its nodes.
  static void corners(const Moment& now, const Face& face, Vector (&x)[4]) {
    for (std::size_t i = 0; i < 4; ++i) x[i] = vector_at(now.position, face.node[i]);
    if (face.offset == 0.0) return;
    const Vector normal = area_normal(face, now.position);
    const double size = norm(normal);
    if (!(size > 0.0)) return;
    for (Vector& at : x) at = at + (face.offset / size) * normal;
  }

  /// From forces on the corners of the surface to those on the nodes.
  static void to_nodes(const Moment& now, const Face& face, Vector (&force)[4]) {
    if (face.offset == 0.0) return;
    const Vector normal = area_normal(face, now.position);
    const double size = norm(normal);
    if (!(size > 0.0)) return;
    Vector x[4];
    for (std::size_t i = 0; i < 4; ++i) x[i] = vector_at(now.position, face.node[i]);
    const Vector sum = force[0] + force[1] + force[2] + force[3];
    turn_back(x, (1.0 / size) * normal, 2.0 * size, -face.offset * sum, 0.0, force);
  }

  void look(const Moment& now, const Past& past, std::int32_t f, std::span<const std::int32_t> near,
            std::vector<Touch>& out) const {
    Vector x[4];
    corners(now, face_a(f), x);
    const Gate gate(x);
    std::span<const Remembered> pairs;  // of this face
    bool looked_up = false;
    Gate::Corners y{};
    alignas(64) double limit[base::lane_count] = {};
    for (std::size_t from = 0; from < near.size(); from += base::lane_count) {
      const std::size_t count = std::min<std::size_t>(base::lane_count, near.size() - from);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const Face& other = face(near[from + lane]);
        Vector corner[4];
        corners(now, other, corner);
        for (std::size_t i = 0; i < 4; ++i) y.set(i, lane, corner[i]);
        limit[lane] =
            keep_depth * 0.5 * (face_a(f).thickness + other.thickness + face_a(f).offset + other.offset);
      }
      const base::Mask may = gate.open(y, base::Lanes::load(limit));
      for (std::size_t lane = 0; lane < count; ++lane)
        if (may[static_cast<int>(lane)]) {
          if (!looked_up) pairs = past.of(f);
          looked_up = true;
          press(now, past, pairs, f, near[from + lane], x, y.face(lane), out);
        }
    }
  }

  void press(const Moment& now, const Past& past, std::span<const Remembered> pairs, std::int32_t f,
             std::int32_t g, const Vector x[4], const std::array<Vector, 4>& y,
             std::vector<Touch>& out) const {
    const Face &one = face_a(f), &other = face(g);
    Overlap shared;
    if (!shared.meet(x, y.data())) return;
    Touch& touch = out.emplace_back();
    touch.faces = true;
    touch.key[0] = f;
    touch.key[1] = g;
    for (std::size_t i = 0; i < 4; ++i) {
      touch.a[i] = one.node[i];
      touch.b[i] = other.node[i];
    }
    touch.normal = shared.normal();
    touch.face = g;
    touch.depth = shared.deepest();
    const double thick = 0.5 * (one.thickness + other.thickness);
    if (touch.depth > release_depth(contact_, thick)) return out.pop_back();
    auto old = pairs.begin();
    while (old != pairs.end() && old->key[1] < static_cast<double>(g)) ++old;
    if (old != pairs.end() && old->key[1] == static_cast<double>(g)) {
      touch.offset = old->offset == out_of_reach ? out_of_reach : std::min(old->offset, touch.depth);
    } else {
      const double reach = reach_of(one, other);
      if (now.step_before == 0.0) {  // what penetrates at the start counts as touching
        touch.offset = touch.depth <= reach ? touch.depth : out_of_reach;
      } else {
        shared.weights_there(touch.wa, touch.wb);
        const double way = norm(relative(touch, now.velocity)) * now.step_before;
        touch.offset = first_offset(now, past, f, g, touch.depth, way);
      }
      if (touch.offset == out_of_reach && touch.depth > reach) return out.pop_back();
    }
    const Springs springs{one.area, std::min(one.area, other.area),
                          1.0 / (hard_depth * hard_depth * thick * thick)};
    Push push;
    if (touch.offset < touch.depth && shared.push(springs, touch.offset, push)) {
      const double of_a = factor_a_ * one.stiffness / one.area,
                   of_b = factor_b_ * other.stiffness / other.area;
      const double pressure = rule_ == 2 ? of_b : rule_ == 3 ? of_a : std::min(of_a, of_b);  // per depth
      touch.area = push.deep_area;
      touch.push = pressure * push.normal;
      touch.energy = pressure * push.energy;
      touch.stiffness = pressure * push.rate;
      for (std::size_t i = 0; i < 4; ++i) {
        touch.wa[i] = push.wa[i];
        touch.wb[i] = push.wb[i];
        touch.on_a[i] = pressure * push.on_a[i];
        touch.on_b[i] = pressure * push.on_b[i];
      }
      to_nodes(now, one, touch.on_a);
      to_nodes(now, other, touch.on_b);
    } else {
      for (std::size_t i = 0; i < 4; ++i) {
        touch.wa[i] = touch.wb[i] = 0.0;
        touch.on_a[i] = touch.on_b[i] = {0, 0, 0};
      }
    }
    touch.penetration = shared.penetration();
  }

  /// The depth that counts as none for a pair that was not there a step ago: none where they met from
  /// outside. Where they came from the side its energy grows from zero with the area they share, whatever is
  /// decided here, and stays with the pair until they part. Sliding bodies hand their pressure from face to
  /// face; where none around pushes at such a depth, the pair is the far side of a wedge or of a corner and
  /// does not push. Nor does one that lay so before, unless it was laid bare where it is.
  /// @param way  of one relative to the other in the last step [length]
  double first_offset(const Moment& now, const Past& past, std::int32_t f, std::int32_t g, double depth,
                      double way) const {
    Vector x[4], y[4];
    corners_before(now, face_a(f), x);
    corners_before(now, face(g), y);
    Overlap before;
    if (before.share(x, y)) {
      if (before.deepest() <= 0.0) return 0.0;
      return contact_.eroding && depth <= reach_of(face_a(f), face(g)) ? depth : out_of_reach;
    }
    if (depth <= way) return 0.0;
    return handed_on(past, *a_, *b_, f, g, depth - way);
  }
  /// How deep faces may be that were not seen to come so; deeper is another side of a body.
  static double reach_of(const Face& one, const Face& other) {
    // Behind the middle of a shell is its other side.
    if (one.shell || other.shell) return one.offset + other.offset;
    return reach_depth * 0.5 * (one.thickness + other.thickness);
  }
  static void corners_before(const Moment& now, const Face& face, Vector (&x)[4]) {
    corners(now, face, x);
    for (std::size_t i = 0; i < 4; ++i) x[i] = x[i] - now.step_before * vector_at(now.velocity, face.node[i]);
  }

  std::shared_ptr<Surface> a_, b_;
  const model::Contact& contact_;
  bool single_;
  double factor_a_, factor_b_;
  int rule_;
  Candidates near_;
};

}  // namespace

std::unique_ptr<Finder> make_segment_finder(std::shared_ptr<Surface> a, std::shared_ptr<Surface> b,
                                            const model::Contact& contact, double factor, int rule) {
  return std::make_unique<SegmentFinder>(std::move(a), std::move(b), contact, factor, rule);
}

}  // namespace cleave::solver
