#pragma once
/// Equality to the bit, for numbers that may be none.

#include <cstring>

namespace cleave::base::test {

inline bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
/// Arrays of doubles.
template <class Array>
bool same_bits(const Array& a, const Array& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

}  // namespace cleave::base::test
