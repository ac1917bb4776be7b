/// spcforc: reaction forces at single point constraints.

#include <algorithm>

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

/// What a *BOUNDARY_SPC, or several on one node, hold.
struct Support {
  model::Index node = -1;
  std::vector<const model::FixedNodes*> by;
};

class Spcforc final : public History {
 public:
  explicit Spcforc(const model::Model& model) : model_(model) {
    for (const model::FixedNodes& fixed : model.fixed)
      if (fixed.directions & 7u)
        for (const model::Index node : fixed.nodes) supports_.push_back({node, {&fixed}});
    std::stable_sort(supports_.begin(), supports_.end(),
                     [](const Support& a, const Support& b) { return a.node < b.node; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < supports_.size(); ++i)
      if (supports_[i].node == supports_[last].node)
        supports_[last].by.push_back(supports_[i].by[0]);
      else
        supports_[++last] = supports_[i];
    if (!supports_.empty()) supports_.resize(last + 1);
  }
  std::string_view name() const override { return "spcforc"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return solver::reactions; }
  std::vector<std::string> columns() const override { return {"x_force", "y_force", "z_force"}; }
  void legend(std::string& ascii) const override { ascii += " single point constraint forces\n\n"; }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, " output at time =%14.5E\n", column(now.state().time));
    double sum[3] = {0, 0, 0};
    for (const Support& support : supports_) {
      double force[3];
      held_force(support, now, force);
      const model::Id id = model_.mesh.nodes.id[static_cast<std::size_t>(support.node)];
      rows.row(id, force);
      append_format(ascii, " node=%8lld local x,y,z forces =%14.4E%14.4E%14.4E\n", static_cast<long long>(id),
                    column(force[0]), column(force[1]), column(force[2]));
      for (int k = 0; k < 3; ++k) sum[k] += force[k];
    }
    rows.row(0, sum);
    append_format(ascii, "             force resultants   =%14.4E%14.4E%14.4E\n", column(sum[0]),
                  column(sum[1]), column(sum[2]));
  }

 private:
  /// The part of the reaction that lies in the directions held now; the rest belongs to prescribed motion.
  static void held_force(const Support& support, const Snapshot& now, double (&force)[3]) {
    const double* reaction = &now.frame().reaction[3 * static_cast<std::size_t>(support.node)];
    std::fill(force, force + 3, 0.0);
    unsigned global = 0;
    const model::FixedNodes* local = nullptr;
    int systems = 0;
    for (const model::FixedNodes* fixed : support.by) {
      if (now.state().time < fixed->birth || now.state().time > fixed->death) continue;
      if (fixed->local)
        local = fixed, ++systems;
      else
        global |= fixed->directions & 7u;
    }
    if (!local) {
      for (unsigned k = 0; k < 3; ++k)
        if (global >> k & 1u) force[k] = reaction[k];
      return;
    }
    // Oblique systems on one node hold a space that is not one of their axes: the whole reaction is theirs.
    if (global != 0 || systems > 1) {
      std::copy(reaction, reaction + 3, force);
      return;
    }
    for (unsigned k = 0; k < 3; ++k) {
      if (!(local->directions >> k & 1u)) continue;
      const model::Vector& axis = local->frame.axis[k];
      const double along = axis.x * reaction[0] + axis.y * reaction[1] + axis.z * reaction[2];
      force[0] += along * axis.x;
      force[1] += along * axis.y;
      force[2] += along * axis.z;
    }
  }

  const model::Model& model_;
  std::vector<Support> supports_;  // by node
};

std::unique_ptr<Writer> build(const Context& context) {
  const auto& fixed = context.model.fixed;
  if (std::none_of(fixed.begin(), fixed.end(),
                   [](const auto& f) { return (f.directions & 7u) && !f.nodes.empty(); }))
    return nullptr;
  return history_writer<Spcforc>(context, context.model.requests.spcforc);
}

}  // namespace

extern const WriterEntry spcforc{"spcforc", build};

}  // namespace cleave::results
