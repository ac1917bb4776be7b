#include "discretisation/fem/solid_block.hpp"
#include "discretisation/fem/tetrahedron.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {1, 2, 16};
constexpr model::Shape shapes[] = {model::Shape::tet10};
constexpr std::string_view name = "tet10";
using Element = fem::Isoparametric<fem::Tet10, false>;

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics&) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<Element>>(elements, name, Element{options.needs_F}, options);
}

}  // namespace

extern const FormulationEntry tet10{
    name,
    "SOLID",
    forms,
    shapes,
    build,
    "Zienkiewicz & Taylor, The Finite Element Method (2000), sec. 8.8; Hinton, Rock & Zienkiewicz 1976"};

}  // namespace cleave::discretisation
