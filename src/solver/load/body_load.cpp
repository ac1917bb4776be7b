/// *LOAD_BODY: the base accelerates along an axis and the body feels the opposite; or the base turns about
/// an axis, and the body feels the centrifugal acceleration w x (x x w). *LOAD_BODY_GENERALIZED adds the
/// Coriolis acceleration 2 v x w and the one of a changing speed of rotation, x x dw/dt.

#include <numeric>

#include "base/threads.hpp"
#include "solver/load/kinds.hpp"

namespace cleave::solver {
namespace {

using model::BodyLoad;
using model::Vector;

class BodyForce final : public Load {
 public:
  /// Nodes of rigid bodies are left out: the bodies know their mass better (rigid_bodies.cpp).
  BodyForce(const model::Model& model, const BodyLoad& load) : model_(model), load_(load) {
    if (load.nodes.empty()) {
      nodes_.resize(model.mesh.nodes.count());
      std::iota(nodes_.begin(), nodes_.end(), 0);
    } else {
      for (std::size_t a = 0; a < load.nodes.size(); ++a)
        if (load.nodes[a]) nodes_.push_back(static_cast<Index>(a));
    }
    if (model.rigid_bodies.empty()) return;
    const auto body = model::body_of_nodes(model.rigid_bodies, model.mesh.nodes.count());
    std::erase_if(nodes_, [&](Index a) { return body[static_cast<std::size_t>(a)] >= 0; });
  }

  std::vector<Index> nodes() const override { return nodes_; }

  void add_force(const Moment& now, std::span<double> force) override {
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(load_.curve)];
    const double value = load_.scale * load_value(curve, now.time, now.step);
    if (value == 0.0) return;
    base::for_each_range(nodes_.size(), 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto node = static_cast<std::size_t>(nodes_[k]);
        const Vector f = now.mass[node] * (load_.generalized ? generalized(value, now, 3 * node)
                                                             : acceleration(value, &now.position[3 * node]));
        force[3 * node] += f.x;
        force[3 * node + 1] += f.y;
        force[3 * node + 2] += f.z;
      }
    });
  }

 private:
  Vector acceleration(double value, const double* x) const {
    if (!load_.rotation) return (-value) * load_.direction;
    const Vector arm = Vector{x[0], x[1], x[2]} - load_.centre;
    return (value * value) * (arm - base::dot(arm, load_.direction) * load_.direction);
  }

  /// The velocity at t_n is not known before the forces are: that of the half step before is carried on by
  /// the acceleration of the last cycle, which is second order.
  Vector generalized(double value, const Moment& now, std::size_t at) const {
    const Vector rate = value * load_.direction;  // of the base
    if (!load_.rotation) return -1.0 * rate;
    if (load_.angular == BodyLoad::Angular::coriolis) {
      const double since = 0.5 * now.step_before;
      const double *v = &now.velocity[at], *a = &now.acceleration_before[at];
      return -2.0 * base::cross(rate, {v[0] + since * a[0], v[1] + since * a[1], v[2] + since * a[2]});
    }
    const double* x = &now.position[at];
    const Vector arm = Vector{x[0], x[1], x[2]} - load_.centre;
    if (load_.angular == BodyLoad::Angular::euler) return -1.0 * base::cross(rate, arm);
    return -1.0 * base::cross(rate, base::cross(rate, arm));
  }

  const model::Model& model_;
  const BodyLoad& load_;
  std::vector<Index> nodes_;
};

}  // namespace

void add_body_loads(const model::Model& model, LoadList& list) {
  for (const BodyLoad& load : model.body_loads) list.push_back(std::make_unique<BodyForce>(model, load));
}

}  // namespace cleave::solver
