#pragma once
/// The part that `run` and `restart` share: from a model and a state to a finished run directory.

#include <filesystem>
#include <string>

#include "app/commands.hpp"
#include "solver/solver.hpp"

namespace cleave::app {

/// One run on its way.
struct Simulation {
  const Options& options;
  const Reading& reading;
  const discretisation::World& world;
  std::filesystem::path directory;  ///< run directory, exists
  std::string deck_messages;        ///< what was said about the deck, for the log
  std::string deck_fingerprint;     ///< of all its text, so that a restart knows its deck
};

/// Moves the state to the end with every observer attached, prints the summary, returns the exit status.
int simulate(const Simulation& simulation, discretisation::State& state);

/// Blocks of the model; none for one that is solved in spacetime. Diagnostics go to the reading.
std::unique_ptr<discretisation::World> world_of(Reading& reading);

/// The solver that the model's sections ask for. Null or diagnosed when it cannot be had.
std::unique_ptr<solver::Solver> solver_of(const discretisation::World& world, const solver::Options& options,
                                          deck::Diagnostics& diagnostics);

/// Blocks of the model; what it has to say against the deck is printed. Null when it was refused.
std::unique_ptr<discretisation::World> build_world(Reading& reading);

/// Prints what an element has against the mesh as it is given, at its line of the deck.
void print_unfit(const Reading& reading, const discretisation::StepStatus& status);

}  // namespace cleave::app
