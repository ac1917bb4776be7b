#include "results/contact_pressure.hpp"

#include <array>
#include <set>

#include "base/tensor.hpp"

namespace cleave::results {

using model::Vector;

std::vector<double> contact_pressure(const solver::Frame& frame) {
  std::vector<double> pressure(frame.world.node_count(), 0.0);
  if (frame.contact_force.empty()) return pressure;
  std::vector<Vector> area(pressure.size(), Vector{0, 0, 0});
  std::set<std::array<model::Index, 4>> done;  // a face counts once, however many contacts it is in
  const auto at = [&](model::Index node) {
    const double* x = &frame.state.position[3 * static_cast<std::size_t>(node)];
    return Vector{x[0], x[1], x[2]};
  };
  for (const model::Contact& contact : frame.model.contacts)
    for (const model::ContactSide* side : {&contact.a, &contact.b})
      for (const model::Segment& face : side->segments) {
        if (!done.insert({face.node[0], face.node[1], face.node[2], face.node[3]}).second) continue;
        const int corners = face.node[3] == face.node[2] ? 3 : 4;
        const Vector n = (0.5 / corners) * base::cross(at(face.node[2]) - at(face.node[0]),
                                                       at(face.node[3]) - at(face.node[1]));
        for (int k = 0; k < corners; ++k) {
          Vector& sum = area[static_cast<std::size_t>(face.node[k])];
          sum = sum + n;
        }
      }
  for (std::size_t a = 0; a < area.size(); ++a) {
    const double square = base::dot(area[a], area[a]);
    const double* f = &frame.contact_force[3 * a];
    if (square > 0.0) pressure[a] = -base::dot(area[a], Vector{f[0], f[1], f[2]}) / square;
  }
  return pressure;
}

}  // namespace cleave::results
