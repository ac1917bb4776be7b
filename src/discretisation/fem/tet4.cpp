#include "discretisation/fem/solid_block.hpp"
#include "discretisation/fem/tetrahedron.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {1, 2, 10};
constexpr model::Shape shapes[] = {model::Shape::tet4};
constexpr std::string_view name = "tet4";
using Element = fem::Isoparametric<fem::Tet4, false>;

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics&) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<Element>>(elements, name, Element{options.needs_F}, options);
}

}  // namespace

extern const FormulationEntry tet4{
    name, "SOLID", forms, shapes, build, "Zienkiewicz & Taylor, The Finite Element Method (2000), sec. 6.2"};

}  // namespace cleave::discretisation
