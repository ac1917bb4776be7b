/// Reads the lines of a block by the layout of its keyword: lines in order, conditions, repeats, series.

#include <algorithm>
#include <limits>

#include "deck/card_data.hpp"
#include "deck/condition.hpp"
#include "deck/deck_data.hpp"

namespace cleave::deck {
namespace {

constexpr std::uint32_t not_read = std::numeric_limits<std::uint32_t>::max();

class CardReader final : public ConditionValues {
 public:
  CardReader(std::shared_ptr<const Deck::Data> deck, std::size_t index, Diagnostics& diagnostics)
      : deck_(std::move(deck)),
        block_(deck_->blocks[index]),
        body_(deck_->bodies[index]),
        options_(deck_->options[index]),
        layout_(*table::find(block_.keyword)),
        diagnostics_(diagnostics),
        cursor_(body_),
        latest_(layout_.field_count, not_read) {
    context_ = {&deck_->parameters, &deck_->sources, &diagnostics, block_.keyword, body_.file, body_.epoch};
    // Blank lines behind the last written one are white space, not cards full of defaults.
    Line line;
    for (LineCursor all(body_); all.next(line);) {
      if (!is_blank(line.text)) last_written_ = line.number;
    }
    advance();
  }

  std::vector<Card> run() {
    std::vector<Card> cards;
    if (layout_.repeat_set) {
      while (has_written_line()) {
        const int before = line_.number;
        cards.push_back(read_set());
        if (have_line_ && line_.number == before) break;  // a layout without lines
      }
    } else {
      cards.push_back(read_set());
    }
    report_surplus();
    return cards;
  }

  double number(std::size_t field) const override {
    const table::Field& f = table::field(layout_, field);
    if (latest_[field] == not_read || !card_->cells[latest_[field]].given) return f.number;
    const Cell& cell = card_->cells[latest_[field]];
    return f.type == 'I' ? static_cast<double>(cell.integer) : f.type == 'F' ? cell.real : 0.0;
  }
  std::string_view text(std::size_t field) const override {
    if (latest_[field] == not_read || !card_->cells[latest_[field]].given)
      return table::field(layout_, field).text;
    return {card_->cells[latest_[field]].text, card_->cells[latest_[field]].size};
  }
  std::size_t rows(std::size_t field) const override { return latest_[field] == not_read ? 0 : 1; }
  std::size_t next_line_values() const override {
    return have_line_ ? count_values(line_.text, fields_of(*current_), current_->field_count, body_.format)
                      : 0;
  }
  bool next_line_starts(std::string_view word) const override {
    return have_line_ && line_.text.substr(0, word.size()) == word;
  }

 private:
  const table::Field* fields_of(const table::Item& item) const {
    return &table::field(layout_, item.first_field);
  }
  bool has_written_line() const { return have_line_ && line_.number <= last_written_; }

  void advance() {
    have_line_ = cursor_.next(line_);
    if (have_line_ && line_.text.find('\t') != std::string_view::npos) line_.text = without_tabs(line_);
  }

  std::string_view without_tabs(const Line& line) {
    diagnostics_.warning({body_.file, line.number, static_cast<int>(line.text.find('\t')) + 1, 1},
                         block_.keyword, {},
                         "the line has tabs; each was taken as blanks up to the next multiple of 8 columns",
                         "write blanks, or commas between the values");
    if (!expanded_) expanded_ = std::make_shared<std::deque<std::string>>();
    return expanded_->emplace_back(expand_tabs(line.text));
  }

  Card read_set() {
    card_ = std::make_shared<Card::Data>();
    card_->layout = &layout_;
    card_->keyword = block_.keyword;
    card_->options = options_;
    card_->place = {body_.file, layout_.repeat_set && have_line_ ? line_.number : block_.place.line,
                    layout_.repeat_set ? 0 : block_.place.column,
                    layout_.repeat_set ? 0 : block_.place.width};
    std::fill(latest_.begin(), latest_.end(), not_read);
    missing_ = 0;

    for (std::size_t i = 0; i < layout_.option_count; ++i) {
      const table::Option& option = *table::option(static_cast<std::uint16_t>(layout_.first_option + i));
      if (option.before && chosen(option)) read_items(option.first_item, option.item_count);
    }
    read_items(layout_.first_item, layout_.item_count);
    for (std::size_t i = 0; i < layout_.option_count; ++i) {
      const table::Option& option = *table::option(static_cast<std::uint16_t>(layout_.first_option + i));
      const bool positional = option.suffix[0] == '\0';
      if (!option.before && (positional ? has_written_line() : chosen(option))) {
        read_items(option.first_item, option.item_count);
      }
    }
    if (missing_ > 0) report_missing();

    std::stable_sort(card_->lines.begin(), card_->lines.end(),
                     [](const auto& a, const auto& b) { return a.first_field < b.first_field; });
    card_->owner =
        expanded_ ? std::make_shared<std::pair<std::shared_ptr<const void>, std::shared_ptr<const void>>>(
                        deck_, expanded_)
                  : std::shared_ptr<const void>(deck_);
    return Card(card_);
  }

