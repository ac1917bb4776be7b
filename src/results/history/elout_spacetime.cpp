/// elout of spacetime parts: stresses in the middle of elements. Same files and columns as for others.

#include "base/tensor.hpp"
#include "discretisation/spacetime/body.hpp"
#include "results/element_values.hpp"
#include "results/history.hpp"
#include "results/history/elout_text.hpp"

namespace cleave::results {
namespace {

using model::ElementKind;

class SpacetimeElout final : public History {
 public:
  explicit SpacetimeElout(const model::Model& model) : model_(model) {
    const model::Requests& r = model.requests;
    kind_ = !r.history_beams.empty()    ? ElementKind::beam
            : !r.history_shells.empty() ? ElementKind::shell
                                        : ElementKind::solid;
  }
  std::string_view name() const override { return "elout"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return 0; }
  void legend(std::string&) const override {}
  std::vector<std::string> columns() const override {
    std::vector<std::string> names = {"part"};
    for (std::string& component : component_names({"stress", 6})) names.push_back(std::move(component));
    names.insert(names.end(), {"effective_plastic_strain", "pressure", "von_mises"});
    return names;
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    if (!now.frame().cells) return;
    append_elout_heading(ascii, kind_, now.state().cycle, now.state().time);
    for (const solver::ElementStress& at : now.frame().cells->stresses()) {
      const auto& part = model_.parts[static_cast<std::size_t>(at.part)];
      const double* s = at.stress;
      const base::Sym3<double> sigma{s[0], s[1], s[2], s[3], s[4], s[5]};
      const double effective = von_mises(sigma);
      append_elout_element(ascii, kind_, at.element, part.id, s, effective, 0.0,
                           kind_ == ElementKind::beam ? spacetime_thickness(part.section) : 0.0);
      const double values[] = {static_cast<double>(part.id), s[0],     s[1], s[2], s[3], s[4], s[5], 0.0,
                               -trace(sigma) / 3.0,          effective};
      rows.row(at.element, values);
    }
  }

 private:
  const model::Model& model_;
  ElementKind kind_;
};

std::unique_ptr<Writer> build(const Context& context) {
  const model::Requests& requests = context.model.requests;
  if (discretisation::spacetime::dimension_of(context.model) == 0 || !requests.any_element()) return nullptr;
  return history_writer<SpacetimeElout>(context, requests.elout);
}

}  // namespace

extern const WriterEntry elout_spacetime{"elout_spacetime", build};

}  // namespace cleave::results
