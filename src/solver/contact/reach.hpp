#pragma once
/// How long a list of neighbours stays whole: boxes that hold where nodes are going to be.

#include "solver/action.hpp"
#include "solver/contact/search.hpp"
#include "solver/contact/surface.hpp"

namespace cleave::solver {

/// Each node has a box around where it was a step ago, where it is, and where it will be if it goes on at its
/// velocity, seen from a frame that moves with the mean velocity, and a margin. While every node is in its
/// box, no pair of things that can meet is missing from lists made with these boxes, however fast they are.
class Reach {
 public:
  /// @param margin  of the boxes [length]
  /// @param sweep   how far the fastest node may travel in its box [length]
  void renew(const Moment& now, std::span<const Index> nodes, double margin, double sweep);
  /// Is every node in its box?
  bool holds(const Moment& now) const;

  const Bounds& box(Index node) const { return boxes_[static_cast<std::size_t>(node)]; }
  template <class Nodes>
  Bounds box_of(const Nodes& nodes) const {
    Bounds all = Bounds::nothing();
    for (const Index node : nodes) all.add(box(node));
    return all;
  }

 private:
  std::vector<Index> nodes_;
  std::vector<Bounds> boxes_;  // [node], set for those in nodes_
  Vector drift_{0, 0, 0};      // mean velocity
  double time_ = 0.0;
};

}  // namespace cleave::solver
