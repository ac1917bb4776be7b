#pragma once
/// The restart file: the whole State in HDF5, so that a run can go on with the same bits.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "discretisation/world.hpp"

namespace cleave::results {

/// Where a restart file comes from.
struct RestartOrigin {
  std::string deck;         ///< path of the main file
  std::string fingerprint;  ///< of the deck's text
  std::string version;      ///< of the program that wrote it
  std::string title;
  // What the command line said about the deck, so that the same model is built again.
  std::vector<std::filesystem::path> include_paths;  ///< absolute
  bool allow_unsupported = false;
  double end_time = -1.0;  ///< in place of ENDTIM; negative: none was given [time]
};

/// A number over the text of every file of a deck, as hexadecimal digits (FNV-1a, 64 bit).
std::string fingerprint(const deck::Sources& sources);

/// Writes the state to a temporary name and renames it once all of it is on the disk.
/// @param observers  memory of observers, which they cannot keep in a state they only read: replaces entries
/// of
///                   the same name in state.memory
/// @return the reason for failure, empty on success; the file of that name is then untouched
[[nodiscard]] std::string write_restart(const std::filesystem::path& path, const discretisation::State& state,
                                        const RestartOrigin& origin,
                                        std::span<const discretisation::Memory> observers = {});

struct Restart {
  std::string error;  ///< empty: the rest is valid
  RestartOrigin origin;
  discretisation::State state;
};

/// Reads a restart file; says what is wrong with one that is missing, cut off, of another program or of
/// another version of the format.
Restart read_restart(const std::filesystem::path& path);

/// Does the restart belong to this deck and these blocks? @return what does not fit, empty if all does
std::string misfit(const Restart& restart, const discretisation::World& world,
                   const std::string& deck_fingerprint);

}  // namespace cleave::results
