/// nodout: motion of the nodes of *DATABASE_HISTORY_NODE.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Nodout final : public History {
 public:
  explicit Nodout(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "nodout"; }
  bool per_entity() const override { return true; }
  unsigned needs() const override { return 0; }
  std::vector<std::string> columns() const override {
    std::vector<std::string> names;
    for (const char* what : {"displacement", "velocity", "acceleration", "coordinate"})
      for (const char* axis : {"x_", "y_", "z_"}) names.push_back(std::string(axis) + what);
    return names;
  }
  void legend(std::string& ascii) const override {
    append_legend(ascii, model_.requests.history_node_titles);
  }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii,
                  "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p%8lld"
                  "                              ( at time%14.7E )\n",
                  static_cast<long long>(now.state().cycle), column(now.state().time));
    ascii +=
        "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      "
        "y-accl      z-accl      x-coor      y-coor      z-coor\n";
    for (const model::Index node : model_.requests.history_nodes) {
      const std::size_t at = 3 * static_cast<std::size_t>(node);
      double values[12];
      for (std::size_t k = 0; k < 3; ++k) {
        values[k] = now.state().position[at + k] - model_.mesh.nodes.position[at + k];
        values[3 + k] = now.frame().velocity[at + k];
        values[6 + k] = now.frame().acceleration[at + k];
        values[9 + k] = now.state().position[at + k];
      }
      const model::Id id = model_.mesh.nodes.id[static_cast<std::size_t>(node)];
      rows.row(id, values);
      append_format(ascii, "%9lld%13.4E", static_cast<long long>(id), column(values[0]));
      for (int k = 1; k < 12; ++k) append_format(ascii, "%12.4E", column(values[k]));
      ascii += '\n';
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.requests.history_nodes.empty()) return nullptr;
  return history_writer<Nodout>(context, context.model.requests.nodout);
}

}  // namespace

extern const WriterEntry nodout{"nodout", build};

}  // namespace cleave::results
