#pragma once
/// What acts on the body: loads, constraints, walls, initial state. All ids are resolved to indices. Places
/// in the deck serve messages; they are not compared.

#include <array>
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "deck/diagnostic.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

using Vector = base::Vec3<double>;
inline constexpr double forever = 1.0e28;

/// Orthonormal axes; rows of `axis` are local x, y, z in global components.
struct Frame {
  Vector axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vector origin = {0, 0, 0};
};

/// Nodes held in some directions (*BOUNDARY_SPC, *NODE TC, *CONSTRAINED_GLOBAL/LOCAL planes).
struct FixedNodes {
  Id id = 0;  ///< of the card (_ID option), 0 none
  std::string title;
  std::vector<Index> nodes;
  unsigned directions = 0;  ///< bit 0 x, 1 y, 2 z translation; bits 3..5 rotation
  bool local = false;       ///< directions are those of `frame`
  Frame frame;
  double birth = 0.0, death = forever;
  deck::Place place{};
};

/// Prescribed translation along one direction, or rotation about an axis
/// (*BOUNDARY_PRESCRIBED_MOTION_NODE/SET).
struct PrescribedMotion {
  enum class Kind { velocity, acceleration, displacement, velocity_by_displacement };  ///< VAD 0 to 3
  Id id = 0;
  std::string title;
  std::vector<Index> nodes;
  Kind kind = Kind::velocity;
  Vector direction = {1, 0, 0};  ///< unit vector
  bool only_direction = true;    ///< false: DOF < 0, motion across the direction is fixed too
  bool rotation =
      false;  ///< DOF 9..11: about `direction` through `centre`; the curve is an angle, its rate, ...
  Vector centre{0, 0, 0};
  bool radial_free = false;  ///< DOF -9..-11: the distance from the axis may change
  Index curve = -1;
  double scale = 1.0;
  double birth = 0.0, death = forever;
  deck::Place place{};
};

/// A force per node along a direction (*LOAD_NODE).
struct NodeLoad {
  std::vector<Index> nodes;
  Vector direction = {1, 0, 0};
  bool follower = false;  ///< DOF 4: along the normal of nodes m1 m2 m3
  Index follow[3] = {-1, -1, -1};
  Index curve = -1;
  double scale = 1.0;
  deck::Place place{};
};

/// Pressure on faces, positive into the body (*LOAD_SEGMENT); uniform or along a vector.
struct SegmentLoad {
  std::vector<Segment> segments;
  /// Faces of ten-node tetrahedra: three corners, then the nodes amid the edges 12, 23, 31.
  std::vector<std::array<Index, 6>> quadratic;
  Index curve = -1;
  double scale = 1.0;
  double arrival = 0.0;  ///< AT
  deck::Place place{};
};

/// Acceleration field (*LOAD_BODY): the body feels `-` base acceleration, as the format defines it.
struct BodyLoad {
  Vector direction = {0, 0, 1};  ///< unit axis; of a generalized load the scale of each component
  bool rotation = false;         ///< angular velocity about `centre` instead of translation
  Vector centre = {0, 0, 0};
  Index curve = -1;
  double scale = 1.0;
  std::vector<bool> nodes;  ///< empty: all nodes; else one flag per node
  /// What a rotating base does to the body; Coriolis and Euler accelerations by *LOAD_BODY_GENERALIZED alone.
  enum class Angular { centrifugal, coriolis, euler };
  Angular angular = Angular::centrifugal;
  bool generalized = false;  ///< of *LOAD_BODY_GENERALIZED, which has nodes of its own
  deck::Place place{};
};

