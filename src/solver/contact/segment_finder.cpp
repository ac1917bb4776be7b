/// Faces against faces (SOFT 2): a pressure in proportion to the depth, over the polygon two faces share.

#include <algorithm>
#include <memory>

#include "solver/contact/candidates.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/gate.hpp"
#include "solver/contact/overlap.hpp"

namespace cleave::solver {
namespace {

constexpr std::size_t grain = 8;     // faces that touch are few and stand together in the list
constexpr double reach_depth = 0.5;  // of the mean thickness of both: deeper is another side of the body
constexpr double keep_depth = 1.0;
constexpr double stiffer = 4.0;  // than a node's spring; the step of the elements leaves room for it

constexpr double hard_depth = 0.25;  // of the mean thickness: there the stiffness is twice that at the start

double ramp(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

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
    if (one.element == other.element) return true;
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

  void look(const Moment& now, const Past& past, std::int32_t f, std::span<const std::int32_t> near,
            std::vector<Touch>& out) const {
    Vector x[4];
    corners(now, face_a(f), x);
    const Gate gate(x);
    for (std::size_t from = 0; from < near.size(); from += base::lane_count) {
      const std::size_t count = std::min<std::size_t>(base::lane_count, near.size() - from);
      Gate::Corners y;
      for (std::size_t lane = 0; lane < base::lane_count; ++lane) {
        const Face& other = face(near[from + std::min(lane, count - 1)]);
        Vector corner[4];
        corners(now, other, corner);
        for (std::size_t i = 0; i < 4; ++i) y.set(i, lane, corner[i]);
      }
      const base::Mask may = gate.open(y);
      for (std::size_t lane = 0; lane < count; ++lane)
        if (may[static_cast<int>(lane)]) press(now, past, f, near[from + lane], x, y.face(lane), out);
    }
  }

  void press(const Moment& now, const Past& past, std::int32_t f, std::int32_t g, const Vector x[4],
             const std::array<Vector, 4>& y, std::vector<Touch>& out) const {
    const Face &one = face_a(f), &other = face(g);
    Overlap shared;
    if (!overlap(x, y.data(), shared)) return;
    Touch touch;
    touch.key[0] = f;
    touch.key[1] = g;
    for (std::size_t i = 0; i < 4; ++i) {
      touch.a[i] = one.node[i];
      touch.wa[i] = shared.wa[i];
      touch.b[i] = other.node[i];
      touch.wb[i] = shared.wb[i];
    }
    touch.normal = shared.normal;
    touch.face = g;
    touch.depth = shared.volume / shared.deep_area;
    touch.area = shared.deep_area;
    const double thick = 0.5 * (one.thickness + other.thickness);
    if (touch.depth > release_depth(contact_, thick)) return;
    // Behind the middle of a shell is its other side.
    const double reach = one.shell || other.shell ? one.offset + other.offset : reach_depth * thick;
    if (touch.depth > reach) {
      const double came =
          -touch.depth - base::dot(relative(touch, now.velocity), touch.normal) * now.step_before;
      if (came < 0.0 && !past.find(touch.key)) return;
    }
    const double of_a = factor_a_ * one.stiffness / one.area, of_b = factor_b_ * other.stiffness / other.area;
    const double pressure = rule_ == 2 ? of_b : rule_ == 3 ? of_a : std::min(of_a, of_b);  // per depth
    // A corner or an edge that pokes covers little area: it gets the stiffness of the area it would cover.
    touch.pokes = 1.0 - ramp(shared.facing, 0.94, 0.995);
    touch.cover = std::min(shared.area / shared.deep_area, 100.0);
    touch.fade = ramp(shared.facing, 0.25, 0.5);
    touch.stiffness = pressure * shared.deep_area;
    touch.hardening = 1.0 / (hard_depth * hard_depth * thick * thick);
    out.push_back(touch);
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
