#pragma once
/// Nodal forces summed as 64-bit integers: the order of contributions cannot matter.
///
/// A contribution is scaled by a power of two and rounded once; integer addition is associative and
/// commutative, so threads, ranks and chunks give the same bits, and equal and opposite contributions
/// cancel exactly. The scale comes from the largest contribution of the step before, with room for 2^10
/// contributions of that size per node and a growth of 2^3 per step; a contribution outside that range goes
/// to a second, coarser sum (a decision about the one number alone, so still associative).

#include <atomic>
#include <bit>
#include <cstdint>
#include <map>
#include <mutex>

#include "base/array.hpp"
#include "base/lanes.hpp"

namespace cleave::discretisation {

class ForceSum {
 public:
  explicit ForceSum(std::size_t node_count = 0) { resize(node_count); }
  void resize(std::size_t node_count);

  /// Clears the sums and chooses the scale.
  /// @param expected_largest  largest single contribution to expect [force]; 0 if unknown
  void begin(double expected_largest);

  /// Scaled integer of one contribution, for |value| < limit(). Two roundings never happen: one multiply by a
  /// power of two (exact) and one addition that rounds to the nearest integer.
  std::int64_t quantum(double value) const {
    return std::bit_cast<std::int64_t>(value * scale_ + magic) - magic_bits;
  }
  /// The same for eight lanes at once.
  base::Mask::Vector quantum(base::Lanes value) const {
    const base::Lanes shifted = value * base::Lanes(scale_) + base::Lanes(magic);
    return std::bit_cast<base::Mask::Vector>(shifted.v) - magic_bits;
  }
  double limit() const { return limit_; }  ///< largest |value| that quantum() may be given [force]

  /// Adds integers of quantum(). `shared` nodes (touched by more than one chunk) are added atomically:
  /// integers make that legal.
  void add(std::int32_t node, int component, std::int64_t integer, bool shared) {
    std::int64_t& slot = sum_[3 * static_cast<std::size_t>(node) + component];
    if (shared)
      std::atomic_ref<std::int64_t>(slot).fetch_add(integer, std::memory_order_relaxed);
    else
      slot += integer;
  }
  /// Adds any value, from any thread: slow path for loads, walls and contributions beyond the limit.
  void add_value(std::int32_t node, int component, double value);

  /// Reports the largest |contribution| of a chunk; a max, so order does not matter.
  void report_largest(double value);
  double largest() const { return largest_.load(std::memory_order_relaxed); }

  /// The sum at a node [force].
  double value(std::int32_t node, int component) const;
  /// All sums as doubles, [node][3].
  void values(base::Array<double>& out) const;

 private:
  static constexpr double magic =
      6755399441055744.0;  // 1.5 * 2^52: adding it leaves the integer in the low bits
  static constexpr std::int64_t magic_bits = std::bit_cast<std::int64_t>(magic);

  base::Array<std::int64_t> sum_;                // [node][3]
  std::map<std::int64_t, std::int64_t> coarse_;  // rare: slot -> integer of the coarser scale
  mutable std::mutex coarse_lock_;
  double scale_ = 1.0, limit_ = 0.0;
  std::atomic<double> largest_{0.0};
};

}  // namespace cleave::discretisation
