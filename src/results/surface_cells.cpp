#include "results/surface_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace cleave::results {
namespace {

using model::Index;
using model::Shape;

constexpr double strip = 0.05;  // width of a line's picture, part of its length

/// The first point at the same place [point].
std::vector<Index> merged(std::span<const double> position) {
  const std::size_t count = position.size() / 3;
  std::vector<Index> order(count), first(count);
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](Index p) {
    const double* x = &position[3 * static_cast<std::size_t>(p)];
    return std::array<double, 3>{x[0], x[1], x[2]};
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const auto at = place(a), bt = place(b);
    return at != bt ? at < bt : a < b;
  });
  for (std::size_t k = 0; k < count; ++k)
    first[static_cast<std::size_t>(order[k])] = k > 0 && place(order[k]) == place(order[k - 1])
                                                    ? first[static_cast<std::size_t>(order[k - 1])]
                                                    : order[k];
  return first;
}

bool is_shell(Shape shape) {
  return shape == Shape::tri3 || shape == Shape::quad4;
}

}  // namespace

Surface outer_faces_by_place(std::span<const SolidCells> cells, std::span<const double> position) {
  const std::vector<Index> first = merged(position);
  std::vector<std::vector<Index>> nodes;
  std::vector<SolidCells> joined;
  for (const SolidCells& group : cells) {
    auto& mine = nodes.emplace_back();
    if (!is_shell(group.shape))
      for (const Index n : group.node) mine.push_back(first[static_cast<std::size_t>(n)]);
  }
  for (std::size_t g = 0; g < cells.size(); ++g)
    joined.push_back({cells[g].shape, nodes[g],
                      is_shell(cells[g].shape) ? std::span<const std::uint8_t>{} : cells[g].alive});
  Surface surface = outer_faces(joined, position.size() / 3);
  for (std::size_t c = 0; c < surface.node.size(); ++c) {
    const SolidCells& group = cells[surface.block[c / 4]];
    const auto per = static_cast<std::size_t>(model::nodes_of(group.shape));
    const auto own = group.node.subspan(per * surface.element[c / 4], per);
    surface.node[c] = *std::find_if(own.begin(), own.end(), [&](Index n) {
      return first[static_cast<std::size_t>(n)] == surface.node[c];
    });
  }
  for (std::size_t g = 0; g < cells.size(); ++g) {
    if (!is_shell(cells[g].shape)) continue;
    const auto per = static_cast<std::size_t>(model::nodes_of(cells[g].shape));
    for (std::size_t e = 0; e < cells[g].node.size() / per; ++e) {
      if (!cells[g].alive.empty() && cells[g].alive[e] == 0) continue;
      for (std::size_t k = 0; k < 4; ++k)
        surface.node.push_back(cells[g].node[per * e + std::min(k, per - 1)]);
      surface.edges.push_back(0);
      surface.block.push_back(static_cast<std::uint32_t>(g));
      surface.element.push_back(static_cast<std::uint32_t>(e));
    }
  }
  return surface;
}

CellSurface surface_of(const solver::CellFields& cells) {
  CellSurface out;
  out.position = cells.point;
  out.point_of.resize(cells.point.size() / 3);
  std::iota(out.point_of.begin(), out.point_of.end(), 0u);
  if (cells.dimension > 1) {
    const SolidCells group{cells.dimension == 2 ? Shape::tri3 : Shape::tet4, cells.cell, {}};
    out.surface = outer_faces_by_place({&group, 1}, out.position);
    orient_outwards(out.surface, {&group, 1}, out.position);
    std::fill(out.surface.edges.begin(), out.surface.edges.end(), std::uint8_t{0});
    return out;
  }
  double low = 0.0, high = 0.0;
  for (std::size_t p = 0; p < out.point_of.size(); ++p) {
    low = p == 0 ? cells.point[0] : std::min(low, cells.point[3 * p]);
    high = p == 0 ? cells.point[0] : std::max(high, cells.point[3 * p]);
  }
  const double half = 0.5 * strip * (high - low);
  const auto count = static_cast<Index>(out.point_of.size());
  out.position.insert(out.position.end(), cells.point.begin(), cells.point.end());
  out.point_of.insert(out.point_of.end(), out.point_of.begin(), out.point_of.begin() + count);
  for (Index p = 0; p < count; ++p) {
    out.position[3 * static_cast<std::size_t>(p) + 1] -= half;
    out.position[3 * static_cast<std::size_t>(p + count) + 1] += half;
  }
  for (std::size_t c = 0; 2 * c < cells.cell.size(); ++c) {
    const Index a = cells.cell[2 * c], b = cells.cell[2 * c + 1];
    const bool turned =
        cells.point[3 * static_cast<std::size_t>(a)] > cells.point[3 * static_cast<std::size_t>(b)];
    const Index left = turned ? b : a, right = turned ? a : b;
    for (const Index n : {left, right, right + count, left + count}) out.surface.node.push_back(n);
    out.surface.edges.push_back(0);
    out.surface.block.push_back(0);
    out.surface.element.push_back(static_cast<std::uint32_t>(c));
  }
  return out;
}

}  // namespace cleave::results
