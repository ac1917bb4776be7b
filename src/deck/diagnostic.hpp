#pragma once
/// What is said to the user about the deck: collected, all at once, in reading order.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace cleave::deck {

/// A stretch of text in one of the files of a deck. Lines and columns count from 1; 0 means unknown.
struct Place {
  std::int32_t file = -1;  ///< index into Sources
  std::int32_t line = 0;
  std::int32_t column = 0;
  std::int32_t width = 0;
};

enum class Severity { note, warning, error };

/// A row of the deck by the number in its first column, where only the model is at hand and no place.
struct NumberedRow {
  enum class Kind : std::uint8_t { none, node, element } kind = Kind::none;
  std::int64_t id = 0;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string keyword;   ///< e.g. "MAT_ELASTIC"; may be empty
  std::string field;     ///< e.g. "PR"; may be empty
  std::string message;   ///< what is wrong: text found, what was expected
  std::string hint;      ///< what to do instead; may be empty
  NumberedRow row = {};  ///< of `keyword`, the better place once it is found
};

class Sources;

/// Collects diagnostics; sorts by reading order when printing; shows the first few of one kind (same
/// severity, keyword and field) and says how many more there are. Keeps 20000 at most and counts the others.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  void error(Place place, std::string keyword, std::string field, std::string message, std::string hint = {});
  void warning(Place place, std::string keyword, std::string field, std::string message,
               std::string hint = {});
  void note(Place place, std::string keyword, std::string field, std::string message, std::string hint = {});

  /// Offers each diagnostic that names a row; one whose place is found drops the row.
  void find_rows(const std::function<Place(const Diagnostic&)>& find);

  bool failed() const { return count(Severity::error) > 0; }
  std::size_t count(Severity severity) const;
  const std::vector<Diagnostic>& all() const { return all_; }

  /// Text for a person: include chain, file:line:column, keyword, field, the line with the ruler, hint.
  std::string render(const Sources& sources, bool colour) const;

 private:
  std::vector<Diagnostic> all_;
  std::unordered_set<std::size_t> seen_;  ///< hashes, so that nothing is said twice
  std::size_t counts_[3] = {0, 0, 0};
  std::size_t dropped_ = 0;  ///< counted but not kept
};

}  // namespace cleave::deck
