#pragma once
/// A tree of bounding boxes: which simplices are near a point or a face.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "discretisation/spacetime/geometry.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
struct Box {
  Point<D> low, high;

  Box() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const Point<D>& x) {
    for (std::size_t k = 0; k < D; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  void add(const Box& box) {
    add(box.low);
    add(box.high);
  }
  double size() const { return distance(low, high); }
  void grow(double by) {
    for (std::size_t k = 0; k < D; ++k) {
      low[k] -= by;
      high[k] += by;
    }
  }
  bool meets(const Box& other) const {
    for (std::size_t k = 0; k < D; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }
};

template <int D>
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box<D>> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!boxes_.empty()) split(0, boxes_.size());
  }

  /// Calls visit(i) for every box i that meets `query`.
  template <class Visit>
  void visit(const Box<D>& query, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::vector<std::size_t> open{0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!node.box.meets(query)) continue;
      if (node.right == 0) {
        for (std::size_t i = node.begin; i < node.end; ++i)
          if (boxes_[order_[i]].meets(query)) visit(order_[i]);
      } else {
        open.push_back(node.right);
        open.push_back(node.left);
      }
    }
  }

 private:
  struct Node {
    Box<D> box;
    std::size_t begin = 0, end = 0, left = 0, right = 0;
  };

  std::size_t split(std::size_t begin, std::size_t end) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Box<D> box;
    for (std::size_t i = begin; i < end; ++i) box.add(boxes_[order_[i]]);
    nodes_[at].box = box;
    nodes_[at].begin = begin;
    nodes_[at].end = end;
    if (end - begin > 4) {
      std::size_t axis = 0;
      for (std::size_t k = 1; k < D; ++k)
        if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
      const std::size_t middle = (begin + end) / 2;
      const auto place = [&](std::size_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
      std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                       order_.begin() + static_cast<std::ptrdiff_t>(middle),
                       order_.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
      const std::size_t left = split(begin, middle), right = split(middle, end);
      nodes_[at].left = left;
      nodes_[at].right = right;
    }
    return at;
  }

  std::vector<Box<D>> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace cleave::discretisation::spacetime
