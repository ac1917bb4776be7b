#pragma once
/// What acts on the nodes from outside the elements: loads give forces, constraints correct accelerations.
///
/// The cycle at t_n (explicit.cpp) is: internal forces, loads, acceleration of every node, constraints,
/// energies. A load or constraint is one file and one line in actions.cpp.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "discretisation/world.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

using model::Index;

/// The cycle as loads and constraints see it: everything known at t_n, and the steps on both sides of it.
struct Moment {
  double time = 0.0;                 ///< t_n
  double step_before = 0.0;          ///< dt that led to t_n, 0 at the start [time]
  double step = 0.0;                 ///< dt to be taken next [time]
  std::span<const double> position;  ///< [node][3] at t_n [length]
  std::span<const double> velocity;  ///< [node][3] at t_n - step_before / 2 [length/time]
  std::span<const double> mass;      ///< [node]
  /// [node][3] at t_n-1, for loads alone: it is overwritten when they are known [length/time^2]
  std::span<const double> acceleration_before = {};

  /// From the middle of the step before to the middle of the next: what an acceleration acts for [time].
  double interval() const { return 0.5 * (step_before + step); }
};

/// Work that leaves or enters the nodes [energy].
struct Work {
  double external = 0.0, damping = 0.0, wall = 0.0;

  Work& operator+=(const Work& other) {
    external += other.external;
    damping += other.damping;
    wall += other.wall;
    return *this;
  }
};

/// Work around t_n in two halves: up to t_n, and from t_n to the middle of the next step.
struct Halves {
  Work before, after;

  Halves& operator+=(const Halves& other) {
    before += other.before;
    after += other.after;
    return *this;
  }
};

/// A force that is known before the acceleration is.
class Load {
 public:
  virtual ~Load() = default;
  virtual std::vector<Index> nodes() const = 0;  ///< every node it may ever push, any order
  /// Adds the forces at t_n. @param force [node][3] [force]
  virtual void add_force(const Moment& now, std::span<double> force) = 0;
};

/// Where constraints say what they did.
struct Reactions {
  std::span<double> held;               ///< [node][3] forces that hold nodes, zero on entry [force]
  std::vector<WallForce> walls;         ///< in the order of Model::walls
  std::vector<BodyMotion> bodies = {};  ///< in the order of Model::rigid_bodies
};

/// Corrects the acceleration of some nodes so that the velocity at t_n + step / 2 is admissible.
class Constraint {
 public:
  virtual ~Constraint() = default;
  virtual std::string name() const = 0;  ///< of its memory in the State
  /// What it remembers between steps, at the start of the run; survives a restart.
  virtual base::Array<double> first_memory(const discretisation::State& state) const = 0;
  /// @param acceleration [node][3], of free nodes on entry; corrected in place [length/time^2]
  virtual void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) = 0;
  virtual std::span<const Index> corrected() const = 0;  ///< nodes of the last call
  /// Work of its forces, once every constraint has been heard.
  virtual Halves work(const Moment& now, std::span<const double> memory,
                      std::span<const double> acceleration) const = 0;
  virtual void report(std::span<const double> memory, Reactions& reactions) const = 0;
  /// Kinetic energy at t_n beyond that of the masses of its nodes, after correct() [energy].
  virtual double kinetic(const Moment&, std::span<const double>, std::span<const double>) const {
    return 0.0;
  }
  /// The longest step after t_n that it can take [time].
  virtual double largest_step(std::span<const double>) const { return 1.0e30; }
};

std::vector<std::unique_ptr<Load>> make_loads(const model::Model& model);
/// In the order in which they act; what comes later prevails.
std::vector<std::unique_ptr<Constraint>> make_constraints(const discretisation::World& world,
                                                          deck::Diagnostics& diagnostics);

/// Value of a load curve [of the curve]: zero outside its points, as the format defines it for everything
/// that acts in time. The last value is kept for one more step, so that a curve that ends with the run does
/// not let go in its last cycle.
double load_value(const model::Curve& curve, double time, double step);

/// Work of a force that may be an impulse (it stops a node within one step): with the mean velocity of each
/// half step it equals the change of kinetic energy exactly. Source: explicit.md, eq. 6.
struct ImpulseWork {
  double before, after;
};
inline ImpulseWork impulse_work(const Moment& now, Index node, const double force[3],
                                std::span<const double> acceleration) {
  ImpulseWork work{0.0, 0.0};
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = 3 * static_cast<std::size_t>(node) + i;
    const double early = now.velocity[at];
    const double middle = early + acceleration[at] * (0.5 * now.step_before);
    const double late = early + acceleration[at] * now.interval();
    work.before += force[i] * (early + middle);
    work.after += force[i] * (middle + late);
  }
  return {0.25 * now.step_before * work.before, 0.25 * now.step * work.after};
}

}  // namespace cleave::solver
