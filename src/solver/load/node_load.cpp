/// *LOAD_NODE: a force on each node along a fixed direction, or along the normal of three moving nodes.

#include "solver/field.hpp"
#include "solver/load/kinds.hpp"

namespace cleave::solver {
namespace {

using model::NodeLoad;
using model::Vector;

class NodeForce final : public Load {
 public:
  NodeForce(const model::Model& model, const NodeLoad& load) : model_(model), load_(load) {}

  std::vector<Index> nodes() const override { return load_.nodes; }

  void add_force(const Moment& now, std::span<double> force) override {
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(load_.curve)];
    const Vector f = (load_.scale * load_value(curve, now.time, now.step)) * direction(now);
    for (const Index node : load_.nodes) {
      double* at = &force[3 * static_cast<std::size_t>(node)];
      at[0] += f.x;
      at[1] += f.y;
      at[2] += f.z;
    }
  }

 private:
  /// A follower turns with the plane of its three nodes; no direction when they are in line.
  Vector direction(const Moment& now) const {
    return load_.follower ? normal_of(now.position, load_.follow) : load_.direction;
  }

  const model::Model& model_;
  const NodeLoad& load_;
};

}  // namespace

void add_node_loads(const model::Model& model, LoadList& list) {
  for (const NodeLoad& load : model.node_loads) list.push_back(std::make_unique<NodeForce>(model, load));
}

}  // namespace cleave::solver
