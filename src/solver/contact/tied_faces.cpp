/// Ties by springs (*CONTACT_TIED_..._OFFSET): over every polygon that two faces share at the start, springs
/// at its quadrature points keep the points of both where they were, seen from side B.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/contact/balanced.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/overlap.hpp"
#include "solver/contact/search.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;

constexpr std::size_t grain = 256;
constexpr double stiffer = 4.0;  // as for faces against faces

struct Frame3 {
  Vector e1, e2, n;
};
/// Axes that turn with a face.
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

/// One spring, with a Touch for its nodes and weights.
struct Spring {
  Touch touch;
  Vector rest;  // from b to a in the frame of b's face [length]
};

class TiedFaces final : public Interaction {
 public:
  TiedFaces(const model::Contact& contact, std::size_t number, std::vector<Spring> springs, double stiffest,
            Surface a, Surface b)
      : contact_(contact),
        number_(number),
        springs_(std::move(springs)),
        scale_(stiffest),
        a_(std::move(a)),
        b_(std::move(b)) {}

  std::size_t contact() const override { return number_; }
  std::string name() const override { return "tied " + std::to_string(number_); }
  base::Array<double> first_memory() const override { return base::Array<double>(head, 0.0); }
  void start(const discretisation::State&) override {}

  ContactOutput add_force(const Moment& now, std::span<const model::Id>, base::Array<double>& memory,
                          discretisation::ForceSum& force) override {
    ContactOutput output;
    active_ = now.time >= contact_.birth && now.time < contact_.death;
    for (std::size_t i = force_x; i < head; ++i) memory[i] = 0.0;
    if (!active_) return output;
    std::vector<double> largest((springs_.size() + grain - 1) / grain, 0.0);
    base::for_each_range(springs_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Balanced balanced(force);
      for (std::size_t i = begin; i < end; ++i) {
        Touch& touch = springs_[i].touch;
        pull(now, springs_[i]);
        balanced.add(touch);
      }
      largest[begin / grain] = balanced.largest();
    });
    double top = scale_;
    for (const double one : largest) top = std::max(top, one);
    force.report_largest(top);
    for (const Spring& spring : springs_) {
      memory[force_x] += spring.touch.pressure.x;
      memory[force_x + 1] += spring.touch.pressure.y;
      memory[force_x + 2] += spring.touch.pressure.z;
    }
    output.stiffness_rate = rate(now);
    return output;
  }

  void settle(const Moment& now, base::Array<double>& memory,
              std::span<const double> acceleration) const override {
    struct Pair {
      double before = 0.0, after = 0.0;
      Pair& operator+=(const Pair& o) {
        before += o.before;
        after += o.after;
        return *this;
      }
    };
    const Pair sum =
        ordered_sum<Pair>(active_ ? springs_.size() : 0, grain, [&](std::size_t begin, std::size_t end) {
          Pair part;
          for (std::size_t i = begin; i < end; ++i) {
            const Touch& touch = springs_[i].touch;
            const Vector early = relative(touch, now.velocity);
            const Vector late = early + now.interval() * relative(touch, acceleration);
            part.before -= 0.5 * now.step_before * dot(touch.pressure, early);
            part.after -= 0.5 * now.step * dot(touch.pressure, late);
          }
          return part;
        });
    memory[energy] += memory[energy_after] + sum.before;
    memory[energy_after] = sum.after;
  }

  InterfaceForce report(std::span<const double> memory) const override {
    InterfaceForce out;
    for (int i = 0; i < 3; ++i) out.force[i] = memory[force_x + static_cast<std::size_t>(i)];
    out.normal_energy = memory[energy];
    for (const Spring& spring : springs_) out.area += active_ ? spring.touch.area : 0.0;
    out.touches = active_ ? springs_.size() : 0;
    return out;
  }

  discretisation::StepStatus accuse(const Moment&, std::string what, std::string cause) const override {
    return {false, -1, 0, "tied contact " + std::to_string(contact_.id) + ": " + what, std::move(cause)};
  }

  void add_nodal(std::span<double> force) const override {
    for (const Spring& spring : springs_)
      if (active_) add_touch(spring.touch, force);
  }
  /// Ties keep their distance: there is no gap to tell.
  void add_fields(const Moment& now, ContactFields& fields) override {
    std::vector<double> force(fields.pressure.size() * 3, 0.0);
    std::vector<Vector> area(fields.pressure.size(), Vector{0, 0, 0});
    add_nodal(force);
    for (const Surface* surface : {&a_, &b_})
      for (const Face& face : surface->faces())
        for (int k = 0; k < face.corners(); ++k) {
          Vector& sum = area[static_cast<std::size_t>(face.node[static_cast<std::size_t>(k)])];
          sum = sum + (1.0 / face.corners()) * area_normal(face, now.position);
        }
    add_pressure(force, area, fields.pressure);
  }
  void clear_nodal(std::span<double> force) const override {
    for (const Spring& spring : springs_) clear_touch(spring.touch, force);
  }

 private:
  enum Slot : std::size_t { energy, energy_after, force_x, head = force_x + 3 };

  static void pull(const Moment& now, Spring& spring) {
    Touch& touch = spring.touch;
    const Frame3 frame = frame_of(now.position, touch.b);
    Vector gap{0, 0, 0};
    for (int k = 0; k < 4; ++k) {
      if (touch.wa[k] != 0.0) gap = gap + touch.wa[k] * vector_at(now.position, touch.a[k]);
      if (touch.wb[k] != 0.0) gap = gap - touch.wb[k] * vector_at(now.position, touch.b[k]);
    }
    const Vector rest = spring.rest.x * frame.e1 + spring.rest.y * frame.e2 + spring.rest.z * frame.n;
    touch.pressure = touch.stiffness * (rest - gap);
  }

  double rate(const Moment& now) const {
    if (sums_.empty()) {
      sums_.assign(now.mass.size(), 0.0);
      for (const Spring& spring : springs_)
        for (int k = 0; k < 4; ++k) {
          sums_[static_cast<std::size_t>(spring.touch.a[k])] +=
              spring.touch.stiffness * std::abs(spring.touch.wa[k]);
          sums_[static_cast<std::size_t>(spring.touch.b[k])] +=
              spring.touch.stiffness * std::abs(spring.touch.wb[k]);
        }
    }
    double most = 0.0;
    for (std::size_t a = 0; a < sums_.size(); ++a)
      if (sums_[a] > 0.0 && now.mass[a] > 0.0) most = std::max(most, 2.0 * sums_[a] / now.mass[a]);
    return most;
  }

  const model::Contact& contact_;
  std::size_t number_;
  std::vector<Spring> springs_;
  double scale_;
  Surface a_, b_;
  mutable std::vector<double> sums_;  // [node] of stiffness; fixed
  bool active_ = false;
};

}  // namespace

