#pragma once
/// The next time step: stable step, safety factor, limits of the deck, and mass scaling.

#include <vector>

#include "discretisation/world.hpp"

namespace cleave::solver {

/// What the elements allow.
struct StableStep {
  double step = 1.0e30;  ///< smallest of the active elements, no safety factor [time]
  model::Id element = 0;
};

/// The step to take after t_n [time]. TSSFAC times the stable step; not above the curve LCTM; DTINIT for the
/// first one if that is smaller. Without any element the step is a hundredth of the run.
double choose_step(const model::Model& model, const discretisation::State& state, const StableStep& stable);

/// The step where springs of contact act beside those of the elements: with the bounds of both,
/// 2 / sqrt(w_e^2 + w_c^2), less for damping in it (Belytschko et al. 2014, sec. 6.2). The safety factor of
/// the elements is not applied once more: a step that is small enough stays. It grows back slowly: a step
/// that changes from dt to dt' while a node has the acceleration a gives it the energy m a^2 (dt^2 - dt'^2) /
/// 8, and bodies that touch and part every few steps would gain that each time.
/// @param step     asked for [time]
/// @param stable   of the elements [time]
/// @param rate     bound of w_c^2 [1/time^2]
/// @param damping  share of critical damping [-]
/// @param last     limit of the step before, 0 for none; overwritten by that of this one [time]
double limit_step(double step, double stable, double rate, double damping, double& last);

/// DTMIN: the step below which the run stops, or (ERODE) the element is deleted; 0 for none [time].
double least_step(const model::Model& model, const discretisation::State& state);

/// DT2MS: elements whose step is too small get mass (DT2MS < 0), or all get the mass that makes their steps
/// equal (DT2MS > 0). DT2MSF stands for DT2MS = -DT2MSF times the first step. Source: the stable step grows
/// with the square root of the density.
class MassScaling {
 public:
  explicit MassScaling(const discretisation::World& world) : world_(world) {}
  bool active() const;

  /// Mass factors of the elements of one block at the start: one [element].
  base::Array<double> first_memory(std::size_t block) const;
  /// Adds or takes mass, and answers the stable step with it.
  /// @param factors  per block [element], the mass of each element in units of its own
  /// @param first    stable step of the unscaled mesh at the start, for DT2MSF [time]
  /// @return true if the masses of nodes changed
  bool apply(discretisation::State& state, const std::vector<base::Array<double>*>& factors, bool start,
             double first, StableStep& stable);

 private:
  double wanted(double time, double first) const;

  const discretisation::World& world_;
  std::vector<double> steps_, change_, mass_;  // scratch
};

}  // namespace cleave::solver
