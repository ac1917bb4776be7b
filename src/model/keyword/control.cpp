/// *CONTROL_*: how the run is carried out.

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

void take_termination(Draft& draft, const Entry& entry) {
  Termination& end = draft.model.control.end;
  end.time = entry.real("ENDTIM", a_time);
  if (!(end.time > 0.0)) draft.error(entry, "ENDTIM", "the end time must be above 0");
  end.cycles = entry.integer("ENDCYC");
  end.no_solution_check = entry.integer("NOSOL") == 1;
  end.step_fraction = entry.real("DTMIN", pure);
  end.energy_change = entry.real("ENDENG", pure);
  // The documented default of 1e8 percent means: never.
  end.mass_change = entry.real("ENDMAS", pure) >= 1e8 ? 0.0 : entry.real("ENDMAS", pure);
}

void take_time_step(Draft& draft, const Entry& entry) {
  TimeStepControl& step = draft.model.control.step;
  step.first = entry.real("DTINIT", a_time);
  step.safety = entry.real_or("TSSFAC", pure, 0.9);
  if (step.safety < 0.0 || step.safety > 1.0)
    draft.warning(entry, "TSSFAC",
                  "found " + std::to_string(step.safety) + ", expected a factor between 0 and 1");
  step.mass_scaling = entry.real("DT2MS", a_time);
  step.mass_scaling_first_only = entry.integer("MS1ST") == 1;
  step.mass_scaling_fraction = entry.real("DT2MSF", pure);
  if (step.mass_scaling_fraction < 0.0)
    draft.error(entry, "DT2MSF",
                "found " + std::to_string(step.mass_scaling_fraction) + ", expected 0 or above",
                "the fraction of the first step below which elements get mass");
  if (step.mass_scaling_fraction > 0.0 && step.mass_scaling != 0.0) {
    draft.warning(entry, "DT2MSF", "not used with DT2MS, which gives the step itself");
    step.mass_scaling_fraction = 0.0;
  }
  step.erode = entry.integer("ERODE") != 0;
  if (step.erode && (step.mass_scaling != 0.0 || step.mass_scaling_fraction > 0.0))
    draft.warning(entry, "ERODE", "not used with mass scaling (DT2MS): a scaled element is not small",
                  "leave DT2MS blank to delete elements by their time step");
  step.limit_curve = draft.curve(entry, "LCTM", false);
  if (entry.integer("DT2MSLC") != 0) step.mass_scaling_curve = draft.curve(entry, "DT2MSLC", false);
  if (entry.integer("ISDO") != 0)
    draft.warning(entry, "ISDO", "the length measure of shells; solids use volume over largest face");
}

void take_viscosity(Draft& draft, const Entry& entry) {
  BulkViscosity& viscosity = draft.model.control.viscosity;
  viscosity.quadratic = entry.real_or("Q1", pure, 1.5);
  viscosity.linear = entry.real_or("Q2", pure, 0.06);
  viscosity.type = static_cast<int>(entry.integer("TYPE") == 0 ? 1 : entry.integer("TYPE"));
}

/// 1 is off, 2 is on; 0 takes the default.
bool switched_on(Draft& draft, const Entry& entry, std::string_view field, bool by_default) {
  const auto value = entry.integer(field);
  if (value < 0 || value > 3)
    draft.error(entry, field,
                "found " + std::to_string(value) + ", expected 1 (not computed) or 2 (computed)");
  return value == 0 ? by_default : value >= 2;
}

void take_energy(Draft& draft, const Entry& entry) {
  EnergyControl& energy = draft.model.control.energy;
  energy.hourglass = switched_on(draft, entry, "HGEN", false);
  energy.wall = switched_on(draft, entry, "RWEN", true);
  energy.sliding = switched_on(draft, entry, "SLNTEN", true);
  energy.damping = switched_on(draft, entry, "RYLEN", false);
}

void take_hourglass(Draft& draft, const Entry& entry) {
  Hourglass& hourglass = draft.model.control.hourglass;
  const auto type = entry.integer("IHQ");
  if (type < 0 || type > 6)
    return draft.refuse(entry, "IHQ", "hourglass type " + std::to_string(type), "types 1 to 6 are computed");
  if (type != 0) hourglass.type = static_cast<int>(type);
  hourglass.coefficient = entry.real_or("QH", pure, 0.1);
  hourglass.place = entry.place("QH");
}

