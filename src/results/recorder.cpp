#include "results/recorder.hpp"

#include <csignal>

#include "results/files.hpp"
#include "results/restart.hpp"

namespace cleave::results {
namespace {

const std::string memory_prefix = "results.";

/// Files of an earlier run in the same directory would be mistaken for those of this one.
void remove_old_files(const std::filesystem::path& directory) {
  std::error_code ignored;
  for (const char* name : {"result.pvd", "summary.json", "restart.h5", "messag"})
    std::filesystem::remove(directory / name, ignored);
  for (const WriterEntry* entry : writer_catalogue()) {
    std::filesystem::remove(directory / entry->name, ignored);
    std::filesystem::remove(directory / (std::string(entry->name) + ".csv"), ignored);
  }
  std::filesystem::remove_all(directory / "result", ignored);
  for (const auto& file : std::filesystem::directory_iterator(directory, ignored))
    if (file.path().filename().string().starts_with("restart_") && file.path().extension() == ".h5")
      std::filesystem::remove(file.path(), ignored);
}

/// Leftovers of a write that a kill cut short.
void remove_unfinished(const std::filesystem::path& directory) {
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(directory, ignored))
    if (file.path().extension() == unfinished_suffix) std::filesystem::remove(file.path(), ignored);
}

}  // namespace

Recorder::Recorder(const model::Model& model, Options options)
    : options_(std::move(options)),
      trouble_(options_.wishes),
      log_(trouble_),
      context_{model, options_, trouble_, log_},
      summary_(context_) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then an error of write(), like a full disk
  for (const WriterEntry* entry : writer_catalogue())
    if (auto writer = entry->build(context_))
      writers_.push_back({std::string(entry->name), std::move(writer)});
}

Recorder::~Recorder() = default;

void Recorder::begin(const solver::Frame& frame) {
  std::error_code failure;
  std::filesystem::create_directories(options_.directory, failure);
  if (failure) trouble_.note(options_.directory, failure.message());
  const auto* resumed = find_memory(frame.state, memory_prefix + "summary");
  if (!resumed) remove_old_files(options_.directory);
  remove_unfinished(options_.directory);
  remove_unfinished(options_.directory / "result");

  log_.open(options_.directory / "messag", resumed != nullptr);
  masses_.emplace(frame.world, frame.motion);
  const Snapshot now(frame, *masses_);
  summary_.begin(now, resumed);
  for (auto& [name, writer] : writers_) writer->begin(now, find_memory(frame.state, memory_prefix + name));
}

void Recorder::after_step(const solver::Frame& frame) {
  const Snapshot now(frame, *masses_);
  summary_.after_step(now);
  for (auto& [name, writer] : writers_) writer->after_step(now);
  if (options_.wishes && options_.wishes->field.exchange(false))
    for (auto& [name, writer] : writers_) writer->extra(now);
  serve_restarts(frame);
}

void Recorder::finish(const solver::Frame& frame, solver::Ending ending,
                      const discretisation::StepStatus& status) {
  // Before the last rows, which an uninterrupted run would not have: a restarted run cuts them off. A state
  // in which an element failed would only fail again; one that knows how to save itself is whole even then.
  if (ending != solver::Ending::physics || frame.save) write_restart(frame, "restart.h5");
  const Snapshot now(frame, *masses_);
  summary_.finish(now, ending, status);
  for (auto& [name, writer] : writers_) writer->finish(now, ending, status);
}

void Recorder::serve_restarts(const solver::Frame& frame) {
  const model::Requests& requests = context_.model.requests;
  const std::int64_t cycle = frame.state.cycle;
  const auto due = [cycle](std::int64_t every) { return every > 0 && cycle % every == 0; };
  if (due(requests.restart_cycles)) write_restart(frame, "restart_" + std::to_string(cycle) + ".h5");
  const bool asked = options_.wishes && options_.wishes->restart.exchange(false);
  if (asked || due(requests.running_restart_cycles)) write_restart(frame, "restart.h5");
}

void Recorder::write_restart(const solver::Frame& frame, const std::string& name) {
  if (frame.save) frame.save();
  std::vector<discretisation::Memory> observers;
  const auto add = [&](const std::string& writer, const std::vector<double>& values) {
    observers.push_back({memory_prefix + writer, {values.begin(), values.end()}});
  };
  add("summary", summary_.remember());
  for (const auto& [writer_name, writer] : writers_) add(writer_name, writer->remember());
  const RestartOrigin origin{.deck = options_.deck.string(),
                             .fingerprint = options_.deck_fingerprint,
                             .version = options_.version,
                             .title = context_.model.title,
                             .include_paths = options_.include_paths,
                             .allow_unsupported = options_.allow_unsupported,
                             .end_time = options_.end_time};
  const auto path = options_.directory / name;
  const std::string reason = results::write_restart(path, frame.state, origin, observers);
  trouble_.note(path, reason);
  if (reason.empty()) log_.event(frame.state, "write " + name);
}

void Recorder::summarise(const solver::Outcome& outcome) {
  const auto path = options_.directory / "summary.json";
  log_.write(summary_.text(outcome));
  trouble_.note(path, write_whole(path, summary_.json(outcome)));
}

std::string Recorder::text_summary(const solver::Outcome& outcome) const {
  return summary_.text(outcome);
}

}  // namespace cleave::results
