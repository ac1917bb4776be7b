#pragma once
/// What holds or drives a rigid body: rows "velocity (or spin) along d is c", made orthonormal.

#include <span>
#include <vector>

#include "discretisation/world.hpp"
#include "solver/action.hpp"
#include "solver/rigid/rotation.hpp"

namespace cleave::solver {

/// Directions in which a velocity is known, and how much it is there.
struct Known {
  Vector axis[3];
  double value[3];
  int count = 0;

  /// Adds a direction; one that depends on those there has no say.
  void add(const Vector& direction, double wanted);
  /// The part of a velocity that is known.
  Vector sum() const;
  /// Unit vectors across the known ones; as many as the result says.
  int free(Vector (&across)[3]) const;
};

/// One body's state that rows may ask for.
struct BodyNow {
  Vector displacement, velocity, spin;  ///< of the centre; velocity and spin of the step before
  Rotation rotation;                    ///< since the start
};

/// The rows of all bodies.
class Drives {
 public:
  explicit Drives(const model::Model& model);

  /// Warns of each body that is told twice at the same time what it does along a direction.
  void warn_of_conflicts(deck::Diagnostics& diagnostics) const;

  /// Numbers that rows remember: two each, the path so far and the path at birth.
  std::size_t memory_size() const { return 2 * rows_.size(); }
  bool any(std::size_t body) const { return first_[body] < first_[body + 1]; }

  /// What is known of the velocity of the centre (or of the spin) over the step to come.
  Known known(std::size_t body, bool rotation, const Moment& now, const BodyNow& at,
              std::span<double> memory) const;
  /// Adds the way of the step to the paths of the rows.
  void advance(std::size_t body, const Moment& now, const BodyNow& at, const Vector& velocity,
               const Vector& spin, std::span<double> memory) const;

 private:
  struct Row {
    Vector direction;
    bool rotation, local;
    double birth, death;
    const model::RigidMotion* motion;  ///< null: held
  };
  static Vector direction(const Row& row, const BodyNow& at) {
    return row.local ? at.rotation(row.direction) : row.direction;
  }
  void add(const model::RigidMotion& motion, std::vector<Row>& rows) const;
  double wanted(const Row& row, std::size_t number, const Moment& now, const BodyNow& at,
                std::span<double> memory) const;

  const model::Model& model_;
  std::vector<std::size_t> first_;  // [body + 1]
  std::vector<Row> rows_;           // motions stand before what is held, later motions before earlier ones
};

}  // namespace cleave::solver
