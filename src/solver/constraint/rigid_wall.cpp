/// *RIGIDWALL_PLANAR: nodes may not pass a plane. A node that would is placed on it, its normal velocity
/// taken away (plastic impact); the momentum it loses is the wall's force. A wall with a mass takes that
/// momentum over. Nodes that RWPNAL names are met by springs instead (rigid_wall_penalty.hpp). Source:
/// Belytschko, Liu, Moran & Elkhodary 2014, sec. 10; explicit.md, section 5.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/constraint/rigid_wall_friction.hpp"
#include "solver/constraint/rigid_wall_penalty.hpp"
#include "solver/constraint/rigid_wall_work.hpp"
#include "solver/field.hpp"

namespace cleave::solver {
namespace {

using model::RigidWall;
using model::Vector;

constexpr std::size_t grain = 2048;

/// A node that would pass the wall within the step.
struct Hit {
  Index node;
  std::size_t member;  ///< position in the wall's list of nodes
  double gap;          ///< distance before the step, not below zero [length]
  double mass;         ///< that the wall feels: divided by the cycles left to stop it
  double approach;     ///< normal velocity at which the wall would just be touched [length/time]
  bool welded;
  double force[3] = {0, 0, 0};  ///< of the wall on the node [force]
};

class PlanarWall final : public Constraint {
 public:
  /// @param stopped  nodes that are stopped at once
  /// @param pushed   nodes that are met by penalty, of the given scale
  PlanarWall(const RigidWall& wall, std::size_t number, std::vector<Index> stopped, std::vector<Index> pushed,
             double scale)
      : wall_(wall), number_(number), stopped_(std::move(stopped)), penalty_(wall, std::move(pushed), scale) {
    found_.resize((stopped_.size() + grain - 1) / grain);
  }

  std::string name() const override { return "rigid wall " + std::to_string(number_); }

  base::Array<double> first_memory(const discretisation::State&) const override {
    base::Array<double> memory(springs_at() + penalty_.memory_size(), 0.0);
    memory[velocity] = wall_.speed;
    return memory;
  }

