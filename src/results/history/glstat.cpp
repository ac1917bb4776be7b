/// glstat: energies of the whole model, and what controls the step.

#include <algorithm>

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

/// Part id of an element, 0 for none.
model::Id part_of(const solver::Frame& frame, model::Id element) {
  for (const auto& block : frame.world.blocks) {
    const auto ids = block->element_ids();
    if (std::find(ids.begin(), ids.end(), element) != ids.end())
      return frame.model.parts[static_cast<std::size_t>(block->part())].id;
  }
  return 0;
}

class Glstat final : public History {
 public:
  explicit Glstat(const model::Model&) {}
  std::string_view name() const override { return "glstat"; }
  bool per_entity() const override { return false; }
  void legend(std::string&) const override {}
  unsigned needs() const override { return solver::energies; }
  std::vector<std::string> columns() const override {
    return {"time_step",
            "kinetic_energy",
            "internal_energy",
            "hourglass_energy",
            "stonewall_energy",
            "damping_energy",
            "sliding_interface_energy",
            "external_work",
            "eroded_kinetic_energy",
            "eroded_internal_energy",
            "eroded_hourglass_energy",
            "total_energy",
            "energy_ratio",
            "energy_ratio_without_eroded",
            "x_velocity",
            "y_velocity",
            "z_velocity",
            "x_momentum",
            "y_momentum",
            "z_momentum",
            "added_mass",
            "percent_mass_increase"};
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    const discretisation::State& state = now.state();
    const discretisation::Energy& energy = state.energy;
    const Motion& all = now.whole();
    const double inverse = all.mass > 0.0 ? 1.0 / all.mass : 0.0;
    const double percent = now.masses().total() > 0.0 ? 100.0 * state.added_mass / now.masses().total() : 0.0;
    const double step = state.step > 0.0 ? state.step : state.next_step;  // before cycle 1: the first one
    rows.row(std::vector<double>{step,
                                 energy.kinetic,
                                 energy.internal,
                                 energy.hourglass,
                                 energy.wall,
                                 energy.damping,
                                 energy.sliding,
                                 energy.external,
                                 energy.eroded_kinetic,
                                 energy.eroded_internal,
                                 energy.eroded_hourglass,
                                 energy.total(),
                                 energy.ratio(),
                                 energy.ratio_without_eroded(),
                                 inverse * all.momentum[0],
                                 inverse * all.momentum[1],
                                 inverse * all.momentum[2],
                                 all.momentum[0],
                                 all.momentum[1],
                                 all.momentum[2],
                                 state.added_mass,
                                 percent});

    const auto line = [&](const char* label, double value) {
      append_format(ascii, " %s%14.5E\n", label, column(value));
    };
    append_format(ascii, "\n\n dt of cycle %7lld is controlled by solid      element %7lld of part %7lld\n\n",
                  static_cast<long long>(state.cycle), static_cast<long long>(now.frame().step_element),
                  static_cast<long long>(part_of(now.frame(), now.frame().step_element)));
    line("time...........................", state.time);
    line("time step......................", step);
    line("kinetic energy.................", energy.kinetic);
    line("internal energy................", energy.internal);
    if (!now.model().walls.empty()) line("stonewall energy...............", energy.wall);
    line("hourglass energy ..............", energy.hourglass);
    line("system damping energy..........", energy.damping);
    line("sliding interface energy.......", energy.sliding);
    line("external work..................", energy.external);
    line("eroded kinetic energy..........", energy.eroded_kinetic);
    line("eroded internal energy.........", energy.eroded_internal);
    line("eroded hourglass energy........", energy.eroded_hourglass);
    line("total energy...................", energy.total());
    line("total energy / initial energy..", energy.ratio());
    line("energy ratio w/o eroded energy.", energy.ratio_without_eroded());
    line("global x velocity..............", inverse * all.momentum[0]);
    line("global y velocity..............", inverse * all.momentum[1]);
    line("global z velocity..............", inverse * all.momentum[2]);
    if (state.added_mass > 0.0) {
      ascii += "\n\n";
      line("added mass.....................", state.added_mass);
      line("percentage increase............", percent);
    }
  }
};

/// Energies are always wanted: a deck that asks for nothing gets a thousand outputs.
std::unique_ptr<Writer> build(const Context& context) {
  model::Interval interval = context.model.requests.glstat;
  if (!interval.active()) interval.every = context.model.control.end.time / 1000.0;
  return history_writer<Glstat>(context, interval);
}

}  // namespace

extern const WriterEntry glstat{"glstat", build};

}  // namespace cleave::results
