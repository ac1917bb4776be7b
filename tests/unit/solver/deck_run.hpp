#pragma once
/// Runs of deck text.

#include <gtest/gtest.h>

#include "deck/deck.hpp"
#include "solver/interaction.hpp"
#include "solver/solver.hpp"

namespace cleave::solver::test {

using model::Vector;

/// Reads, prepares as the program does, and runs to the end or to a cycle.
struct DeckRun {
  deck::Diagnostics diagnostics;
  model::Account account;
  model::Model model;
  discretisation::World world;
  discretisation::State state;
  Outcome outcome;

  explicit DeckRun(const std::string& text, std::int64_t stop = 0, Observer* observer = nullptr) {
    run(text, stop, observer);
  }

  bool says(std::string_view phrase, deck::Severity severity = deck::Severity::error) const {
    for (const auto& d : diagnostics.all())
      if (d.severity == severity && d.message.find(phrase) != std::string::npos) return true;
    return false;
  }
  std::string text() const {
    std::string all;
    for (const auto& d : diagnostics.all()) all += d.keyword + " " + d.field + ": " + d.message + "\n";
    return all;
  }

  Vector momentum() const {
    Vector sum{0, 0, 0};
    for (std::size_t a = 0; a < state.mass.size(); ++a)
      sum = sum + state.mass[a] *
                      Vector{state.velocity[3 * a], state.velocity[3 * a + 1], state.velocity[3 * a + 2]};
    return sum;
  }
  /// With the half-step velocity, for which it is conserved exactly.
  Vector spin() const {
    Vector sum{0, 0, 0};
    for (std::size_t a = 0; a < state.mass.size(); ++a) {
      const double *x = &state.position[3 * a], *v = &state.velocity[3 * a];
      sum = sum + state.mass[a] * base::cross(Vector{x[0], x[1], x[2]}, Vector{v[0], v[1], v[2]});
    }
    return sum;
  }

 protected:
  DeckRun() = default;
  void run(const std::string& text, std::int64_t stop, Observer* observer) {
    const deck::Deck deck = deck::Deck::read_text(text + "*END\n", "test.k", {}, diagnostics);
    model = model::build(deck, {}, diagnostics, account);
    if (diagnostics.failed()) return;
    join_ties(model, diagnostics);
    move_apart(model, diagnostics);
    world = discretisation::build(model, diagnostics);
    const auto solver = make_explicit(world, {stop}, diagnostics);
    if (diagnostics.failed()) return;
    EXPECT_TRUE(discretisation::initialise(world, state).ok);
    Wishes wishes;
    std::vector<Observer*> observers;
    if (observer) observers.push_back(observer);
    outcome = solver->advance(state, observers, wishes);
  }
};

}  // namespace cleave::solver::test
