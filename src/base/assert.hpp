#pragma once
/// CLEAVE_ASSERT(condition, why): our own mistakes. User input must never reach it.
/// Stays on in release builds; prints file, line and reason, then aborts.

namespace cleave::base {
[[noreturn]] void assertion_failed(const char* condition, const char* why, const char* file, int line);
}

#define CLEAVE_ASSERT(condition, why)                                        \
  do {                                                                       \
    if (!(condition)) [[unlikely]]                                           \
      ::cleave::base::assertion_failed(#condition, why, __FILE__, __LINE__); \
  } while (false)
