#include "model/rigid.hpp"

namespace cleave::model {

std::vector<Index> body_of_nodes(const std::vector<RigidBody>& bodies, std::size_t node_count) {
  std::vector<Index> body(node_count, -1);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const Index node : bodies[b].nodes) body[static_cast<std::size_t>(node)] = static_cast<Index>(b);
  return body;
}

}  // namespace cleave::model