  bool chosen(const table::Option& option) const {
    return std::any_of(options_->begin(), options_->end(),
                       [&](const std::string& s) { return table::among(option.suffix, s, '|'); });
  }

  /// Reads entries of the table one after the other; a group recurses.
  void read_items(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      const table::Item& item = *table::item(static_cast<std::uint16_t>(i));
      current_ = &item;
      if (holds(item, *this)) {
        switch (item.kind) {
          case table::Kind::line:
            read_lines(item);
            break;
          case table::Kind::series:
            read_series(item);
            break;
          case table::Kind::text:
            read_text(item);
            break;
          case table::Kind::group:
            read_group(item, i + 1);
            break;
        }
      }
      i += item.children;
    }
  }

  void read_group(const table::Item& item, std::size_t first) {
    const std::size_t count = repeats(item, *this);
    for (std::size_t k = 0; k < count; ++k) {
      if (!has_written_line()) {
        if (!item.to_end) note_missing(*table::item(static_cast<std::uint16_t>(first)));
        return;
      }
      const int before = line_.number;
      read_items(first, item.children);
      if (have_line_ && line_.number == before) break;  // nothing was there to read
    }
  }

  void read_lines(const table::Item& item) {
    const std::size_t count = repeats(item, *this);
    for (std::size_t k = 0; k < count; ++k) {
      if (item.to_end) {
        if (!has_written_line()) break;
        if (is_blank(line_.text)) {  // harmless between rows
          advance();
          continue;
        }
      }
      if (!have_line_) {
        if (!item.optional) note_missing(item);
        return;
      }
      read_line(item);
      advance();
    }
  }

  void read_line(const table::Item& item) {
    const table::Field* fields = fields_of(item);
    cutter_.cut(line_.text, fields, item.field_count, body_.format);
    if (item.field_count == 0) return;
    if (!cutter_.comma()) check_columns(fields, item.field_count);
    add_line(item, cutter_);
    if (!item.wrap || !cutter_.comma()) return;
    // A comma line may go on with further rows; anything but a value behind the last field is a remark.
    const std::string_view whole = line_.text;
    for (std::string_view rest = trim(cutter_.rest()); begins_value(rest); rest = trim(cutter_.rest())) {
      shift_ = static_cast<int>(rest.data() - whole.data());
      cutter_.cut(rest, fields, item.field_count, body_.format);
      if (!cutter_.comma()) break;
      add_line(item, cutter_);
    }
    shift_ = 0;
  }

  /// Values that do not stand in their columns are read one after the other where that is the only way.
  void check_columns(const table::Field* fields, std::size_t count) {
    const bool cut = cutter_.cuts_a_number();
    if (!cut && !has_broken_number(fields, count)) return;
    const Place place{body_.file, line_.number, 1,
                      static_cast<int>(std::min<std::size_t>(line_.text.size(), 80))};
    const char* const hint = "shift them into the columns, or write commas between them";
    if (cutter_.cut_at_blanks()) {
      diagnostics_.warning(
          place, block_.keyword, {},
          "the values do not stand in their columns; they were read one after the other, as blanks part them",
          hint);
    } else if (cut) {
      diagnostics_.warning(place, block_.keyword, {},
                           "a number runs over the border of its column; the columns were taken as they are",
                           hint);
    }
  }

  /// Is there a field that columns cut wrongly? References are judged when they are read.
  bool has_broken_number(const table::Field* fields, std::size_t count) const {
    double real = 0.0;
    std::int64_t integer = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::string_view text = cutter_.slice(k).text;
      if (text.empty() || fields[k].type == 'A' || is_reference(text)) continue;
      if ((fields[k].type == 'I' ? parse_integer(text, integer) : parse_real(text, real)) !=
          NumberState::good)
        return true;
    }
    return false;
  }

  void add_line(const table::Item& item, const FieldCutter& cutter) {
    const auto first_cell = static_cast<std::uint32_t>(card_->cells.size());
    card_->lines.push_back({item.first_field, item.field_count, first_cell, line_.number});
    for (std::size_t k = 0; k < item.field_count; ++k) {
      const table::Field& field = table::field(layout_, item.first_field + k);
      Slice slice = cutter.slice(k);
      slice.column += shift_;
      Cell cell;
      cell.column = slice.column;
      cell.width = static_cast<std::uint16_t>(std::min(slice.width, 65535));
      if (!slice.text.empty()) {
        read_cell(slice, field, cell);
        cell.unreadable = !cell.given;
      }
      card_->cells.push_back(cell);
      latest_[item.first_field + k] = first_cell + static_cast<std::uint32_t>(k);
    }
  }

  void read_cell(const Slice& slice, const table::Field& field, Cell& cell) {
    const Place place{body_.file, line_.number, slice.column, slice.width};
    const std::string_view name = table::first_name(field.name);
    if (field.type == 'I') {
      cell.given = read_value(slice.text, context_, name, place, cell.integer);
    } else if (field.type == 'F') {
      cell.given = read_value(slice.text, context_, name, place, cell.real);
    } else {
      std::string_view value = slice.text;
      constexpr int title = 40;  // in a title & is a letter like any other
      if (value[0] == '&' && value.size() > 1 && field.width < title) {
        const std::string* text = read_text_reference(value, context_, name, place);
        if (text == nullptr) return;
        value = *text;
      }
      cell.text = value.data();
      cell.size = static_cast<std::uint32_t>(
          std::min<std::size_t>(value.size(), std::numeric_limits<std::uint32_t>::max()));
      cell.given = true;
    }
  }

