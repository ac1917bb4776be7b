#pragma once
/// Which boxes meet: a hierarchy of boxes over items in the order of a space-filling curve.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace cleave::solver {

struct Bounds {
  double low[3], high[3];

  static Bounds nothing() { return {{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}}; }
  void add(const Bounds& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  void grow(double by) {
    for (int i = 0; i < 3; ++i) {
      low[i] -= by;
      high[i] += by;
    }
  }
  bool meets(const Bounds& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

/// A tree of boxes. Building it costs O(n): Morton codes (Morton 1966), radix sort, and boxes of neighbours
/// joined level by level (Karras 2012 for the idea). A query costs O(log n) where few boxes overlap.
class Tree {
 public:
  void build(std::span<const Bounds> boxes);
  /// Calls visit(item) for every item whose box meets the query, in no particular order.
  template <class Visit>
  void query(const Bounds& box, const Visit& visit) const {
    if (order_.empty()) return;
    descend(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t leaf = 4;  // items of a leaf, and branches of a node

  template <class Visit>
  void descend(std::size_t level, std::size_t at, const Bounds& box, const Visit& visit) const {
    if (!levels_[level][at].meets(box)) return;
    const std::size_t begin = leaf * at;
    if (level == 0) {
      const std::size_t end = std::min(begin + leaf, order_.size());
      for (std::size_t i = begin; i < end; ++i)
        if (items_[i].meets(box)) visit(order_[i]);
      return;
    }
    const std::size_t end = std::min(begin + leaf, levels_[level - 1].size());
    for (std::size_t i = begin; i < end; ++i) descend(level - 1, i, box, visit);
  }

  std::vector<std::int32_t> order_;          // items along the curve
  std::vector<Bounds> items_;                // their boxes, in that order
  std::vector<std::vector<Bounds>> levels_;  // leaves first; the last has one box
};

}  // namespace cleave::solver
