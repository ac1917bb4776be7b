#include "solver/rigid/body_loads.hpp"

#include <algorithm>

#include "solver/field.hpp"
#include "solver/rigid/inertia.hpp"

namespace cleave::solver {

using base::cross;
using base::dot;

BodyLoads::BodyLoads(const discretisation::World& world) : world_(world), model_(*world.model) {
  for (const discretisation::RigidBody& body : world.bodies) {
    std::vector<const model::BodyLoad*>& felt = felt_.emplace_back();
    for (const model::BodyLoad& load : model_.body_loads) {
      const auto count = std::count_if(body.node.begin(), body.node.end(), [&](Index a) {
        return load.nodes.empty() || load.nodes[static_cast<std::size_t>(a)];
      });
      if (2 * static_cast<std::size_t>(count) > body.node.size()) felt.push_back(&load);
    }
  }
}

Wrench BodyLoads::at(const Moment& now, std::size_t body, const BodyNow& at) const {
  const discretisation::RigidBody& fixed = world_.bodies[body];
  const double mass = fixed.whole.mass;
  const auto value = [&](Index curve, double scale) {
    return scale * load_value(model_.curves[static_cast<std::size_t>(curve)], now.time, now.step);
  };
  Wrench sum;
  for (const model::BodyLoad* load : felt_[body]) {
    const double size = value(load->curve, load->scale);
    if (!load->rotation) {
      sum.force = sum.force - (mass * size) * load->direction;
      continue;
    }
    // Centrifugal: w^2 (1 - d d) x, and its moment about the centre w^2 (J d) x d.
    const Vector d = load->direction, arm = fixed.whole.centre + at.displacement - load->centre;
    const double square = load->generalized ? dot(d, d) : 1.0;
    sum.force = sum.force + (mass * size * size) * (square * arm - dot(arm, d) * d);
    sum.moment = sum.moment + (size * size) * cross(Inertia(fixed, at.rotation).times(d), d);
  }
  for (const model::RigidLoad& load : model_.rigid_loads) {
    if (load.body != static_cast<Index>(body)) continue;
    Vector& to = load.moment ? sum.moment : sum.force;
    to = to + value(load.curve, load.scale) *
                  (load.follower ? normal_of(now.position, load.follow) : load.direction);
  }
  return sum;
}

}  // namespace cleave::solver
