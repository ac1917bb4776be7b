#pragma once
/// The advancing front: where its vertices are and how far in time. Part of the State: copy it, and it is a
/// checkpoint.

#include <cstdint>
#include <vector>

#include "discretisation/spacetime/mesh.hpp"

namespace cleave::discretisation::spacetime {

/// Time budget of a triangle under newest-vertex bisection; see progress.hpp.
struct Budget {
  double step = 0.0;        ///< s of the triangle at its generation [time]
  std::uint8_t newest = 0;  ///< local number of the newest vertex; the edge opposite is bisected next
};

template <int D>
struct Front {
  std::vector<Point<D>> position;  ///< [vertex] [length]
  std::vector<double> time;        ///< [vertex] [time]
  std::vector<Budget> budget;      ///< [simplex] with Progress::budget, else empty

  Event<D> event(Vertex v) const {
    Event<D> y;
    for (std::size_t k = 0; k < D; ++k) y[k] = position[static_cast<std::size_t>(v)][k];
    y[D] = time[static_cast<std::size_t>(v)];
    return y;
  }
};

/// The key by which tents are ordered: a vertex may be pitched when its key is less than those of all its
/// neighbours. `rank` is SpaceMesh::rank.
struct Key {
  double time = 0.0;
  std::int32_t rank = 0;
  bool operator<(const Key& other) const {
    return time != other.time ? time < other.time : rank < other.rank;
  }
};

}  // namespace cleave::discretisation::spacetime
