#pragma once
/// Entities of one part that share a formulation and a law. Blocks are const; what changes is in the State.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discretisation/force_sum.hpp"
#include "discretisation/state.hpp"
#include "model/model.hpp"

namespace cleave::discretisation {

using model::Id;
using model::Index;

/// What physics has to say when it fails; the solver stops, writes a last result and tells the user.
struct StepStatus {
  bool ok = true;
  Index part = -1;  ///< index into Model::parts
  Id element = 0;
  std::string what;          ///< e.g. "volume became negative"
  std::string likely_cause;  ///< and what to try

  /// Keeps the failure of the lowest element id, so that the message does not depend on threads.
  void merge(StepStatus other);
};

/// Given to a block once per step: positions at t_n+1, velocity at t_n+1/2, and the step between t_n and
/// t_n+1.
struct StepInput {
  double time = 0.0;                 ///< t_n+1
  double dt = 0.0;                   ///< t_n+1 - t_n; 0 for the forces of the initial state
  const double* position = nullptr;  ///< [node][3] at t_n+1
  const double* velocity = nullptr;  ///< [node][3] at t_n+1/2
  double erosion_step = 0.0;         ///< delete elements whose stable step is below this; 0 never
};

/// What a block answers.
struct StepOutput {
  StepStatus status;
  double stable_step = 1.0e30;  ///< smallest of the active elements, safety factor not applied [time]
  Id stable_element = 0;        ///< the element that gives it (lowest id among equals)
  double internal_energy = 0.0, hourglass_energy = 0.0;  ///< of active elements, after the step
  double eroded_internal = 0.0, eroded_hourglass = 0.0;  ///< of elements deleted in this step
  double damping_work = 0.0;                             ///< dissipated by stiffness damping in this step
  std::vector<Id> eroded;                                ///< ids deleted in this step, ascending
};

/// One named quantity per element for output: `size` numbers each.
struct ElementField {
  std::string name;  ///< "stress", "effective_plastic_strain", "pressure", ...
  int size = 1;
};

class Block {
 public:
  virtual ~Block() = default;

  virtual Index part() const = 0;  ///< index into Model::parts
  virtual model::Shape shape() const = 0;
  virtual std::string_view formulation() const = 0;  ///< e.g. "hex8 one point"
  virtual int points_per_element() const = 0;
  virtual std::span<const Id> element_ids() const = 0;  ///< in block order
  virtual std::span<const Index> connectivity()
      const = 0;  ///< [element][node], block order, nodes of the model

  /// Sizes and fills the block's state: reference volumes, initial history. Fails on an inverted element.
  virtual StepStatus initialise(const base::Array<double>& position, BlockState& state) const = 0;
  /// Adds lumped masses [node] [mass].
  virtual void add_mass(const BlockState& state, std::span<double> mass) const = 0;
  /// Adds factor[e] times the lumped mass of each element [element] to its nodes, in element order: mass
  /// scaling, and what a deleted element takes away. add_mass() is this with every factor 1.
  virtual void add_scaled_mass(const BlockState& state, std::span<const double> factor,
                               std::span<double> mass) const = 0;

  /// One step of every active element: strain, law, force, in one visit. Adds minus the internal force.
  virtual StepOutput add_force(const StepInput& input, BlockState& state, ForceSum& force) const = 0;

  /// Stable step of each active element in the given configuration [element]; deleted ones give 1e30.
  virtual void stable_steps(const base::Array<double>& position, const BlockState& state,
                            std::span<double> steps) const = 0;

  // --- for results and external tools ---------------------------------------------------------------
  virtual std::vector<ElementField> fields() const = 0;
  /// Values of a field averaged over an element's points: [element][size]. Asserts on an unknown name.
  /// @param elements  places in block order, in the order of `out`; empty means every element
  virtual void evaluate(std::string_view field, const base::Array<double>& position, const BlockState& state,
                        std::span<const std::size_t> elements, std::span<double> out) const = 0;
  /// Is the element still there? [element]
  virtual void alive(const BlockState& state, std::span<bool> out) const = 0;
  /// Bytes per element: connectivity, state and tables, for the memory report.
  virtual double bytes_per_element() const = 0;
};

}  // namespace cleave::discretisation
