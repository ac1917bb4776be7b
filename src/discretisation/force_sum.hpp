#pragma once
/// Nodal forces summed as 64-bit integers: the order of contributions cannot matter.
///
/// A contribution is scaled by a power of two and rounded once; integer addition is associative and
/// commutative, so threads, ranks and chunks give the same bits, and equal and opposite contributions
/// cancel exactly. The scale comes from the largest contribution of the step before, with room for a growth
/// of 2^3 per step and 2^12 contributions of that size per node; a contribution outside that range goes to a
/// coarser sum (which one is a decision about the one number alone, so still associative).

#include <atomic>
#include <bit>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

#include "base/array.hpp"
#include "base/lanes.hpp"

namespace cleave::discretisation {

class ForceSum {
 public:
  /// Eight integers whose sums wrap around instead of overflowing.
  using Wrapping = std::uint64_t __attribute__((vector_size(64)));

  explicit ForceSum(std::size_t node_count = 0) { resize(node_count); }
  void resize(std::size_t node_count);

  /// Clears the sums and chooses the scale, a function of the argument alone (a restart gets the same bits).
  /// @param expected_largest  largest single contribution to expect [force]; 0 if unknown
  void begin(double expected_largest);

  /// Scaled integer of one contribution, for |value| < limit(). Two roundings never happen: one multiply by a
  /// power of two (exact) and one addition that rounds to the nearest integer.
  /// A value beyond the limit, or NaN, gives some integer that out_of_range() shows: the difference wraps.
  std::int64_t quantum(double value) const {
    return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(value * scale_ + magic) - magic_bits);
  }
  /// The same for eight lanes at once.
  base::Mask::Vector quantum(base::Lanes value) const {
    const base::Lanes shifted = value * base::Lanes(scale_) + base::Lanes(magic);
    return (base::Mask::Vector)(std::bit_cast<Wrapping>(shifted.v) - magic_bits);
  }
  double limit() const { return limit_; }  ///< |value| given to quantum() must be below it [force]
  /// Folds integers of quantum() into the bits a chunk reports: or-ing keeps the highest bit, which is all
  /// the scale needs, costs less than a maximum, and shows a contribution that was out of range or NaN.
  static base::Mask::Vector magnitude_bits(base::Mask::Vector integers) {
    return integers ^ (integers >> 63);
  }
  /// Was a contribution with these magnitude bits out of the range of quantum()?
  static bool out_of_range(std::int64_t bits) { return bits >= (std::int64_t{1} << 51); }

  /// Adds integers of quantum(). Nodes that another thread may add to at the same time are `shared` and
  /// added atomically: integers make that legal.
  void add(std::int32_t node, int component, std::int64_t integer, bool shared) {
    std::int64_t& slot = sum_[3 * static_cast<std::size_t>(node) + component];
    if (shared)
      std::atomic_ref<std::int64_t>(slot).fetch_add(integer, std::memory_order_relaxed);
    else
      slot += integer;
  }
  /// Memory for partial sums that a block sets aside while its chunks run, four integers per slot.
  std::int64_t* partial_sums(std::size_t slot_count) {
    if (partial_.size() < 4 * slot_count) partial_.resize(4 * slot_count);
    return partial_.data();
  }
  /// Asks for the memory of a node that add() will touch soon.
  void prefetch(std::int32_t node) const { __builtin_prefetch(&sum_[3 * static_cast<std::size_t>(node)], 1); }
  /// Adds any finite value, from any thread: slow path for loads, walls and contributions beyond the limit.
  void add_value(std::int32_t node, int component, double value);

  /// Reports the largest |contribution| of a chunk; a max, so order does not matter.
  void report_largest(double value);
  /// The same from magnitude bits: the power of two at or below the largest contribution.
  void report_magnitude(std::int64_t bits);
  /// What the next begin() should expect: the largest contribution, but no less than half of what this step
  /// expected, so that the scale does not follow the forces of a body at rest down to noise.
  double largest() const;

  /// The sum at a node [force].
  double value(std::int32_t node, int component) const;
  /// All sums as doubles, [node][3].
  void values(base::Array<double>& out) const;
  /// Those of nodes first .. last-1, [node - first][3], from the thread that calls.
  void values(std::size_t first, std::size_t last, double* out) const;
  /// As values(), and leaves zeros behind.
  void take(std::size_t first, std::size_t last, double* out);
  /// Every node has been taken: the next begin() finds the sums clear.
  void all_taken() { clear_ = true; }

 private:
  static constexpr double magic =
      6755399441055744.0;  // 1.5 * 2^52: adding it leaves the integer in the low bits
  static constexpr std::uint64_t magic_bits = std::bit_cast<std::uint64_t>(magic);

  base::Array<std::int64_t> sum_;  // [node][3]
  base::Array<std::int64_t> partial_;
  // Rare: (slot, level) -> integer; level n has the scale divided by 2^(32 n).
  std::map<std::pair<std::int64_t, int>, std::int64_t> coarse_;
  std::mutex coarse_lock_;
  bool clear_ = true;
  double expected_ = 0.0, scale_ = 1.0, limit_ = 0.0;
  std::atomic<double> largest_{0.0};
};

}  // namespace cleave::discretisation
