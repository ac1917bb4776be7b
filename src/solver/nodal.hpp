#pragma once
/// The passes over all nodes: acceleration, velocity at t_n, kinetic energy, and the move to t_n+1.
///
/// They are bound by memory, so each array is touched as rarely as the scheme allows: one pass turns force
/// into acceleration, velocity and kinetic energy; one pass moves. Ranges of nodes that a constraint has
/// corrected are settled again, whole, so the sums stay in fixed order.

#include <span>
#include <vector>

#include "discretisation/force_sum.hpp"
#include "discretisation/state.hpp"

namespace cleave::solver {

class Nodal {
 public:
  explicit Nodal(std::size_t node_count);

  /// Must follow any change of the masses.
  void mass_changed(const discretisation::State& state);

  /// a = (internal + external) / m, zero where there is no mass.
  /// @param external      [node][3], or empty [force]
  /// @param acceleration  [node][3], overwritten [length/time^2]
  void accelerate(const discretisation::State& state, const discretisation::ForceSum& internal,
                  std::span<const double> external, std::span<double> acceleration);

  /// These nodes have a new acceleration; settle() looks at them again.
  void corrected(std::span<const std::int32_t> nodes);
  void settle(const discretisation::State& state, std::span<const double> acceleration);
  /// As if every node had been corrected; for a state that was restarted from.
  void settle_all(const discretisation::State& state, std::span<const double> acceleration);

  /// From t_n to t_n+1: v += a (dt_n + dt_n-1) / 2, x += v dt_n.
  static void move(discretisation::State& state, std::span<const double> acceleration);

  double kinetic() const;                                       ///< at t_n [energy]
  std::span<const double> velocity() const { return middle_; }  ///< [node][3] at t_n [length/time]

 private:
  void settle_range(const discretisation::State& state, std::span<const double> acceleration,
                    std::size_t begin, std::size_t end);

  static constexpr std::size_t grain = 1024;
  std::size_t count_;
  base::Array<double> inverse_mass_;  // [node], 0 for massless nodes
  base::Array<double> middle_;        // [node][3] velocity at t_n
  std::vector<double> kinetic_;       // [range], twice the energy
  std::vector<char> stale_;           // [range]
};

}  // namespace cleave::solver
