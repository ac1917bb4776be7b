#include "results/element_values.hpp"

#include <algorithm>

#include "base/tensor.hpp"

namespace cleave::results {
namespace {

/// The block's own field of that name; null when it has none.
const discretisation::ElementField* find(const std::vector<discretisation::ElementField>& fields,
                                         const std::string& name) {
  const auto at = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == name; });
  return at == fields.end() ? nullptr : &*at;
}

}  // namespace

std::vector<Quantity> element_quantities(const discretisation::World& world) {
  std::vector<Quantity> all = {
      {"stress", 6}, {"effective_plastic_strain", 1}, {"pressure", 1}, {"von_mises", 1}};
  for (const auto& block : world.blocks)
    for (const discretisation::ElementField& field : block->fields()) {
      const auto at =
          std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == field.name; });
      if (at == all.end())
        all.push_back({field.name, field.size});
      else
        at->size = std::max(at->size, field.size);
    }
  return all;
}

void evaluate(const Quantity& quantity, const discretisation::Block& block,
              const base::Array<double>& position, const discretisation::BlockState& state,
              std::span<const std::size_t> elements, std::vector<double>& out) {
  const std::size_t count = elements.empty() ? block.element_ids().size() : elements.size();
  const std::size_t size = static_cast<std::size_t>(quantity.size);
  out.assign(count * size, 0.0);
  const auto fields = block.fields();
  if (const auto* field = find(fields, quantity.name)) {
    const std::size_t own = static_cast<std::size_t>(field->size);
    if (own == size) {
      block.evaluate(field->name, position, state, elements, out);
      return;
    }
    std::vector<double> values(count * own);
    block.evaluate(field->name, position, state, elements, values);
    for (std::size_t e = 0; e < count; ++e)
      for (std::size_t k = 0; k < own; ++k) out[e * size + k] = values[e * own + k];
    return;
  }
  if ((quantity.name != "pressure" && quantity.name != "von_mises") || !find(fields, "stress")) return;
  std::vector<double> stress(6 * count);
  block.evaluate("stress", position, state, elements, stress);
  for (std::size_t e = 0; e < count; ++e) {
    const double* s = &stress[6 * e];
    const base::Sym3<double> sigma{s[0], s[1], s[2], s[3], s[4], s[5]};
    out[e] = quantity.name == "pressure" ? -trace(sigma) / 3.0 : von_mises(sigma);
  }
}

std::vector<std::string> component_names(const Quantity& quantity) {
  if (quantity.size == 1) return {quantity.name};
  std::vector<std::string> names;
  if (quantity.size == 6) {
    for (const char* axes : {"xx", "yy", "zz", "xy", "yz", "zx"}) names.push_back(quantity.name + '_' + axes);
    return names;
  }
  for (int k = 1; k <= quantity.size; ++k) names.push_back(quantity.name + '_' + std::to_string(k));
  return names;
}

Alive::Alive(const discretisation::Block& block, const discretisation::BlockState& state) {
  const std::size_t count = block.element_ids().size();
  flag_ = std::make_unique<bool[]>(count);
  block.alive(state, std::span<bool>(flag_.get(), count));
  count_ = static_cast<std::size_t>(std::count(flag_.get(), flag_.get() + count, true));
}

}  // namespace cleave::results
