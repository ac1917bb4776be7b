/// Field frames for ParaView: result.pvd lists result/result_0000.vtu, ... with their times.

#include "results/clock.hpp"
#include "results/files.hpp"
#include "results/text.hpp"
#include "results/vtu.hpp"
#include "results/writer.hpp"

namespace cleave::results {
namespace {

class Fields final : public Writer {
 public:
  explicit Fields(const Context& context)
      : context_(context), clock_(context.model.requests.field, context.model.curves) {}

  void begin(const Snapshot& now, const discretisation::Memory* resumed) override {
    std::error_code failure;
    std::filesystem::create_directories(context_.options.directory / "result", failure);
    if (failure) context_.trouble.note(context_.options.directory / "result", failure.message());
    if (resumed && resumed->values.size() >= 2) {
      clock_.set_next(resumed->values[0]);
      last_cycle_ = static_cast<std::int64_t>(resumed->values[1]);
      times_.assign(resumed->values.begin() + 2, resumed->values.end());
      for (std::size_t i = 0; i < times_.size(); ++i)
        if (!std::filesystem::exists(context_.options.directory / name_of(i)))
          times_.clear();  // other directory
    }
    if (times_.empty())
      frame(now);  // the first frame shows the start, whatever the interval
    else
      list();  // frames after the restart point are no longer listed; they will be written again
    if (clock_.due(now.state().time)) clock_.advance(now.state().time);
  }

  void after_step(const Snapshot& now) override {
    if (!clock_.due(now.state().time)) return;
    if (now.state().cycle != last_cycle_) frame(now);
    clock_.advance(now.state().time);
  }

  void finish(const Snapshot& now, solver::Ending, const discretisation::StepStatus&) override {
    if (now.state().cycle != last_cycle_) frame(now);
  }

  void extra(const Snapshot& now) override {
    if (now.state().cycle != last_cycle_) frame(now);
  }

  std::vector<double> remember() const override {
    std::vector<double> values = {clock_.next(), static_cast<double>(last_cycle_)};
    values.insert(values.end(), times_.begin(), times_.end());
    return values;
  }

 private:
  static std::string name_of(std::size_t number) {
    std::string name;
    append_format(name, "result/result_%04zu.vtu", number);
    return name;
  }

  void frame(const Snapshot& now) {
    if (context_.trouble.any()) return;
    const auto path = context_.options.directory / name_of(times_.size());
    const std::string reason = write_vtu(path, now.frame(), context_.options.double_fields);
    context_.trouble.note(path, reason);
    if (!reason.empty()) return;
    context_.log.event(now.state(), "write " + name_of(times_.size()));
    times_.push_back(now.state().time);
    last_cycle_ = now.state().cycle;
    list();
  }

  /// Rewrites result.pvd, which lists whole frames only.
  void list() {
    std::string xml =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n";
    for (std::size_t i = 0; i < times_.size(); ++i) {
      xml += "<DataSet timestep=\"";
      append_shortest(xml, times_[i]);
      xml += "\" part=\"0\" file=\"" + name_of(i) + "\"/>\n";
    }
    xml += "</Collection>\n</VTKFile>\n";
    const auto path = context_.options.directory / "result.pvd";
    context_.trouble.note(path, write_whole(path, xml));
  }

  Context context_;
  Clock clock_;
  std::vector<double> times_;  // of the frames written
  std::int64_t last_cycle_ = -1;
};

std::unique_ptr<Writer> build(const Context& context) {
  return std::make_unique<Fields>(context);
}

}  // namespace

extern const WriterEntry fields{"fields", build};

}  // namespace cleave::results
