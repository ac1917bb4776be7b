#pragma once
/// What touches around a face count as none of their depth.

#include <algorithm>
#include <vector>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// Least offsets of the touches of the step before by face, for faces against faces: sliding bodies hand
/// their pressure from face to face.
class Offsets {
 public:
  static constexpr double none = 1e300;

  void take(const Past& past, const model::Contact& contact) {
    for (std::vector<double>* side : {&a_, &b_}) std::fill(side->begin(), side->end(), none);
    if (contact.soft != 2) return;
    single_ = contact.search == model::Contact::Search::single;
    for (const Remembered& one : past.all()) {
      lower(a_, one.key[0], one.offset);
      lower(single_ ? a_ : b_, one.key[1], one.offset);
    }
  }
  /// The least of both faces; `none` where neither touched anything, and for nodes.
  double around(const Touch& touch) const {
    return std::min(at(a_, touch.key[0]), at(single_ ? a_ : b_, touch.key[1]));
  }

 private:
  static void lower(std::vector<double>& side, double face, double offset) {
    const auto at = static_cast<std::size_t>(face);
    if (at >= side.size()) side.resize(at + 1, none);
    side[at] = std::min(side[at], offset);
  }
  static double at(const std::vector<double>& side, std::int64_t face) {
    const auto at = static_cast<std::size_t>(face);
    return at < side.size() ? side[at] : none;
  }
  std::vector<double> a_, b_;  // [face]
  bool single_ = false;
};

}  // namespace cleave::solver