  void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) override {
    const double moved = memory[move];
    memory[travel] += moved;
    memory[move] = 0.0;
    for (std::size_t slot = normal_force; slot < node_state; ++slot) memory[slot] = 0.0;
    hits_.clear();
    nodes_.clear();
    forces_.clear();
    speed_before_ = memory[velocity];
    const double middle = now.time + 0.5 * now.step;
    if (middle < wall_.birth || middle >= wall_.death) return;

    // A wall with a mass is slowed down by the springs before it stops the other nodes.
    for (const WallPenalty::Push& one :
         penalty_.push(now, memory[travel], moved, memory.subspan(springs_at()), acceleration)) {
      book(one.node, one.force, memory);
      if (wall_.mass > 0.0)
        memory[velocity] -= now.interval() / wall_.mass *
                            base::dot(Vector{one.force[0], one.force[1], one.force[2]}, wall_.normal);
    }
    find_hits(now, memory, acceleration);
    exchange_momentum(memory);
    for (Hit& hit : hits_) stop(now, memory, acceleration, hit);
    std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return a.member < b.member; });
    for (const Hit& hit : hits_) book(hit.node, hit.force, memory);
    memory[normal_force] = memory[force_x] * wall_.normal.x + memory[force_x + 1] * wall_.normal.y +
                           memory[force_x + 2] * wall_.normal.z;
    memory[move] = memory[velocity] * now.step;
  }

  std::span<const Index> corrected() const override { return nodes_; }

  Halves work(const Moment& now, std::span<const double> memory,
              std::span<const double> acceleration) const override {
    return wall_work(now, memory[normal_force], speed_before_, memory[velocity], forces_, acceleration);
  }

  void report(std::span<const double> memory, Reactions& reactions) const override {
    WallForce& out = reactions.walls[number_];
    out.normal = memory[normal_force];
    for (std::size_t i = 0; i < 3; ++i) out.force[i] = memory[force_x + i];
    out.position = base::dot(wall_.origin, wall_.normal) + memory[travel];
    out.velocity = memory[velocity];
  }

 private:
  /// Places in the memory; the state of the nodes (welded, or cycles in contact) follows.
  enum Slot : std::size_t { travel, velocity, move, normal_force, force_x, node_state = force_x + 3 };

  /// Where the memory of the springs begins.
  std::size_t springs_at() const { return node_state + (remembers_nodes() ? stopped_.size() : 0); }

  void book(Index node, const double (&force)[3], std::span<double> memory) {
    nodes_.push_back(node);
    forces_.push_back({node, {force[0], force[1], force[2]}});
    for (std::size_t i = 0; i < 3; ++i) memory[force_x + i] += force[i];
  }

  bool welds() const { return wall_.friction == 2.0 || wall_.friction == 3.0; }
  bool remembers_nodes() const { return welds() || wall_.soft_cycles > 1; }

  /// Nodes that the wall, at the speed it has, would overtake within the step; in the order of its list.
  void find_hits(const Moment& now, std::span<double> memory, std::span<const double> acceleration) {
    const double interval = now.interval(), slack = 1e-6 * (wall_.length_l + wall_.length_m);
    base::for_each_range(stopped_.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Hit>& found = found_[begin / grain];
      found.clear();
      for (std::size_t member = begin; member < end; ++member) {
        const Index node = stopped_[member];
        const Vector from = vector_at(now.position, node) - wall_.origin;
        const Vector v = vector_at(now.velocity, node) + interval * vector_at(acceleration, node);
        const double distance = base::dot(from, wall_.normal) - memory[travel];
        const double gap = std::max(distance, 0.0);
        const double approach = base::dot(v, wall_.normal) + gap / now.step;
        double* state = remembers_nodes() ? &memory[node_state + member] : nullptr;
        const bool welded = welds() && *state != 0.0;
        if (!welded && !(approach < memory[velocity])) {
          if (state && !welds() && distance > 0.0) *state = 0.0;
          continue;
        }
        if (wall_.finite && !welded) {
          if (distance < -slack && !(state && *state > 0.0)) continue;  // passed beside the wall earlier
          const Vector at = from + now.step * v;
          const double l = base::dot(at, wall_.edge_l), m = base::dot(at, wall_.edge_m);
          if (l < 0.0 || l > wall_.length_l || m < 0.0 || m > wall_.length_m) continue;
        }
        const double mass = now.mass[static_cast<std::size_t>(node)];
        found.push_back({node, member, gap, mass / cycles_left(state), approach, welded});
      }
    });
    for (const auto& found : found_) hits_.insert(hits_.end(), found.begin(), found.end());
  }

  /// FORCES, SOFT: over how many cycles from now on the approach is to be stopped.
  double cycles_left(const double* state) const {
    return wall_.soft_cycles > 1 && state && !welds() ? std::max(1.0, wall_.soft_cycles - *state) : 1.0;
  }

  /// Common velocity of a wall with a mass and the nodes it stops: momentum is kept, and only nodes that are
  /// slower than the result take part. Taking them slowest first decides both in one sweep.
  void exchange_momentum(std::span<double> memory) {
    if (wall_.mass <= 0.0) return;
    std::stable_sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) {
      return a.welded != b.welded ? a.welded : a.approach < b.approach;
    });
    double mass = wall_.mass, momentum = wall_.mass * memory[velocity];
    std::size_t taken = 0;
    for (; taken < hits_.size(); ++taken) {
      const Hit& hit = hits_[taken];
      if (!hit.welded && !(hit.approach * mass < momentum)) break;
      mass += hit.mass;
      momentum += hit.mass * hit.approach;
    }
    hits_.resize(taken);
    memory[velocity] = momentum / mass;
  }

  void stop(const Moment& now, std::span<double> memory, std::span<double> acceleration, Hit& hit) const {
    const double interval = now.interval();
    const Vector early = vector_at(now.velocity, hit.node);
    const Vector free = early + interval * vector_at(acceleration, hit.node);
    const double normal = base::dot(free, wall_.normal);
    double* state = remembers_nodes() ? &memory[node_state + hit.member] : nullptr;

    // Normal velocity that puts the node on the wall, or a share of the way there.
    const double gain = (memory[velocity] - hit.gap / now.step - normal) / cycles_left(state);
    if (state && welds() && speed_before_ - normal > wall_.velocity_limit) *state = 1.0;
    if (state && !welds()) *state += 1.0;

    // Along the wall: Coulomb's law between impulses.
    const Vector sliding = free - normal * wall_.normal;
    const Vector after = (normal + gain) * wall_.normal + sliding +
                         friction_change(wall_, sliding, std::sqrt(base::dot(sliding, sliding)),
                                         std::max(gain, 0.0), wall_.normal, now.position);
    const Vector change = after - free;
    const double mass = now.mass[static_cast<std::size_t>(hit.node)];
    const double force[3] = {mass * change.x / interval, mass * change.y / interval,
                             mass * change.z / interval};
    std::copy(force, force + 3, hit.force);
    double* a = &acceleration[3 * static_cast<std::size_t>(hit.node)];
    a[0] = (after.x - early.x) / interval;
    a[1] = (after.y - early.y) / interval;
    a[2] = (after.z - early.z) / interval;
  }

  const RigidWall& wall_;
  std::size_t number_;
  std::vector<Index> stopped_;
  WallPenalty penalty_;
  std::vector<std::vector<Hit>> found_;  // [range], scratch
  std::vector<Hit> hits_;                // of the last call
  std::vector<Index> nodes_;
  std::vector<WallPenalty::Push> forces_;  // on all nodes, of the last call
  double speed_before_ = 0.0;
};

}  // namespace

void add_rigid_walls(const discretisation::World& world, ConstraintList& list,
                     deck::Diagnostics& diagnostics) {
  const model::Model& model = *world.model;
  for (std::size_t w = 0; w < model.walls.size(); ++w) {
    const RigidWall& wall = model.walls[w];
    if (wall.geometric) {
      list.push_back(make_geometric_wall(model, w, diagnostics));
      continue;
    }
    std::size_t behind = 0;
    double deepest = 0.0;
    for (const Index node : wall.nodes) {
      const double distance =
          base::dot(vector_at(model.mesh.nodes.position, node) - wall.origin, wall.normal);
      const double reach = std::sqrt(base::dot(wall.origin, wall.origin)) + std::abs(distance);
      if (wall.finite || distance >= -1e-9 * reach) continue;
      ++behind;
      deepest = std::min(deepest, distance);
    }
    if (behind > 0)
      diagnostics.warning(wall.place, wall.keyword, "",
                          std::to_string(behind) + " nodes lie behind rigid wall " + std::to_string(wall.id) +
                              " at the start, up to " + std::to_string(-deepest) + " deep",
                          "they may leave but not go deeper; check the direction of the wall's normal");
    std::vector<Index> stopped, pushed;
    for (const Index node : wall.nodes) {
      const bool rigid =
          !world.body_of_node.empty() && world.body_of_node[static_cast<std::size_t>(node)] >= 0;
      (wall.penalty < 0.0 || (wall.penalty > 0.0 && rigid) ? pushed : stopped).push_back(node);
    }
    list.push_back(
        std::make_unique<PlanarWall>(wall, w, std::move(stopped), std::move(pushed), std::abs(wall.penalty)));
  }
}

}  // namespace cleave::solver
