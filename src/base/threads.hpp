#pragma once
/// The one door to threads (oneTBB behind it).
///
/// Loops run over chunks whose number and content never depend on the thread count; what a chunk
/// contributes is combined by associative operations (integer sums, min, max) or in chunk order,
/// so results are the same bits for any number of threads.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace cleave::base {

/// Limits the library to `count` threads (0: one per core) until changed again.
void set_thread_count(int count);
int thread_count();

/// Takes further items of a for_each_fed() loop from its bodies.
class Feed {
 public:
  virtual void add(std::int32_t item) = 0;

 protected:
  ~Feed() = default;
};

namespace detail {
void run_chunks(std::size_t count, void (*body)(const void*, std::size_t), const void* context);
void run_fed(const std::int32_t* seeds, std::size_t count, void (*body)(const void*, std::int32_t, Feed&),
             const void* context);
}  // namespace detail

/// Calls body(chunk) for chunk = 0 .. count-1, in any order, on any thread.
/// The body must not throw.
template <class Body>
void for_each_chunk(std::size_t count, const Body& body) {
  detail::run_chunks(
      count, [](const void* context, std::size_t chunk) { (*static_cast<const Body*>(context))(chunk); },
      &body);
}

/// Calls body(begin, end) over [0, count) in ranges of fixed size `grain`.
template <class Body>
void for_each_range(std::size_t count, std::size_t grain, const Body& body) {
  for_each_chunk((count + grain - 1) / grain, [&](std::size_t chunk) {
    const std::size_t begin = chunk * grain;
    body(begin, begin + grain < count ? begin + grain : count);
  });
}

/// Calls body(item, feed) for each seed and each item that a body adds to the feed, in any order, on any
/// thread, without a barrier; returns when none is left. What a body wrote before it added an item is seen by
/// the item's body. The body must not throw, nor start another loop.
template <class Body>
void for_each_fed(const std::vector<std::int32_t>& seeds, const Body& body) {
  detail::run_fed(
      seeds.data(), seeds.size(),
      [](const void* context, std::int32_t item, Feed& feed) {
        (*static_cast<const Body*>(context))(item, feed);
      },
      &body);
}

}  // namespace cleave::base
