#pragma once
/// Lines and fields: where they begin and end, in every format a deck may mix.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/layout_table.hpp"
#include "deck/number.hpp"
#include "deck/source.hpp"

namespace cleave::deck {

enum class Format : std::uint8_t { standard, ten, wide };  ///< 8/10/16, I10=Y, LONG=Y

/// A stretch of the text of one file: the lines of one keyword.
struct Body {
  const char *begin = nullptr, *end = nullptr;
  int file = -1;
  int first_line = 0;  ///< number of the line at `begin`
  int line_count = 0;
  Format format = Format::standard;
  bool has_return = false;
  std::uint32_t epoch = 0;  ///< parameter definitions made before
};

struct Line {
  std::string_view text;
  int number = 0;
};

/// Walks the lines of a body, comments left out.
class LineCursor {
 public:
  explicit LineCursor(const Body& body)
      : at_(body.begin), end_(body.end), number_(body.first_line), has_return_(body.has_return) {}

  bool next(Line& line) {
    while (at_ != end_) {
      const char* const stop = line_end(at_, end_, has_return_);
      line = {{at_, static_cast<std::size_t>(stop - at_)}, number_++};
      at_ = after_line(stop, end_);
      if (line.text.empty() || line.text[0] != '$') return true;
    }
    return false;
  }

 private:
  const char *at_, *end_;
  int number_;
  bool has_return_;
};

inline bool is_blank(std::string_view text) {
  return trim(text).empty();
}

/// `text` with every tab replaced by blanks up to the next multiple of 8 columns.
std::string expand_tabs(std::string_view text);

/// Position of the first comma outside `<...>`, or npos.
std::size_t find_comma(std::string_view text);

/// Position of the first comma that makes a line free format, or npos: it stands in front of column `reach`,
/// or behind a single number that runs over the columns. Other commas behind the columns belong to a remark.
std::size_t find_format_comma(std::string_view text, std::size_t reach);

/// A value as it stands in a line, blanks around it removed; `column` counts from 1.
struct Slice {
  std::string_view text;
  int column = 0;
  int width = 0;  ///< of the column in fixed format, of the text in comma format
};

/// Cuts one line into the fields of one line of the table.
///
/// A line with a comma before the end of its columns is free format, others are cut by columns: the
/// decision is made line by line. A line of one long text is never cut at commas; a line of short fields
/// that ends in a long text (id and heading) is cut only in front of that text.
class FieldCutter {
 public:
  /// @param fields the fields of the line, in column order
  void cut(std::string_view line, const table::Field* fields, std::size_t count, Format format);
  /// Cuts the same line at blanks instead, if that is the only way to read it: a value crosses the border of
  /// its column, every value suits its field, and either all fields have one or each lies in its own columns.
  /// True: done, slices are those now.
  bool cut_at_blanks();
  /// Does a number run over the border of its column, so that its end would be read as another value? Numbers
  /// that touch fill their columns; one that begins at the border and ends early is a piece of its neighbour.
  bool cuts_a_number() const;
  bool comma() const { return comma_; }
  /// The value of the n-th field of the table's line; empty where blank or missing.
  Slice slice(std::size_t n) const;
  /// What stands behind the last field of a comma line; for lines that hold more values than the table has.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view line_;
  const table::Field* fields_ = nullptr;
  std::size_t count_ = 0;
  Format format_ = Format::standard;
  bool comma_ = false;
  std::vector<std::string_view> pieces_;
  std::string_view rest_;
};

/// Cuts a line of a series into its values and hands on those that are not blank, with their positions on the
/// line. A comma line may hold more than the table says; no more than `wanted` positions are looked at.
void cut_series(std::string_view line, const table::Item& item, Format format, std::size_t wanted,
                const std::function<void(std::size_t position, const Slice& slice)>& take);

/// Does the text begin as a number, a parameter or an expression does?
inline bool begins_value(std::string_view text) {
  return !text.empty() && ((text[0] >= '0' && text[0] <= '9') ||
                           std::string_view("+-.&<").find(text[0]) != std::string_view::npos);
}

/// First column (from 0) and width of a field in a format.
struct Columns {
  std::size_t offset, width;
};
inline Columns columns_of(const table::Field& f, Format format) {
  if (format == Format::standard) return {f.offset, f.width};
  if (format == Format::ten) return {f.offset10, f.width10};
  return {std::size_t{20} * f.comma, f.long_width};
}

/// Number of values on a line: given commas, or columns of the layout in use.
std::size_t count_values(std::string_view line, const table::Field* fields, std::size_t count, Format format);

}  // namespace cleave::deck