std::unique_ptr<Interaction> make_tied_faces(const discretisation::World& world, std::size_t number,
                                             deck::Diagnostics& diagnostics) {
  const model::Model& model = *world.model;
  const model::Contact& contact = model.contacts[number];
  Surface a(world, contact, contact.a, false, true, diagnostics);
  Surface b(world, contact, contact.b, false, true, diagnostics);
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
  double scale = 0.0;
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
      Vector y[4];
      corners(other, y);
      Overlap shared;
      std::vector<SharedPoint> points;
      if (!shared.share(x, y)) continue;
      shared.points(points);
      const double modulus = stiffer * model.control.contact.stiffness *
                             std::min(contact.scale_a * one.stiffness / one.area,
                                      contact.scale_b * other.stiffness / other.area);
      for (const SharedPoint& point : points) {
        if (std::abs(point.gap) > reach) continue;
        Spring spring{};
        for (std::size_t k = 0; k < 4; ++k) {
          spring.touch.a[k] = one.node[k];
          spring.touch.b[k] = other.node[k];
          spring.touch.wa[k] = point.wa[k];
          spring.touch.wb[k] = point.wb[k];
        }
        spring.touch.stiffness = modulus * point.area;
        spring.touch.area = point.area;
        Vector gap{0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k) gap = gap + point.wa[k] * x[k] - point.wb[k] * y[k];
        const Frame3 frame = frame_of(position, spring.touch.b);
        spring.rest = {dot(gap, frame.e1), dot(gap, frame.e2), dot(gap, frame.n)};
        springs.push_back(spring);
        scale = std::max(scale, 1e-3 * spring.touch.stiffness * other.thickness);
      }
    }
  }
  if (springs.empty())
    diagnostics.error(contact.place, contact.keyword, "SURFA",
                      "no face of tied contact " + std::to_string(contact.id) + " lies over a face of side B",
                      "the surfaces must be less than half an element apart and look at each other");
  return std::make_unique<TiedFaces>(contact, number, std::move(springs), scale, std::move(a), std::move(b));
}

}  // namespace cleave::solver
