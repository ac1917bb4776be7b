#pragma once
/// Loads on a rigid body as a whole: *LOAD_BODY, *LOAD_RIGID_BODY.

#include <vector>

#include "solver/rigid/drive.hpp"

namespace cleave::solver {

/// Sum of forces on a body, and of their moments about its centre.
struct Wrench {
  Vector force{0, 0, 0}, moment{0, 0, 0};
  Wrench& operator+=(const Wrench& other) {
    force = force + other.force;
    moment = moment + other.moment;
    return *this;
  }
};

class BodyLoads {
 public:
  explicit BodyLoads(const discretisation::World& world);

  /// Force and moment about the centre at t_n.
  Wrench at(const Moment& now, std::size_t body, const BodyNow& at) const;

 private:
  const discretisation::World& world_;
  const model::Model& model_;
  std::vector<std::vector<const model::BodyLoad*>> felt_;  // [body] those that act on most of its nodes
};

}  // namespace cleave::solver
