#include "discretisation/fem/tet4_nodal_pressure.hpp"

#include "discretisation/fem/solid_block.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {13};
constexpr model::Shape shapes[] = {model::Shape::tet4};
constexpr std::string_view name = "tet4-nodal-pressure";
using Element = fem::Tet4NodalPressure;

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics&) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<Element>>(elements, name, Element{{options.needs_F}}, options);
}

}  // namespace

extern const FormulationEntry tet4_nodal_pressure{
    name,  "SOLID",
    forms, shapes,
    build, "Bonet & Burton, CNME 14 (1998) 437-449; Bonet, Marriott & Hassan, CNME 17 (2001) 551-561"};

}  // namespace cleave::discretisation
