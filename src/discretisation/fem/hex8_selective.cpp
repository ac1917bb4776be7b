#include "discretisation/fem/hexahedron.hpp"
#include "discretisation/fem/solid_block.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {2};
constexpr model::Shape shapes[] = {model::Shape::hex8};
constexpr std::string_view name = "hex8-selective";
using Element = fem::Isoparametric<fem::Hex8, true>;

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics&) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<Element>>(elements, name, Element{options.needs_F}, options);
}

}  // namespace

extern const FormulationEntry hex8_selective{name,   "SOLID", forms,
                                             shapes, build,   "Hughes, IJNME 15 (1980) 1413-1418"};

}  // namespace cleave::discretisation
