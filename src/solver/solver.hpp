#pragma once
/// What moves the State, and how others may watch.

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "discretisation/world.hpp"

namespace cleave::solver {

/// Force on one rigid wall at t_n, summed over its nodes [force].
struct WallForce {
  double normal = 0.0;  ///< along the wall normal, positive pushes the body off
  double force[3] = {0, 0, 0};
  double position = 0.0;  ///< of a moving wall along its normal [length]
  double velocity = 0.0;  ///< of a moving wall along its normal [length/time]
};

/// Velocity of all nodes at t_n, the mean of the half steps around it. Worked out where it is asked for: few
/// observers do, in few cycles, and an array of it would cost the solver's loop a tenth of its memory
/// traffic.
class NodeVelocity {
 public:
  /// @param half_step     [node][3] at t_n - since [length/time]
  /// @param acceleration  [node][3] at t_n [length/time^2]
  NodeVelocity(std::span<const double> half_step, std::span<const double> acceleration, double since)
      : half_step_(half_step), acceleration_(acceleration), since_(since) {}
  std::size_t size() const { return half_step_.size(); }
  /// Component i % 3 of node i / 3 [length/time].
  double operator[](std::size_t i) const { return half_step_[i] + acceleration_[i] * since_; }

 private:
  std::span<const double> half_step_, acceleration_;
  double since_;
};

/// Mass, momentum and kinetic energy of a part, where the solver knows better than a sum over nodes.
struct PartMotion {
  double mass = 0.0;               ///< [mass]
  double momentum[3] = {0, 0, 0};  ///< [mass length/time]
  double kinetic = 0.0;            ///< [energy]
};

/// A rigid body at t_n; vectors in global axes.
struct BodyMotion {
  double position[3] = {0, 0, 0}, displacement[3] = {0, 0, 0};  ///< of the centre [length]
  double velocity[3] = {0, 0, 0};                               ///< of the centre [length/time]
  double acceleration[3] = {0, 0, 0};                           ///< of the centre [length/time^2]
  double quaternion[4] = {1, 0, 0, 0};                          ///< of the rotation since the start
  double spin[3] = {0, 0, 0};                                   ///< angular velocity [1/time]
  double spin_rate[3] = {0, 0, 0};                              ///< angular acceleration [1/time^2]
  double momentum[3] = {0, 0, 0};                               ///< angular, about the centre
  double force[3] = {0, 0, 0}, moment[3] = {0, 0, 0};           ///< that hold or drive the body [force]
  double mass = 0.0, kinetic = 0.0;                             ///< [mass] [energy]
};

/// Fields on cells of their own, each with its own points, for solvers whose fields jump between elements.
struct CellFields {
  int dimension = 0;                        ///< of the cells, which are simplices: 1, 2 or 3
  std::vector<double> point;                ///< [point][3], undeformed [length]
  std::vector<model::Index> cell;           ///< [cell][dimension + 1]
  std::vector<discretisation::Id> element;  ///< [cell] user's element
  std::vector<discretisation::Id> part;     ///< [cell] user's part
  struct Field {
    std::string name;
    int size = 1;
    std::vector<double> value;  ///< [point][size]
  };
  std::vector<Field> fields;
};

/// Stress of an element of *DATABASE_HISTORY_SOLID, _SHELL or _BEAM, global axes.
struct ElementStress {
  discretisation::Id element = 0;
  model::Index part = -1;
  double stress[6] = {0, 0, 0, 0, 0, 0};  ///< xx yy zz xy yz zx [stress]
};

class CellSource {
 public:
  virtual ~CellSource() = default;
  /// The fields at the time of the frame.
  virtual CellFields cells() const = 0;
  /// The first tents of the run as cells of spacetime, as many as Options::tents says; time is the last axis,
  /// in lengths that the fastest wave runs. Empty in three dimensions.
  virtual CellFields tents() const = 0;
  /// At the time of the frame, in the middle of each element, in the order of the requests.
  virtual std::vector<ElementStress> stresses() const = 0;
};

/// Displacement of one more side of a crack against the first, at a node of *DATABASE_HISTORY_NODE:
/// opening * normal + sliding * tangent.
struct CrackOpening {
  model::Index node = -1;
  int side = 2;                  ///< counted from 1, by the order of the elements around the node
  double opening = 0.0;          ///< along the normal: positive where the faces have come apart [length]
  double sliding = 0.0;          ///< along the faces. In the plane along the normal turned by a right angle
                                 ///< counter-clockwise, in space the amount [length]
  double normal[3] = {0, 0, 0};  ///< of the undeformed crack, from the first side to this one
};

/// Stress intensities at a tip of a crack in isotropic spacetime parts, from the jump of displacement across
/// the crack between two distances behind the tip: along the normal, ahead, and along ahead x normal.
struct CrackTip {
  model::Index node = -1;
  double intensity[3] = {0, 0, 0};  ///< K_I K_II K_III [stress length^(1/2)]
  double near = 0.0, far = 0.0;     ///< the two distances [length]
  double ahead[3] = {0, 0, 0};      ///< the way the undeformed crack points, square to its rim
  double normal[3] = {0, 0, 0};     ///< of the undeformed crack
};

/// What of a frame a solver may leave out until an observer asks for it, because it costs time: bits.
enum Wanted : unsigned {
  every_node = 1u,  ///< nodal values of all nodes; those of *DATABASE_HISTORY_NODE are always there
  energies = 2u,    ///< of the State and its parts, PartMotion, facts
  reactions = 4u,   ///< Frame::reaction
  everything = 7u
};

/// A named number of a run for its summary, and the table of a solver's own at one instant.
struct Fact {
  std::string name;  ///< lower case, with underscores
  double value = 0.0;
};

/// What a contact does at t_n, and has done so far.
struct InterfaceForce {
  double force[3] = {0, 0, 0};                         ///< on side A; side B gets the opposite [force]
  double normal_energy = 0.0;                          ///< stored in the springs between the sides [energy]
  double friction_energy = 0.0, damping_energy = 0.0;  ///< taken from the bodies [energy]
  double area = 0.0;  ///< of the faces or nodes that touch, both sides where both are looked at
  std::size_t touches = 0;
  double deepest = 0.0;  ///< penetration, beyond that at the start [length]

