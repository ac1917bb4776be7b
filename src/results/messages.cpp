/// What goes into the log by itself: the start, the course, deletions, mass scaling and the end.

#include "base/threads.hpp"
#include "results/clock.hpp"
#include "results/log.hpp"
#include "results/summary.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

/// Time runs along in the log in so many lines.
constexpr double lines_per_run = 100.0;

class Messages final : public Writer {
 public:
  explicit Messages(const Context& context)
      : context_(context), clock_({.every = context.model.control.end.time / lines_per_run}, {}) {}

  void begin(const Snapshot& now, const discretisation::Memory* resumed) override {
    if (resumed && resumed->values.size() == 2) {
      clock_.set_next(resumed->values[0]);
      added_mass_ = resumed->values[1];
      context_.log.event(now.state(), "restarted");
      return;
    }
    std::string head;
    append_format(head, " %.72s\n                         cleave (version %s)     date %s\n\n",
                  context_.model.title.c_str(), context_.options.version.c_str(), today().c_str());
    append_format(head, " deck      %s\n threads   %d\n nodes     %zu\n", context_.options.deck.c_str(),
                  base::thread_count(), context_.model.mesh.nodes.count());
    const model::Mesh& mesh = context_.model.mesh;
    for (const auto* groups : {&mesh.beams, &mesh.shells, &mesh.solids})
      for (const model::Elements& group : *groups)
        append_format(head, " %-9s %zu\n", std::string(model::name_of(group.shape)).c_str(), group.count());
    for (const auto& block : now.frame().world.blocks)
      append_format(head, " part %lld: %zu elements, %s\n",
                    static_cast<long long>(context_.model.parts[static_cast<std::size_t>(block->part())].id),
                    block->element_ids().size(), std::string(block->formulation()).c_str());
    append_format(head, " mass      %.6E\n", now.masses().total());
    if (!context_.options.deck_messages.empty()) head += '\n' + context_.options.deck_messages;
    context_.log.write(head + '\n');
    added_mass(now);
    course(now);
    if (clock_.due(now.state().time)) clock_.advance(now.state().time);
  }

  void after_step(const Snapshot& now) override {
    std::string lines;
    for (const model::Id id : now.frame().eroded)
      append_format(lines, " solid element%10lld failed at time%14.5E\n", static_cast<long long>(id),
                    now.state().time);
    if (!lines.empty()) context_.log.write(lines);
    added_mass(now);
    if (!clock_.due(now.state().time)) return;
    course(now);
    clock_.advance(now.state().time);
  }

  void finish(const Snapshot& now, solver::Ending ending, const discretisation::StepStatus& status) override {
    std::string lines = "\n";
    if (!status.ok) {
      lines += " *** Error: ";
      if (status.element > 0)
        append_format(lines, "%selement%10lld: ", kind_of(status).c_str(),
                      static_cast<long long>(status.element));
      lines += status.what + '\n';
      if (!status.likely_cause.empty()) lines += "     " + status.likely_cause + '\n';
    }
    lines += " the run ended because " + std::string(describe(ending)) + '\n';
    append_format(lines, " problem time%17.5E\n problem cycle%16lld\n\n", now.state().time,
                  static_cast<long long>(now.state().cycle));
    // The words that scripts look for in this file.
    lines += is_normal(ending) ? " N o r m a l    t e r m i n a t i o n\n"
                               : " E r r o r   t e r m i n a t i o n\n";
    context_.log.write(lines);
  }

  std::vector<double> remember() const override { return {clock_.next(), added_mass_}; }

 private:
  /// "solid ", "shell " or "beam "; empty for an element that the mesh does not have. Each kind has numbers
  /// of its own, so one may be of several kinds; then its part decides.
  std::string kind_of(const discretisation::StepStatus& status) const {
    using model::ElementKind;
    for (const ElementKind kind : {ElementKind::solid, ElementKind::shell, ElementKind::beam})
      for (const model::Elements& group : context_.model.mesh.elements(kind))
        for (std::size_t e = 0; e < group.count(); ++e)
          if (group.id[e] == status.element && (status.part < 0 || group.part[e] == status.part))
            return std::string(model::name_of(kind)) + ' ';
    return {};
  }

  void course(const Snapshot& now) {
    now.evaluate(solver::energies);
    std::string what;
    append_format(what, "energy ratio %.6f", now.state().energy.ratio());
    context_.log.event(now.state(), what);
  }
  void added_mass(const Snapshot& now) {
    const double added = now.state().added_mass;
    if (added <= 1.05 * added_mass_) return;  // each 5 % more is worth a line
    added_mass_ = added;
    std::string what;
    append_format(what, "added mass %.4E (%.3f %%)", added, 100.0 * added / now.masses().total());
    context_.log.event(now.state(), what);
  }

  Context context_;
  Clock clock_;
  double added_mass_ = 0.0;
};

std::unique_ptr<Writer> build(const Context& context) {
  return std::make_unique<Messages>(context);
}

}  // namespace

extern const WriterEntry messages{"messages", build};

}  // namespace cleave::results
