/// crack: opening and sliding of cracks at the nodes of *DATABASE_HISTORY_NODE.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Crack final : public History {
 public:
  explicit Crack(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "crack"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return 0; }
  std::vector<std::string> columns() const override {
    return {"side", "opening", "sliding", "x_normal", "y_normal", "z_normal"};
  }
  void legend(std::string& ascii) const override {
    append_legend(ascii, model_.requests.history_node_titles);
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, "\n\n cracks at time =%14.7E\n", column(now.state().time));
    ascii += "\n     node side     opening     sliding    x-normal    y-normal    z-normal\n";
    for (const solver::CrackOpening& at : now.frame().cracks) {
      const model::Id id = model_.mesh.nodes.id[static_cast<std::size_t>(at.node)];
      const double values[] = {
          static_cast<double>(at.side), at.opening, at.sliding, at.normal[0], at.normal[1], at.normal[2]};
      rows.row(id, values);
      append_format(ascii, "%9lld%5d", static_cast<long long>(id), at.side);
      for (int k = 1; k < 6; ++k) append_format(ascii, "%12.4E", column(values[k]));
      ascii += '\n';
    }
  }

 private:
  const model::Model& model_;
};

/// As often as nodout, for models with cracks.
std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.precracks.empty() || context.model.requests.history_nodes.empty()) return nullptr;
  return history_writer<Crack>(context, context.model.requests.nodout);
}

}  // namespace

extern const WriterEntry crack{"crack", build};

}  // namespace cleave::results
