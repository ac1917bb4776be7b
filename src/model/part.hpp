#pragma once
/// Parts: geometry + material + the formulation chosen for it.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "deck/diagnostic.hpp"
#include "model/control.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

class Law;
struct Elasticity;
struct RigidMaterial;
struct RigidInertia;

/// What *SECTION_* says, format neutral: family ("SOLID", "SOLID_EFG", ...), ELFORM and further numbers by
/// name.
struct Section {
  Id id = 0;
  std::string title;
  std::string family;
  int form = 1;
  std::vector<std::pair<std::string, double>> numbers;
  deck::Place place;

  double number(std::string_view name, double fallback) const;
};

/// Space dimensions of a spacetime section: *SECTION_BEAM_SDG 1, _SHELL_SDG 2, _SOLID_SDG 3; 0 of any other.
int spacetime_dimension(const Section& section);
/// What a spacetime section measures across its dimensions: area of a bar, thickness of a plate (1 where
/// blank), 1 in space. [length^(3-D)]
double spacetime_thickness(const Section& section);

/// A *MAT_, *EOS_ or *MAT_ADD_ card as it was read: the fields that were given, so that it can be written
/// back.
struct MaterialCard {
  struct Value {
    std::string name, text;  ///< empty text: the number counts
    double number = 0.0;
  };
  Id id = 0;
  std::string keyword, title;
  std::vector<Value> values;
};

struct Part {
  Id id = 0;
  std::string title;
  Section section;                   ///< a copy: small, and spares an index
  Id material_id = 0, state_id = 0;  ///< MID and EOSID, for printing
  std::string material_keyword;      ///< canonical, e.g. "MAT_PLASTIC_KINEMATIC"
  std::shared_ptr<const Law> law;    ///< with its equation of state and erosion criteria inside
  /// Linear elastic constants; of spacetime parts, which have no law if they are not isotropic.
  std::shared_ptr<const Elasticity> elastic;
  /// Of a part that does not deform: *MAT_RIGID, and *PART_INERTIA if that is given. Null otherwise.
  std::shared_ptr<const RigidMaterial> rigid;
  std::shared_ptr<const RigidInertia> inertia;
  double density = 0.0;  ///< reference [mass/length^3]
  Hourglass hourglass;
  double mass_damping = 0.0;      ///< *DAMPING_PART_MASS value when constant (curve below) [1/time]
  Index mass_damping_curve = -1;  ///< index into curves, multiplied by mass_damping
  double mass_damping_factor[3] = {1.0, 1.0, 1.0};
  double stiffness_damping = 0.0;  ///< *DAMPING_PART_STIFFNESS COEF
  deck::Place place;
};

}  // namespace cleave::model
