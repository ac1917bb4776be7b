/// matsum: energies, momentum and rigid-body velocity of each part.

#include <algorithm>

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Matsum final : public History {
 public:
  explicit Matsum(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "matsum"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return solver::energies; }
  std::vector<std::string> columns() const override {
    return {"internal_energy",
            "kinetic_energy",
            "hourglass_energy",
            "eroded_internal_energy",
            "eroded_kinetic_energy",
            "eroded_hourglass_energy",
            "x_momentum",
            "y_momentum",
            "z_momentum",
            "x_rigid_body_velocity",
            "y_rigid_body_velocity",
            "z_rigid_body_velocity",
            "mass",
            "added_mass"};
  }
  void legend(std::string& ascii) const override {
    std::vector<std::pair<model::Id, std::string>> entries;
    for (const model::Part& part : model_.parts) entries.emplace_back(part.id, part.title);
    append_legend(ascii, entries);
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, "\n\n time =%13.4E\n", column(now.state().time));
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
      const Motion& motion = now.parts()[p];
      const discretisation::PartEnergy energy =
          p < now.state().parts.size() ? now.state().parts[p] : discretisation::PartEnergy{};
      const double inverse = motion.mass > 0.0 ? 1.0 / motion.mass : 0.0;
      const double velocity[3] = {inverse * motion.momentum[0], inverse * motion.momentum[1],
                                  inverse * motion.momentum[2]};
      const double added =
          now.state().added_mass > 0.0 ? std::max(0.0, motion.mass - now.masses().parts()[p].total) : 0.0;
      const model::Id id = model_.parts[p].id;
      rows.row(id, std::vector<double>{energy.internal, motion.kinetic, energy.hourglass,
                                       energy.eroded_internal, energy.eroded_kinetic, energy.eroded_hourglass,
                                       motion.momentum[0], motion.momentum[1], motion.momentum[2],
                                       velocity[0], velocity[1], velocity[2], motion.mass, added});

      append_format(ascii, id < 100000 ? " mat.#=%5lld   " : " mat.#=%8lld", static_cast<long long>(id));
      append_format(ascii,
                    "          inten=%13.4E     kinen=%13.4E     eroded_ie=%13.4E     eroded_ke=%13.4E\n",
                    column(energy.internal), column(motion.kinetic), column(energy.eroded_internal),
                    column(energy.eroded_kinetic));
      append_format(ascii, " x-mom=%13.4E     y-mom=%13.4E     z-mom=%13.4E\n", column(motion.momentum[0]),
                    column(motion.momentum[1]), column(motion.momentum[2]));
      append_format(ascii, " x-rbv=%13.4E     y-rbv=%13.4E     z-rbv=%13.4E\n", column(velocity[0]),
                    column(velocity[1]), column(velocity[2]));
      append_format(ascii, "                         hgeng=%13.4E     +mass=%13.4E     eroded_he=%13.4E\n\n",
                    column(energy.hourglass), column(added), column(energy.eroded_hourglass));
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  return history_writer<Matsum>(context, context.model.requests.matsum);
}

}  // namespace

extern const WriterEntry matsum{"matsum", build};

}  // namespace cleave::results
