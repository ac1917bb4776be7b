/// One contact: touches become forces; friction and energies are remembered. Theory: docs/solver/contact.md.

#include <atomic>
#include <cmath>

#include "base/threads.hpp"
#include "solver/contact/balanced.hpp"
#include "solver/contact/finders.hpp"
#include "solver/contact/pair_friction.hpp"
#include "solver/contact/pair_text.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

using base::dot;
using discretisation::ForceSum;

constexpr std::size_t grain = 256;
constexpr double tunnelled = 1.0;  // thicknesses behind a face at which a touch has come through

/// Energies taken from the nodes [energy].
struct Spent {
  double normal = 0.0, friction = 0.0, damping = 0.0;
  Spent& operator+=(const Spent& o) {
    normal += o.normal;
    friction += o.friction;
    damping += o.damping;
    return *this;
  }
};

class Interface final : public Interaction {
 public:
  Interface(const model::Model& model, const model::Contact& contact, std::size_t number,
            std::vector<std::unique_ptr<Finder>> finders, std::vector<std::unique_ptr<Gauge>> gauges,
            double force_scale, double stiffest)
      : model_(model),
        contact_(contact),
        number_(number),
        finders_(std::move(finders)),
        gauges_(std::move(gauges)),
        force_scale_(force_scale),
        rate_scale_(stiffest > 0.0 ? 0x1p36 / stiffest : 1.0) {}

  std::size_t contact() const override { return number_; }
  std::string name() const override { return "contact " + std::to_string(number_); }
  base::Array<double> first_memory() const override {
    base::Array<double> memory(head, 0.0);
    memory[least_step] = 1e30;
    return memory;
  }
  void start(const discretisation::State& state) override {
    for (const auto& finder : finders_) finder->start(state);
  }

