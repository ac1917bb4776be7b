#pragma once
/// How the run is to be carried out: *CONTROL_* and *TERMINATION_* with every default filled in.

#include <optional>
#include <vector>

#include "model/mesh.hpp"

namespace cleave::model {

struct TimeStepControl {
  double first = 0.0;                    ///< DTINIT, 0 automatic [time]
  double safety = 0.9;                   ///< TSSFAC
  double mass_scaling = 0.0;             ///< DT2MS: <0 only smaller elements, >0 all; 0 none [time]
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
  bool no_solution_check = false;  ///< NOSOL is refused; kept false
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
  bool sliding = false;    ///< SLNTEN == 2
  bool damping = false;    ///< RYLEN == 2
};

/// Hourglass control of a part: *HOURGLASS, else *CONTROL_HOURGLASS, else the format's default.
struct Hourglass {
  int type = 2;              ///< IHQ 1..6
  double coefficient = 0.1;  ///< QM
  double quadratic_bulk = 1.5, linear_bulk = 0.06;
};

struct Control {
  TimeStepControl step;
  Termination end;
  BulkViscosity viscosity;
  EnergyControl energy;
  Hourglass hourglass;               ///< default for parts without their own
  int invariant_node_numbering = 1;  ///< *CONTROL_ACCURACY INN, 1 none
  int solid_sort = 0;                ///< *CONTROL_SOLID ESORT: 1 tetrahedra and wedges take ELFORM 10 and 15
};

}  // namespace cleave::model
