#include "deck/write.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/assert.hpp"
#include "deck/condition.hpp"

namespace cleave::deck {
namespace {

constexpr int long_text = 40;

/// Text as it may stand in a deck: one line that is neither keyword nor remark.
std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  if (!line.empty() && (line[0] == '*' || line[0] == '$' || line[0] == '-')) line.insert(0, 1, ' ');
  return line;
}

}  // namespace

void append_real(std::string& text, double value) {
  CLEAVE_ASSERT(std::isfinite(value), "a deck holds finite numbers only");
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  CLEAVE_ASSERT(error == std::errc(), "the shortest form of a double fits 32 characters");
  text.append(digits, end);
  // A point tells a real from an integer to other readers.
  if (std::string_view(digits, static_cast<std::size_t>(end - digits)).find_first_of(".e") ==
      std::string_view::npos)
    text += '.';
}

/// Lays the values of a CardWriter on the lines of the table, in the order in which the reader takes them.
class CardLines final : public ConditionValues {
 public:
  using Value = CardWriter::Value;

  CardLines(const CardWriter& card, const table::Keyword& layout)
      : card_(card),
        layout_(layout),
        latest_(layout.field_count, nullptr),
        times_(layout.field_count, 0),
        used_(card.columns_.size(), 0) {
    for (std::size_t f = 0; f < layout.field_count; ++f) {
      column_of_.push_back(card.columns_.size());
      for (std::size_t c = 0; c < card.columns_.size(); ++c) {
        if (card.columns_[c].name == table::field(layout, f).name) column_of_.back() = c;
      }
    }
  }

  void append_to(std::string& text) {
    add_options(true);
    add_items(layout_.first_item, layout_.item_count);
    add_options(false);
    // Trailing lines without a value may go, but not in front of a further data set.
    while (!layout_.repeat_set && !lines_.empty() && lines_.back().optional && !lines_.back().given)
      lines_.pop_back();
    for (const OneLine& line : lines_) text += line.text + "\n";
  }

  double number(std::size_t field) const override {
    const Value* value = latest_[field];
    if (value == nullptr || std::holds_alternative<std::monostate>(*value))
      return table::field(layout_, field).number;
    if (const auto* integer = std::get_if<std::int64_t>(value)) return static_cast<double>(*integer);
    const auto* real = std::get_if<double>(value);
    return real != nullptr ? *real : 0.0;
  }
  std::string_view text(std::size_t field) const override {
    const auto* value = latest_[field] == nullptr ? nullptr : std::get_if<std::string>(latest_[field]);
    return value == nullptr ? std::string_view(table::field(layout_, field).text) : *value;
  }
  std::size_t rows(std::size_t field) const override { return times_[field]; }
  /// Solids of ten nodes need the two-line form, whose first line holds two values.
  std::size_t next_line_values() const override {
    for (const CardWriter::Column& c : card_.columns_) {
      if (c.name == "N9" || c.name == "N10") return 2;
    }
    return current_->field_count;
  }
  bool next_line_starts(std::string_view) const override { return has_values(*current_, 0); }

 private:
  struct OneLine {
    std::string text;
    bool optional, given;
  };

  void add_options(bool before) {
    for (std::size_t i = 0; i < layout_.option_count; ++i) {
      const table::Option& option = *table::option(static_cast<std::uint16_t>(layout_.first_option + i));
      const bool positional = option.suffix[0] == '\0';
      const bool chosen =
          std::any_of(card_.options_.begin(), card_.options_.end(),
                      [&](const std::string& s) { return table::among(option.suffix, s, '|'); });
      if (option.before == before && (positional || chosen)) add_items(option.first_item, option.item_count);
    }
  }

  bool has_values(const table::Item& item, std::size_t children) const {
    for (std::size_t k = 0; k < item.field_count; ++k) {
      const std::size_t c = column_of_[item.first_field + k];
      if (c < used_.size() && used_[c] < card_.columns_[c].rows.size()) return true;
    }
    for (std::size_t i = 1; i <= children; ++i) {
      if (has_values(*(&item + i), 0)) return true;
    }
    return false;
  }

