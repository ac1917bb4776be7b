/// Materials, local spaces and thickness of spacetime parts.

#include "discretisation/spacetime/body_steps.hpp"
#include "model/elasticity.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Of the section, where it says any; else of the control card.
SpaceChoice space_of(const model::Part& part, const model::SpacetimeControl& control) {
  using Asked = model::SpacetimeControl::Space;
  static constexpr Asked codes[] = {Asked::trefftz, Asked::one_field, Asked::three_field, Asked::trefftz};
  const int code = static_cast<int>(part.section.number("SPACE", 0.0)),
            degree = static_cast<int>(part.section.number("DEGREE", 0.0));
  const Asked space = code == 0 ? control.space : codes[code];
  return {space == Asked::one_field     ? LocalSpace::one_field
          : space == Asked::three_field ? LocalSpace::three_field
                                        : LocalSpace::trefftz,
          degree == 0 ? control.degree : degree};
}

/// Is the cross section free (bars) or the plate thin, so that stresses across it vanish?
PlaneKind plane_of(const model::Section& section) {
  const int dimension = spacetime_dimension(section);
  const bool stress = dimension == 1 ? section.form == 1 : dimension == 2 && section.form == 12;
  return stress ? PlaneKind::stress : PlaneKind::strain;
}

}  // namespace

template <int D>
void gather_parts(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics) {
  for (const model::Part& part : model.parts) {
    Elastic<D> material;
    const PlaneKind plane = plane_of(part.section);
    const auto index = static_cast<model::Index>(&part - model.parts.data());
    const std::string wrong =
        !part.elastic ? "it has no linear elastic material"
        : part.elastic->isotropic
            ? make_isotropic<D>(part.density, part.elastic->young, part.elastic->poisson, plane, material)
            : make_orthotropic<D>(model, index, plane, material);
    if (!wrong.empty())
      diagnostics.error(part.elastic ? part.elastic->place : part.place, part.material_keyword, "",
                        "part " + std::to_string(part.id) + ": " + wrong);
    body.problem.materials.push_back(material);
    body.problem.spaces.push_back(space_of(part, model.control.spacetime));

    const double thickness = spacetime_thickness(part.section);
    if (&part != &model.parts.front() && thickness != body.thickness)
      diagnostics.error(part.section.place, "SECTION_" + part.section.family, D == 1 ? "A" : "T1",
                        "part " + std::to_string(part.id) + " has " + shortest(thickness) + ", part " +
                            std::to_string(model.parts.front().id) + " has " + shortest(body.thickness),
                        "all parts of a body must have the same thickness or area");
    body.thickness = thickness;
  }
}

template void gather_parts<1>(const model::Model&, Body<1>&, deck::Diagnostics&);
template void gather_parts<2>(const model::Model&, Body<2>&, deck::Diagnostics&);
template void gather_parts<3>(const model::Model&, Body<3>&, deck::Diagnostics&);

}  // namespace cleave::discretisation::spacetime
