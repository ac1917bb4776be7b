/// ncforc: contact forces and pressures at nodes.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Ncforc final : public History {
 public:
  explicit Ncforc(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "ncforc"; }
  bool per_entity() const override { return true; }
  std::vector<std::string> columns() const override { return {"x_force", "y_force", "z_force", "pressure"}; }
  void legend(std::string&) const override {}

  /// Nodes without contact force are left out.
  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    if (!now.frame().contact) return;
    const std::vector<double> pressure = now.frame().contact->contact_fields().pressure;
    append_format(ascii, "\n\n forces (t=%13.5E) for nodes in contact\n\n", column(now.state().time));
    ascii += "  nodal group    force-x      force-y      force-z      pressure\n";
    for (std::size_t a = 0; a < pressure.size(); ++a) {
      const double* f = now.frame().contact_force.data() + 3 * a;
      if (f[0] == 0.0 && f[1] == 0.0 && f[2] == 0.0) continue;
      const model::Id id = model_.mesh.nodes.id[a];
      rows.row(id, std::vector<double>{f[0], f[1], f[2], pressure[a]});
      append_format(ascii, "%9lld%15.4E%13.4E%13.4E%13.4E\n", static_cast<long long>(id), column(f[0]),
                    column(f[1]), column(f[2]), column(pressure[a]));
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.contacts.empty()) return nullptr;
  return history_writer<Ncforc>(context, context.model.requests.ncforc);
}

}  // namespace

extern const WriterEntry ncforc{"ncforc", build};

}  // namespace cleave::results
