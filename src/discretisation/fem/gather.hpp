#pragma once
/// Between nodes and lanes: the copies that a chunk works on.
///
/// A chunk's nodes lie in local memory as rows of eight doubles (x y z 0 vx vy vz 0), one cache line each.
/// Eight elements read one node each as eight rows and transpose them in registers; forces go back the
/// same way as rows of four integers. That is several times faster than gathering single numbers.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/array.hpp"
#include "base/tensor.hpp"
#include "discretisation/chunk.hpp"

namespace cleave::discretisation::fem {

using base::lane_count;
using base::Lanes;
using base::Vec3;

inline constexpr int row = 8;        ///< doubles per local node
inline constexpr int force_row = 4;  ///< integers per local node

using Integers = base::Mask::Vector;  ///< eight 64-bit integers
using Quad = std::int64_t __attribute__((vector_size(32), aligned(32), may_alias));

/// Asks for part `part` of `parts` of what load() will read of a chunk: a cache line of a node comes from
/// memory while the chunk before is computed.
inline void prefetch_nodes(const ChunkTable& table, const Chunk& chunk, std::int32_t part, std::int32_t parts,
                           const double* position, const double* velocity) {
  const Index* list = table.nodes.data() + chunk.first_node;
  const std::int32_t end = chunk.node_count * (part + 1) / parts;
  for (std::int32_t i = chunk.node_count * part / parts; i < end; ++i) {
    const std::size_t at = 3 * static_cast<std::size_t>(list[i]);
    __builtin_prefetch(position + at);
    __builtin_prefetch(velocity + at);
  }
}

/// Local memory of a thread for one chunk.
struct ChunkMemory {
  base::Array<double> node;         ///< [local node][row]
  base::Array<std::int64_t> force;  ///< [local node][force_row]

  /// Copies positions and velocities of the chunk's nodes and clears the forces.
  void load(const ChunkTable& table, const Chunk& chunk, const double* position, const double* velocity) {
    const std::size_t count = static_cast<std::size_t>(chunk.node_count);
    if (node.size() < count * row) node.resize(count * row);
    if (force.size() < count * force_row) force.resize(count * force_row);
    const Index* list = table.nodes.data() + chunk.first_node;
    double* to = node.data();
    for (std::size_t i = 0; i < count; ++i, to += row) {
      const double* x = position + 3 * static_cast<std::size_t>(list[i]);
      const double* v = velocity + 3 * static_cast<std::size_t>(list[i]);
      const Lanes::Vector line = {x[0], x[1], x[2], 0.0, v[0], v[1], v[2], 0.0};
      Lanes(line).store(to);
    }
    std::fill_n(force.begin(), count * force_row, std::int64_t{0});
  }
};

/// Position and velocity of one node of eight elements.
struct GatheredNode {
  Vec3<Lanes> x, v;
};

/// @param node   local rows
/// @param local  local node number of each lane
inline GatheredNode gather(const double* node, const std::uint16_t* local) {
  using V = Lanes::Vector;
  V r[lane_count];
  for (int lane = 0; lane < lane_count; ++lane) r[lane] = Lanes::load(node + row * local[lane]).v;
  // Pairs of rows, then pairs of pairs: columns 0 2 4 6 from the low halves, 1 3 5 7 from the high ones.
  V low[4], high[4];
  for (int i = 0; i < 4; ++i) {
    low[i] = __builtin_shufflevector(r[2 * i], r[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    high[i] = __builtin_shufflevector(r[2 * i], r[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  const auto columns_04 = [](V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13); };
  const auto columns_26 = [](V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15); };
  const auto first = columns_04;
  const auto second = columns_26;
  const V a = columns_04(low[0], low[1]), b = columns_04(low[2], low[3]);
  const V c = columns_26(low[0], low[1]), d = columns_26(low[2], low[3]);
  const V e = columns_04(high[0], high[1]), f = columns_04(high[2], high[3]);
  return {{Lanes(first(a, b)), Lanes(first(e, f)), Lanes(first(c, d))},
          {Lanes(second(a, b)), Lanes(second(e, f)), Lanes(second(c, d))}};
}

/// Adds the integer forces of one node of eight elements to the local rows.
inline void scatter(std::int64_t* force, const std::uint16_t* local, Integers x, Integers y, Integers z) {
  const Integers zero = {};
  const Integers xy_even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Integers xy_odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  const Integers z_even = __builtin_shufflevector(z, zero, 0, 8, 2, 10, 4, 12, 6, 14);
  const Integers z_odd = __builtin_shufflevector(z, zero, 1, 9, 3, 11, 5, 13, 7, 15);
  const auto add = [&](int lane, Quad f) {
    Quad& to = *reinterpret_cast<Quad*>(force + force_row * local[lane]);
    to += f;
  };
  const auto add_lanes = [&](Integers xy, Integers zz, int odd) {
    const Integers front = __builtin_shufflevector(xy, zz, 0, 1, 8, 9, 2, 3, 10, 11);
    const Integers back = __builtin_shufflevector(xy, zz, 4, 5, 12, 13, 6, 7, 14, 15);
    add(odd, __builtin_shufflevector(front, front, 0, 1, 2, 3));
    add(odd + 2, __builtin_shufflevector(front, front, 4, 5, 6, 7));
    add(odd + 4, __builtin_shufflevector(back, back, 0, 1, 2, 3));
    add(odd + 6, __builtin_shufflevector(back, back, 4, 5, 6, 7));
  };
  add_lanes(xy_even, z_even, 0);
  add_lanes(xy_odd, z_odd, 1);
}

}  // namespace cleave::discretisation::fem
