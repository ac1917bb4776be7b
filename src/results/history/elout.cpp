/// elout: stresses and history variables of the elements of *DATABASE_HISTORY_SOLID.

#include <algorithm>

#include "discretisation/spacetime/body.hpp"
#include "results/element_values.hpp"
#include "results/history.hpp"
#include "results/history/elout_text.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Elout final : public History {
 public:
  explicit Elout(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "elout"; }
  bool per_entity() const override { return true; }
  void legend(std::string&) const override {}

  void prepare(const solver::Frame& frame) override {
    // Element -> its place, in the order in which the deck asks.
    std::vector<std::pair<model::Id, std::size_t>> wanted;
    for (std::size_t i = 0; i < model_.requests.history_solids.size(); ++i)
      wanted.emplace_back(model_.requests.history_solids[i], i);
    std::sort(wanted.begin(), wanted.end());
    elements_.assign(wanted.size(), {});
    for (std::size_t b = 0; b < frame.world.blocks.size(); ++b) {
      const auto ids = frame.world.blocks[b]->element_ids();
      for (std::size_t e = 0; e < ids.size(); ++e)
        for (auto at =
                 std::lower_bound(wanted.begin(), wanted.end(), std::pair<model::Id, std::size_t>(ids[e], 0));
             at != wanted.end() && at->first == ids[e]; ++at)
          elements_[at->second] = {ids[e], b, e};
    }
    std::erase_if(elements_, [](const Element& element) { return element.id == 0; });

    // Columns: what the blocks of these elements have.
    quantities_ = element_quantities(frame.world);
    std::erase_if(quantities_, [&](const Quantity& quantity) {
      if (quantity.name == "pressure" || quantity.name == "von_mises" || quantity.name == "stress" ||
          quantity.name == "effective_plastic_strain")
        return false;
      return std::none_of(elements_.begin(), elements_.end(), [&](const Element& element) {
        const auto fields = frame.world.blocks[element.block]->fields();
        return std::any_of(fields.begin(), fields.end(),
                           [&](const auto& f) { return f.name == quantity.name; });
      });
    });
  }

  std::vector<std::string> columns() const override {
    std::vector<std::string> names = {"part"};
    for (const Quantity& quantity : quantities_)
      for (std::string& component : component_names(quantity)) names.push_back(std::move(component));
    return names;
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    const discretisation::World& world = now.frame().world;
    append_elout_heading(ascii, model::ElementKind::solid, now.state().cycle, now.state().time);
    std::vector<std::vector<double>> values(elements_.size());
    std::vector<bool> gone(elements_.size(), false);
    for (std::size_t b = 0; b < world.blocks.size(); ++b) {
      // The elements wanted of this block: `which` of the list, at `places` of the block.
      std::vector<std::size_t> which, places;
      for (std::size_t i = 0; i < elements_.size(); ++i)
        if (elements_[i].block == b) {
          which.push_back(i);
          places.push_back(elements_[i].place);
        }
      if (which.empty()) continue;
      const Alive alive(*world.blocks[b], now.state().blocks[b]);
      for (const std::size_t i : which) gone[i] = !alive[elements_[i].place];
      std::vector<double> part;
      for (const Quantity& quantity : quantities_) {
        evaluate(quantity, *world.blocks[b], now.state().position, now.state().blocks[b], places, part);
        const std::size_t size = static_cast<std::size_t>(quantity.size);
        for (std::size_t k = 0; k < which.size(); ++k)
          values[which[k]].insert(values[which[k]].end(), &part[size * k], &part[size * k] + size);
      }
    }
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (!gone[i]) write_element(world, elements_[i], values[i], ascii, rows);
  }

 private:
  struct Element {
    model::Id id = 0;
    std::size_t block = 0, place = 0;
  };

  void write_element(const discretisation::World& world, const Element& element, std::vector<double>& values,
                     std::string& ascii, Rows& rows) const {
    const model::Id part = model_.parts[static_cast<std::size_t>(world.blocks[element.block]->part())].id;
    // The first quantities are stress, effective plastic strain, pressure and von Mises stress, in this
    // order.
    const double plastic_strain = values[6], von_mises = values[8];
    append_elout_element(ascii, model::ElementKind::solid, element.id, part, values.data(), von_mises,
                         plastic_strain);
    values.insert(values.begin(), static_cast<double>(part));
    rows.row(element.id, values);
  }

  const model::Model& model_;
  std::vector<Element> elements_;
  std::vector<Quantity> quantities_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.requests.history_solids.empty() ||
      discretisation::spacetime::dimension_of(context.model) > 0)
    return nullptr;
  return history_writer<Elout>(context, context.model.requests.elout);
}

}  // namespace

extern const WriterEntry elout{"elout", build};

}  // namespace cleave::results
