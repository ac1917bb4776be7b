#pragma once
/// One keyword data set with checked values, found by field name.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deck/diagnostic.hpp"

namespace cleave::deck {

/// One data set: one *MAT_ELASTIC, one row pair of *PART, one row of *BOUNDARY_SPC_SET, ...
///
/// Field names are those of the card table (see `cleave explain KEYWORD`). A field that repeats
/// (points of a curve, rows of a table) is read with a row index; a series (ids of a set) as a whole.
/// Asking for a field the layout does not have is a mistake of ours and asserts.
class Card {
 public:
  /// Canonical keyword without options, e.g. "MAT_PLASTIC_KINEMATIC" also for *MAT_003_TITLE.
  const std::string& keyword() const;
  /// Was this suffix in the keyword name? e.g. option("TITLE"), option("SET").
  bool option(std::string_view suffix) const;
  bool has_field(std::string_view field) const;

  /// The value, or the documented default, or 0 where the field is blank and has no default.
  double real(std::string_view field, std::size_t row = 0) const;
  std::int64_t integer(std::string_view field, std::size_t row = 0) const;
  /// Bytes without leading and trailing blanks.
  std::string_view text(std::string_view field, std::size_t row = 0) const;
  double operator[](std::string_view field) const { return real(field); }

  /// Was something written in this field (not blank), and could it be read?
  bool given(std::string_view field, std::size_t row = 0) const;
  /// Was something written that could not be read? The reader has reported it; whatever else is wrong with
  /// the value follows from that.
  bool unreadable(std::string_view field, std::size_t row = 0) const;
  /// How many rows hold this field (1 for a field of a plain line that is present, 0 if its line is absent).
  std::size_t row_count(std::string_view field) const;
  /// All values of a series, zeros and blanks at line ends included (they are padding, caller skips them).
  std::span<const std::int64_t> integers(std::string_view series) const;
  std::span<const double> reals(std::string_view series) const;

  Place place() const;                                             ///< the keyword line
  Place place(std::string_view field, std::size_t row = 0) const;  ///< the field; falls back to its line

  /// Every field name of the layout that was given a non-blank value, for "not honoured" checks.
  std::vector<std::string> given_fields() const;

  struct Data;
  explicit Card(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace cleave::deck