/// *RIGIDWALL_PLANAR and *RIGIDWALL_GEOMETRIC with every option; node penetration is stopped kinematically.
struct RigidWall {
  enum class Shape { plane, prism, cylinder, sphere };
  Id id = 0;
  std::string title;
  std::vector<Index> nodes;  ///< that may not pass
  Shape shape = Shape::plane;
  bool geometric = false;  ///< a *RIGIDWALL_GEOMETRIC: it may move as a curve tells, it has no mass
  Vector origin{0, 0, 0}, normal{0, 0, 1};  ///< outward unit normal; axis of a cylinder, which begins at the
                                            ///< origin; a sphere has its centre there
  bool finite = false;                      ///< of a *RIGIDWALL_PLANAR or _FLAT: only a rectangle
  Vector edge_l{1, 0, 0}, edge_m{0, 1, 0};  ///< unit edges of the finite wall or prism
  double length_l = 0.0, length_m = 0.0;    ///< of a geometric wall 0: without end [length]
  double length_n = 0.0;  ///< of a prism against the normal, of a cylinder along its axis; 0: without end
  double radius = 0.0;    ///< of a cylinder or sphere [length]
  bool interior = false;  ///< nodes are inside the cylinder or sphere and may not leave it
  double friction = 0.0;  ///< FRIC: Coulomb; 1 no sliding; 2 welds and slides; 3 welds, no sliding
  double velocity_limit = 0.0;  ///< WVEL: FRIC 2 and 3 weld nodes that hit faster than this
  bool orthotropic = false;     ///< _ORTHO: coefficients along two directions, in place of FRIC
  double static_friction[2] = {0, 0}, dynamic_friction[2] = {0, 0};
  double friction_decay[2] = {0, 0};    ///< [time/length]
  Vector friction_axis{1, 0, 0};        ///< unit, the first of the directions up to its normal component
  Index friction_node[2] = {-1, -1};    ///< the first direction runs between these nodes, if any
  double mass = 0.0;                    ///< > 0: moving wall
  double speed = 0.0;                   ///< initial, along the normal [length/time]
  Index motion = -1;                    ///< curve of a geometric wall's motion since its birth
  bool motion_is_displacement = false;  ///< else velocity
  Vector motion_direction{1, 0, 0};     ///< unit
  double birth = 0.0, death = forever;
  double penalty = 0.0;  ///< RWPNAL: a planar wall meets nodes by springs of this scale; > 0 those of rigid
                         ///< bodies, < 0 all, 0: none, and nodes of rigid bodies pass [-]
  int soft_cycles = 0;   ///< _FORCES SOFT: cycles over which the velocity is zeroed
  std::string keyword = "RIGIDWALL_PLANAR";  ///< for messages
  deck::Place place{};
};

/// A traction-free crack that is there from the start, along faces of the mesh (*BOUNDARY_PRECRACK).
struct Precrack {
  Id part = 0;
  std::vector<Vector> points;  ///< corners: a polyline in the plane, a plane convex polygon in space [length]
  deck::Place place;
};

/// Viscous absorbing faces (*BOUNDARY_NON_REFLECTING).
struct AbsorbingFaces {
  std::vector<Segment> segments;
  bool dilatational = true, shear = true;
  deck::Place place{};
};

/// A plane elastic wave that comes in through absorbing faces (*LOAD_INCIDENT_WAVE).
struct IncidentWave {
  enum class Kind { pressure, shear };
  std::vector<Segment> segments;
  Kind kind = Kind::pressure;
  Vector direction = {1, 0, 0};     ///< of propagation, unit
  Vector polarisation = {0, 0, 0};  ///< of a shear wave, unit, across the direction
  Vector reference = {0, 0, 0};     ///< point that the front passes at the arrival time [length]
  /// Stress in the wave: normal stress along the direction, pull positive, or shear stress along the
  /// polarisation. [stress]
  Index curve = -1;
  double scale = 1.0;
  double arrival = 0.0;  ///< [time]
  deck::Place place{};
};

/// Stress of an element at time 0, uniform (*INITIAL_STRESS_SHELL, _SOLID).
struct InitialStress {
  bool shell = false;  ///< the element is a shell, else a solid
  Id element = 0;
  double stress[6] = {0, 0, 0, 0, 0, 0};  ///< xx yy zz xy yz zx [stress]
  deck::Place place{};
};

struct PointMass {
  Id id = 0;
  Index node = -1;
  double mass = 0.0;
  deck::Place place{};
};

struct GlobalDamping {
  Index curve = -1;    ///< factor over time; -1: constant `value`
  double value = 0.0;  ///< [1/time]
  double factor[3] = {1.0, 1.0, 1.0};
  deck::Place place{};
};

}  // namespace cleave::model
