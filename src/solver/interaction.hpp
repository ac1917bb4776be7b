#pragma once
/// Forces between surfaces: contact. An interaction adds forces that act on two sides at once, to the same
/// sums as the elements do, so that what one side gets the other loses to the last bit.

#include "solver/action.hpp"

namespace cleave::solver {

/// What an interaction answers when it has added its forces.
struct ContactOutput {
  discretisation::StepStatus status;
  double stiffness_rate = 0.0;  ///< bound of the squares of the frequencies that its springs add [1/time^2]
  double damping = 0.0;         ///< largest share of critical damping in it [-]
};

class Interaction {
 public:
  virtual ~Interaction() = default;
  virtual std::size_t contact() const = 0;  ///< index into Model::contacts
  virtual std::string name() const = 0;     ///< of its memory in the State
  virtual base::Array<double> first_memory() const = 0;
  /// Before the first step of a run, or of a run that goes on: which elements are there.
  virtual void start(const discretisation::State& state) = 0;
  /// Finds who touches whom at t_n and adds the forces between them.
  /// @param eroded  elements deleted in this step
  /// @param memory  what it remembers between steps; may change its size
  virtual ContactOutput add_force(const Moment& now, std::span<const model::Id> eroded,
                                  base::Array<double>& memory, discretisation::ForceSum& force) = 0;
  /// Books the work of the forces last added, once the accelerations are final.
  virtual void settle(const Moment& now, base::Array<double>& memory,
                      std::span<const double> acceleration) const = 0;
  virtual InterfaceForce report(std::span<const double> memory) const = 0;
  /// A failure that names the contact, and the pair that gives its bodies most energy now.
  virtual discretisation::StepStatus accuse(const Moment& now, std::string what, std::string cause) const = 0;
  /// Adds the forces last added to those of each node [node][3] [force]; for output.
  virtual void add_nodal(std::span<double> force) const = 0;
  /// Adds the pressure of its own forces at the nodes, and lowers the gaps to what it finds; for output.
  virtual void add_fields(const Moment& now, ContactFields& fields) = 0;
  /// Sets to zero what add_nodal added to.
  virtual void clear_nodal(std::span<double> force) const = 0;
};

/// Before anything is computed: moves nodes that penetrate at the start to the surface of the other side, for
/// contacts with IGNORE 0, and says so. Changes positions of the mesh.
void move_apart(model::Model& model, deck::Diagnostics& diagnostics);

/// Before anything is computed: nodes that a tie puts on faces of a rigid body become extra nodes of the body
/// (all ties but those by springs alone), with a note. Errors: the node is held, or of another body; the tie
/// begins or ends within the run.
void join_ties(model::Model& model, deck::Diagnostics& diagnostics);

/// One for each contact that is not a tie of nodes. Faces that lead nowhere, and what penetrates at the
/// start, are diagnostics.
std::vector<std::unique_ptr<Interaction>> make_interactions(const discretisation::World& world,
                                                            deck::Diagnostics& diagnostics);

}  // namespace cleave::solver
