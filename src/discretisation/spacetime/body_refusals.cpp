#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {

void refuse_unsupported(const model::Model& model, deck::Diagnostics& diagnostics) {
  const auto refuse = [&](const deck::Place& place, std::string keyword, std::string field, std::string what,
                          std::string instead) {
    diagnostics.error(place, std::move(keyword), std::move(field), std::move(what), std::move(instead));
  };
  for (const auto& load : model.node_loads)
    refuse(load.place, "LOAD_NODE", "", "a force at a point has no finite displacement in spacetime parts",
           "spread it over faces by *LOAD_SEGMENT");
  for (const auto& wall : model.walls)
    refuse(wall.place, wall.keyword, "", "rigid walls are not computed for spacetime parts",
           "prescribe the motion of the faces that would touch it");
  for (const auto& contact : model.contacts)
    refuse(contact.place, contact.keyword, "", "contact is not computed for spacetime parts",
           "join the parts by shared nodes, or take an ELFORM of ordinary solids");
  for (const auto& mass : model.point_masses)
    refuse(mass.place, "ELEMENT_MASS", "", "spacetime parts have no nodal masses to add to",
           "give a denser material to a part of its own");
  for (const auto& damping : model.global_damping)
    refuse(damping.place, "DAMPING_GLOBAL", "", "damping is not computed for spacetime parts",
           "leave it out");
  for (const model::Part& part : model.parts) {
    const std::string name = "part " + std::to_string(part.id);
    if (part.mass_damping != 0.0 || part.stiffness_damping != 0.0)
      refuse(part.place, "DAMPING_PART", "", name + ": damping is not computed for spacetime parts",
             "leave it out");
  }
  const model::Control& control = model.control;
  if (control.step.mass_scaling != 0.0 || control.step.mass_scaling_fraction > 0.0 ||
      control.step.mass_scaling_curve >= 0)
    refuse({}, "CONTROL_TIMESTEP", "DT2MS", "masses are not scaled in spacetime parts",
           "small elements need no scaling here: only they take small steps");
  if (control.step.erode)
    refuse({}, "CONTROL_TIMESTEP", "ERODE", "elements are not deleted in spacetime parts", "leave it 0");
  if (control.step.limit_curve >= 0)
    refuse({}, "CONTROL_TIMESTEP", "LCTM", "there is no step to limit in spacetime parts",
           "limit the height of tents by HCAP of *CONTROL_SPACETIME");
}

}  // namespace cleave::discretisation::spacetime