  ContactOutput add_force(const Moment& now, std::span<const model::Id> eroded, base::Array<double>& memory,
                          ForceSum& force) override {
    if (!eroded.empty())
      for (const auto& finder : finders_) finder->erode(eroded);
    touches_.clear();
    ContactOutput output;
    if (now.time < contact_.birth || now.time >= contact_.death) {
      memory.resize(head);
      for (std::size_t i = force_x; i < least_step; ++i) memory[i] = 0.0;
      return output;
    }
    memory[least_step] = std::min(memory[least_step], now.step);
    const Past past(std::span<const double>(memory).subspan(head));
    ends_.clear();
    for (const auto& finder : finders_) {
      finder->find(now, past, touches_);
      ends_.push_back(touches_.size());
    }
    output.status = check(now, past);

    kept_.resize(touches_.size());
    std::vector<double> largest((touches_.size() + grain - 1) / grain, 0.0);
    std::vector<double> damped(largest.size(), 0.0);
    rates_.resize(now.mass.size());
    const bool first = now.step_before == 0.0;
    base::for_each_range(touches_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Balanced balanced(force);
      for (std::size_t i = begin; i < end; ++i) {
        Touch& touch = touches_[i];
        const Remembered* old = past.find(touch.key);
        kept_[i] = press(now, memory[least_step], touch, old, first, damped[begin / grain]);
        balanced.add(touch);
        add_rate(touch);
      }
      largest[begin / grain] = balanced.largest();
    });
    double top = force_scale_;
    for (const double one : largest) top = std::max(top, one);
    force.report_largest(top);
    for (const double one : damped) output.damping = std::max(output.damping, one);
    output.stiffness_rate = take_rate(now);
    remember(memory);
    return output;
  }

  void settle(const Moment& now, base::Array<double>& memory,
              std::span<const double> acceleration) const override {
    Spent before{memory[normal_after], memory[friction_after], memory[damping_after]};
    Spent after;
    struct Both {
      Spent before, after;
      Both& operator+=(const Both& o) {
        before += o.before;
        after += o.after;
        return *this;
      }
    };
    const Both sum = ordered_sum<Both>(touches_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Both part;
      for (std::size_t i = begin; i < end; ++i) {
        const Touch& touch = touches_[i];
        const Vector early = relative(touch, now.velocity);
        const Vector late = early + now.interval() * relative(touch, acceleration);
        const double b = -0.5 * now.step_before, a = -0.5 * now.step;
        const double press = pressure_dot(touch, now.velocity);
        const double pressed = press + now.interval() * pressure_dot(touch, acceleration);
        part.before += {b * press, b * dot(touch.friction, early), b * dot(touch.viscous, early)};
        part.after += {a * pressed, a * dot(touch.friction, late), a * dot(touch.viscous, late)};
      }
      return part;
    });
    before += sum.before;
    after = sum.after;
    memory[normal] += before.normal;
    memory[friction] += before.friction;
    memory[damping] += before.damping;
    memory[normal_after] = after.normal;
    memory[friction_after] = after.friction;
    memory[damping_after] = after.damping;
  }

  InterfaceForce report(std::span<const double> memory) const override {
    InterfaceForce out;
    for (int i = 0; i < 3; ++i) out.force[i] = memory[force_x + static_cast<std::size_t>(i)];
    out.normal_energy = memory[normal];
    out.friction_energy = memory[friction];
    out.damping_energy = memory[damping];
    out.area = memory[contact_area];
    out.touches = (memory.size() - head) / (sizeof(Remembered) / sizeof(double));
    out.deepest = memory[deepest];
    return out;
  }

  discretisation::StepStatus accuse(const Moment& now, std::string what, std::string cause) const override {
    std::size_t worst = touches_.size();
    double most = 0.0;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const double power = pressure_dot(touches_[i], now.velocity);
      if (worst == touches_.size() || power > most) most = power, worst = i;
    }
    if (worst < touches_.size()) return name_pair(now, worst, what, std::move(cause));
    return {false, -1, 0, own_name() + ": " + what, std::move(cause)};
  }

  void add_nodal(std::span<double> force) const override {
    for (const Touch& touch : touches_) add_touch(touch, force);
  }
  void add_fields(const Moment& now, ContactFields& fields) override {
    std::vector<double> force(fields.pressure.size() * 3, 0.0);
    std::vector<Vector> area(fields.pressure.size(), Vector{0, 0, 0});
    add_nodal(force);
    for (const auto& gauge : gauges_) {
      gauge->gaps(now, fields.gap);
      gauge->add_areas(now, area);
    }
    add_pressure(force, area, fields.pressure);
  }
  void clear_nodal(std::span<double> force) const override {
    for (const Touch& touch : touches_) clear_touch(touch, force);
  }

 private:
  /// Places in the memory; what is remembered of each touch follows.
  enum Slot : std::size_t {
    normal,
    friction,
    damping,
    normal_after,
    friction_after,
    damping_after,
    force_x,
    contact_area = force_x + 3,
    deepest,
    least_step,
    head
  };

  /// The depth that counts as none. What penetrates at the start counts as touching, and so do nodes that
  /// come to lie behind a face by anything but going into it: nobody did the work. It does not come back once
  /// it has left. For faces their finder knows.
  double offset_of(const Moment& now, const Touch& touch, const Remembered* old, bool first) const {
    if (touch.faces) return touch.offset;
    if (old) return std::min(old->offset, touch.depth);
    if (first) return touch.depth;
    return std::clamp(depth_before(now, touch), 0.0, touch.depth);
  }

  /// Forces of a touch; @return what is to be remembered of it.
  Remembered press(const Moment& now, double step, Touch& touch, const Remembered* old, bool first,
                   double& largest_damping) const {
    const Vector v = relative(touch, now.velocity);
    const double approach = dot(v, touch.normal);
    Remembered kept{{static_cast<double>(touch.key[0]), static_cast<double>(touch.key[1])},
                    {0, 0, 0},
                    offset_of(now, touch, old, first),
                    touch.depth};
    const double depth = touch.depth - kept.offset;
    double inverse_a = 0.0, inverse_b = 0.0;
    for (int k = 0; k < 4; ++k) {
      const double ma = now.mass[static_cast<std::size_t>(touch.a[k])];
      const double mb = now.mass[static_cast<std::size_t>(touch.b[k])];
      if (ma > 0.0) inverse_a += touch.wa[k] * touch.wa[k] / ma;
      if (mb > 0.0) inverse_b += touch.wb[k] * touch.wb[k] / mb;
    }
    const double mass = inverse_a + inverse_b > 0.0 ? 1.0 / (inverse_a + inverse_b) : 0.0;
    if (contact_.soft == 1)
      touch.stiffness = std::max(touch.stiffness, 0.5 * contact_.soft_scale * mass / (step * step));
    const double push = touch.faces ? touch.push : touch.stiffness * depth;
    if (!(push > 0.0)) {
      touch.stiffness = 0.0;
      return kept;
    }
    if (touch.faces)
      for (const Vector& part : touch.on_a) touch.pressure = touch.pressure + part;
    else
      touch.pressure = push * touch.normal;

    double holding = push;  // what holds by friction: damping is part of it
    if (contact_.damping > 0.0) {
      const double critical = 2.0 * std::sqrt(touch.stiffness * mass);
      const double brake = std::max(-contact_.damping * critical * approach, -push);  // never pulls
      touch.viscous = brake * touch.normal;
      holding += brake;
      largest_damping = contact_.damping;
    }
    rub(now, touch, old, v - approach * touch.normal, holding, kept);
    return kept;
  }

  /// Coulomb friction: a spring that slips when it is pulled harder than friction holds.
  void rub(const Moment& now, Touch& touch, const Remembered* old, const Vector& sliding, double push,
           Remembered& kept) const {
    const auto number = static_cast<std::size_t>(&touch - touches_.data());
    const model::PartFriction pair = pair_friction(contact_, finder_of(number), touch);
    const double fs = pair.static_friction, fd = pair.dynamic_friction;
    if (fs == 0.0 && fd == 0.0) return;
    const double speed = norm(sliding);
    const double coefficient = fd + (fs - fd) * std::exp(-pair.decay * speed);
    double most = coefficient * push;
    if (pair.viscous_limit > 0.0) most = std::min(most, pair.viscous_limit * touch.area);
    Vector force{0, 0, 0};
    if (old) {
      const Vector last{old->friction[0], old->friction[1], old->friction[2]};
      // The face has turned meanwhile: keep the size.
      const Vector flat = last - dot(last, touch.normal) * touch.normal;
      const double now_size = norm(flat);
      if (now_size > 0.0) force = (norm(last) / now_size) * flat;
    }
    force = force - (touch.stiffness * now.step_before) * sliding;
    const double size = norm(force);
    if (size > most) force = (most / size) * force;
    touch.friction = force;
    kept.friction[0] = force.x;
    kept.friction[1] = force.y;
    kept.friction[2] = force.z;
  }

  /// Sums of stiffness over a node, as integers, so that the order does not matter.
  void add_rate(const Touch& touch) {
    if (touch.stiffness == 0.0) return;
    const std::array<double, 8> rows = half_rows(touch);
    for (std::size_t k = 0; k < 8; ++k) {
      if (rows[k] == 0.0) continue;
      const auto node = static_cast<std::size_t>(k < 4 ? touch.a[k] : touch.b[k - 4]);
      const auto integer = static_cast<std::int64_t>(std::llrint(std::min(rows[k] * rate_scale_, 0x1p57)));
      std::atomic_ref<std::int64_t>(rates_[node]).fetch_add(integer, std::memory_order_relaxed);
    }
  }
  /// Gershgorin's bound of the squared frequencies; clears the sums.
  double take_rate(const Moment& now) {
    double most = 0.0;
    for (const Touch& touch : touches_)
      for (int k = 0; k < 4; ++k)
        for (const Index node : {touch.a[k], touch.b[k]}) {
          std::int64_t& sum = rates_[static_cast<std::size_t>(node)];
          const double mass = now.mass[static_cast<std::size_t>(node)];
          if (sum != 0 && mass > 0.0)
            most = std::max(most, 2.0 * static_cast<double>(sum) / (rate_scale_ * mass));
          sum = 0;
        }
    return most;
  }

  void remember(base::Array<double>& memory) const {
    constexpr std::size_t width = sizeof(Remembered) / sizeof(double);
    memory.resize(head + width * touches_.size());
    for (std::size_t i = force_x; i < least_step; ++i) memory[i] = 0.0;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const Touch& touch = touches_[i];
      const auto* from = reinterpret_cast<const double*>(&kept_[i]);
      std::copy(from, from + width, memory.begin() + static_cast<std::ptrdiff_t>(head + width * i));
      const double sign = touch.reverse ? -1.0 : 1.0;
      const Vector f = touch.pressure + touch.friction + touch.viscous;
      memory[force_x] += sign * f.x;
      memory[force_x + 1] += sign * f.y;
      memory[force_x + 2] += sign * f.z;
      if (touch.stiffness > 0.0) memory[contact_area] += touch.area;
      if (kept_[i].offset < out_of_reach)
        memory[deepest] = std::max(memory[deepest], depth_of(touch) - kept_[i].offset);
    }
  }

  /// How deep a touch was a step ago, as far as the velocity tells; below 0 it was apart.
  static double depth_before(const Moment& now, const Touch& touch) {
    return touch.depth + dot(relative(touch, now.velocity), touch.normal) * now.step_before;
  }

  static double depth_of(const Touch& touch) { return touch.faces ? touch.penetration : touch.depth; }

  /// A touch that went through the solid behind its face ends the run.
  discretisation::StepStatus check(const Moment& now, const Past& past) const {
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const Touch& touch = touches_[i];
      if (depth_of(touch) <= tunnelled * finder_of(i).face(touch.face).thickness) continue;
      const Remembered* old = past.find(touch.key);
      if (!old || old->offset == out_of_reach) continue;
      return name_pair(
          now, i, "went through the surface of the element",
          "the contact is too soft for this load: raise SFSA and SFSB or SLSFAC, or take SOFT 1 or 2");
    }
    return {};
  }
  const Finder& finder_of(std::size_t touch) const {
    std::size_t finder = 0;
    while (touch >= ends_[finder]) ++finder;
    return *finders_[finder];
  }
  std::string own_name() const {
    return "contact " + std::to_string(contact_.id) +
           (contact_.title.empty() ? "" : " (" + contact_.title + ")");
  }
  discretisation::StepStatus name_pair(const Moment& now, std::size_t i, const std::string& what,
                                       std::string cause) const {
    const Touch& touch = touches_[i];
    const Finder& finder = finder_of(i);
    const Face& face = finder.face(touch.face);
    const Face* of_a = finder.face_of_a(touch);
    return {false, face.part, face.element,
            own_name() + ": " + pair_text(model_, touch, face, of_a, now.position) + " " + what,
            std::move(cause)};
  }

  const model::Model& model_;
  const model::Contact& contact_;
  std::size_t number_;
  std::vector<std::unique_ptr<Finder>> finders_;
  std::vector<std::unique_ptr<Gauge>> gauges_;
  double force_scale_;             // what a force of this contact may well be [force]
  double rate_scale_;              // integers per stiffness
  std::vector<Touch> touches_;     // of the last call
  std::vector<std::size_t> ends_;  // of those of each finder
  std::vector<Remembered> kept_;
  std::vector<std::int64_t> rates_;  // [node], zero between calls
};

}  // namespace

std::unique_ptr<Interaction> make_interface(const model::Model& model, std::size_t number,
                                            std::vector<std::unique_ptr<Finder>> finders,
                                            std::vector<std::unique_ptr<Gauge>> gauges, double force_scale,
                                            double stiffest) {
  return std::make_unique<Interface>(model, model.contacts[number], number, std::move(finders),
                                     std::move(gauges), force_scale, stiffest);
}

}  // namespace cleave::solver
