#pragma once
/// Arrays aligned for the widest vector register, so that lanes load without a split.

#include <cstddef>
#include <new>
#include <vector>

namespace cleave::base {

template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
  void deallocate(T* pointer, std::size_t) { ::operator delete(pointer, alignment); }
  template <class U>
  bool operator==(const CacheAligned<U>&) const {
    return true;
  }
};

/// A vector whose data start on a 64-byte boundary.
template <class T>
using Array = std::vector<T, CacheAligned<T>>;

}  // namespace cleave::base