  double energy() const { return normal_energy + friction_energy + damping_energy; }
};

/// Contact at the nodes of its surfaces.
struct ContactFields {
  std::vector<double> pressure;  ///< [node] force along the area of the faces there now, per area; positive
                                 ///< pushes into the body; 0 elsewhere [stress]
  std::vector<double> gap;  ///< [node] way to the closest face that the node looks at, negative behind it;
                            ///< at most the thickness of an element there; elsewhere the widest [length]
};

/// Works them out where they are asked for: few observers do, in few cycles.
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  virtual ContactFields contact_fields() const = 0;  ///< at the time of the frame
};

/// Everything an observer may read after a step; valid only during the call.
struct Frame {
  const model::Model& model;
  const discretisation::World& world;
  const discretisation::State& state;
  std::span<const double> acceleration;  ///< [node][3] at t_n [length/time^2]
  NodeVelocity velocity;                 ///< [node][3] at t_n [length/time]
  std::span<const double>
      reaction;  ///< [node][3] constraint force on held nodes (SPC, motion), else 0 [force]
  std::span<const WallForce> walls;            ///< one per Model::walls
  discretisation::Id step_element = 0;         ///< controls the step
  std::span<const discretisation::Id> eroded;  ///< deleted in this step
  std::span<const PartMotion> motion = {};     ///< [part]; empty: sum over the nodes
  const CellSource* cells = nullptr;           ///< null: fields are those of nodes and blocks
  std::span<const Fact> facts = {};            ///< the solver's own table at t_n; always the same names
  std::function<void()> save = {};  ///< brings State::memory up to date before it is saved; empty: it is
  std::span<const InterfaceForce> interfaces = {};  ///< one per Model::contacts
  std::span<const double> contact_force = {};       ///< [node][3] of all contacts; empty without any [force]
  std::span<const BodyMotion> bodies = {};          ///< one per Model::rigid_bodies
  const ContactSource* contact = nullptr;           ///< null without contact
  std::span<const CrackOpening> cracks = {};        ///< the same nodes and sides in all frames of a run
  std::span<const CrackTip> tips = {};              ///< of cracks, by node; the same in all frames of a run
  /// Brings what is wanted (bits of Wanted) up to t_n; empty: everything is there. Nothing of it moves in
  /// memory.
  std::function<void(unsigned)> evaluate = {};
  bool energies_due = true;  ///< energies are those of t_n without being asked for
};

enum class Ending {
  end_time,
  cycle_limit,
  step_too_small,
  energy_limit,
  mass_limit,
  node_bound,
  switched_off,
  signal,
  physics
};

/// What a user or the system asks for while the run goes on; checked once per cycle.
/// The solver takes `stop`; the observers that serve `report`, `restart` and `field` hold a reference and
/// take (clear) those.
struct Wishes {
  std::atomic<bool> stop{false};     ///< sw1, SIGINT, SIGTERM: write a restart and end
  std::atomic<bool> signal{false};   ///< the stop came from a signal; set before `stop`
  std::atomic<bool> report{false};   ///< sw2: time and cycle numbers, go on
  std::atomic<bool> restart{false};  ///< sw3: write a restart, go on
  std::atomic<bool> field{false};    ///< sw4: write a field frame, go on
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void begin(const Frame& frame) = 0;  ///< t = 0, or the state restarted from
  virtual void after_step(const Frame& frame) = 0;
  virtual void finish(const Frame& frame, Ending ending, const discretisation::StepStatus& status) = 0;
};

struct Options {
  std::int64_t stop_at_cycle = 0;  ///< for tests of restart; 0 none
  int tents = 0;                   ///< spacetime: how many of the first tents to keep for a picture
};

/// What one run of a solver came to.
struct Outcome {
  Ending ending = Ending::end_time;
  discretisation::StepStatus status;  ///< ok unless physics failed
  double seconds = 0.0;               ///< wall clock in the time loop
  double element_cycles = 0.0;        ///< active elements times cycles
  struct Phase {
    std::string name;  ///< "elements", "contact", "loads", "update", "output"
    double seconds = 0.0;
  };
  std::vector<Phase> phases;
  std::vector<Fact> facts = {};  ///< what else the solver wants known
};

class Solver {
 public:
  virtual ~Solver() = default;
  /// Moves the state until the model's termination or a wish. The state is left at the end of a whole cycle.
  virtual Outcome advance(discretisation::State& state, std::span<Observer* const> observers,
                          Wishes& wishes) = 0;
};

/// Explicit central differences. Unsupported combinations are diagnostics.
std::unique_ptr<Solver> make_explicit(const discretisation::World& world, const Options& options,
                                      deck::Diagnostics& diagnostics);

/// Spacetime discontinuous Galerkin on tents, for models of spacetime parts. A cycle is one output instant:
/// the State is filled from the cut of the solution at its time. What the body cannot be made of is
/// diagnosed.
std::unique_ptr<Solver> make_tents(const discretisation::World& world, const Options& options,
                                   deck::Diagnostics& diagnostics);

}  // namespace cleave::solver