  void add_items(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      const table::Item& item = *table::item(static_cast<std::uint16_t>(i));
      current_ = &item;
      if (holds(item, *this)) {
        if (item.kind == table::Kind::series) {
          add_series(item);
        } else {
          const std::size_t times = repeats(item, *this);
          for (std::size_t k = 0; k < times && (!item.to_end || has_values(item, item.children)); ++k) {
            const std::size_t before = taken_;
            if (item.kind == table::Kind::group)
              add_items(i + 1, item.children);
            else
              add_line(item);
            if (item.to_end && taken_ == before) break;  // what is left has no line under these conditions
          }
        }
      }
      i += item.children;
    }
  }

  /// The next value of a field, or nothing.
  const Value* take(std::size_t field) {
    const std::size_t c = column_of_[field];
    ++times_[field];
    if (c >= used_.size() || used_[c] >= card_.columns_[c].rows.size()) return nullptr;
    ++taken_;
    return &card_.columns_[c].rows[used_[c]++];
  }

  static void append(std::string& line, const Value& value) {
    if (const auto* integer = std::get_if<std::int64_t>(&value))
      line += std::to_string(*integer);
    else if (const auto* real = std::get_if<double>(&value))
      append_real(line, *real);
    else if (const auto* text = std::get_if<std::string>(&value))
      line += one_line(*text);
  }

  void add_line(const table::Item& item) {
    OneLine line{{}, item.optional, false};
    std::size_t commas = 0;
    // A line known by its first word carries it in front of its fields.
    if (item.when_count == 1 && table::code(item.when_first)->code == table::Code::line_starts &&
        item.field_count > 0 && table::field(layout_, item.first_field).comma > 0) {
      line.text = table::code(item.when_first)->word;
    }
    for (std::size_t k = 0; k < item.field_count; ++k) {
      const std::size_t f = std::size_t{item.first_field} + k;
      const table::Field& field = table::field(layout_, f);
      const Value* value = take(f);
      latest_[f] = value;
      if (value == nullptr || std::holds_alternative<std::monostate>(*value)) continue;
      line.given = true;
      if (field.type == 'A' && field.width >= long_text) {
        // A long text takes the rest of its line by columns, so that its commas stay its own.
        if (line.text.size() < field.offset) line.text.insert(0, field.offset - line.text.size(), ' ');
        append(line.text, *value);
        commas = 1;
        continue;
      }
      const bool heading_follows = k + 1 < item.field_count && table::field(layout_, f + 1).type == 'A' &&
                                   table::field(layout_, f + 1).width >= long_text;
      for (; commas < field.comma && !heading_follows; ++commas) line.text += ',';
      append(line.text, *value);
      if (heading_follows && line.text.size() < field.width)
        line.text.insert(0, field.width - line.text.size(), ' ');
      if (heading_follows) commas = 1;
    }
    if (line.given && commas == 0) line.text += ',';  // comma format, whatever the width of the columns
    lines_.push_back(std::move(line));
  }

  void add_series(const table::Item& item) {
    std::size_t values = repeats(item, *this);
    const std::size_t c = column_of_[item.first_field];
    const std::size_t available = c < used_.size() ? card_.columns_[c].rows.size() - used_[c] : 0;
    values = std::min(values, available);
    for (std::size_t done = 0; done < values;) {
      OneLine line{{}, item.optional, true};
      const std::size_t here = std::min<std::size_t>(item.per_line, values - done);
      for (std::size_t k = 0; k < here; ++k) {
        append(line.text, *take(item.first_field));
        if (k + 1 < here || here == 1) line.text += ',';
      }
      done += here;
      lines_.push_back(std::move(line));
    }
  }

  const CardWriter& card_;
  const table::Keyword& layout_;
  std::vector<const Value*> latest_;    ///< value last written for each field
  std::vector<std::size_t> times_;      ///< lines written with each field
  std::vector<std::size_t> used_;       ///< rows used up of each column
  std::vector<std::size_t> column_of_;  ///< column of each field, or past the end
  std::vector<OneLine> lines_;
  std::size_t taken_ = 0;  ///< values written so far
  const table::Item* current_ = nullptr;
};

CardWriter::CardWriter(std::string_view keyword, std::vector<std::string> options)
    : keyword_(keyword), options_(std::move(options)) {
  CLEAVE_ASSERT(table::find(keyword_) != nullptr, "a keyword to be written is not in the card table");
}

CardWriter::Value& CardWriter::value(std::string_view field, std::size_t row) {
  const table::Keyword& layout = *table::find(keyword_);
  std::string_view name;
  for (std::size_t f = 0; f < layout.field_count && name.empty(); ++f) {
    if (table::among(table::field(layout, f).name, field, '/')) name = table::field(layout, f).name;
  }
  CLEAVE_ASSERT(!name.empty(), "the layout of this keyword has no such field");
  auto column =
      std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.name == name; });
  if (column == columns_.end()) column = columns_.insert(columns_.end(), {std::string(name), {}});
  if (column->rows.size() <= row) column->rows.resize(row + 1);
  return column->rows[row];
}

CardWriter& CardWriter::set(std::string_view field, double number, std::size_t row) {
  value(field, row) = number;
  return *this;
}

CardWriter& CardWriter::set(std::string_view field, std::string_view text, std::size_t row) {
  value(field, row) = std::string(text);
  return *this;
}

CardWriter& CardWriter::set_integer(std::string_view field, std::int64_t number, std::size_t row) {
  value(field, row) = number;
  return *this;
}

CardWriter& CardWriter::series(std::string_view field, std::span<const std::int64_t> values) {
  for (std::size_t i = values.size(); i-- > 0;) value(field, i) = values[i];
  return *this;
}

CardWriter& CardWriter::series(std::string_view field, std::span<const double> values) {
  for (std::size_t i = values.size(); i-- > 0;) value(field, i) = values[i];
  return *this;
}

void CardWriter::append_to(std::string& text, bool keyword_line) const {
  if (keyword_line) {
    text += '*' + keyword_;
    for (const std::string& option : options_) text += '_' + option;
    text += '\n';
  }
  CardLines(*this, *table::find(keyword_)).append_to(text);
}

std::string CardWriter::text() const {
  std::string result;
  append_to(result);
  return result;
}

void RowWriter::comma() {
  if (!first_) text_ += ',';
  first_ = false;
}

RowWriter& RowWriter::integer(std::int64_t value) {
  comma();
  char digits[24];
  text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  return *this;
}

RowWriter& RowWriter::real(double value) {
  comma();
  append_real(text_, value);
  return *this;
}

RowWriter& RowWriter::blank() {
  comma();
  return *this;
}

void RowWriter::end() {
  text_ += '\n';
  first_ = true;
}

}  // namespace cleave::deck
