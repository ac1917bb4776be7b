#pragma once
/// Sums over many entities whose bits do not depend on the number of threads.

#include <vector>

#include "base/threads.hpp"

namespace cleave::solver {

/// Sum of body(begin, end) over [0, count) in ranges of `grain`, added in the order of the ranges.
template <class Value, class Body>
Value ordered_sum(std::size_t count, std::size_t grain, const Body& body) {
  std::vector<Value> partial((count + grain - 1) / grain);
  base::for_each_range(
      count, grain, [&](std::size_t begin, std::size_t end) { partial[begin / grain] = body(begin, end); });
  Value total{};
  for (const Value& value : partial) total += value;
  return total;
}

}  // namespace cleave::solver
