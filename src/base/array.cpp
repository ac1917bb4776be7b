#include "base/array.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace cleave::base::detail {
namespace {

constexpr std::size_t line = 64, huge_page = std::size_t{2} << 20;
constexpr bool is_large(std::size_t bytes) {
  return bytes >= 2 * huge_page;
}

}  // namespace

void* allocate_aligned(std::size_t bytes) {
  if (!is_large(bytes)) return ::operator new(bytes, std::align_val_t(line));
  void* pointer = std::aligned_alloc(huge_page, (bytes + huge_page - 1) / huge_page * huge_page);
  if (!pointer) throw std::bad_alloc();
  madvise(pointer, bytes, MADV_HUGEPAGE);  // a wish: without huge pages it is ordinary memory
  return pointer;
}

void free_aligned(void* pointer, std::size_t bytes) {
  if (is_large(bytes))
    std::free(pointer);
  else
    ::operator delete(pointer, std::align_val_t(line));
}

}  // namespace cleave::base::detail