void take_accuracy(Draft& draft, const Entry& entry) {
  const auto inn = entry.integer("INN");
  draft.model.control.invariant_node_numbering = static_cast<int>(inn == 0 ? 1 : inn);
}

void take_solid(Draft& draft, const Entry& entry) {
  const auto sort = entry.integer("ESORT");
  if (sort < 0 || sort > 2)
    draft.error(entry, "ESORT", "found " + std::to_string(sort) + ", expected 0, 1 or 2");
  if (sort == 2)
    return draft.refuse(entry, "ESORT", "wedges with one point (ELFORM 115)",
                        "1 makes wedges ELFORM 15 and tetrahedra ELFORM 10");
  draft.model.control.solid_sort = static_cast<int>(sort);
}

/// SOLN says which problem is solved; only 0, the mechanical one, is.
void take_solution(Draft& draft, const Entry& entry) {
  if (entry.integer("SOLN") != 0)
    draft.refuse(entry, "SOLN", "thermal or coupled analysis", "only mechanical analysis (0) is computed");
}

/// A relaxation phase before the run is asked for by IDRFLG other than 0 and -999.
void take_relaxation(Draft& draft, const Entry& entry) {
  const auto flag = entry.integer("IDRFLG");
  if (flag != 0 && flag != -999)
    draft.refuse(entry, "IDRFLG", "dynamic relaxation", "use *DAMPING_GLOBAL in a run of its own");
}

constexpr Handler handlers[] = {
    {.keyword = "CONTROL_TERMINATION",
     .phase = Phase::definition,
     .honoured = "ENDTIM ENDCYC DTMIN ENDENG ENDMAS NOSOL",
     .take = take_termination},
    {.keyword = "CONTROL_TIMESTEP",
     .phase = Phase::definition,
     .honoured = "DTINIT TSSFAC ISDO DT2MS LCTM ERODE MS1ST DT2MSF DT2MSLC",
     .harmless = "TSLIMT IHDO IGADO",
     .take = take_time_step,
     .remark = "selective mass scaling (IMSCL, RMSCL) is refused"},
    {.keyword = "CONTROL_BULK_VISCOSITY",
     .phase = Phase::definition,
     .honoured = "Q1 Q2 TYPE",
     .harmless = "BTYPE TSTYPE",
     .take = take_viscosity},
    {.keyword = "CONTROL_ENERGY",
     .phase = Phase::definition,
     .honoured = "HGEN RWEN SLNTEN RYLEN",
     .harmless = "IRGEN MATEN DRLEN DISEN",
     .take = take_energy},
    {.keyword = "CONTROL_HOURGLASS",
     .phase = Phase::definition,
     .honoured = "IHQ QH",
     .take = take_hourglass},
    {.keyword = "CONTROL_ACCURACY",
     .phase = Phase::definition,
     .honoured = "INN",
     .harmless = "OSU PIDOS IACC EXACC SRTFLG",
     .take = take_accuracy,
     .remark = "stress rates are second order in every run"},
    {.keyword = "CONTROL_SOLUTION",
     .phase = Phase::definition,
     .honoured = "SOLN",
     .harmless = "NLQ ISNAN LCINT LCACC NCDCF NOCOPY",
     .take = take_solution},
    {.keyword = "CONTROL_DYNAMIC_RELAXATION",
     .phase = Phase::definition,
     .honoured = "IDRFLG",
     .harmless = "NRCYCK DRTOL DRFCTR DRTERM TSSFDR IRELAL EDTTL DRPSET",
     .take = take_relaxation},
    {.keyword = "CONTROL_SOLID",
     .phase = Phase::definition,
     .honoured = "ESORT",
     .harmless = "FMATRX SWLOCL T10JTOL ICOH RINRT COHEQC",
     .take = take_solid,
     .remark = "tetrahedra and wedges in a part of hexahedra are ELFORM 10 and 15 with any ESORT, never "
               "hexahedra with repeated nodes"},
};

}  // namespace
extern const Family control_cards{handlers};

}  // namespace cleave::model
