#pragma once
/// Averages at the nodes of a block, and the two visits of its elements that go with them.
///
/// Each chunk adds up in rows of its own, in the order of its elements; rows of a node that several chunks
/// touch are added in the order of chunks. Neither depends on the number of threads, so doubles will do.

#include <algorithm>
#include <memory>

#include "discretisation/fem/force_scatter.hpp"
#include "discretisation/fem/solid_element.hpp"

namespace cleave::discretisation::fem {

/// Four sums at every node of every chunk, the first of them the weights.
class NodeRows {
 public:
  static constexpr int width = 4;

  explicit NodeRows(const ChunkTable& table)
      : table_(table), row_(std::make_unique_for_overwrite<Row[]>(table.nodes.size())) {}

  double* of(const Chunk& chunk) { return row_[static_cast<std::size_t>(chunk.first_node)].value; }
  void clear(const Chunk& chunk) { std::fill_n(of(chunk), chunk.node_count * width, 0.0); }

  /// Adds the same four numbers of each element to the rows of all its nodes.
  /// @param rows   of the chunk
  /// @param local  [node][lane] of the batch
  template <int Nodes>
  static void add(double* rows, const std::uint16_t* local, const Lanes (&value)[width]) {
    const auto pairs_even = [](V a, V b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); };
    const auto pairs_odd = [](V a, V b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); };
    const V low[2] = {pairs_even(value[0].v, value[1].v), pairs_odd(value[0].v, value[1].v)};
    const V high[2] = {pairs_even(value[2].v, value[3].v), pairs_odd(value[2].v, value[3].v)};
    Four of_lane[lane_count];
    for (int odd = 0; odd < 2; ++odd) {
      const V front = __builtin_shufflevector(low[odd], high[odd], 0, 1, 8, 9, 2, 3, 10, 11);
      const V back = __builtin_shufflevector(low[odd], high[odd], 4, 5, 12, 13, 6, 7, 14, 15);
      of_lane[odd] = __builtin_shufflevector(front, front, 0, 1, 2, 3);
      of_lane[odd + 2] = __builtin_shufflevector(front, front, 4, 5, 6, 7);
      of_lane[odd + 4] = __builtin_shufflevector(back, back, 0, 1, 2, 3);
      of_lane[odd + 6] = __builtin_shufflevector(back, back, 4, 5, 6, 7);
    }
    for (int lane = 0; lane < lane_count; ++lane)
      for (int a = 0; a < Nodes; ++a) at(rows, local[a * lane_count + lane]) += of_lane[lane];
  }

  /// Sum over the nodes of each element of the numbers in their rows.
  template <int Nodes>
  static void sum(double* rows, const std::uint16_t* local, Lanes (&value)[width]) {
    Four q[lane_count];
    for (int lane = 0; lane < lane_count; ++lane) {
      q[lane] = at(rows, local[lane]);
      for (int a = 1; a < Nodes; ++a) q[lane] += at(rows, local[a * lane_count + lane]);
    }
    V w[4], low[2], high[2];
    for (int i = 0; i < 4; ++i) w[i] = __builtin_shufflevector(q[i], q[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    for (int i = 0; i < 2; ++i) {
      low[i] = __builtin_shufflevector(w[2 * i], w[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
      high[i] = __builtin_shufflevector(w[2 * i], w[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    const auto first = [](V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); };
    const auto second = [](V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); };
    value[0] = Lanes(first(low[0], low[1]));
    value[1] = Lanes(first(high[0], high[1]));
    value[2] = Lanes(second(low[0], low[1]));
    value[3] = Lanes(second(high[0], high[1]));
  }

  /// After all chunks have added: nodes of several chunks get the sum of their rows in each of them.
  void combine() {
    const SharedNodes& shared = table_.between_chunks;
    base::for_each_range(shared.node.size(), 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::int32_t *from = &shared.place[static_cast<std::size_t>(shared.first[n])],
                           *to = &shared.place[0] + shared.first[n + 1];
        Four total = row(*from);
        for (const std::int32_t* r = from + 1; r < to; ++r) total += row(*r);
        for (const std::int32_t* r = from; r < to; ++r) row(*r) = total;
      }
    });
  }

  /// After combine(): divides the sums of a chunk's nodes by their weights and by `nodes_per_element`, so
  /// that sum() gives means. A node without weight, where every element is deleted, is left as it is.
  void divide(const Chunk& chunk, double nodes_per_element) {
    double* rows = of(chunk);
    for (std::int32_t i = 0; i < chunk.node_count; ++i) {
      Four& r = at(rows, i);
      const double weight = nodes_per_element * r[0];
      if (weight > 0.0) r *= 1.0 / weight;
    }
  }

 private:
  struct alignas(32) Row {
    double value[width];
  };
  using V = Lanes::Vector;
  using Four = double __attribute__((vector_size(32), aligned(32), may_alias));
  static Four& at(double* rows, std::int32_t i) { return *reinterpret_cast<Four*>(rows + width * i); }
  Four& row(std::int32_t i) { return at(row_[0].value, i); }

  const ChunkTable& table_;
  std::unique_ptr<Row[]> row_;  // [node of chunk], filled by clear()
};

/// What a step keeps at the nodes: rows of (reference volume, volume, mid-step volume, growth), and of
/// (reference volume, its product with the mean stress, 0, 0), each summed over the living elements around.
struct NodeAverages {
  NodeRows volume, stress;
  explicit NodeAverages(const ChunkTable& table) : volume(table), stress(table) {}
};
/// For elements that need none.
struct NoAverages {
  explicit NoAverages(const ChunkTable&) {}
};

/// Nodes of a batch from the chunk's memory.
template <int Nodes>
void gather_batch(const ChunkTable& table, std::size_t batch, const ChunkMemory& memory, Vec3<Lanes>* x,
                  Vec3<Lanes>* v) {
  const std::uint16_t* local = table.local.data() + batch * Nodes * lane_count;
  for (int a = 0; a < Nodes; ++a) {
    const GatheredNode at = gather(memory.node.data(), local + a * lane_count);
    x[a] = at.x;
    v[a] = at.v;
  }
}

/// Before the strains: adds up the volumes around each node.
/// @param reference_volume  called with a batch [length^3]
template <class Element, class Reference>
void volume_visit(const Element& element, const ChunkTable& table, const StepInput& input,
                  const BlockState& state, const Reference& reference_volume, NodeRows& rows) {
  constexpr int nodes = Element::node_count;
  base::for_each_chunk(table.chunks.size(), [&](std::size_t c) {
    thread_local ChunkMemory memory;
    const Chunk& chunk = table.chunks[c];
    memory.load(table, chunk, input.position, input.velocity);
    rows.clear(chunk);
    for (int i = 0; i < chunk.batch_count; ++i) {
      const std::size_t b = static_cast<std::size_t>(chunk.first_batch + i);
      Vec3<Lanes> x[nodes], v[nodes];
      gather_batch<nodes>(table, b, memory, x, v);
      const Lanes zero(0.0);
      const base::Mask active = Lanes::load(state.alive.data() + b * lane_count) > zero;
      Lanes value[NodeRows::width] = {reference_volume(b)};
      element.volumes(x, v, input.dt, value + 1);
      if (!all(active))
        for (Lanes& entry : value) entry = select(active, entry, zero);
      NodeRows::add<nodes>(rows.of(chunk), table.local.data() + b * nodes * lane_count, value);
    }
  });
  rows.combine();
}

/// After the stresses: every element gets the mean of its nodes' averages of mean stress. That is the adjoint
/// of the averaging of volumes, so the work of these forces is that of the mean stresses.
/// @param broken  called with chunk, batch and lane of an element whose force is not a number
template <class Element, class Broken>
void pressure_visit(const Element& element, const ChunkTable& table, const StepInput& input,
                    const BlockState& state, NodeRows& rows, const ForceScatter<Element::node_count>& scatter,
                    const Broken& broken) {
  constexpr int nodes = Element::node_count;
  rows.combine();
  for_each_grouped_chunk(table, [&](std::size_t c) {
    thread_local ChunkMemory memory;
    const Chunk& chunk = table.chunks[c];
    memory.load(table, chunk, input.position, input.velocity);
    rows.divide(chunk, nodes);
    std::int64_t magnitude = 0;
    for (int i = 0; i < chunk.batch_count; ++i) {
      const std::size_t b = static_cast<std::size_t>(chunk.first_batch + i);
      Vec3<Lanes> x[nodes], v[nodes], f[nodes];
      gather_batch<nodes>(table, b, memory, x, v);
      const base::Mask active = Lanes::load(state.alive.data() + b * lane_count) > Lanes(0.0);
      Lanes mean[NodeRows::width];
      NodeRows::sum<nodes>(rows.of(chunk), table.local.data() + b * nodes * lane_count, mean);
      element.pressure_force(x, mean[1], f);
      magnitude |=
          scatter.add(b, chunk, active, all(active), f, memory, [&](int lane) { broken(c, b, lane); });
    }
    scatter.finish(chunk, memory, magnitude);
  });
  scatter.add_shared();
}

}  // namespace cleave::discretisation::fem
