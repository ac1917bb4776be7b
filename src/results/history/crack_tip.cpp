/// crack_tip: stress intensities at the tips of cracks.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class CrackTips final : public History {
 public:
  explicit CrackTips(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "crack_tip"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return 0; }
  std::vector<std::string> columns() const override {
    return {"K_I",     "K_II",    "K_III",    "near",     "far",     "x_ahead",
            "y_ahead", "z_ahead", "x_normal", "y_normal", "z_normal"};
  }
  void legend(std::string&) const override {}

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, "\n\n crack tips at time =%14.7E\n", column(now.state().time));
    ascii += "\n     node         K_I        K_II       K_III        from          to\n";
    for (const solver::CrackTip& at : now.frame().tips) {
      const model::Id id = model_.mesh.nodes.id[static_cast<std::size_t>(at.node)];
      const double values[] = {at.intensity[0], at.intensity[1], at.intensity[2], at.near,
                               at.far,          at.ahead[0],     at.ahead[1],     at.ahead[2],
                               at.normal[0],    at.normal[1],    at.normal[2]};
      rows.row(id, values);
      append_format(ascii, "%9lld", static_cast<long long>(id));
      for (int k = 0; k < 5; ++k) append_format(ascii, "%12.4E", column(values[k]));
      ascii += '\n';
    }
  }

 private:
  const model::Model& model_;
};

/// As often as nodout, for models with cracks.
std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.precracks.empty()) return nullptr;
  return history_writer<CrackTips>(context, context.model.requests.nodout);
}

}  // namespace

extern const WriterEntry crack_tip{"crack_tip", build};

}  // namespace cleave::results
