#include "results/extents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "results/element_values.hpp"

namespace cleave::results {
namespace {

/// As each_node(), for models whose elements are in no blocks but in spacetime: all that the deck has.
template <class Visit>
void each_node_of_mesh(const model::Mesh& mesh, const Visit& visit) {
  for (const auto* groups : {&mesh.beams, &mesh.shells, &mesh.solids})
    for (const model::Elements& group : *groups) {
      const auto nodes = static_cast<std::size_t>(model::nodes_of(group.shape));
      for (std::size_t k = 0; k < group.node.size(); ++k)
        visit(static_cast<std::size_t>(group.part[k / nodes]), static_cast<std::size_t>(group.node[k]),
              k % nodes == 0);
    }
}

/// Visits every node of every element of a part that counts (nodes come once per element).
template <class Visit>
void each_node(const discretisation::World& world, const discretisation::State* state, const Visit& visit) {
  if (world.blocks.empty()) return each_node_of_mesh(world.model->mesh, visit);
  for (std::size_t b = 0; b < world.blocks.size(); ++b) {
    const discretisation::Block& block = *world.blocks[b];
    const std::size_t count = block.element_ids().size();
    const std::size_t nodes = static_cast<std::size_t>(model::nodes_of(block.shape()));
    const auto part = static_cast<std::size_t>(block.part());
    const auto connectivity = block.connectivity();
    std::optional<Alive> alive;
    if (state) alive.emplace(block, state->blocks[b]);
    for (std::size_t e = 0; e < count; ++e) {
      if (alive && !(*alive)[e]) continue;
      for (std::size_t a = 0; a < nodes; ++a)
        visit(part, static_cast<std::size_t>(connectivity[nodes * e + a]), a == 0);
    }
  }
}

}  // namespace

std::vector<Extent> extents(const discretisation::World& world, std::span<const double> position,
                            const discretisation::State* state, std::span<const PartAxes> axes) {
  std::vector<Extent> all(world.model->parts.size());
  std::vector<double> widest(3 * all.size(), 0.0);  // squared distances
  each_node(world, state, [&](std::size_t p, std::size_t node, bool first_of_element) {
    Extent& extent = all[p];
    const double* x = &position[3 * node];
    const bool first = extent.elements == 0;
    if (first_of_element) ++extent.elements;
    double square[3];
    for (int k = 0; k < 3; ++k) {
      extent.low[k] = first ? x[k] : std::min(extent.low[k], x[k]);
      extent.high[k] = first ? x[k] : std::max(extent.high[k], x[k]);
      const double off = axes.empty() ? 0.0 : x[k] - axes[p].centre[k];
      square[k] = off * off;
    }
    for (std::size_t k = 0; k < 3; ++k)
      widest[3 * p + k] = std::max(widest[3 * p + k], square[(k + 1) % 3] + square[(k + 2) % 3]);
  });
  for (std::size_t p = 0; p < all.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) all[p].diameter[k] = 2.0 * std::sqrt(widest[3 * p + k]);
  return all;
}

std::vector<PartAxes> part_axes(const discretisation::World& world) {
  const std::vector<double>& position = world.model->mesh.nodes.position;
  const std::vector<Extent> boxes = extents(world, position, nullptr, {});
  std::vector<unsigned char> held(world.node_count(), 0);  // bit k: held along the global axis k
  for (const model::FixedNodes& fixed : world.model->fixed)
    if (!fixed.local)
      for (const model::Index a : fixed.nodes)
        held[static_cast<std::size_t>(a)] |= static_cast<unsigned char>(fixed.directions & 7u);

  // A bounding plane is one of symmetry when it has nodes and all of them are held across it.
  std::vector<bool> open(6 * boxes.size(), false);
  each_node(world, nullptr, [&](std::size_t p, std::size_t node, bool) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double near = 1.0e-6 * (boxes[p].high[k] - boxes[p].low[k]), x = position[3 * node + k];
      if (held[node] >> k & 1u) continue;
      if (x <= boxes[p].low[k] + near) open[6 * p + 2 * k] = true;
      if (x >= boxes[p].high[k] - near) open[6 * p + 2 * k + 1] = true;
    }
  });
  std::vector<PartAxes> axes(boxes.size());
  for (std::size_t p = 0; p < boxes.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const bool low = !open[6 * p + 2 * k], high = !open[6 * p + 2 * k + 1];
      axes[p].symmetry[k] = low != high && boxes[p].elements > 0;
      axes[p].centre[k] = !axes[p].symmetry[k] ? 0.5 * (boxes[p].low[k] + boxes[p].high[k])
                          : low                ? boxes[p].low[k]
                                               : boxes[p].high[k];
    }
  return axes;
}

}  // namespace cleave::results
