#pragma once
/// The commands of the program; each returns its exit status.

#include <optional>

#include "app/options.hpp"
#include "deck/deck.hpp"
#include "model/model.hpp"

namespace cleave::app {

int run(const Options& options);
int restart(const Options& options);
int check(const Options& options);
int view(const Options& options);
int explain(const Options& options);
int convert(const Options& options);
int examples(const Options& options);

/// What reading a deck gives: the model, and all that was said about it.
struct Reading {
  deck::Diagnostics diagnostics;
  model::Account account;
  std::optional<deck::Deck> deck;
  model::Model model;

  bool failed() const { return diagnostics.failed(); }
};

/// Reads the deck and builds the model. Diagnostics are collected, not printed.
/// @param needs_end_time  is a deck that gives no end time an error?
Reading read_deck(const Options& options, bool needs_end_time = true);

/// Prints the diagnostics to standard error, coloured on a terminal; their number comes last.
void print_diagnostics(const Reading& reading);

}  // namespace cleave::app
