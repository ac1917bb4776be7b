#include "discretisation/fem/hex8_one_point.hpp"

#include "discretisation/fem/hourglass_limit.hpp"
#include "discretisation/fem/hourglass_stiffness.hpp"
#include "discretisation/fem/solid_block.hpp"

namespace cleave::discretisation {
namespace {

constexpr int forms[] = {1};
constexpr model::Shape shapes[] = {model::Shape::hex8};
constexpr std::string_view name = "hex8-one-point";

template <class Hourglass>
std::unique_ptr<Block> make(const PartElements& elements, Hourglass hourglass) {
  const auto options = fem::solid_options(elements);
  return std::make_unique<fem::SolidBlock<fem::HexOnePoint<Hourglass>>>(
      elements, name, fem::HexOnePoint<Hourglass>{hourglass, options.needs_F}, options);
}

std::unique_ptr<Block> build(const PartElements& elements, deck::Diagnostics& diagnostics) {
  const auto& part = elements.model.parts[static_cast<std::size_t>(elements.part)];
  const auto& control = part.hourglass;
  switch (control.type) {
    case 1:
    case 2:
    case 3:
      fem::warn_of_unstable_hourglass(elements, diagnostics);
      return make(elements, fem::ViscousHourglass{control.coefficient});
    case 4:
    case 5:
      return make(elements, fem::StiffnessHourglass{control.coefficient});
    case 6:
      return make(elements, fem::AssumedStrainHourglass{control.coefficient});
  }
  diagnostics.error(part.place, "HOURGLASS", "IHQ",
                    "hourglass type " + std::to_string(control.type) + " is not one of 1 to 6");
  return nullptr;
}

}  // namespace

extern const FormulationEntry hex8_one_point{
    name, "SOLID", forms, shapes, build, "Flanagan & Belytschko, IJNME 17 (1981) 679-706"};

}  // namespace cleave::discretisation
