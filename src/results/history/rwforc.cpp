/// rwforc: forces on the rigid walls.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Rwforc final : public History {
 public:
  explicit Rwforc(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "rwforc"; }
  bool per_entity() const override { return true; }
  std::vector<std::string> columns() const override {
    return {"normal_force", "x_force", "y_force", "z_force", "position", "velocity"};
  }
  void legend(std::string& ascii) const override {
    std::vector<std::pair<model::Id, std::string>> entries;
    for (std::size_t w = 0; w < model_.walls.size(); ++w)
      if (!model_.walls[w].title.empty()) entries.emplace_back(id_of(w), model_.walls[w].title);
    append_legend(ascii, entries);
    ascii += "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n";
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    for (std::size_t w = 0; w < now.frame().walls.size(); ++w) {
      const solver::WallForce& wall = now.frame().walls[w];
      rows.row(id_of(w), std::vector<double>{wall.normal, wall.force[0], wall.force[1], wall.force[2],
                                             wall.position, wall.velocity});
      append_format(ascii, "%12.5E%8lld%15.6E%15.6E%15.6E%15.6E\n", column(now.state().time),
                    static_cast<long long>(id_of(w)), column(wall.normal), column(wall.force[0]),
                    column(wall.force[1]), column(wall.force[2]));
    }
  }

 private:
  /// The wall's own id, else its place in the deck, from 1.
  model::Id id_of(std::size_t wall) const {
    return model_.walls[wall].id > 0 ? model_.walls[wall].id : static_cast<model::Id>(wall + 1);
  }
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.walls.empty()) return nullptr;
  return history_writer<Rwforc>(context, context.model.requests.rwforc);
}

}  // namespace

extern const WriterEntry rwforc{"rwforc", build};

}  // namespace cleave::results
