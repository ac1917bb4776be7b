#pragma once
/// A frame of the solver with the sums that several writers need, computed once.

#include <span>
#include <vector>

#include "solver/solver.hpp"

namespace cleave::results {

/// Mass, momentum and kinetic energy of a set of nodes.
struct Motion {
  double mass = 0.0;
  double momentum[3] = {0, 0, 0};
  double kinetic = 0.0;  ///< half m v^2 with the velocity at t_n [energy]
};

/// Which share of each node's mass belongs to which part; fixed for the whole run.
class Masses {
 public:
  /// @param motion  [part] where the solver gives it: the masses of parts without blocks
  explicit Masses(const discretisation::World& world, std::span<const solver::PartMotion> motion = {});

  struct Part {
    std::vector<model::Index> node;  ///< nodes of the part's elements, ascending
    std::vector<double> mass;        ///< of the elements, lumped to these nodes, before mass scaling [mass]
    double total = 0.0;
  };
  const std::vector<Part>& parts() const { return parts_; }
  const std::vector<double>& elements() const { return elements_; }  ///< of all parts [node] [mass]
  const std::vector<double>& points() const { return points_; }      ///< *ELEMENT_MASS [node] [mass]
  double total() const { return total_; }
  /// Is this node one of a rigid body? Its mass then counts with the body.
  bool rigid(std::size_t node) const { return !rigid_.empty() && rigid_[node] != 0; }

 private:
  std::vector<char> rigid_;  // [node], empty without bodies
  std::vector<Part> parts_;
  std::vector<double> elements_, points_;
  double total_ = 0.0;
};

class Snapshot {
 public:
  Snapshot(const solver::Frame& frame, const Masses& masses) : frame_(frame), masses_(masses) {}

  const solver::Frame& frame() const { return frame_; }
  /// Before anything of solver::Wanted is read.
  void evaluate(unsigned wanted) const {
    if (wanted && frame_.evaluate) frame_.evaluate(wanted);
  }
  const model::Model& model() const { return frame_.model; }
  const discretisation::State& state() const { return frame_.state; }
  const Masses& masses() const { return masses_; }

  /// All nodes of the model; what the solver says of all parts, where it does.
  const Motion& whole() const;
  /// Nodes that parts share are divided by the masses of their elements; what scaling adds to a node or
  /// deleted elements take from it is divided likewise.
  const std::vector<Motion>& parts() const;

 private:
  const solver::Frame& frame_;
  /// A part of a rigid body: its share of the body's motion.
  Motion of_rigid(std::size_t body, std::size_t part) const;

  const Masses& masses_;
  mutable bool have_whole_ = false;
  mutable Motion whole_;
  mutable std::vector<Motion> parts_;
};

/// Memory entry of a name in a state restarted from; null when there is none.
const discretisation::Memory* find_memory(const discretisation::State& state, std::string_view name);

}  // namespace cleave::results
