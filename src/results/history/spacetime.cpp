/// spacetime: what the tents came to, by the solver's own names.

#include <algorithm>

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Spacetime final : public History {
 public:
  explicit Spacetime(const model::Model&) {}
  std::string_view name() const override { return "spacetime"; }
  bool per_entity() const override { return false; }
  void prepare(const solver::Frame& frame) override {
    for (const solver::Fact& fact : frame.facts) columns_.push_back(fact.name);
  }
  unsigned needs() const override { return solver::energies; }
  std::vector<std::string> columns() const override { return columns_; }
  void legend(std::string&) const override {}

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, "\n\n time =%13.4E\n", column(now.state().time));
    std::vector<double> values;
    for (const solver::Fact& fact : now.frame().facts) {
      values.push_back(fact.value);
      std::string label = fact.name;
      std::replace(label.begin(), label.end(), '_', ' ');
      label.resize(31, '.');
      append_format(ascii, " %s%14.5E\n", label.c_str(), column(fact.value));
    }
    rows.row(values);
  }

 private:
  std::vector<std::string> columns_;
};

/// As often as energies are written, for models of spacetime parts.
std::unique_ptr<Writer> build(const Context& context) {
  const auto& parts = context.model.parts;
  if (std::none_of(parts.begin(), parts.end(),
                   [](const model::Part& part) { return part.section.family.ends_with("_SDG"); }))
    return nullptr;
  model::Interval interval = context.model.requests.glstat;
  if (!interval.active()) interval.every = context.model.control.end.time / 1000.0;
  return history_writer<Spacetime>(context, interval);
}

}  // namespace

extern const WriterEntry spacetime{"spacetime", build};

}  // namespace cleave::results
