#include "discretisation/fem/hexahedron.hpp"
#include "discretisation/fem/solid_block.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {1, 2, 15};
constexpr model::Shape shapes[] = {model::Shape::penta6};
constexpr std::string_view name = "penta6";
using Element = fem::Isoparametric<fem::Penta6, true>;

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics&) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<Element>>(elements, name, Element{options.needs_F}, options);
}

}  // namespace

extern const FormulationEntry penta6{
    name,   "SOLID", forms,
    shapes, build,   "Zienkiewicz & Taylor, The Finite Element Method (2000), sec. 8.8; Hughes 1980"};

}  // namespace cleave::discretisation
