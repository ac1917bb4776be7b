#include "discretisation/spacetime/estimate.hpp"

#include <limits>

#include "discretisation/spacetime/body.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Later tents stand between neighbours that are already higher, and rise more: tents counted over those that
/// first heights would make are 0.58 in bars, 0.65 to 0.77 in two and three dimensions.
constexpr double later = 0.7;

template <int D>
TentEstimate estimate(const model::Model& model) {
  TentEstimate out;
  deck::Diagnostics diagnostics;
  const auto body = make_body<D>(model, diagnostics);
  if (!body) return out;
  const Pitcher<D> pitcher(body->mesh, body->pitch);
  const Front<D> front = pitcher.level_front(0.0);
  for (Vertex v = 0; v < body->mesh.vertex_count(); ++v) {
    const double height = pitcher.pitch(front, v, std::numeric_limits<double>::infinity()).height();
    if (!(height > 0.0)) continue;
    if (out.lowest == 0.0 || height < out.lowest) {
      out.lowest = height;
      const auto node = static_cast<std::size_t>(body->node_of_vertex[static_cast<std::size_t>(v)]);
      out.lowest_at = model.mesh.nodes.id[node];
      for (std::size_t k = 0; k < 3; ++k) out.position[k] = model.mesh.nodes.position[3 * node + k];
    }
    out.highest = std::max(out.highest, height);
    out.patches += later * body->end_time / height;
  }
  return out;
}

}  // namespace

TentEstimate estimate_tents(const model::Model& model) {
  switch (dimension_of(model)) {
    case 1:
      return estimate<1>(model);
    case 2:
      return estimate<2>(model);
    case 3:
      return estimate<3>(model);
    default:
      return {};
  }
}

}  // namespace cleave::discretisation::spacetime
