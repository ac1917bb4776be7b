#pragma once
/// Text to cards: the whole deck with every include read, parameters resolved and layouts applied.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deck/card.hpp"
#include "deck/diagnostic.hpp"

namespace cleave::deck {

/// The files a deck was read from, with their text, for places and rulers.
class Sources {
 public:
  struct File {
    std::filesystem::path path;
    std::string_view text;
    Place included_from;  ///< file == -1 for the main file
  };
  const File& file(int index) const;
  int count() const;
  /// The text of one line without its line end.
  std::string_view line(int file, int line) const;

  struct Storage;
  std::shared_ptr<Storage> storage;
};

/// Factors and offsets that *INCLUDE_TRANSFORM lays on everything in a file (nested ones multiply and add).
struct IncludeTransform {
  std::int64_t node_offset = 0, element_offset = 0, part_offset = 0, material_offset = 0, set_offset = 0,
               function_offset = 0, definition_offset = 0, other_offset = 0;
  double mass = 1.0, time = 1.0, length = 1.0;               ///< unit factors
  double temperature_factor = 1.0, temperature_shift = 0.0;  ///< new = factor * (old + shift)
  std::int64_t transformation = 0;                           ///< *DEFINE_TRANSFORMATION id, 0 for none
  int parent = 0;  ///< transform around this one: its `transformation` acts after
  Place place;     ///< of the *INCLUDE_TRANSFORM
};

/// One line of a bulk keyword (*NODE, *ELEMENT_*, *SET_* rows) split into values without allocation.
class Row {
 public:
  std::int64_t integer(int field) const;  ///< 0 where blank; reports a malformed number once
  double real(int field) const;           ///< 0 where blank
  bool given(int field) const;
  int field_count() const;  ///< fields present on the line
  Place place() const;
  Place place(int field) const;
  int transform = 0;  ///< index into Deck::transforms()

  struct Reader;
  Reader* reader = nullptr;
};

struct ReadOptions {
  std::vector<std::filesystem::path> include_paths;
  bool follow_includes = true;  ///< false: included files are not read, without a word
  /// An unknown keyword may be a misspelt load or support: an error, not a warning. Output and analyses
  /// that follow a run cannot change it, and remain warnings.
  bool refuse_unknown = false;
};

/// One keyword occurrence, its layout known, its cards not yet expanded.
struct Block {
  std::string keyword;               ///< canonical, without options
  std::vector<std::string> options;  ///< suffixes found in the name
  std::string written;               ///< as in the deck
  Place place;
  int transform = 0;      ///< index into Deck::transforms(); 0 is the identity
  bool known = true;      ///< false: not in the card table
  bool consumed = false;  ///< the reader itself has used it: *KEYWORD, *INCLUDE, *PARAMETER, *TITLE, ...
  std::size_t index = 0;  ///< position in Deck::blocks()
};

class Deck {
 public:
  /// Reads the file and everything it includes. Never throws for bad text: diagnostics tell.
  static Deck read(const std::filesystem::path& main_file, const ReadOptions& options,
                   Diagnostics& diagnostics);
  /// The same from memory, for tests and fuzzing.
  static Deck read_text(std::string_view text, const std::string& name, const ReadOptions& options,
                        Diagnostics& diagnostics);

  const Sources& sources() const;
  const std::vector<Block>& blocks() const;  ///< in reading order
  const std::vector<IncludeTransform>& transforms() const;
  std::string_view title() const;  ///< *TITLE, or empty

  /// The data sets of one occurrence; malformed fields are reported and read as their default.
  std::vector<Card> cards(const Block& block, Diagnostics& diagnostics) const;

  /// Streams rows of a bulk keyword: *NODE, *ELEMENT_SOLID (one- and two-line forms are normalised to
  /// EID PID N1..N10), *ELEMENT_SHELL, *ELEMENT_MASS. Millions of lines per second; nothing is stored.
  void rows(const Block& block, Diagnostics& diagnostics, const std::function<void(const Row&)>& take) const;

  /// Number of lines in the block, cheap: to reserve arrays.
  std::size_t line_count(const Block& block) const;

  struct Data;
  explicit Deck(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace cleave::deck
