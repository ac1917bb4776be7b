#pragma once
/// The way of nodal forces from lanes to the global sum: rounded to integers, added up in the chunk's local
/// memory, handed over at the end of the chunk.

#include <cmath>

#include "base/threads.hpp"
#include "discretisation/fem/gather.hpp"
#include "discretisation/force_sum.hpp"

namespace cleave::discretisation::fem {

/// Calls body(chunk) for every chunk, those of a group one after the other on one thread.
template <class Body>
void for_each_grouped_chunk(const ChunkTable& table, const Body& body) {
  base::for_each_range(table.chunks.size(), static_cast<std::size_t>(table.chunks_per_group),
                       [&](std::size_t begin, std::size_t end) {
                         for (std::size_t c = begin; c < end; ++c) body(c);
                       });
}

/// One visit of all chunks of a block with `Nodes` nodes per element. Forces given are internal ones and are
/// subtracted from the sum.
template <int Nodes>
class ForceScatter {
 public:
  ForceScatter(const ChunkTable& table, ForceSum& force)
      : table_(table),
        force_(force),
        partial_(base::thread_count() > 1 ? force.partial_sums(table.between_groups.place.size()) : nullptr) {
  }

  /// Rounds the nodal forces of a batch and adds them to the chunk's memory. The last node balances the
  /// others, so that the integer forces of an element add up to zero and momentum is exact.
  /// @param active  elements that count; `everyone` if all do
  /// @param f       [node] of the element, internal [force]
  /// @param broken  called with the lane of an element whose force is not a number
  /// @return magnitude bits of what was added, see ForceSum
  template <class Broken>
  std::int64_t add(std::size_t batch, const Chunk& chunk, base::Mask active, bool everyone,
                   const Vec3<Lanes>* f, ChunkMemory& memory, const Broken& broken) const {
    Integers q[Nodes][3];
    Integers bits = {};
    ForceSum::Wrapping last[3] = {};  // out of range or NaN it wraps, and add_large() puts it right
    for (int a = 0; a < Nodes - 1; ++a) {
      const Lanes component[3] = {f[a].x, f[a].y, f[a].z};
      for (int i = 0; i < 3; ++i) {
        q[a][i] = force_.quantum(component[i]);
        if (!everyone) q[a][i] &= active.v;
        bits |= ForceSum::magnitude_bits(q[a][i]);
        last[i] -= (ForceSum::Wrapping)q[a][i];
      }
    }
    for (int i = 0; i < 3; ++i) {
      q[Nodes - 1][i] = (Integers)last[i];
      bits |= ForceSum::magnitude_bits(q[Nodes - 1][i]);
    }
    std::int64_t magnitude = 0;
    for (int lane = 0; lane < lane_count; ++lane) magnitude |= bits[lane];
    if (ForceSum::out_of_range(magnitude)) [[unlikely]]
      magnitude = add_large(batch, chunk, bits, f, q, broken);
    const std::uint16_t* local = table_.local.data() + batch * Nodes * lane_count;
    for (int a = 0; a < Nodes; ++a)
      scatter(memory.force.data(), local + a * lane_count, q[a][0], q[a][1], q[a][2]);
    return magnitude;
  }

  /// Hands over the sums of a chunk: those of its own nodes to the global sum, those of shared nodes are set
  /// aside unless there is one thread. Chunks of one group must follow each other on one thread.
  void finish(const Chunk& chunk, const ChunkMemory& memory, std::int64_t magnitude) const {
    const Index* list = table_.nodes.data() + chunk.first_node;
    const std::int64_t* f = memory.force.data();
    const std::int32_t direct = partial_ ? chunk.own_count : chunk.node_count;
    for (std::int32_t i = 0; i < direct; ++i, f += force_row) {
      for (int k = 0; k < 3; ++k) force_.add(list[i], k, -f[k], false);
    }
    if (partial_)
      std::copy(f, memory.force.data() + chunk.node_count * force_row,
                partial_ + static_cast<std::ptrdiff_t>(chunk.first_slot) * force_row);
    force_.report_magnitude(magnitude);
  }

  /// Asks for the memory that finish() will add to: part `part` of `parts` of the chunk's own nodes.
  void prefetch(const Chunk& chunk, std::int32_t part, std::int32_t parts) const {
    const Index* list = table_.nodes.data() + chunk.first_node;
    const std::int32_t end = chunk.own_count * (part + 1) / parts;
    for (std::int32_t i = chunk.own_count * part / parts; i < end; ++i) force_.prefetch(list[i]);
  }

  /// After all chunks: one thread per shared node adds what the chunks set aside.
  void add_shared() const {
    if (!partial_) return;
    const SharedNodes& shared = table_.between_groups;
    base::for_each_range(shared.node.size(), 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::size_t ahead = std::min(n + 16, end - 1);
        force_.prefetch(shared.node[ahead]);
        for (std::int32_t s = shared.first[ahead]; s < shared.first[ahead + 1]; ++s)
          __builtin_prefetch(partial_ +
                             std::ptrdiff_t{shared.place[static_cast<std::size_t>(s)]} * force_row);
        std::int64_t sum[3] = {0, 0, 0};
        for (std::int32_t s = shared.first[n]; s < shared.first[n + 1]; ++s) {
          const std::int64_t* part =
              partial_ + std::ptrdiff_t{shared.place[static_cast<std::size_t>(s)]} * force_row;
          for (int k = 0; k < 3; ++k) sum[k] += part[k];
        }
        for (int k = 0; k < 3; ++k) force_.add(shared.node[n], k, -sum[k], false);
      }
    });
  }

 private:
  // Elements with a force beyond the range of the integers: one by one, through the coarser sums.
  template <class Broken>
  [[gnu::noinline]] std::int64_t add_large(std::size_t batch, const Chunk& chunk, Integers bits,
                                           const Vec3<Lanes>* f, Integers (&q)[Nodes][3],
                                           const Broken& broken) const {
    std::int64_t kept = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
      if (!ForceSum::out_of_range(bits[lane])) {
        kept |= bits[lane];
        continue;
      }
      bool finite = true;
      for (int a = 0; a < Nodes; ++a)
        finite = finite && std::isfinite(f[a].x[lane]) && std::isfinite(f[a].y[lane]) &&
                 std::isfinite(f[a].z[lane]);
      if (!finite) broken(lane);
      for (int a = 0; a < Nodes; ++a) {
        const double value[3] = {f[a].x[lane], f[a].y[lane], f[a].z[lane]};
        const std::size_t at = (batch * Nodes + static_cast<std::size_t>(a)) * lane_count;
        const std::uint16_t local = table_.local[at + static_cast<std::size_t>(lane)];
        const Index node = table_.nodes[static_cast<std::size_t>(chunk.first_node) + local];
        for (int i = 0; i < 3; ++i) {
          q[a][i][lane] = 0;
          if (finite) force_.add_value(node, i, -value[i]);
        }
      }
    }
    return kept;
  }

  const ChunkTable& table_;
  ForceSum& force_;
  std::int64_t* partial_;  // sums of shared nodes; null with one thread
};

}  // namespace cleave::discretisation::fem
