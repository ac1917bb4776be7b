#include "results/history.hpp"

#include "results/text.hpp"

namespace cleave::results {

Rows::Rows(std::string& out, const discretisation::State& state) : out_(out) {
  append_shortest(start_, state.time);
  start_ += ',' + std::to_string(state.cycle);
}

void Rows::row(std::span<const double> values) {
  out_ += start_;
  end(values);
}

void Rows::row(model::Id id, std::span<const double> values) {
  out_ += start_;
  out_ += ',' + std::to_string(id);
  end(values);
}

void Rows::end(std::span<const double> values) {
  for (const double value : values) {
    out_ += ',';
    append_shortest(out_, value);
  }
  out_ += '\n';
}

void append_legend(std::string& ascii, std::span<const std::pair<model::Id, std::string>> entries) {
  if (entries.empty()) return;
  ascii += "\n{BEGIN LEGEND}\n Entity #        Title\n";
  for (const auto& [id, title] : entries)
    append_format(ascii, "%9lld     %.70s\n", static_cast<long long>(id), title.c_str());
  ascii += "{END LEGEND}\n\n";
}

HistoryWriter::HistoryWriter(const Context& context, std::unique_ptr<History> history, Clock clock)
    : context_(context), history_(std::move(history)), clock_(clock) {}

void HistoryWriter::begin(const Snapshot& now, const discretisation::Memory* resumed) {
  const std::string name(history_->name());
  const auto& directory = context_.options.directory;
  history_->prepare(now.frame());
  std::uint64_t keep_ascii = 0, keep_csv = 0;
  if (resumed && resumed->values.size() == 4) {
    clock_.set_next(resumed->values[0]);
    keep_ascii = static_cast<std::uint64_t>(resumed->values[1]);
    keep_csv = static_cast<std::uint64_t>(resumed->values[2]);
    last_cycle_ = static_cast<std::int64_t>(resumed->values[3]);
  }
  context_.trouble.note(directory / name, ascii_.open(directory / name, keep_ascii));
  context_.trouble.note(directory / (name + ".csv"), csv_.open(directory / (name + ".csv"), keep_csv));
  if (ascii_.size() == 0) {
    std::string head;
    append_format(head, " %.72s\n", context_.model.title.c_str());
    append_format(head, "                         cleave (version %s)     date %s\n",
                  context_.options.version.c_str(), today().c_str());
    history_->legend(head);
    append(ascii_, name, head);
  }
  if (csv_.size() == 0) {
    std::string head = history_->per_entity() ? "time,cycle,id" : "time,cycle";
    for (const std::string& column : history_->columns()) head += ',' + column;
    append(csv_, name + ".csv", head + '\n');
  }
  after_step(now);
}

void HistoryWriter::after_step(const Snapshot& now) {
  if (!clock_.due(now.state().time)) return;
  if (now.state().cycle != last_cycle_) write(now);
  clock_.advance(now.state().time);
}

void HistoryWriter::finish(const Snapshot& now, solver::Ending, const discretisation::StepStatus&) {
  if (now.state().cycle != last_cycle_) write(now);
}

std::vector<double> HistoryWriter::remember() const {
  return {clock_.next(), static_cast<double>(ascii_.size()), static_cast<double>(csv_.size()),
          static_cast<double>(last_cycle_)};
}

void HistoryWriter::write(const Snapshot& now) {
  std::string ascii, csv;
  Rows rows(csv, now.state());
  now.evaluate(history_->needs());
  history_->write(now, ascii, rows);
  const std::string name(history_->name());
  append(ascii_, name, ascii);
  append(csv_, name + ".csv", csv);
  last_cycle_ = now.state().cycle;
}

void HistoryWriter::append(GrowingFile& file, const std::string& name, const std::string& piece) {
  if (!file.is_open() || context_.trouble.any()) return;  // nothing more after the first failure
  context_.trouble.note(context_.options.directory / name, file.append(piece));
}

}  // namespace cleave::results
