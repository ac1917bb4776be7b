#pragma once
/// Named element quantities over all blocks: what field files and element histories write.

#include <string>
#include <vector>

#include "discretisation/world.hpp"

namespace cleave::results {

/// A quantity that at least one block has, or that follows from its stress.
struct Quantity {
  std::string name;
  int size = 1;
};

/// stress, effective_plastic_strain, pressure, von_mises first; then history variables by name, in the order
/// of the blocks. Two blocks that give one name different sizes keep the larger.
std::vector<Quantity> element_quantities(const discretisation::World& world);

/// Values of one quantity in one block; what the block does not have is 0 (pressure and von Mises stress are
/// computed from its stress).
/// @param elements  places in block order; empty means every element
/// @param out       [element][quantity.size], resized
void evaluate(const Quantity& quantity, const discretisation::Block& block,
              const base::Array<double>& position, const discretisation::BlockState& state,
              std::span<const std::size_t> elements, std::vector<double>& out);

/// Column or component names: "stress_xx" ... for stress, NAME for a scalar, NAME_1 ... otherwise.
std::vector<std::string> component_names(const Quantity& quantity);

/// Which elements of a block are still there; unlike std::vector<bool> an array that spans can see.
class Alive {
 public:
  Alive(const discretisation::Block& block, const discretisation::BlockState& state);
  bool operator[](std::size_t element) const { return flag_[element]; }
  std::size_t count() const { return count_; }  ///< of those still there

 private:
  std::unique_ptr<bool[]> flag_;
  std::size_t count_ = 0;
};

}  // namespace cleave::results
