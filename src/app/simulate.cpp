#include "app/simulate.hpp"

#include <unistd.h>

#include <cstdio>

#include "app/account.hpp"
#include "app/switches.hpp"
#include "app/version.hpp"
#include "base/threads.hpp"
#include "discretisation/spacetime/body.hpp"
#include "model/keyword/row_place.hpp"
#include "results/picture_writer.hpp"
#include "results/recorder.hpp"
#include "results/tent_picture.hpp"
#include "solver/interaction.hpp"

namespace cleave::app {

std::unique_ptr<discretisation::World> world_of(Reading& reading) {
  auto world = std::make_unique<discretisation::World>();
  if (discretisation::spacetime::dimension_of(reading.model) > 0)
    world->model = &reading.model;  // its parts have no blocks: the solver makes them computable
  else {
    solver::join_ties(reading.model, reading.diagnostics);
    solver::move_apart(reading.model, reading.diagnostics);
    *world = discretisation::build(reading.model, reading.diagnostics);
  }
  return world;
}

std::unique_ptr<solver::Solver> solver_of(const discretisation::World& world, const solver::Options& options,
                                          deck::Diagnostics& diagnostics) {
  if (discretisation::spacetime::dimension_of(*world.model) > 0)
    return solver::make_tents(world, options, diagnostics);
  return solver::make_explicit(world, options, diagnostics);
}

std::unique_ptr<discretisation::World> build_world(Reading& reading) {
  auto world = world_of(reading);
  if (!reading.failed()) return world;
  print_diagnostics(reading);
  return nullptr;
}

void print_unfit(const Reading& reading, const discretisation::StepStatus& status) {
  const auto places =
      model::row_places(*reading.deck, "ELEMENT_SOLID", model::IdKind::element, {status.element});
  deck::Diagnostics diagnostics;
  diagnostics.error(places.empty() ? deck::Place{} : places.begin()->second, "ELEMENT_SOLID", "EID",
                    "element " + std::to_string(status.element) + ": " + status.what, status.likely_cause);
  std::fputs(diagnostics.render(reading.deck->sources(), isatty(STDERR_FILENO)).c_str(), stderr);
}

int simulate(const Simulation& simulation, discretisation::State& state) {
  const Options& options = simulation.options;
  const Reading& reading = simulation.reading;

  deck::Diagnostics diagnostics;
  const int threads = reading.model.control.spacetime.threads;
  if (options.threads == 0 && threads > 0) base::set_thread_count(threads);
  const auto solver = solver_of(
      simulation.world, {.stop_at_cycle = options.stop_at_cycle, .tents = options.tents}, diagnostics);
  model::find_rows(*reading.deck, diagnostics);
  const std::string objections = diagnostics.render(reading.deck->sources(), isatty(STDERR_FILENO));
  std::fputs(objections.c_str(), stderr);
  if (diagnostics.failed()) return bad_deck;

  std::vector<std::filesystem::path> include_paths;  // whole: a restart may start from another folder
  for (const auto& path : options.include_paths) include_paths.push_back(std::filesystem::absolute(path));

  solver::Wishes wishes;
  results::Recorder recorder(reading.model,
                             {.directory = simulation.directory,
                              .version = version,
                              .deck = std::filesystem::absolute(options.input).lexically_normal(),
                              .deck_fingerprint = simulation.deck_fingerprint,
                              .include_paths = include_paths,
                              .allow_unsupported = options.allow_unsupported,
                              .end_time = options.end_time,
                              .progress = !options.quiet,
                              .wishes = &wishes,
                              .account = &reading.account,
                              .deck_messages = simulation.deck_messages + objections,
                              .warnings = reading.diagnostics.count(deck::Severity::warning)});
  results::PictureWriter picture(simulation.directory);
  results::TentPicture tents(simulation.directory);
  std::vector<solver::Observer*> observers = {&recorder, &picture};
  if (options.tents > 0) observers.push_back(&tents);

  solver::Outcome outcome;
  {
    const Switches switches(wishes, simulation.directory);
    outcome = solver->advance(state, observers, wishes);
  }
  recorder.summarise(outcome);

  if (!options.quiet)
    std::printf("%s\n%s", recorder.text_summary(outcome).c_str(), table_of(reading.account).c_str());
  for (const std::string& problem : {picture.problem(), tents.problem()})
    if (!problem.empty()) std::fprintf(stderr, "cleave: no picture: %s\n", problem.c_str());
  if (recorder.failed()) return files_failed;
  if (outcome.ending == solver::Ending::physics) return physics_failed;
  if (const int signal = Switches::signal_received()) return 128 + signal;
  return done;
}

}  // namespace cleave::app
