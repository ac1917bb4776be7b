/// Rigid bodies: the forces on the nodes of each are summed, the body is moved by them as a whole, and its
/// nodes are sent to where the body takes them, measured from where they stood at the start, so that its
/// shape never drifts. Theory: docs/solver/rigid-bodies.md.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/threads.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/field.hpp"
#include "solver/ordered_sum.hpp"
#include "solver/rigid/body_loads.hpp"
#include "solver/rigid/drive.hpp"
#include "solver/rigid/inertia.hpp"

namespace cleave::solver {
namespace {

using base::cross;
using base::dot;
using discretisation::RigidBody;

constexpr std::size_t grain = 512;
constexpr double largest_angle = 0.2;  // that a body may turn in a step [radian]

/// What a body remembers, as it lies in the memory: at t_n, over the steps around it, and at t_n+1.
struct Body {
  Vector displacement;       ///< of the centre at t_n [length]
  Rotation rotation;         ///< since the start, at t_n
  Vector next_displacement;  ///< at t_n+1
  Rotation next_rotation;
  Vector velocity;                              ///< of the centre at t_n + step / 2
  Vector momentum;                              ///< angular, about the centre, at t_n + step / 2
  Vector spin;                                  ///< at t_n + step / 2
  Vector acceleration;                          ///< of the centre at t_n
  Vector spin_rate;                             ///< at t_n
  Vector force, moment;                         ///< that hold or drive the body at t_n
  Vector velocity_now, spin_now, momentum_now;  ///< at t_n
  double kinetic;                               ///< at t_n [energy]
  double external_before, external_after, damping_before, damping_after;  ///< work around t_n
};
constexpr std::size_t width = sizeof(Body) / sizeof(double);
static_assert(width * sizeof(double) == sizeof(Body), "a body is nothing but doubles");

class RigidBodies final : public Constraint {
 public:
  RigidBodies(const discretisation::World& world, deck::Diagnostics& diagnostics)
      : world_(world), model_(*world.model), drives_(model_), loads_(world) {
    drives_.warn_of_conflicts(diagnostics);
    for (const RigidBody& body : world.bodies)
      nodes_.insert(nodes_.end(), body.node.begin(), body.node.end());
    std::sort(nodes_.begin(), nodes_.end());
    for (std::size_t b = 0; b < world.bodies.size(); ++b)
      (world.bodies[b].node.size() > grain ? large_ : small_).push_back(b);
  }

  std::string name() const override { return "rigid bodies"; }

  base::Array<double> first_memory(const discretisation::State&) const override {
    base::Array<double> memory(width * world_.bodies.size() + drives_.memory_size(), 0.0);
    for (std::size_t b = 0; b < world_.bodies.size(); ++b) {
      Body body{};
      body.velocity = world_.bodies[b].velocity;
      body.spin = world_.bodies[b].spin;
      body.momentum = Inertia(world_.bodies[b], body.rotation).times(body.spin);
      put(memory, b, body);
    }
    for (std::size_t r = width * world_.bodies.size() + 1; r < memory.size(); r += 2)
      memory[r] = std::numeric_limits<double>::quiet_NaN();  // the path at birth
    return memory;
  }

