#pragma once
/// Cards back to text, in full precision: what is read again has the same bits.

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cleave::deck {

/// Collects the values of one data set by field name and writes its lines by the card table: option lines
/// first, conditions and repeats as the reader sees them, comma format, shortest numbers that read back
/// exactly.
///
///   CardWriter("MAT_ELASTIC", {"TITLE"}).set("TITLE", "steel").set("MID", 1).set("E",
///   207.0).append_to(text);
///
/// Asserts on names that the layout does not have and on numbers that are not finite.
class CardWriter {
 public:
  /// @param keyword canonical name; @param options suffixes with lines of their own, or without
  explicit CardWriter(std::string_view keyword, std::vector<std::string> options = {});

  CardWriter& set(std::string_view field, double value, std::size_t row = 0);
  CardWriter& set(std::string_view field, std::string_view text, std::size_t row = 0);
  CardWriter& set(std::string_view field, const char* text, std::size_t row = 0) {
    return set(field, std::string_view(text), row);
  }
  template <std::integral Integer>
  CardWriter& set(std::string_view field, Integer value, std::size_t row = 0) {
    return set_integer(field, static_cast<std::int64_t>(value), row);
  }
  CardWriter& series(std::string_view field, std::span<const std::int64_t> values);
  CardWriter& series(std::string_view field, std::span<const double> values);

  /// Adds the keyword line (unless this is a further data set under the keyword above) and the lines of the
  /// set.
  void append_to(std::string& text, bool keyword_line = true) const;
  std::string text() const;

 private:
  friend class CardLines;
  using Value = std::variant<std::monostate, std::int64_t, double, std::string>;
  struct Column {
    std::string name;  ///< as in the table, all alternatives
    std::vector<Value> rows;
  };

  CardWriter& set_integer(std::string_view field, std::int64_t value, std::size_t row);
  Value& value(std::string_view field, std::size_t row);

  std::string keyword_;
  std::vector<std::string> options_;
  std::vector<Column> columns_;
};

/// Writes rows of bulk keywords (*NODE, *ELEMENT_SOLID) without a CardWriter for each.
///
///   RowWriter row(text); row.integer(id).real(x).real(y).real(z).end();
class RowWriter {
 public:
  explicit RowWriter(std::string& text) : text_(text) {}
  RowWriter& integer(std::int64_t value);
  RowWriter& real(double value);
  RowWriter& blank();
  void end();

 private:
  void comma();
  std::string& text_;
  bool first_ = true;
};

/// The shortest decimal that reads back to the same bits.
void append_real(std::string& text, double value);

}  // namespace cleave::deck