  void read_series(const table::Item& item) {
    const std::size_t wanted = repeats(item, *this);
    const table::Field& field = table::field(layout_, item.first_field);
    Card::Data::Series* series = nullptr;
    for (Card::Data::Series& s : card_->series) {
      if (s.field == item.first_field) series = &s;
    }
    if (series == nullptr) {
      card_->series.push_back({item.first_field, have_line_ ? line_.number : body_.first_line, {}, {}});
      series = &card_->series.back();
    }
    for (std::size_t done = 0; done < wanted;) {
      if (!has_written_line() && (item.to_end || !have_line_)) {
        if (!item.optional && done == 0) note_missing(item);
        return;
      }
      done += read_series_line(item, field, wanted - done, *series);
      advance();
    }
  }

  /// One line of a series; gives the number of values it counts for.
  std::size_t read_series_line(const table::Item& item, const table::Field& field, std::size_t wanted,
                               Card::Data::Series& series) {
    const bool integer = field.type == 'I';
    const std::size_t start = integer ? series.integers.size() : series.reals.size();
    const auto resize = [&](std::size_t n) {
      integer ? series.integers.resize(start + n) : series.reals.resize(start + n);
    };
    std::size_t count = 0;
    cut_series(line_.text, item, body_.format, wanted, [&](std::size_t position, const Slice& slice) {
      resize(count = position + 1);
      const Place place{body_.file, line_.number, slice.column, slice.width};
      if (integer)
        read_value(slice.text, context_, table::first_name(field.name), place, series.integers.back());
      else
        read_value(slice.text, context_, table::first_name(field.name), place, series.reals.back());
    });
    // A counted series keeps its positions, so blanks at the end of a line count; ids are only padded.
    if (!item.to_end) resize(count = std::max(count, std::min<std::size_t>(item.per_line, wanted)));
    return std::max<std::size_t>(1, count);
  }

  void read_text(const table::Item& item) {
    for (; has_written_line(); advance()) {
      Cell cell;
      cell.text = line_.text.data();
      cell.size = static_cast<std::uint32_t>(
          std::min<std::size_t>(line_.text.size(), std::numeric_limits<std::uint32_t>::max()));
      cell.column = 1;
      cell.given = true;
      card_->lines.push_back(
          {item.first_field, 1, static_cast<std::uint32_t>(card_->cells.size()), line_.number});
      card_->cells.push_back(cell);
    }
  }

  void note_missing(const table::Item& item) {
    if (missing_++ == 0) first_missing_ = table::first_name(fields_of(item)->name);
  }

  void report_missing() {
    const std::string count = missing_ == 1 ? "a line is" : std::to_string(missing_) + " lines are";
    diagnostics_.warning(block_.place, block_.keyword, std::string(first_missing_),
                         count + " missing, from the one that begins with " + std::string(first_missing_) +
                             "; their fields take the defaults",
                         "an empty line stands for a card full of defaults");
  }

  void report_surplus() {
    if (!has_written_line()) return;
    const Line first = line_;
    std::size_t count = 0;
    for (; has_written_line(); have_line_ = cursor_.next(line_)) {
      if (!is_blank(line_.text)) ++count;
    }
    diagnostics_.warning(
        {body_.file, first.number, 1, static_cast<int>(std::min<std::size_t>(first.text.size(), 80))},
        block_.keyword, {},
        count == 1
            ? "this line is not read: the keyword has no more cards"
            : "from here on " + std::to_string(count) + " lines are not read: the keyword has no more cards",
        "for a second data set repeat the keyword; remarks begin with $");
  }

  std::shared_ptr<const Deck::Data> deck_;
  const Block& block_;
  const Body& body_;
  std::shared_ptr<const std::vector<std::string>> options_;
  const table::Keyword& layout_;
  Diagnostics& diagnostics_;
  LineCursor cursor_;
  ValueContext context_;
  Line line_;
  bool have_line_ = false;
  int last_written_ = 0;
  std::vector<std::uint32_t> latest_;  ///< cell last read for each field of the set
  const table::Item* current_ = nullptr;
  std::shared_ptr<Card::Data> card_;
  FieldCutter cutter_;
  int shift_ = 0;  ///< columns in front of the further rows of a comma line
  std::shared_ptr<std::deque<std::string>> expanded_;
  std::size_t missing_ = 0;
  std::string_view first_missing_;
};

}  // namespace

std::vector<Card> read_cards(const std::shared_ptr<const Deck::Data>& deck, std::size_t block,
                             Diagnostics& diagnostics) {
  if (!may_read(*deck, block, diagnostics)) return {};
  return CardReader(deck, block, diagnostics).run();
}

}  // namespace cleave::deck
