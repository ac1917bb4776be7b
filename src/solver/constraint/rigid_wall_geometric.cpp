/// *RIGIDWALL_GEOMETRIC: nodes may not enter a flat wall, prism, cylinder or sphere that stands or moves as
/// told.
///
/// A node that would is placed on the surface, by an impulse along the normal where its step enters. For a
/// node that lies on the surface this is the normal at t_n, so that sliding along a curved wall takes no
/// energy: the scheme is the one of constrained dynamics by Ryckaert, Ciccotti & Berendsen 1977. For one that
/// arrives it is the plastic impact of a planar wall.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/constraint/rigid_wall_friction.hpp"
#include "solver/constraint/rigid_wall_shape.hpp"
#include "solver/constraint/rigid_wall_work.hpp"
#include "solver/field.hpp"

namespace cleave::solver {
namespace {

using model::RigidWall;
using model::Vector;

constexpr std::size_t grain = 2048;

class GeometricWall final : public Constraint {
 public:
  GeometricWall(const model::Model& model, std::size_t number)
      : model_(model), wall_(model.walls[number]), number_(number), shape_(wall_) {
    stopped_.resize((wall_.nodes.size() + grain - 1) / grain);
  }

  std::string name() const override { return "rigid wall " + std::to_string(number_); }

  base::Array<double> first_memory(const discretisation::State&) const override {
    return base::Array<double>(memory_size, 0.0);
  }

  void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) override {
    memory[travel] += memory[move];
    speed_before_ = memory[speed];
    std::fill(memory.begin() + move, memory.end(), 0.0);
    stops_.clear();
    nodes_.clear();
    const double middle = now.time + 0.5 * now.step;
    if (middle < wall_.birth || middle >= wall_.death) return;
    memory[move] = distance_to_move(now, memory[travel]);
    memory[speed] = memory[move] / now.step;

    base::for_each_range(wall_.nodes.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Stop>& found = stopped_[begin / grain];
      found.clear();
      for (std::size_t k = begin; k < end; ++k) stop(now, memory, acceleration, wall_.nodes[k], found);
    });
    for (const auto& found : stopped_) stops_.insert(stops_.end(), found.begin(), found.end());
    for (const Stop& one : stops_) {
      nodes_.push_back(one.node);
      memory[normal_force] += one.normal;
      for (std::size_t i = 0; i < 3; ++i) memory[force_x + i] += one.force[i];
    }
  }

  std::span<const Index> corrected() const override { return nodes_; }

  Halves work(const Moment& now, std::span<const double> memory,
              std::span<const double> acceleration) const override {
    const Vector& d = wall_.motion_direction;
    const double along = memory[force_x] * d.x + memory[force_x + 1] * d.y + memory[force_x + 2] * d.z;
    return wall_work(now, along, speed_before_, memory[speed], stops_, acceleration);
  }

  void report(std::span<const double> memory, Reactions& reactions) const override {
    WallForce& out = reactions.walls[number_];
    out.normal = memory[normal_force];
    for (std::size_t i = 0; i < 3; ++i) out.force[i] = memory[force_x + i];
    out.position = memory[travel];
    out.velocity = memory[speed];
  }

 private:
  /// Places in the memory. What is to be travelled in the step at hand is added when it has been taken.
  enum Slot : std::size_t { travel, move, speed, normal_force, force_x, memory_size = force_x + 3 };

  /// A node that is stopped.
  struct Stop {
    Index node;
    double normal;    ///< force along the surface's normal [force]
    double force[3];  ///< of the wall on the node [force]
  };

  double distance_to_move(const Moment& now, double travelled) const {
    if (wall_.motion < 0) return 0.0;
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(wall_.motion)];
    const double start = std::max(wall_.birth, 0.0);
    if (wall_.motion_is_displacement) return curve.value(now.time + now.step - start) - travelled;
    return now.step * load_value(curve, now.time - start + 0.5 * now.step, now.step);
  }

  void stop(const Moment& now, std::span<const double> memory, std::span<double> acceleration, Index node,
            std::vector<Stop>& found) const {
    const double interval = now.interval(), dt = now.step;
    const Vector early = vector_at(now.velocity, node);
    const Vector free = early + interval * vector_at(acceleration, node);
    const Vector wall_velocity = memory[speed] * wall_.motion_direction;

    // The step as the moving wall sees it.
    const Vector from =
        vector_at(now.position, node) - wall_.origin - memory[travel] * wall_.motion_direction;
    Vector to = from + dt * (free - wall_velocity);
    const auto hit = shape_.enters(from, to);
    if (!hit) return;
    to = to + hit->push * hit->normal;

    // Friction takes from what slides; on a curved wall the node is then put on the surface again.
    const Vector along = (1.0 / dt) * (to - from);
    const Vector sliding = along - base::dot(along, hit->normal) * hit->normal;
    if (wall_.friction > 0.0) {
      to = to + dt * friction_change(wall_, sliding, std::sqrt(base::dot(sliding, sliding)), hit->push / dt,
                                     hit->normal, now.position);
      to = to + shape_.push(*hit, to) * hit->normal;
    }

    const Vector after = wall_velocity + (1.0 / dt) * (to - from);
    const double mass = now.mass[static_cast<std::size_t>(node)];
    const Vector force = (mass / interval) * (after - free);
    found.push_back({node, base::dot(force, hit->normal), {force.x, force.y, force.z}});
    double* a = &acceleration[3 * static_cast<std::size_t>(node)];
    a[0] = (after.x - early.x) / interval;
    a[1] = (after.y - early.y) / interval;
    a[2] = (after.z - early.z) / interval;
  }

  const model::Model& model_;
  const RigidWall& wall_;
  std::size_t number_;
  WallShape shape_;
  std::vector<std::vector<Stop>> stopped_;  // [range], scratch
  std::vector<Stop> stops_;                 // of the last call
  std::vector<Index> nodes_;
  double speed_before_ = 0.0;  // of the wall in the step before the last call
};

}  // namespace

std::unique_ptr<Constraint> make_geometric_wall(const model::Model& model, std::size_t number,
                                                deck::Diagnostics& diagnostics) {
  const RigidWall& wall = model.walls[number];
  const WallShape shape(wall);
  std::size_t behind = 0;
  double deepest = 0.0;
  for (const Index node : wall.nodes) {
    const double depth = shape.depth(vector_at(model.mesh.nodes.position, node) - wall.origin);
    if (!shape.endless() || depth == 0.0) continue;
    ++behind;
    deepest = std::max(deepest, depth);
  }
  if (behind > 0)
    diagnostics.warning(wall.place, wall.keyword, "",
                        std::to_string(behind) + " nodes lie " + (wall.interior ? "outside" : "inside") +
                            " rigid wall " + std::to_string(wall.id) + " at the start, up to " +
                            std::to_string(deepest) + " deep",
                        "they may leave but not go deeper; check where the wall stands");
  return std::make_unique<GeometricWall>(model, number);
}

}  // namespace cleave::solver
