#pragma once
/// Spectral elements of degree 4, order 4 in time, on a plate in rectangles between rollers: what the
/// spacetime method is measured against. Gauss-Lobatto nodes are quadrature points, so that the mass is
/// diagonal; the scheme is the modified equation of order 4, two evaluations of forces a step, as in the
/// reference of bench/README.

#include <array>
#include <functional>
#include <vector>

namespace cleave::bench {

class SpectralPlate {
 public:
  static constexpr int degree = 4, nodes = degree + 1;
  using State = std::array<double, 2>;
  using Start = std::function<State(double x, double y)>;

  /// Plane strain, rho = c_p = 1, lambda = mu = 1/3. @param lines_x, lines_y  borders of the elements,
  /// ascending
  SpectralPlate(std::vector<double> lines_x, std::vector<double> lines_y);

  /// @return seconds of the steps; not those of the start
  double run(double end, const Start& displacement, const Start& velocity);

  int elements() const { return count_[0] * count_[1]; }
  int steps() const { return steps_; }
  /// Displacement and velocity at the end, [node of x][node of y] by visit(x, y, u, v, mass).
  void each_node(const std::function<void(double x, double y, const State& u, const State& v, double mass)>&
                     visit) const;
  /// Velocity along x at the end, at `points` places in each element of the lowest row, on its lowest line.
  void along_x(int points, const std::function<void(double x, double v, double weight)>& visit) const;

 private:
  using Field = std::array<std::vector<double>, 2>;
  void add_forces(const Field& u, Field& f) const;
  void hold(Field& f) const;
  double fastest();

  std::vector<double> lines_[2];
  int count_[2], width_[2], steps_ = 0;
  double place_[nodes], weight_[nodes], derivative_[nodes][nodes];
  std::vector<double> mass_, at_[2];
  Field u_, v_, f_, g_;
};

/// Borders of n equal elements; those that touch [low, high] are halved until they are 2^levels times
/// smaller.
std::vector<double> graded_lines(int n, double low, double high, int levels);

/// Rectangles of the mesh that halves in both directions at once, hanging nodes allowed.
int quadtree_leaves(int n, double low, double high, int levels);

}  // namespace cleave::bench
