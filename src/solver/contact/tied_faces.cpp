/// Ties by springs (*CONTACT_TIED_..._OFFSET) keep points of both sides where they were, seen from the faces
/// of side B. A spring that does not lie along its rest would turn the pair: its face takes the moment, so
/// that angular momentum is kept.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/contact/balanced.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/tied_springs.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

using base::cross;

constexpr std::size_t grain = 256;
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
            const double early = pressure_dot(touch, now.velocity);
            const double late = early + now.interval() * pressure_dot(touch, acceleration);
            part.before -= 0.5 * now.step_before * early;
            part.after -= 0.5 * now.step * late;
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
    Vector couple[4];
    couple_of(now.position, touch.b, cross(touch.pressure, gap), couple);
    touch.faces = true;
    for (int k = 0; k < 4; ++k) {
      touch.on_a[k] = touch.wa[k] * touch.pressure;
      touch.on_b[k] = couple[k] - touch.wb[k] * touch.pressure;
    }
  }

  /// Gershgorin's bound with what each node does to a spring: its weight, and for its face the turn.
  double rate(const Moment& now) const {
    if (sums_.empty()) {
      sums_.assign(now.mass.size(), 0.0);
      for (const Spring& spring : springs_) {
        const Touch& touch = spring.touch;
        double turn[4], all = 2.0;
        couple_bound(now.position, touch.b, turn);
        for (double& one : turn) all += one *= norm(spring.rest);
        for (std::size_t k = 0; k < 4; ++k) {
          const double half = 0.5 * all * touch.stiffness;
          sums_[static_cast<std::size_t>(touch.a[k])] += half * std::abs(touch.wa[k]);
          sums_[static_cast<std::size_t>(touch.b[k])] += half * (std::abs(touch.wb[k]) + turn[k]);
        }
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
  const model::Contact& contact = world.model->contacts[number];
  model::ContactSide around = contact.a;  // faces around the nodes of a set: those of all parts
  if (contact.a.segments.empty())
    for (Index p = 0; p < static_cast<Index>(world.model->parts.size()); ++p) around.parts.push_back(p);
  Surface a(world, contact, around, false, true, diagnostics);
  Surface b(world, contact, contact.b, false, true, diagnostics);
  std::vector<Spring> springs = find_springs(world, contact, a, b, diagnostics);
  if (springs.empty()) return nullptr;
  double scale = 0.0;
  for (const Spring& spring : springs)
    scale = std::max(scale, 1e-3 * spring.touch.stiffness * std::sqrt(spring.touch.area));
  return std::make_unique<TiedFaces>(contact, number, std::move(springs), scale, std::move(a), std::move(b));
}

}  // namespace cleave::solver
