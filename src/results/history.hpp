#pragma once
/// ASCII histories in the established layout, each with a CSV twin.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/clock.hpp"
#include "results/files.hpp"
#include "results/writer.hpp"

namespace cleave::results {

/// Rows of a CSV history: time and cycle are put in front of each.
class Rows {
 public:
  Rows(std::string& out, const discretisation::State& state);
  void row(std::span<const double> values);                ///< of a history of the whole model
  void row(model::Id id, std::span<const double> values);  ///< of one entity

 private:
  void end(std::span<const double> values);
  std::string& out_;
  std::string start_;
};

/// What one history says: its columns and its text.
class History {
 public:
  virtual ~History() = default;
  virtual std::string_view name() const = 0;             ///< file name; the twin is NAME.csv
  virtual std::vector<std::string> columns() const = 0;  ///< after time and cycle
  virtual bool per_entity() const = 0;                   ///< then `id` is the third column
  virtual void legend(std::string& ascii) const = 0;     ///< after the title, before the first output
  virtual void prepare(const solver::Frame&) {}          ///< once, before the columns are asked for
  /// What write() reads, bits of solver::Wanted.
  virtual unsigned needs() const { return solver::everything; }
  virtual void write(const Snapshot& now, std::string& ascii, Rows& rows) = 0;
};

/// Writes a history at its instants, and once more at the very end.
class HistoryWriter final : public Writer {
 public:
  HistoryWriter(const Context& context, std::unique_ptr<History> history, Clock clock);
  void begin(const Snapshot& now, const discretisation::Memory* resumed) override;
  void after_step(const Snapshot& now) override;
  void finish(const Snapshot& now, solver::Ending, const discretisation::StepStatus&) override;
  std::vector<double> remember() const override;

 private:
  void write(const Snapshot& now);
  void append(GrowingFile& file, const std::string& name, const std::string& piece);

  Context context_;
  std::unique_ptr<History> history_;
  Clock clock_;
  GrowingFile ascii_, csv_;
  std::int64_t last_cycle_ = -1;
};

/// "{BEGIN LEGEND}" with ids and titles, as readers of these files expect; nothing when `entries` is empty.
void append_legend(std::string& ascii, std::span<const std::pair<model::Id, std::string>> entries);

/// The same of things that have an id and a title: those with a title.
template <class Titled>
void append_titles(std::string& ascii, const std::vector<Titled>& things) {
  std::vector<std::pair<model::Id, std::string>> entries;
  for (const Titled& one : things)
    if (!one.title.empty()) entries.emplace_back(one.id, one.title);
  append_legend(ascii, entries);
}

/// A writer for the history if its interval is active, else null.
template <class Kind>
std::unique_ptr<Writer> history_writer(const Context& context, const model::Interval& interval) {
  if (!interval.active()) return nullptr;
  return std::make_unique<HistoryWriter>(context, std::make_unique<Kind>(context.model),
                                         Clock(interval, context.model.curves));
}

}  // namespace cleave::results
