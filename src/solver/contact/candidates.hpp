#pragma once
/// Which faces each thing of the other side may meet while the boxes of a Reach hold.

#include <algorithm>
#include <vector>

#include "base/threads.hpp"
#include "solver/contact/reach.hpp"
#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Numbers of both lists, ascending, each once.
inline std::vector<Index> united(std::span<const Index> first, std::span<const Index> second) {
  std::vector<Index> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

class Candidates {
 public:
  bool holds(const Moment& now) const { return reach_.holds(now); }
  void forget() { reach_.forget(); }

  /// Boxes around the nodes, then a tree of boxes around the active faces; see Reach::renew.
  /// @param depth  by which the box of a face grows, in its thicknesses [-]
  void place(const Moment& now, std::span<const Index> nodes, double margin, double sweep,
             const Surface& faces, double depth) {
    reach_.renew(now, nodes, margin, sweep);
    const auto& active = faces.active();
    std::vector<Bounds> boxes(active.size());
    base::for_each_range(active.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        boxes[i] = box(faces.faces()[static_cast<std::size_t>(active[i])], depth);
    });
    tree_.build(boxes);
  }
  const Reach& reach() const { return reach_; }
  Bounds box(const Face& face, double depth) const {
    Bounds box = reach_.box_of(face.node);
    box.grow(depth * face.thickness);
    return box;
  }

  /// Lists, for each of the things, the active faces whose boxes meet its own and that it may meet.
  /// @param box_of  (thing) its box
  /// @param may     (thing, face) may these two ever touch?
  template <class BoxOf, class May>
  void list(std::span<const std::int32_t> things, const Surface& faces, std::size_t grain,
            const BoxOf& box_of, const May& may) {
    struct Part {
      std::vector<std::int32_t> who, first, list;
    };
    const auto& active = faces.active();
    std::vector<Part> parts((things.size() + grain - 1) / grain);
    base::for_each_range(things.size(), grain, [&](std::size_t begin, std::size_t end) {
      Part& part = parts[begin / grain];
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t before = part.list.size();
        tree_.query(box_of(things[i]), [&](std::int32_t item) {
          const std::int32_t f = active[static_cast<std::size_t>(item)];
          if (may(things[i], f)) part.list.push_back(f);
        });
        if (part.list.size() == before) continue;
        std::sort(part.list.begin() + static_cast<std::ptrdiff_t>(before), part.list.end());
        part.who.push_back(things[i]);
        part.first.push_back(static_cast<std::int32_t>(before));
      }
    });
    who_.clear();
    first_.clear();
    list_.clear();
    for (const Part& part : parts) {
      const auto shift = static_cast<std::int32_t>(list_.size());
      who_.insert(who_.end(), part.who.begin(), part.who.end());
      for (const std::int32_t f : part.first) first_.push_back(f + shift);
      list_.insert(list_.end(), part.list.begin(), part.list.end());
    }
    first_.push_back(static_cast<std::int32_t>(list_.size()));
  }

  /// Appends the touches of all listed things in their order, whatever the threads.
  /// @param look  (thing, its faces ascending, std::vector<Touch>& to append to)
  template <class Look>
  void touches(std::size_t grain, std::vector<Touch>& out, const Look& look) const {
    std::vector<std::vector<Touch>> found((who_.size() + grain - 1) / grain);
    base::for_each_range(who_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto from = static_cast<std::size_t>(first_[i]), to = static_cast<std::size_t>(first_[i + 1]);
        look(who_[i], std::span<const std::int32_t>(list_).subspan(from, to - from), found[begin / grain]);
      }
    });
    for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
  }

 private:
  Reach reach_;
  Tree tree_;
  std::vector<std::int32_t> who_;           // things near any face
  std::vector<std::int32_t> first_, list_;  // their faces, one list after the other
};

}  // namespace cleave::solver
