/// Cracks of the model: faces of the mesh to be opened.

#include <algorithm>

#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// On a line a crack is a point: the vertex there.
MeshFault crack_faces(SpaceMeshInput<1>& input, std::span<const Point<1>> points) {
  MeshFault fault;
  fault.ok = false;
  if (points.size() != 1) {
    fault.what = "a crack through a bar is one point";
    return fault;
  }
  double size = 0.0;
  for (const auto& x : input.vertex) size = std::max(size, std::abs(x[0] - input.vertex[0][0]));
  for (std::size_t v = 0; v < input.vertex.size(); ++v)
    if (std::abs(input.vertex[v][0] - points[0][0]) <= 1e-6 * size) {
      input.crack.push_back({static_cast<Vertex>(v)});
      fault.ok = true;
      return fault;
    }
  fault.what = "no node lies at x = " + shortest(points[0][0]);
  fault.likely_cause = "a crack through a bar must stand at a node";
  return fault;
}
MeshFault crack_faces(SpaceMeshInput<2>& input, std::span<const Point<2>> points) {
  return add_crack(input, points);
}
MeshFault crack_faces(SpaceMeshInput<3>& input, std::span<const Point<3>> points) {
  return add_crack(input, points);
}

/// Is the face one of a simplex of the part?
template <int D>
bool touches(const SpaceMeshInput<D>& input, const std::vector<std::vector<std::size_t>>& star,
             const std::array<Vertex, D>& face, model::Index part) {
  const auto& around = star[static_cast<std::size_t>(face[0])];
  return std::any_of(around.begin(), around.end(), [&](std::size_t s) {
    return input.material[s] == part && std::all_of(face.begin(), face.end(), [&](Vertex v) {
             return std::find(input.simplex[s].begin(), input.simplex[s].end(), v) != input.simplex[s].end();
           });
  });
}

}  // namespace

template <int D>
void gather_cracks(const model::Model& model, SpaceMeshInput<D>& input, deck::Diagnostics& diagnostics) {
  if (model.precracks.empty()) return;
  std::vector<std::vector<std::size_t>> star(input.vertex.size());
  for (std::size_t s = 0; s < input.simplex.size(); ++s)
    for (const Vertex v : input.simplex[s]) star[static_cast<std::size_t>(v)].push_back(s);
  for (const model::Precrack& crack : model.precracks) {
    std::vector<Point<D>> points;
    for (const model::Vector& p : crack.points) {
      const double x[] = {p.x, p.y, p.z};
      Point<D> point;
      std::copy(x, x + D, point.begin());
      points.push_back(point);
    }
    const std::size_t before = input.crack.size();
    if (const MeshFault fault = crack_faces(input, points); !fault.ok) {
      diagnostics.error(crack.place, "BOUNDARY_PRECRACK", "", fault.what, fault.likely_cause);
      continue;
    }
    const model::Index part = model.part_of(crack.part);
    for (std::size_t c = before; c < input.crack.size(); ++c)
      if (!touches<D>(input, star, input.crack[c], part)) {
        diagnostics.error(crack.place, "BOUNDARY_PRECRACK", "PID",
                          "the crack runs outside part " + std::to_string(crack.part),
                          "give a crack for each part it runs through");
        break;
      }
  }
}

template void gather_cracks<1>(const model::Model&, SpaceMeshInput<1>&, deck::Diagnostics&);
template void gather_cracks<2>(const model::Model&, SpaceMeshInput<2>&, deck::Diagnostics&);
template void gather_cracks<3>(const model::Model&, SpaceMeshInput<3>&, deck::Diagnostics&);

}  // namespace cleave::discretisation::spacetime
