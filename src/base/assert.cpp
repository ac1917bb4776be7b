#include "base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace cleave::base {

void assertion_failed(const char* condition, const char* why, const char* file, int line) {
  std::fprintf(stderr, "cleave: internal error at %s:%d: %s (%s)\n", file, line, why, condition);
  std::abort();
}

}  // namespace cleave::base
