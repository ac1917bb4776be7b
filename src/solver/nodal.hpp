#pragma once
/// The passes over all nodes: acceleration, kinetic energy, and the move to t_n+1.
///
/// They are bound by memory, so each array is touched as rarely as the scheme allows: one pass takes the
/// force and gives acceleration and kinetic energy; one pass moves. Ranges of nodes that a constraint has
/// corrected are settled again, whole, so the sums stay in fixed order.

#include <span>
#include <vector>

#include "discretisation/force_sum.hpp"
#include "discretisation/state.hpp"

namespace cleave::solver {

class Nodal {
 public:
  explicit Nodal(std::size_t node_count);

  /// a = (internal + external) / m, zero where there is no mass.
  /// @param internal      taken: zeros are left
  /// @param external      [node][3], or empty [force]
  /// @param acceleration  [node][3], overwritten [length/time^2]
  void accelerate(const discretisation::State& state, discretisation::ForceSum& internal,
                  std::span<const double> external, std::span<double> acceleration);

  /// These nodes have a new acceleration; settle() looks at them again.
  void corrected(std::span<const std::int32_t> nodes);
  void settle(const discretisation::State& state, std::span<const double> acceleration);
  /// As if every node had been corrected; for a state that was restarted from.
  void settle_all(const discretisation::State& state, std::span<const double> acceleration);

  /// From t_n to t_n+1: v += a (dt_n + dt_n-1) / 2, x += v dt_n.
  static void move(discretisation::State& state, std::span<const double> acceleration);

  double kinetic() const;  ///< at t_n [energy]

 private:
  static constexpr std::size_t grain = 1024;  // of the threads and of the sums
  static constexpr std::size_t piece = 256;   // whose arrays stay in the nearest cache between passes
  std::size_t count_;
  std::vector<double> kinetic_;  // [range], twice the energy
  std::vector<char> stale_;      // [range]
};

}  // namespace cleave::solver
