#pragma once
/// Whether two faces that come to lie behind each other from the side carry on what others did.

#include <algorithm>
#include <vector>

#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// A face and the active faces that share a node with it, ascending.
inline std::vector<std::int64_t> with_neighbours(const Surface& surface, std::int32_t face) {
  std::vector<std::int64_t> all{face};
  for (const Index node : surface.faces()[static_cast<std::size_t>(face)].node)
    for (const std::int32_t other : surface.faces_at(node)) all.push_back(other);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The least offset of the pairs of the step before that push and have one of the two faces and a neighbour
/// of the other; `out_of_reach` where there is none. Neighbours of both do not count, nor do pairs that are
/// much less deep than this one: then it is a far side.
/// @param depth  of the pair f, g, at least, a step ago [length]
inline double handed_on(const Past& past, const Surface& a, const Surface& b, std::int32_t f, std::int32_t g,
                        double depth) {
  constexpr double as_deep = 3.0;
  double least = out_of_reach;
  const auto look = [&](std::int32_t one, const std::vector<std::int64_t>& others) {
    for (const Remembered& pair : past.of(one))
      if (depth <= as_deep * pair.depth &&
          std::binary_search(others.begin(), others.end(), static_cast<std::int64_t>(pair.key[1])))
        least = std::min(least, pair.offset);
  };
  const auto around_f = with_neighbours(a, f), around_g = with_neighbours(b, g);
  look(f, around_g);
  for (const std::int64_t one : around_f) look(static_cast<std::int32_t>(one), {g});
  if (&a != &b) return least;
  look(g, around_f);  // a single surface keeps each pair in the order of its numbers
  for (const std::int64_t one : around_g) look(static_cast<std::int32_t>(one), {f});
  return least;
}

}  // namespace cleave::solver
