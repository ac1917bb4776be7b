#pragma once
/// Tables times several vectors at once.
///
/// Vectors stand side by side, number by number: x[k * width + v] is number k of vector v. The width is
/// either one or a lane; a lone vector finds its lanes among the outputs instead. Each output is one chain of
/// fused multiply-adds over the inputs in their order, so that a vector has the same bits in any company.

#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {

/// y = t^T x. @param t [inputs][outputs]; rows aligned, padding of any value
/// @param x [inputs][width] @param y [padded(outputs)][width], aligned; what is beyond the outputs may be
/// overwritten
void multiply_vectors(const Block& t, const double* x, double* y, int width);

/// How many numbers `rows` of vectors take.
constexpr std::size_t vectors_size(int rows, int width) {
  return static_cast<std::size_t>(padded(rows)) * static_cast<std::size_t>(width);
}

}  // namespace cleave::discretisation::spacetime
