#pragma once
/// Arrays aligned for the widest vector register, so that lanes load without a split.

#include <cstddef>
#include <vector>

namespace cleave::base {

namespace detail {
/// Memory on a 64-byte boundary; large blocks on huge pages where the system has them, because a sweep over a
/// large model otherwise spends a fifth of its time looking up pages. Throws std::bad_alloc.
void* allocate_aligned(std::size_t bytes);
void free_aligned(void* pointer, std::size_t bytes);
}  // namespace detail

template <class T>
struct CacheAligned {
  using value_type = T;

  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(detail::allocate_aligned(count * sizeof(T))); }
  void deallocate(T* pointer, std::size_t count) { detail::free_aligned(pointer, count * sizeof(T)); }
  template <class U>
  bool operator==(const CacheAligned<U>&) const {
    return true;
  }
};

/// A vector whose data start on a 64-byte boundary.
template <class T>
using Array = std::vector<T, CacheAligned<T>>;

}  // namespace cleave::base