  void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) override {
    const auto move = [&](std::size_t b) {
      Body body = get(memory, b);
      body.displacement = body.next_displacement;
      body.rotation = body.next_rotation;
      advance(now, b, sum_forces(now, b, body, acceleration), body, memory);
      send_nodes(now, b, body, acceleration);
      put(memory, b, body);
    };
    base::for_each_range(small_.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) move(small_[i]);
    });
    for (const std::size_t b : large_) move(b);
  }

  std::span<const Index> corrected() const override { return nodes_; }

  Halves work(const Moment&, std::span<const double> memory, std::span<const double>) const override {
    Halves sum;
    for (std::size_t b = 0; b < world_.bodies.size(); ++b) {
      const Body body = get(memory, b);
      sum.before.external += body.external_before;
      sum.after.external += body.external_after;
      sum.before.damping += body.damping_before;
      sum.after.damping += body.damping_after;
    }
    return sum;
  }

  /// The bodies' own kinetic energy takes the place of that of their nodes' masses.
  double kinetic(const Moment& now, std::span<const double> memory,
                 std::span<const double> acceleration) const override {
    const double twice = ordered_sum<double>(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i) {
        const Vector v =
            vector_at(now.velocity, nodes_[i]) + (0.5 * now.step_before) * vector_at(acceleration, nodes_[i]);
        sum += now.mass[static_cast<std::size_t>(nodes_[i])] * dot(v, v);
      }
      return sum;
    });
    double own = 0.0;
    for (std::size_t b = 0; b < world_.bodies.size(); ++b) own += get(memory, b).kinetic;
    return own - 0.5 * twice;
  }

  double largest_step(std::span<const double> memory) const override {
    double least = 1.0e30;
    for (std::size_t b = 0; b < world_.bodies.size(); ++b) {
      const Vector spin = get(memory, b).spin;
      const double rate = std::sqrt(dot(spin, spin));
      if (rate > 0.0) least = std::min(least, largest_angle / rate);
    }
    return least;
  }

  void report(std::span<const double> memory, Reactions& reactions) const override {
    const auto copy = [](const Vector& v, double(&out)[3]) { out[0] = v.x, out[1] = v.y, out[2] = v.z; };
    for (std::size_t b = 0; b < world_.bodies.size(); ++b) {
      const Body body = get(memory, b);
      BodyMotion& out = reactions.bodies[b];
      copy(world_.bodies[b].whole.centre + body.displacement, out.position);
      copy(body.displacement, out.displacement);
      copy(body.velocity_now, out.velocity);
      copy(body.acceleration, out.acceleration);
      copy(body.spin_now, out.spin);
      copy(body.spin_rate, out.spin_rate);
      copy(body.momentum_now, out.momentum);
      copy(body.force, out.force);
      copy(body.moment, out.moment);
      const Rotation& q = body.rotation;
      const double parts[4] = {q.w, q.v.x, q.v.y, q.v.z};
      std::copy(parts, parts + 4, out.quaternion);
      out.mass = world_.bodies[b].whole.mass;
      out.kinetic = body.kinetic;
    }
  }

 private:
  static Body get(std::span<const double> memory, std::size_t b) {
    Body body;
    std::copy_n(&memory[width * b], width, reinterpret_cast<double*>(&body));
    return body;
  }
  static void put(std::span<double> memory, std::size_t b, const Body& body) {
    std::copy_n(reinterpret_cast<const double*>(&body), width, &memory[width * b]);
  }

  /// What elements, contact and loads do to the nodes.
  Wrench sum_forces(const Moment& now, std::size_t b, const Body& body, std::span<const double> a) const {
    const RigidBody& fixed = world_.bodies[b];
    const Vector centre = fixed.whole.centre + body.displacement;
    const auto part = [&](std::size_t begin, std::size_t end) {
      Wrench sum;
      for (std::size_t i = begin; i < end; ++i) {
        const Index node = fixed.node[i];
        const Vector f = now.mass[static_cast<std::size_t>(node)] * vector_at(a, node);
        sum.force = sum.force + f;
        sum.moment = sum.moment + cross(vector_at(now.position, node) - centre, f);
      }
      return sum;
    };
    return fixed.node.size() > grain ? ordered_sum<Wrench>(fixed.node.size(), grain, part)
                                     : part(0, fixed.node.size());
  }

  /// Damping by mass of a body at t_n, per axis [1/time].
  Vector damping(const Moment& now, std::size_t b) const {
    double rate[3] = {0, 0, 0};
    const auto factor = [&](Index curve) {
      return load_value(model_.curves[static_cast<std::size_t>(curve)], now.time, now.step);
    };
    for (const model::GlobalDamping& one : model_.global_damping)
      for (int i = 0; i < 3; ++i) rate[i] += (one.curve < 0 ? one.value : factor(one.curve)) * one.factor[i];
    if (!world_.bodies[b].part.empty()) {
      const model::Part& lead = model_.parts[static_cast<std::size_t>(world_.bodies[b].part[0])];
      if (lead.mass_damping != 0.0)
        for (int i = 0; i < 3; ++i)
          rate[i] += lead.mass_damping *
                     (lead.mass_damping_curve < 0 ? 1.0 : factor(lead.mass_damping_curve)) *
                     lead.mass_damping_factor[i];
    }
    return {rate[0], rate[1], rate[2]};
  }

  /// Works of forces with the velocities of the half steps around t_n; source: explicit.md, eq. 6.
  static void book(const Moment& now, const Vector& force, const Vector& early, const Vector& middle,
                   const Vector& late, double& before, double& after) {
    before += 0.25 * now.step_before * dot(force, early + middle);
    after += 0.25 * now.step * dot(force, middle + late);
  }

  /// Moves a body from t_n to t_n+1.
  void advance(const Moment& now, std::size_t b, const Wrench& of_nodes, Body& body,
               std::span<double> memory) const {
    const RigidBody& fixed = world_.bodies[b];
    const std::span<double> rows = memory.subspan(width * world_.bodies.size());
    const BodyNow at{body.displacement, body.velocity, body.spin, body.rotation};
    const Wrench loads = loads_.at(now, b, at);
    const Vector rate = damping(now, b);
    body.external_before = body.external_after = body.damping_before = body.damping_after = 0.0;
    body.force = body.moment = {0, 0, 0};
    body.kinetic = 0.0;

    translate(now, b, at, of_nodes.force, loads.force, rate, body, rows);
    rotate(now, b, at, of_nodes.moment, loads.moment, (rate.x + rate.y + rate.z) / 3.0, body, rows);
    drives_.advance(b, now, at, body.velocity, body.spin, rows);
    body.next_displacement = body.displacement + now.step * body.velocity;
    body.kinetic += 0.5 * fixed.whole.mass * dot(body.velocity_now, body.velocity_now);
  }

  void translate(const Moment& now, std::size_t b, const BodyNow& at, const Vector& of_nodes,
                 const Vector& loads, const Vector& rate, Body& body, std::span<double> rows) const {
    const double mass = world_.bodies[b].whole.mass, back = 0.5 * now.step_before;
    const Vector early = body.velocity, push = (1.0 / mass) * (of_nodes + loads);
    const Vector a{(push.x - rate.x * early.x) / (1.0 + back * rate.x),
                   (push.y - rate.y * early.y) / (1.0 + back * rate.y),
                   (push.z - rate.z * early.z) / (1.0 + back * rate.z)};
    Vector late = early + now.interval() * a;
    const Known known = drives_.known(b, false, now, at, rows);
    for (int k = 0; k < known.count; ++k)
      late = late + (known.value[k] - dot(late, known.axis[k])) * known.axis[k];
    body.acceleration = known.count > 0 ? (1.0 / now.interval()) * (late - early) : a;
    body.velocity = late;
    body.velocity_now = early + back * body.acceleration;
    const Vector& middle = body.velocity_now;
    if (known.count > 0) body.force = mass * (body.acceleration - a);
    const Vector damped = mass * (a - push);
    book(now, loads + body.force, early, middle, late, body.external_before, body.external_after);
    book(now, -1.0 * damped, early, middle, late, body.damping_before, body.damping_after);
  }

  void rotate(const Moment& now, std::size_t b, const BodyNow& at, const Vector& of_nodes,
              const Vector& loads, double rate, Body& body, std::span<double> rows) const {
    const RigidBody& fixed = world_.bodies[b];
    const Inertia inertia(fixed, body.rotation);
    const double back = 0.5 * now.step_before;
    const Vector moment = of_nodes + loads;
    const Known known = drives_.known(b, true, now, at, rows);
    // With damping: L_n = L + back (M - rate L_n).
    const Vector middle = (1.0 / (1.0 + back * rate)) * (body.momentum + back * moment);
    const Vector damped = (-rate) * middle;
    const Vector late = body.momentum + now.interval() * (moment + damped);
    if (known.count == 0) {
      const Vector spins[3] = {inertia.solve(body.momentum), inertia.solve(middle), inertia.solve(late)};
      body.spin_now = spins[1];
      body.momentum_now = middle;
      body.spin_rate = inertia.solve(moment + damped - cross(body.spin_now, middle));
      body.kinetic += 0.5 * dot(middle, body.spin_now);
      book(now, loads, spins[0], spins[1], spins[2], body.external_before, body.external_after);
      book(now, -1.0 * damped, spins[0], spins[1], spins[2], body.damping_before, body.damping_after);
      body.momentum = late;
      const Vector by = inertia.from_axes(free_turn(inertia.to_axes(late), fixed.inverse, now.step));
      body.next_rotation = cayley(by) * body.rotation;
      body.spin = Inertia(fixed, body.next_rotation).solve(late);
      return;
    }
    const Vector early_spin = body.spin, spin = driven_spin(now, fixed, known, late, body);
    body.spin_rate = (1.0 / now.interval()) * (spin - early_spin);
    body.spin_now = early_spin + back * body.spin_rate;
    body.momentum_now = inertia.times(body.spin_now);
    body.kinetic += 0.5 * dot(body.spin_now, body.momentum_now);
    body.moment = inertia.times(body.spin_rate) - moment - damped;
    body.spin = spin;
    book(now, loads + body.moment, early_spin, body.spin_now, spin, body.external_before,
         body.external_after);
    book(now, -1.0 * damped, early_spin, body.spin_now, spin, body.damping_before, body.damping_after);
    body.moment = body.moment + cross(body.spin_now, body.momentum_now);  // what the holder feels
  }

  /// Spin over the step where it is known in some directions: in the others the angular momentum is that
  /// which the moments give, with the inertia as it stands in the middle of the step. Sets rotation and
  /// momentum.
  Vector driven_spin(const Moment& now, const RigidBody& fixed, const Known& known, const Vector& late,
                     Body& body) const {
    Vector free[3];
    const int count = known.free(free);
    const Vector given = known.sum();
    Vector spin = given;
    for (int k = 0; k < count; ++k) spin = spin + dot(body.spin, free[k]) * free[k];
    for (int iteration = 0; iteration < 50; ++iteration) {
      const Rotation half = turn((0.5 * now.step) * spin) * body.rotation;
      const Inertia inertia(fixed, half);
      const Vector rest = late - inertia.times(given);
      Vector better = given;
      if (count == 1) {
        const double j = dot(free[0], inertia.times(free[0]));
        if (j > 0.0) better = better + (dot(free[0], rest) / j) * free[0];
      } else if (count == 2) {
        const Vector j0 = inertia.times(free[0]), j1 = inertia.times(free[1]);
        const double a = dot(free[0], j0), c = dot(free[0], j1), d = dot(free[1], j1), det = a * d - c * c;
        const double p = dot(free[0], rest), q = dot(free[1], rest);
        if (det > 1e-12 * a * d)
          better = better + ((d * p - c * q) / det) * free[0] + ((a * q - c * p) / det) * free[1];
      }
      const Vector change = better - spin;
      spin = better;
      body.momentum = inertia.times(spin);
      if (dot(change, change) <= 1e-32 * dot(spin, spin)) break;
    }
    body.next_rotation = turn(now.step * spin) * body.rotation;
    return spin;
  }

  /// Accelerations that take the nodes to their places at t_n+1.
  void send_nodes(const Moment& now, std::size_t b, const Body& body, std::span<double> acceleration) const {
    const RigidBody& fixed = world_.bodies[b];
    const double per_step = 1.0 / now.step, per_interval = 1.0 / now.interval();
    const auto send = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index node = fixed.node[i];
        const Vector start = vector_at(model_.mesh.nodes.position, node);
        const Vector goal =
            start + (body.next_displacement + body.next_rotation.shift(start - fixed.whole.centre));
        const Vector late = per_step * (goal - vector_at(now.position, node));
        const Vector a = per_interval * (late - vector_at(now.velocity, node));
        double* out = &acceleration[3 * static_cast<std::size_t>(node)];
        out[0] = a.x, out[1] = a.y, out[2] = a.z;
      }
    };
    if (fixed.node.size() > grain)
      base::for_each_range(fixed.node.size(), grain, send);
    else
      send(0, fixed.node.size());
  }

  const discretisation::World& world_;
  const model::Model& model_;
  Drives drives_;
  BodyLoads loads_;
  std::vector<Index> nodes_;                // of all bodies, ascending
  std::vector<std::size_t> small_, large_;  // bodies by the number of their nodes
};

}  // namespace

void add_rigid_bodies(const discretisation::World& world, ConstraintList& list,
                      deck::Diagnostics& diagnostics) {
  if (!world.bodies.empty()) list.push_back(std::make_unique<RigidBodies>(world, diagnostics));
}

}  // namespace cleave::solver
