#pragma once
/// The first tents of a run, kept for a picture of the spacetime mesh.

#include <mutex>
#include <vector>

#include "discretisation/spacetime/front.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

/// Keeps the tents that come first in the order (time of the foot, rank of the vertex), in which a single
/// worker could have solved them: the same tents for any number of threads.
template <int D>
class TentAlbum {
 public:
  using Patch = discretisation::spacetime::Patch<D>;
  using Key = discretisation::spacetime::Key;

  explicit TentAlbum(int most) : most_(static_cast<std::size_t>(most)) {}

  /// Any thread.
  void add(const Key& key, const Patch& patch);

  /// The spacetime elements of the tents: triangles in (x, speed * t) or tetrahedra in (x, y, speed * t),
  /// with the field "order" of their tent, from 1. Empty in three dimensions, which a picture has not enough
  /// of.
  /// `part` is the number of the material.
  /// @param element_of_simplex  user's numbers
  CellFields cells(double speed, std::span<const model::Id> element_of_simplex) const;

 private:
  struct Tent {
    Key key;
    std::vector<discretisation::spacetime::PatchElement<D>> elements;
    bool operator<(const Tent& other) const { return key < other.key; }
  };
  std::size_t most_;
  std::mutex mutex_;
  std::vector<Tent> tents_;  ///< a heap, the last on top
};

}  // namespace cleave::solver
