#include "discretisation/curve_order.hpp"

#include <algorithm>
#include <numeric>

namespace cleave::discretisation {
namespace {

constexpr int bit_count = 20;

}  // namespace

std::uint64_t hilbert_index(const std::uint32_t x[3]) {
  std::uint32_t a[3] = {x[0], x[1], x[2]};
  // Undo the turns of the curve, from the coarsest cell to the finest.
  for (std::uint32_t q = 1u << (bit_count - 1); q > 1; q >>= 1) {
    const std::uint32_t below = q - 1;
    for (std::uint32_t& axis : a) {
      if (axis & q) {
        a[0] ^= below;
      } else {
        const std::uint32_t swapped = (a[0] ^ axis) & below;
        a[0] ^= swapped;
        axis ^= swapped;
      }
    }
  }
  // Gray code to binary.
  a[1] ^= a[0];
  a[2] ^= a[1];
  std::uint32_t flip = 0;
  for (std::uint32_t q = 1u << (bit_count - 1); q > 1; q >>= 1)
    if (a[2] & q) flip ^= q - 1;
  for (std::uint32_t& axis : a) axis ^= flip;
  // Interleave, first axis first.
  std::uint64_t index = 0;
  for (int bit = bit_count - 1; bit >= 0; --bit)
    for (const std::uint32_t axis : a) index = index << 1 | (axis >> bit & 1u);
  return index;
}

std::vector<model::Index> curve_order(const std::vector<model::Index>& node, int nodes_per_element,
                                      const std::vector<double>& position) {
  const std::size_t count = node.size() / static_cast<std::size_t>(nodes_per_element);
  std::vector<double> centre(3 * count, 0.0);
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  for (std::size_t e = 0; e < count; ++e)
    for (int i = 0; i < 3; ++i) {
      for (int a = 0; a < nodes_per_element; ++a)
        centre[3 * e + i] += position[3 * node[e * nodes_per_element + a] + i] / nodes_per_element;
      low[i] = std::min(low[i], centre[3 * e + i]);
      high[i] = std::max(high[i], centre[3 * e + i]);
    }
  double extent = 0.0;
  for (int i = 0; i < 3; ++i) extent = std::max(extent, high[i] - low[i]);
  const double cells = extent > 0.0 ? ((1u << bit_count) - 1) / extent : 0.0;

  std::vector<std::uint64_t> key(count);
  for (std::size_t e = 0; e < count; ++e) {
    std::uint32_t cell[3];
    for (int i = 0; i < 3; ++i) cell[i] = static_cast<std::uint32_t>((centre[3 * e + i] - low[i]) * cells);
    key[e] = hilbert_index(cell);
  }
  std::vector<model::Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](model::Index a, model::Index b) { return key[a] < key[b]; });
  return order;
}

}  // namespace cleave::discretisation
