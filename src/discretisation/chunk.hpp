#pragma once
/// Elements of a block cut into chunks: the unit of work of a thread and of the memory that stays in cache.
///
/// A chunk copies what it needs of its nodes into local memory, sums forces there, and gives them to the
/// global sum at its end. Chunks follow a space-filling curve. A thread takes them in groups of neighbours,
/// so most nodes belong to one group and are added to directly; sums of nodes between groups are set aside
/// and added together, node by node, when all chunks are done. The number and content of chunks and groups do
/// not depend on the number of threads.

#include <cstdint>
#include <vector>

#include "base/array.hpp"
#include "base/lanes.hpp"
#include "discretisation/formulation.hpp"

namespace cleave::discretisation {

/// One chunk: batches [first_batch, first_batch + batch_count) of the block.
struct Chunk {
  std::int32_t first_batch = 0, batch_count = 0;
  std::int32_t first_node = 0;  ///< offset into ChunkTable::nodes
  std::int32_t own_count = 0;   ///< nodes no chunk of another group touches; they come first
  std::int32_t node_count = 0;  ///< own and shared
  std::int32_t first_slot = 0;  ///< where the sums of its shared nodes are set aside
};

/// Nodes that several chunks or groups touch, and where each chunk keeps what it has for them.
struct SharedNodes {
  std::vector<Index> node;          ///< in the order of the chunks that meet them first
  std::vector<std::int32_t> first;  ///< [node + 1], offsets into place
  std::vector<std::int32_t> place;  ///< in the order of chunks
};

/// The elements of a block in curve order, cut into chunks.
struct ChunkTable {
  int nodes_per_element = 0;
  std::size_t element_count = 0;  ///< without padding
  std::size_t batch_count = 0;
  std::vector<Id> id;               ///< [element], block order
  std::vector<Index> connectivity;  ///< [element][node], block order, nodes of the model
  std::vector<Chunk> chunks;
  std::vector<Index> nodes;          ///< of all chunks, see Chunk
  base::Array<std::uint16_t> local;  ///< [batch][node][lane], position in the chunk's nodes
  int chunks_per_group = 1;
  SharedNodes between_chunks;  ///< places are offsets into `nodes`
  SharedNodes between_groups;  ///< places are slots, see Chunk::first_slot
  int largest_node_count = 0;  ///< of any chunk

  static constexpr int batches_per_chunk = 64;
  /// A block has at least so many groups, if it has so many chunks: enough to keep threads evenly busy.
  static constexpr int least_group_count = 128;
  static constexpr int most_chunks_per_group = 16;

  /// Lanes of the last batch beyond the last element repeat it.
  explicit ChunkTable(const PartElements& elements);
  ChunkTable() = default;

  /// Element in a lane of a batch; padding gives the last element.
  std::size_t element(std::size_t batch, int lane) const {
    const std::size_t e = batch * base::lane_count + static_cast<std::size_t>(lane);
    return e < element_count ? e : element_count - 1;
  }
  double bytes() const;
};

}  // namespace cleave::discretisation
