#include "discretisation/chunk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/threads.hpp"
#include "discretisation/curve_order.hpp"
#include "sample.hpp"

namespace cleave::discretisation::sample {
namespace {

TEST(HilbertCurve, NeighboursOnTheCurveAreNeighboursInSpace) {
  // The first 16^3 cells of the curve fill a cube, each a step of one from the one before.
  std::map<std::uint64_t, std::array<std::uint32_t, 3>> cells;
  for (std::uint32_t i = 0; i < 16; ++i)
    for (std::uint32_t j = 0; j < 16; ++j)
      for (std::uint32_t k = 0; k < 16; ++k) {
        const std::uint32_t x[3] = {i, j, k};
        cells[hilbert_index(x)] = {i, j, k};
      }
  ASSERT_EQ(cells.size(), 4096u);
  EXPECT_EQ(cells.rbegin()->first, 4095u);
  auto before = cells.begin();
  for (auto cell = std::next(before); cell != cells.end(); before = cell++) {
    int distance = 0;
    for (std::size_t i = 0; i < 3; ++i) distance += std::abs(int(cell->second[i]) - int(before->second[i]));
    EXPECT_EQ(distance, 1);
  }
}

TEST(Chunks, HoldEveryElementAndNodeOnce) {
  const Sample s = box(13, 11, 9, elastic());  // 1287 elements: two full chunks, and a padded batch
  const auto& solids = s.model.mesh.solids[0];
  const ChunkTable table({s.model, 0, solids.shape, solids.id, solids.node});
  EXPECT_EQ(table.batch_count, 161u);
  EXPECT_EQ(table.chunks.size(), 3u);

  auto ids = table.id;
  std::ranges::sort(ids);
  EXPECT_EQ(ids, solids.id);

  std::map<Index, int> met;
  std::set<std::int32_t> slots;
  for (const Chunk& chunk : table.chunks) {
    std::set<Index> mine;
    for (std::int32_t b = chunk.first_batch; b < chunk.first_batch + chunk.batch_count; ++b)
      for (int a = 0; a < 8; ++a)
        for (int lane = 0; lane < base::lane_count; ++lane) {
          const auto batch = static_cast<std::size_t>(b), node = static_cast<std::size_t>(a);
          const auto local = table.local[(batch * 8 + node) * 8 + static_cast<std::size_t>(lane)];
          const Index n = table.nodes[static_cast<std::size_t>(chunk.first_node + local)];
          EXPECT_EQ(n, table.connectivity[table.element(batch, lane) * 8 + node]);
          mine.insert(n);
        }
    EXPECT_EQ(mine.size(), static_cast<std::size_t>(chunk.node_count));
    for (const Index n : mine) ++met[n];
  }
  EXPECT_EQ(met.size(), s.node_count());

  // Nodes of one chunk alone are its own; the others are shared, with a slot for each chunk.
  std::size_t shared = 0;
  for (const Chunk& chunk : table.chunks)
    for (std::int32_t i = 0; i < chunk.node_count; ++i)
      EXPECT_EQ(met[table.nodes[static_cast<std::size_t>(chunk.first_node + i)]] == 1, i < chunk.own_count);
  for (std::size_t n = 0; n < table.between_groups.node.size(); ++n) {
    EXPECT_EQ(table.between_groups.first[n + 1] - table.between_groups.first[n],
              met[table.between_groups.node[n]]);
    for (std::int32_t at = table.between_groups.first[n]; at < table.between_groups.first[n + 1]; ++at) {
      const std::int32_t slot = table.between_groups.place[static_cast<std::size_t>(at)];
      EXPECT_TRUE(slots.insert(slot).second);
      const auto chunk = std::ranges::find_if(table.chunks, [&](const Chunk& c) {
        return slot >= c.first_slot && slot < c.first_slot + c.node_count - c.own_count;
      });
      ASSERT_NE(chunk, table.chunks.end());
      EXPECT_EQ(table.nodes[static_cast<std::size_t>(chunk->first_node + chunk->own_count + slot -
                                                     chunk->first_slot)],
                table.between_groups.node[n]);
    }
    ++shared;
  }
  EXPECT_GT(shared, 100u);
}

TEST(Chunks, OfOneGroupShareNoSlots) {
  const Sample s = box(64, 64, 33, elastic());  // 264 chunks: two to a group
  const auto& solids = s.model.mesh.solids[0];
  const ChunkTable table({s.model, 0, solids.shape, solids.id, solids.node});
  ASSERT_EQ(table.chunks_per_group, 2);

  // A node has slots if, and only if, chunks of several groups meet it.
  std::vector<std::set<std::size_t>> groups(s.node_count());
  for (std::size_t c = 0; c < table.chunks.size(); ++c)
    for (std::int32_t i = 0; i < table.chunks[c].node_count; ++i)
      groups[table.nodes[static_cast<std::size_t>(table.chunks[c].first_node + i)]].insert(c / 2);
  for (const Chunk& chunk : table.chunks)
    for (std::int32_t i = 0; i < chunk.node_count; ++i)
      ASSERT_EQ(groups[table.nodes[static_cast<std::size_t>(chunk.first_node + i)]].size() == 1,
                i < chunk.own_count);
  for (const Index n : table.between_groups.node) EXPECT_GT(groups[n].size(), 1u);

  // Every element pulls at its nodes; the sums are the same bits whoever adds them.
  const auto block = s.block();
  BlockState state;
  base::Array<double> x(s.model.mesh.nodes.position.begin(), s.model.mesh.nodes.position.end());
  base::Array<double> v(x.size());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = std::sin(0.1 * static_cast<double>(i % 1009));
  base::Array<double> one, some;
  for (const int threads : {1, 3}) {
    base::set_thread_count(threads);
    block->initialise(x, state);
    ForceSum force(s.node_count());
    force.begin(1.0);
    block->add_force({1e-4, 1e-4, x.data(), v.data(), 0.0}, state, force);
    force.values(threads == 1 ? one : some);
  }
  base::set_thread_count(0);
  EXPECT_NE(one, base::Array<double>(one.size(), 0.0));
  EXPECT_EQ(one, some);
}

TEST(Chunks, AreCompact) {
  const Sample s = box(32, 32, 16, elastic());
  const auto& solids = s.model.mesh.solids[0];
  const ChunkTable table({s.model, 0, solids.shape, solids.id, solids.node});
  double nodes = 0.0;
  for (const Chunk& chunk : table.chunks) nodes += chunk.node_count;
  // A cube of 512 elements has 729 nodes.
  EXPECT_LT(nodes / static_cast<double>(table.chunks.size()), 1.15 * 729);
}

}  // namespace
}  // namespace cleave::discretisation::sample
