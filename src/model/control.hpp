#pragma once
/// How the run is to be carried out: *CONTROL_* and *TERMINATION_* with every default filled in.

#include <optional>
#include <vector>

#include "deck/diagnostic.hpp"
#include "model/contact.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

struct TimeStepControl {
  double first = 0.0;                    ///< DTINIT, 0 automatic [time]
  double safety = 0.9;                   ///< TSSFAC
  double mass_scaling = 0.0;             ///< DT2MS: <0 only smaller elements, >0 all; 0 none [time]
  double mass_scaling_fraction = 0.0;    ///< DT2MSF: of the first stable step, in place of DT2MS; 0 none [-]
  Index mass_scaling_curve = -1;         ///< DT2MSLC: DT2MS over time, index into curves
  bool mass_scaling_first_only = false;  ///< MS1ST
  Index limit_curve = -1;                ///< LCTM: step limit over time, index into curves
  bool erode = false;                    ///< ERODE: delete solids whose step falls below the DTMIN limit
};

struct Termination {
  double time = 0.0;               ///< ENDTIM
  std::int64_t cycles = 0;         ///< ENDCYC, 0 none
  double step_fraction = 0.0;      ///< DTMIN: stop when step < DTMIN * initial step; 0 none
  double energy_change = 0.0;      ///< ENDENG: percent change of energy ratio; 0 none
  double mass_change = 0.0;        ///< ENDMAS: percent change of mass; 0 none (only with mass scaling)
  bool no_solution_check = false;  ///< NOSOL: the deck is read and checked, nothing is computed
  struct NodeBound {               ///< *TERMINATION_NODE: stop on a displacement bound
    Index node;
    int stop;                 ///< 1 x, 2 y, 3 z outside [minimum, maximum]
    double maximum, minimum;  ///< coordinate bounds [length]
  };
  std::vector<NodeBound> nodes;
};

struct BulkViscosity {
  double quadratic = 1.5;  ///< Q1
  double linear = 0.06;    ///< Q2
  int type = 1;            ///< 1 standard; -1 also shells (none yet), as the deck says
};

struct EnergyControl {     ///< *CONTROL_ENERGY with the established meaning 1 = off, 2 = on
  bool hourglass = false;  ///< HGEN == 2: compute and add hourglass energy to the balance
  bool wall = true;        ///< RWEN == 2
  bool sliding = true;     ///< SLNTEN == 2, the default where there is contact
  bool damping = false;    ///< RYLEN == 2
};

/// Hourglass control of a part: *HOURGLASS, else *CONTROL_HOURGLASS, else the format's default.
struct Hourglass {
  int type = 2;              ///< IHQ 1..6
  double coefficient = 0.1;  ///< QM
  double quadratic_bulk = 1.5, linear_bulk = 0.06;
  deck::Place place{};  ///< of the coefficient in the deck
};

/// How spacetime parts are to be solved: *CONTROL_SPACETIME. Sections of parts may overrule space and degree.
struct SpacetimeControl {
  enum class Space : std::uint8_t { one_field, three_field, trefftz };
  enum class Progress : std::uint8_t {
    triangle,
    subsimplex,
    budget
  };  ///< (a), (b), (c) of docs/spacetime.md
  Space space = Space::trefftz;
  int degree = 3;     ///< of the space, 1 to 6
  double chi = 0.95;  ///< fraction of the characteristic slope, (0, 1) [-]
  Progress progress = Progress::subsimplex;
  double eps = 0.1;            ///< of the progress constraint, (0, 1/2] [-]
  double height_factor = 1.0;  ///< of the allowed height of tents, (0, 1] [-]
  double height_cap = 0.0;     ///< of any tent; 0 none [time]
  double smoothing = 0.0;      ///< inclined poles: share of the way to the mean of the neighbours [-]
  int threads = 0;             ///< 0: as the command line says
  bool verify = false;         ///< hold every patch to its identities
  int subdivision = 0;         ///< of cells in field files; 0: by degree
  bool repeat = false;         ///< regular meshes: equal tents, whose patches share what geometry decides
  deck::Place place;           ///< of the card; not compared
};

struct Control {
  TimeStepControl step;
  Termination end;
  BulkViscosity viscosity;
  EnergyControl energy;
  Hourglass hourglass;               ///< default for parts without their own
  int invariant_node_numbering = 1;  ///< *CONTROL_ACCURACY INN, 1 none
  SpacetimeControl spacetime;
  ContactControl contact;
  int solid_sort = 0;  ///< *CONTROL_SOLID ESORT: 1 wedges in a part of tetrahedra take ELFORM 15
};

}  // namespace cleave::model
