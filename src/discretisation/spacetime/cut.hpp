#pragma once
/// Cuts of simplices by planes of constant time.
///
/// With m corners before the plane and n after it, the cut has a corner e_ij on each of the m n edges between
/// them and is the product of two simplices; the lattice paths from (0, 0) to (m - 1, n - 1) triangulate it.
/// Source: the staircase triangulation, De Loera, Rambau & Santos, Triangulations (2010), section 6.2.

#include <array>
#include <cstddef>

namespace cleave::discretisation::spacetime {

/// Corners of a simplex inside another that has C corners, each by its barycentric coordinates there.
template <int C, int K>
using Piece = std::array<std::array<double, C>, K>;

namespace detail {

/// Corners of a simplex on the two sides of a plane of time, and the points of its edges on the plane.
template <int C>
struct Sides {
  std::array<int, C> before{}, after{};
  int m = 0, n = 0;  ///< how many are before and after
  const std::array<double, C>& time;
  double t;

  Sides(const std::array<double, C>& corner_time, double plane) : time(corner_time), t(plane) {
    for (int c = 0; c < C; ++c) {
      if (time[c] < t)
        before[m++] = c;
      else
        after[n++] = c;
    }
  }
  std::array<double, C> edge(int i, int j) const {
    const int a = before[i], b = after[j];
    const double part = (t - time[a]) / (time[b] - time[a]);
    std::array<double, C> point{};
    point[a] = 1.0 - part;
    point[b] = part;
    return point;
  }
  /// Calls visit(fill) for every path from (first, 0); fill(piece, k) writes its points from piece[k] on.
  template <class Visit>
  void each_path(int first, const Visit& visit) const {
    const int down = m - 1 - first, steps = down + n - 1;
    for (unsigned path = 0; path < 1u << steps; ++path) {
      int downs = 0;
      for (int s = 0; s < steps; ++s) downs += path >> s & 1u;
      if (downs != down) continue;
      visit([&](auto& piece, int k) {
        int i = first, j = 0;
        piece[k] = edge(i, j);
        for (int s = 0; s < steps && k + 1 + s < static_cast<int>(piece.size()); ++s) {
          if (path >> s & 1u)
            ++i;
          else
            ++j;
          piece[k + 1 + s] = edge(i, j);
        }
      });
    }
  }
};

}  // namespace detail

/// Calls visit(piece) for each of the simplices, C - 1 corners each, that make up the cut of a simplex by
/// time = t. A facet that lies in the plane belongs to the simplex before it, so that the cuts of the
/// elements between two fronts fill the body exactly once.
/// @param time [corner] [time]
template <int C, class Visit>
void cut(const std::array<double, C>& time, double t, const Visit& visit) {
  const detail::Sides<C> sides(time, t);
  if (sides.m == 0 || sides.n == 0) return;
  sides.each_path(0, [&](const auto& fill) {
    Piece<C, C - 1> piece;
    fill(piece, 0);
    visit(piece);
  });
}

/// Calls visit(piece) for each of the simplices that make up the part of a simplex before time t.
template <int C, class Visit>
void clip(const std::array<double, C>& time, double t, const Visit& visit) {
  const detail::Sides<C> sides(time, t);
  Piece<C, C> piece{};
  if (sides.n == 0) {
    for (int c = 0; c < C; ++c) piece[c][c] = 1.0;
    visit(piece);
    return;
  }
  for (int first = 0; first < sides.m; ++first) {
    sides.each_path(first, [&](const auto& fill) {
      for (int i = 0; i <= first; ++i) {
        piece[i] = {};
        piece[i][sides.before[i]] = 1.0;
      }
      fill(piece, first + 1);
      visit(piece);
    });
  }
}

}  // namespace cleave::discretisation::spacetime
