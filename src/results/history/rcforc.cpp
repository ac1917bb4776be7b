/// rcforc: resultant forces on both sides of each contact.

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

class Rcforc final : public History {
 public:
  explicit Rcforc(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "rcforc"; }
  bool per_entity() const override { return true; }
  std::vector<std::string> columns() const override {
    return {"x_force", "y_force", "z_force", "area", "touches", "penetration"};
  }
  void legend(std::string& ascii) const override { append_titles(ascii, model_.contacts); }

  /// The text has a line for each side; a row of the twin holds the force on side A.
  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    for (std::size_t c = 0; c < now.frame().interfaces.size(); ++c) {
      const solver::InterfaceForce& one = now.frame().interfaces[c];
      const model::Contact& contact = model_.contacts[c];
      rows.row(contact.id, std::vector<double>{one.force[0], one.force[1], one.force[2], one.area,
                                               static_cast<double>(one.touches), one.deepest});
      const auto line = [&](const char* side, double sign) {
        append_format(ascii, " %-6s%8lld  time%13.5E  x%13.5E  y%13.5E  z%13.5E  mass%13.5E\n", side,
                      static_cast<long long>(contact.id), column(now.state().time),
                      column(sign * one.force[0]), column(sign * one.force[1]), column(sign * one.force[2]),
                      0.0);
      };
      line("slave", 1.0);
      if (contact.search != model::Contact::Search::single) line("master", -1.0);
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.contacts.empty()) return nullptr;
  return history_writer<Rcforc>(context, context.model.requests.rcforc);
}

}  // namespace

extern const WriterEntry rcforc{"rcforc", build};

}  // namespace cleave::results
