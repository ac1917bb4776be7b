#pragma once
/// Which faces each thing of the other side may meet while the boxes of a Reach hold.

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/threads.hpp"
#include "solver/contact/reach.hpp"
#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Numbers of both lists, ascending, each once; both are ascending.
inline std::vector<Index> united(std::span<const Index> first, std::span<const Index> second) {
  std::vector<Index> all;
  all.reserve(first.size() + second.size());
  std::set_union(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(all));
  return all;
}

class Candidates {
 public:
  /// Are the lists whole: every node in its box, the faces of both surfaces those that were listed?
  bool hold(const Moment& now, const Surface& a, const Surface& b) const {
    return a.version() == version_a_ && b.version() == version_b_ && reach_.holds(now);
  }

  /// Boxes around the nodes; see Reach::renew.
  void place(const Moment& now, std::span<const Index> nodes, double margin, double sweep, const Surface& a,
             const Surface& b) {
    reach_.renew(now, nodes, margin, sweep);
    version_a_ = a.version();
    version_b_ = b.version();
  }
  const Reach& reach() const { return reach_; }
  Bounds box(const Face& face, double depth) const {
    Bounds box = reach_.box_of(face.node);
    box.grow(depth * face.thickness + face.offset + beyond_);
    return box;
  }
  /// How far the surface of the things may lie from their nodes [length].
  void things_reach(double beyond) { beyond_ = beyond; }

  /// Lists, for each of the things, the active faces whose boxes meet its own and that it may meet.
  /// @param depth   by which the box of a face grows, in its thicknesses [-]
  /// @param box_of  (thing) its box
  /// @param may     (thing, face) may these two ever touch?
  template <class BoxOf, class May>
  void list(std::span<const std::int32_t> things, const Surface& faces, double depth, std::size_t grain,
            const BoxOf& box_of, const May& may) {
    // Only faces within the box of all things matter, and only things within the box of those faces.
    thing_boxes_.resize(things.size());
    const Bounds reached = fill(thing_boxes_, [&](std::size_t i) { return box_of(things[i]); });
    const auto& active = faces.active();
    face_boxes_.resize(active.size());
    fill(face_boxes_,
         [&](std::size_t i) { return box(faces.faces()[static_cast<std::size_t>(active[i])], depth); });
    faces_.clear();
    Bounds met = Bounds::nothing();
    for (std::size_t i = 0; i < active.size(); ++i)
      if (reached.meets(face_boxes_[i])) {
        met.add(face_boxes_[i]);
        face_boxes_[faces_.size()] = face_boxes_[i];
        faces_.push_back(active[i]);
      }
    tree_.build(std::span<const Bounds>(face_boxes_).first(faces_.size()));

    const std::size_t count = (things.size() + grain - 1) / grain;
    if (parts_.size() < count) parts_.resize(count);
    base::for_each_range(things.size(), grain, [&](std::size_t begin, std::size_t end) {
      Part& part = parts_[begin / grain];
      part.clear();
      for (std::size_t i = begin; i < end; ++i) {
        if (!met.meets(thing_boxes_[i])) continue;
        const std::size_t before = part.list.size();
        tree_.query(thing_boxes_[i], [&](std::int32_t item) {
          const std::int32_t f = faces_[static_cast<std::size_t>(item)];
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
    for (std::size_t p = 0; p < count; ++p) {
      const Part& part = parts_[p];
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
  void touches(std::size_t grain, std::vector<Touch>& out, const Look& look) {
    if (base::thread_count() == 1) {  // no need to put together what is in order already
      for (std::size_t i = 0; i < who_.size(); ++i) look(who_[i], faces_of(i), out);
      return;
    }
    const std::size_t count = (who_.size() + grain - 1) / grain;
    if (found_.size() < count) found_.resize(count);
    base::for_each_range(who_.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Touch>& found = found_[begin / grain];
      found.clear();
      for (std::size_t i = begin; i < end; ++i) look(who_[i], faces_of(i), found);
    });
    for (std::size_t p = 0; p < count; ++p) out.insert(out.end(), found_[p].begin(), found_[p].end());
  }

  /// Calls visit(thing, its faces ascending) for all listed things.
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < who_.size(); ++i) visit(who_[i], faces_of(i));
  }

 private:
  /// Of the i-th thing near any face.
  std::span<const std::int32_t> faces_of(std::size_t i) const {
    const auto from = static_cast<std::size_t>(first_[i]), to = static_cast<std::size_t>(first_[i + 1]);
    return std::span<const std::int32_t>(list_).subspan(from, to - from);
  }

  /// What one range of things lists.
  struct Part {
    std::vector<std::int32_t> who, first, list;
    void clear() {
      who.clear();
      first.clear();
      list.clear();
    }
  };

  /// Fills in boxes by their number. @return the box of all
  template <class Box>
  static Bounds fill(std::vector<Bounds>& boxes, const Box& box) {
    constexpr std::size_t grain = 1024;
    std::vector<Bounds> partial((boxes.size() + grain - 1) / grain, Bounds::nothing());
    base::for_each_range(boxes.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) partial[begin / grain].add(boxes[i] = box(i));
    });
    Bounds all = Bounds::nothing();
    for (const Bounds& some : partial) all.add(some);
    return all;
  }

  double beyond_ = 0.0;
  Reach reach_;
  std::int64_t version_a_ = -1, version_b_ = -1;
  Tree tree_;
  std::vector<std::int32_t> faces_;         // in the tree
  std::vector<std::int32_t> who_;           // things near any face
  std::vector<std::int32_t> first_, list_;  // their faces, one list after the other
  // Scratch, kept so that a cycle allocates nothing.
  std::vector<Bounds> thing_boxes_, face_boxes_;
  std::vector<Part> parts_;
  std::vector<std::vector<Touch>> found_;
};

}  // namespace cleave::solver
