#include "discretisation/rigid/block.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "discretisation/rigid/mass.hpp"

namespace cleave::discretisation {
namespace {

class RigidBlock final : public Block {
 public:
  explicit RigidBlock(PartElements elements)
      : part_(elements.part),
        shape_(elements.shape),
        id_(std::move(elements.id)),
        node_(std::move(elements.node)),
        mass_(id_.size()) {
    const model::Part& part = elements.model.parts[static_cast<std::size_t>(part_)];
    const auto n = static_cast<std::size_t>(model::nodes_of(shape_));
    std::vector<model::Vector> corner(n);
    for (std::size_t e = 0; e < id_.size(); ++e) {
      for (std::size_t a = 0; a < n; ++a) {
        const double* x = &elements.model.mesh.nodes.position[3 * static_cast<std::size_t>(node_[n * e + a])];
        corner[a] = {x[0], x[1], x[2]};
      }
      mass_[e] = element_mass(part, shape_, corner).mass;
    }
  }

  Index part() const override { return part_; }
  model::Shape shape() const override { return shape_; }
  std::string_view formulation() const override { return "rigid"; }
  int points_per_element() const override { return 1; }
  std::span<const Id> element_ids() const override { return id_; }
  std::span<const Index> connectivity() const override { return node_; }

  StepStatus initialise(const base::Array<double>&, BlockState& state) const override {
    state.alive.assign(id_.size(), 1.0);
    return {};
  }
  void add_mass(const BlockState&, std::span<double> mass) const override {
    add(mass, [](std::size_t) { return 1.0; });
  }
  void add_scaled_mass(const BlockState&, std::span<const double> factor,
                       std::span<double> mass) const override {
    add(mass, [&](std::size_t e) { return factor[e]; });
  }
  StepOutput add_force(const StepInput&, BlockState&, ForceSum&) const override { return {}; }
  void stable_steps(const base::Array<double>&, const BlockState&, std::span<double> steps) const override {
    std::fill(steps.begin(), steps.end(), 1.0e30);
  }
  std::vector<ElementField> fields() const override { return {}; }
  void evaluate(std::string_view, const base::Array<double>&, const BlockState&, std::span<const std::size_t>,
                std::span<double>) const override {
    CLEAVE_ASSERT(false, "rigid elements have no fields");
  }
  void alive(const BlockState&, std::span<bool> out) const override {
    std::fill(out.begin(), out.end(), true);
  }
  double bytes_per_element() const override {
    return static_cast<double>(sizeof(Id) + sizeof(double) +
                               static_cast<std::size_t>(model::nodes_of(shape_)) * sizeof(Index));
  }

 private:
  template <class Factor>
  void add(std::span<double> mass, const Factor& factor) const {
    const auto n = static_cast<std::size_t>(model::nodes_of(shape_));
    for (std::size_t e = 0; e < id_.size(); ++e) {
      const double share = factor(e) * mass_[e] / static_cast<double>(n);
      for (std::size_t a = 0; a < n; ++a) mass[static_cast<std::size_t>(node_[n * e + a])] += share;
    }
  }

  Index part_;
  model::Shape shape_;
  std::vector<Id> id_;
  std::vector<Index> node_;
  std::vector<double> mass_;  // [element]
};

}  // namespace

double shell_thickness(const model::Section& section) {
  return section.family == "SHELL" ? section.number("T1", 0.0) : 0.0;
}

RigidMass element_mass(const model::Part& part, model::Shape shape, std::span<const model::Vector> corner) {
  if (shape == model::Shape::tri3 || shape == model::Shape::quad4)
    return shell_mass(shape, corner, part.density, shell_thickness(part.section),
                      part.section.number("MAREA", 0.0));
  return solid_mass(shape, corner, part.density);
}

std::unique_ptr<Block> make_rigid_block(PartElements elements) {
  return std::make_unique<RigidBlock>(std::move(elements));
}

}  // namespace cleave::discretisation
