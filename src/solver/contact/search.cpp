#include "solver/contact/search.hpp"

#include <array>

#include "base/threads.hpp"

namespace cleave::solver {
namespace {

constexpr std::size_t grain = 4096;

/// Every third bit of the result is a bit of the argument, of which 21 count.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

struct Coded {
  std::uint64_t code;
  std::int32_t item;
};

/// Stable sort by code, 11 bits at a time.
void radix_sort(std::vector<Coded>& keys) {
  std::vector<Coded> other(keys.size());
  for (int shift = 0; shift < 63; shift += 11) {
    std::array<std::uint32_t, 2049> first{};
    for (const Coded& key : keys) ++first[(key.code >> shift & 2047) + 1];
    if (std::find(first.begin(), first.end(), keys.size()) != first.end()) continue;  // all the same digit
    for (std::size_t d = 0; d < 2048; ++d) first[d + 1] += first[d];
    for (const Coded& key : keys) other[first[key.code >> shift & 2047]++] = key;
    keys.swap(other);
  }
}

}  // namespace

void Tree::build(std::span<const Bounds> boxes) {
  order_.clear();
  levels_.clear();
  const std::size_t count = boxes.size();
  if (count == 0) return;

  std::vector<Bounds> partial((count + grain - 1) / grain, Bounds::nothing());
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) partial[begin / grain].add(boxes[i]);
  });
  Bounds all = Bounds::nothing();
  for (const Bounds& part : partial) all.add(part);
  double size = 0.0;
  for (int i = 0; i < 3; ++i) size = std::max(size, all.high[i] - all.low[i]);
  const double scale = size > 0.0 ? 2097151.0 / size : 0.0;

  std::vector<Coded> keys(count);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::uint64_t code = 0;
      for (int k = 0; k < 3; ++k) {
        const double middle = 0.5 * (boxes[i].low[k] + boxes[i].high[k]) - all.low[k];
        code |= spread(static_cast<std::uint64_t>(middle * scale)) << k;
      }
      keys[i] = {code, static_cast<std::int32_t>(i)};
    }
  });
  radix_sort(keys);
  order_.resize(count);
  items_.resize(count);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      order_[i] = keys[i].item;
      items_[i] = boxes[static_cast<std::size_t>(keys[i].item)];
    }
  });

  const std::vector<Bounds>* below = &items_;
  do {
    std::vector<Bounds> level((below->size() + leaf - 1) / leaf, Bounds::nothing());
    base::for_each_range(level.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t k = leaf * i; k < std::min(leaf * (i + 1), below->size()); ++k)
          level[i].add((*below)[k]);
    });
    levels_.push_back(std::move(level));
    below = &levels_.back();
  } while (below->size() > 1);
}

}  // namespace cleave::solver
