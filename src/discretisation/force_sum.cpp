#include "discretisation/force_sum.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/threads.hpp"

namespace cleave::discretisation {
namespace {

constexpr int value_bits =
    51;  // |integer| of one contribution stays below 2^51, where the magic number works
constexpr int growth_bits = 3;  // room for contributions to grow from one step to the next
constexpr int level_bits = 32;  // from one coarser sum to the next
constexpr std::size_t grain = 1 << 16;

}  // namespace

void ForceSum::resize(std::size_t node_count) {
  sum_.assign(3 * node_count, 0);
  clear_ = true;
  coarse_.clear();
}

void ForceSum::begin(double expected_largest) {
  CLEAVE_ASSERT(std::isfinite(expected_largest) && expected_largest >= 0.0, "a force scale is finite");
  // limit_ is the power of two at least 2^growth_bits above what is expected.
  expected_ = expected_largest > 0.0 ? std::max(expected_largest, 1e-250) : 1.0;
  int exponent = 0;
  std::frexp(expected_, &exponent);
  limit_ = std::ldexp(1.0, exponent + growth_bits);
  scale_ = std::ldexp(1.0, value_bits - exponent - growth_bits);
  largest_.store(0.0, std::memory_order_relaxed);
  coarse_.clear();
  if (!clear_)
    base::for_each_range(sum_.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::fill(sum_.begin() + begin, sum_.begin() + end, std::int64_t{0});
    });
  clear_ = false;
}

void ForceSum::add_value(std::int32_t node, int component, double value) {
  const double size = std::fabs(value);
  CLEAVE_ASSERT(std::isfinite(value), "forces are checked before they are summed");
  report_largest(size);
  if (size < limit_) return add(node, component, quantum(value), true);
  int level = 0;
  double scale = scale_, limit = limit_;
  while (size >= limit) {
    ++level;
    scale = std::ldexp(scale, -level_bits);
    limit = std::ldexp(limit, level_bits);
  }
  const std::int64_t integer = std::llrint(value * scale);
  const std::lock_guard guard(coarse_lock_);
  coarse_[{3 * static_cast<std::int64_t>(node) + component, level}] += integer;
}

void ForceSum::report_largest(double value) {
  double seen = largest_.load(std::memory_order_relaxed);
  while (value > seen && !largest_.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

void ForceSum::report_magnitude(std::int64_t bits) {
  if (bits == 0) return;
  const int width = std::bit_width(static_cast<std::uint64_t>(bits));
  report_largest(std::ldexp(1.0 / scale_, width - 1));
}

double ForceSum::largest() const {
  return std::max(largest_.load(std::memory_order_relaxed), 0.5 * expected_);
}

double ForceSum::value(std::int32_t node, int component) const {
  const std::int64_t slot = 3 * static_cast<std::int64_t>(node) + component;
  double result = static_cast<double>(sum_[static_cast<std::size_t>(slot)]) / scale_;
  for (auto it = coarse_.lower_bound({slot, 0}); it != coarse_.end() && it->first.first == slot; ++it)
    result += static_cast<double>(it->second) * std::ldexp(1.0 / scale_, level_bits * it->first.second);
  return result;
}

void ForceSum::values(base::Array<double>& out) const {
  out.resize(sum_.size());
  base::for_each_range(sum_.size() / 3, grain,
                       [&](std::size_t begin, std::size_t end) { values(begin, end, &out[3 * begin]); });
}

void ForceSum::values(std::size_t first, std::size_t last, double* out) const {
  const double unit = 1.0 / scale_;  // a power of two: as exact as the division
  const std::int64_t* from = sum_.data() + 3 * first;
  for (std::size_t i = 0; i < 3 * (last - first); ++i) out[i] = static_cast<double>(from[i]) * unit;
  if (coarse_.empty()) return;
  const auto begin = static_cast<std::int64_t>(3 * first), end = static_cast<std::int64_t>(3 * last);
  for (auto it = coarse_.lower_bound({begin, 0}); it != coarse_.end() && it->first.first < end; ++it)
    out[it->first.first - begin] =
        value(static_cast<std::int32_t>(it->first.first / 3), static_cast<int>(it->first.first % 3));
}

void ForceSum::take(std::size_t first, std::size_t last, double* out) {
  values(first, last, out);
  std::fill(sum_.begin() + static_cast<std::ptrdiff_t>(3 * first),
            sum_.begin() + static_cast<std::ptrdiff_t>(3 * last), std::int64_t{0});
}

}  // namespace cleave::discretisation
