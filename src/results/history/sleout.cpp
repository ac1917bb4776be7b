/// sleout: energies of each contact: stored in its springs, and taken by friction and damping.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Sleout final : public History {
 public:
  explicit Sleout(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "sleout"; }
  bool per_entity() const override { return true; }
  std::vector<std::string> columns() const override {
    return {"total_energy", "normal_energy", "friction_energy", "damping_energy"};
  }
  void legend(std::string& ascii) const override { append_titles(ascii, model_.contacts); }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    double sum = 0.0;
    for (const solver::InterfaceForce& one : now.frame().interfaces) sum += one.energy();
    append_format(ascii, "\n\n sliding interface energies, time =%13.5E\n total = %13.5E\n\n",
                  column(now.state().time), column(sum));
    ascii += "      #         total        normal      friction       damping\n";
    for (std::size_t c = 0; c < now.frame().interfaces.size(); ++c) {
      const solver::InterfaceForce& one = now.frame().interfaces[c];
      const model::Id id = model_.contacts[c].id;
      rows.row(id,
               std::vector<double>{one.energy(), one.normal_energy, one.friction_energy, one.damping_energy});
      append_format(ascii, "%7lld%14.5E%14.5E%14.5E%14.5E\n", static_cast<long long>(id),
                    column(one.energy()), column(one.normal_energy), column(one.friction_energy),
                    column(one.damping_energy));
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.contacts.empty()) return nullptr;
  return history_writer<Sleout>(context, context.model.requests.sleout);
}

}  // namespace

extern const WriterEntry sleout{"sleout", build};

}  // namespace cleave::results
