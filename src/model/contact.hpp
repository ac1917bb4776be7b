#pragma once
/// What touches what: *CONTACT_* with every reference resolved, and *CONTROL_CONTACT.

#include <string>
#include <vector>

#include "deck/diagnostic.hpp"
#include "model/load.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

/// One side of a contact: faces that others may not pass, or nodes that may not pass others' faces.
struct ContactSide {
  int type = 0;              ///< SURFATYP: 0 segments, 2 part set, 3 part, 4 nodes, 5 all, 6 all but
  Id id = 0;                 ///< SURFA: number of the set or part, to be written back
  std::vector<Index> parts;  ///< whose outer faces these are, ascending; empty for sets of faces or nodes
  std::vector<Segment> segments;  ///< at the start
  std::vector<Index> nodes;       ///< of the segments, or of the node set; ascending
};

/// *PART_CONTACT: friction of a part, for contacts that ask for it (FS = -1).
struct PartFriction {
  double static_friction = 0.0, dynamic_friction = 0.0;  ///< FS, FD [-]
  double decay = 0.0;                                    ///< DC [time/length]
  double viscous_limit = 0.0;                            ///< VC [stress]
  bool operator==(const PartFriction&) const = default;
};

struct Contact {
  enum class Search : std::uint8_t {
    one_way,  ///< nodes of side A against faces of side B
    two_way,  ///< that, and nodes of side B against faces of side A
    single    ///< one surface against itself and all others of side A
  };

  std::string keyword;  ///< canonical
  Id id = 0;            ///< of the card, else its place in the deck, from 1
  bool named = false;   ///< was the number given?
  std::string title;
  deck::Place place;
  Search search = Search::two_way;
  bool automatic = false;  ///< faces of solids are turned outward by themselves
  bool eroding = false;    ///< new faces appear where elements are deleted
  bool tied = false;
  bool offset = false;        ///< tied: by springs that keep the distance, not by projection
  bool joins = false;         ///< tied, but not _OFFSET alone: nodes over faces of rigid bodies become theirs
  double tie_distance = 0.0;  ///< SAST < 0: farthest distance that is tied; 0: 5 % of a face [length]
  ContactSide a, b;           ///< b is empty for a single surface

  double static_friction = 0.0, dynamic_friction = 0.0;  ///< FS, FD, times FSF [-]
  double friction_decay = 0.0;                           ///< DC [time/length]
  double viscous_limit = 0.0;  ///< VC times VSF: largest friction per area; 0 none [stress]
  std::vector<PartFriction>
      part_friction;     ///< FS = -1 [part]: the mean of both parts' own counts; else empty
  double damping = 0.0;  ///< VDC / 100: share of critical damping [-]
  double birth = 0.0, death = forever;
  double scale_a = 1.0, scale_b = 1.0;  ///< SFSA, SFSB: of the stiffness of each side [-]

  double solid_thickness = 0.0;  ///< SLDTHK: surfaces of solids lie half of it outside their nodes [length]
  double solid_modulus = 0.0;    ///< SLDSTF: in place of the bulk modulus of solids; 0 none [stress]
  int soft = 0;              ///< SOFT: 0 stiffness from moduli, 1 from masses and step, 2 segment to segment
  double soft_scale = 0.1;   ///< SOFSCL
  double extension = 1.025;  ///< MAXPAR: how far a face reaches beyond its free edges
  int ignore = 0;            ///< IGNORE
  double release = 0.0;  ///< PENMAX: depth beyond which a touch lets go; 0 none [length], or in thicknesses
                         ///< of the solid behind the face where `automatic` [-]
};

/// *CONTROL_CONTACT.
struct ContactControl {
  double stiffness = 0.1;  ///< SLSFAC [-]
  int penalty = 1;         ///< PENOPT: 1 the softer side, 2 side B, 3 side A
  int orient = 1;          ///< ORIEN: 1 faces of parts, 2 sets of faces too, 3 none
  int ignore = 0;          ///< IGNORE where the contact gives none
  int shell_thickness =
      0;  ///< SHLTHK: 0 automatic contacts alone see shells thick, 1 all but rigid ones, 2 all
};

}  // namespace cleave::model
