#pragma once
/// Nodes that a planar rigid wall meets by penalty (RWPNAL of *CONTROL_CONTACT): those of rigid bodies, or
/// all.

#include <vector>

#include "solver/action.hpp"

namespace cleave::solver {

/// A spring for each node that is behind the wall: k = 0.1 |RWPNAL| m / dt^2 with the node's mass and the
/// smallest step so far, less by 1 + sum m / M for a wall with a mass M, so that no spring swings faster than
/// the step lets it (w dt < 0.32 at RWPNAL 1). Friction is a spring of the same stiffness that slips.
///
/// What lies behind a wall without end when it begins to act keeps its depth: it may leave but not go deeper.
/// A wall that ends meets what passes through it. Theory: docs/solver/rigid-bodies.md.
class WallPenalty {
 public:
  /// A node that is pushed.
  struct Push {
    Index node;
    double force[3];  ///< of the wall on the node [force]
  };

  /// @param nodes  that are met this way, in the order of the wall's list
  /// @param scale  |RWPNAL| [-]
  WallPenalty(const model::RigidWall& wall, std::vector<Index> nodes, double scale);

  std::size_t memory_size() const { return nodes_.empty() ? 0 : node_state + slots * nodes_.size(); }
  /// Adds what the springs do at t_n to the accelerations of the nodes.
  /// @param travel  of the wall along its normal until t_n [length]
  /// @param move    of the wall in the step that led to t_n [length]
  /// @param memory  of memory_size()
  /// @return nodes in the order of the list; valid until the next call
  const std::vector<Push>& push(const Moment& now, double travel, double move, std::span<double> memory,
                                std::span<double> acceleration);

 private:
  /// Places in the memory: the smallest step so far [time], whether the wall has begun to act, then for each
  /// node what follows.
  enum Slot : std::size_t { least_step, begun, node_state };
  enum NodeSlot : std::size_t { state, level, slip, slots = slip + 3 };
  static constexpr double apart = 0.0, touches = 1.0, welded = 2.0;  // states

  double stiffness(const Moment& now, double step) const;
  bool push_one(const Moment& now, double travel, double move, double per_mass, Index node, double* own,
                double (&force)[3]) const;

  const model::RigidWall& wall_;
  std::vector<Index> nodes_;
  double scale_;
  std::vector<std::vector<Push>> found_;  // [range], scratch
  std::vector<Push> pushes_;              // of the last call
};

}  // namespace cleave::solver
