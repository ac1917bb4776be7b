#include "discretisation/chunk.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "discretisation/curve_order.hpp"

namespace cleave::discretisation {

using base::lane_count;

ChunkTable::ChunkTable(const PartElements& elements)
    : nodes_per_element(model::nodes_of(elements.shape)), element_count(elements.id.size()) {
  const auto per = static_cast<std::size_t>(nodes_per_element);
  const auto order = curve_order(elements.node, nodes_per_element, elements.model.mesh.nodes.position);
  id.reserve(element_count);
  connectivity.reserve(element_count * per);
  for (const Index e : order) {
    id.push_back(elements.id[e]);
    for (std::size_t a = 0; a < per; ++a) connectivity.push_back(elements.node[e * per + a]);
  }
  batch_count = (element_count + lane_count - 1) / lane_count;
  local.resize(batch_count * per * lane_count);

  // How many chunks touch each node, and which nodes lie between groups.
  const std::size_t node_total = elements.model.mesh.nodes.count();
  const std::size_t chunk_count = (batch_count + batches_per_chunk - 1) / batches_per_chunk;
  const std::size_t elements_per_chunk = batches_per_chunk * lane_count;
  chunks_per_group = std::clamp(static_cast<int>(chunk_count) / least_group_count, 1, most_chunks_per_group);
  const auto group_of = [&](std::int32_t c) { return c / chunks_per_group; };
  const auto range_of = [&](std::size_t c) {
    return std::pair{c * elements_per_chunk * per,
                     std::min((c + 1) * elements_per_chunk, element_count) * per};
  };
  std::vector<std::int32_t> met(node_total, 0);
  std::vector<std::int32_t> seen_by(node_total, -1);
  std::vector<bool> between(node_total, false);
  for (std::size_t c = 0; c < chunk_count; ++c) {
    const auto [begin, end] = range_of(c);
    for (std::size_t i = begin; i < end; ++i) {
      const Index n = connectivity[i];
      const auto now = static_cast<std::int32_t>(c), before = seen_by[n];
      if (before == now) continue;
      if (before >= 0 && group_of(before) != group_of(now)) between[n] = true;
      seen_by[n] = now;
      ++met[n];
    }
  }

  // Places of shared nodes; nodes and places in the order of chunks, so that a pass over them is one over
  // both.
  std::vector<std::int32_t> next_row(node_total, -1), next_slot(node_total, -1);
  const auto list = [&](SharedNodes& shared, std::vector<std::int32_t>& next, const auto& is_shared) {
    shared.first.push_back(0);
    for (const Index n : connectivity)
      if (is_shared(n) && next[n] < 0) {
        next[n] = shared.first.back();
        shared.node.push_back(n);
        shared.first.push_back(shared.first.back() + met[n]);
      }
    shared.place.resize(static_cast<std::size_t>(shared.first.back()));
  };
  list(between_chunks, next_row, [&](Index n) { return met[n] > 1; });
  list(between_groups, next_slot, [&](Index n) { return between[n]; });
  std::int32_t slot_count = 0;

  // Nodes of each chunk, its own first, each group ascending; then the local connectivity.
  std::vector<std::uint16_t> place(node_total);
  for (std::size_t c = 0; c < chunk_count; ++c) {
    const auto [begin, end] = range_of(c);
    std::vector<Index> mine(connectivity.begin() + static_cast<std::ptrdiff_t>(begin),
                            connectivity.begin() + static_cast<std::ptrdiff_t>(end));
    std::sort(mine.begin(), mine.end());
    mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
    const auto rest = std::stable_partition(mine.begin(), mine.end(), [&](Index n) { return !between[n]; });
    CLEAVE_ASSERT(mine.size() < 65536, "local node numbers have 16 bits");
    for (std::size_t i = 0; i < mine.size(); ++i) place[mine[i]] = static_cast<std::uint16_t>(i);

    Chunk chunk;
    chunk.first_batch = static_cast<std::int32_t>(c * batches_per_chunk);
    chunk.batch_count = static_cast<std::int32_t>(
        std::min<std::size_t>(batches_per_chunk, batch_count - c * batches_per_chunk));
    chunk.first_node = static_cast<std::int32_t>(nodes.size());
    chunk.own_count = static_cast<std::int32_t>(rest - mine.begin());
    chunk.node_count = static_cast<std::int32_t>(mine.size());
    chunk.first_slot = slot_count;
    for (auto n = mine.begin(); n != mine.end(); ++n)
      if (met[*n] > 1)
        between_chunks.place[next_row[*n]++] = chunk.first_node + static_cast<std::int32_t>(n - mine.begin());
    for (auto n = rest; n != mine.end(); ++n) between_groups.place[next_slot[*n]++] = slot_count++;
    chunks.push_back(chunk);
    largest_node_count = std::max(largest_node_count, chunk.node_count);
    nodes.insert(nodes.end(), mine.begin(), mine.end());

    for (std::int32_t b = chunk.first_batch; b < chunk.first_batch + chunk.batch_count; ++b)
      for (std::size_t a = 0; a < per; ++a)
        for (int lane = 0; lane < lane_count; ++lane)
          local[(static_cast<std::size_t>(b) * per + a) * lane_count + static_cast<std::size_t>(lane)] =
              place[connectivity[element(static_cast<std::size_t>(b), lane) * per + a]];
  }
}

double ChunkTable::bytes() const {
  return static_cast<double>(
      id.size() * sizeof(Id) + connectivity.size() * sizeof(Index) + chunks.size() * sizeof(Chunk) +
      nodes.size() * sizeof(Index) + local.size() * sizeof(std::uint16_t) +
      (between_chunks.node.size() + between_groups.node.size()) * (sizeof(Index) + sizeof(std::int32_t)) +
      between_chunks.place.size() * sizeof(std::int32_t) +
      between_groups.place.size() * (sizeof(std::int32_t) + 4 * sizeof(std::int64_t)));
}

}  // namespace cleave::discretisation
