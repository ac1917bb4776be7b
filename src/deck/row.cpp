/// Streams the rows of bulk keywords without storing them.

#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "deck/deck_data.hpp"
#include "deck/keyword_name.hpp"

namespace cleave::deck {
namespace {

constexpr int solid_fields = 12;  ///< EID PID N1..N10

}  // namespace

/// The line at hand, cut on demand.
struct Row::Reader {
  ValueContext context;
  Line lines[2];  ///< the second only for the two-line form of solids
  const table::Field* fields[2] = {nullptr, nullptr};
  int counts[2] = {0, 0};  ///< fields on each line
  bool comma[2] = {false, false};
  FieldCutter cutters[2];
  Format format = Format::standard;
  std::string expanded[2];

  /// Sets one of the two lines.
  void set(int which, const Line& line, const table::Field* layout, int count) {
    lines[which] = line;
    fields[which] = layout;
    counts[which] = count;
    const auto n = static_cast<std::size_t>(count);
    const Columns last = columns_of(layout[n - 1], format);
    if (line.text.find('\t') != std::string_view::npos) {
      context.diagnostics->warning(
          {context.file, line.number, static_cast<int>(line.text.find('\t')) + 1, 1},
          std::string(context.keyword), {},
          "the line has tabs; each was taken as blanks up to the next multiple of 8 columns",
          "write blanks, or commas between the values");
      expanded[which] = expand_tabs(line.text);
      lines[which].text = expanded[which];
    }
    comma[which] = find_format_comma(lines[which].text, last.offset + last.width) != std::string_view::npos;
    if (comma[which]) cutters[which].cut(lines[which].text, layout, n, format);
    comma[which] = comma[which] && cutters[which].comma();
  }

  /// Which line holds field `n`; `n` becomes its number there.
  int line_of(int& n) const {
    if (counts[1] == 0 || n < counts[0]) return 0;
    n -= counts[0];
    return 1;
  }

  Slice slice(int which, int n) const {
    const auto k = static_cast<std::size_t>(n);
    if (n < 0 || n >= counts[which]) return {};
    if (comma[which]) return cutters[which].slice(k);
    const Columns columns = columns_of(fields[which][k], format);
    const std::string_view text = lines[which].text;
    if (columns.offset >= text.size())
      return {{}, static_cast<int>(columns.offset) + 1, static_cast<int>(columns.width)};
    return {trim(text.substr(columns.offset, columns.width)), static_cast<int>(columns.offset) + 1,
            static_cast<int>(columns.width)};
  }

  template <class Value>
  Value value(int n) const {
    const int which = line_of(n);
    const Slice s = slice(which, n);
    Value result{};
    if (s.text.empty()) return result;
    // The common case first; the slow way reports what is wrong.
    NumberState state;
    if constexpr (std::is_same_v<Value, double>)
      state = parse_real(s.text, result);
    else
      state = parse_integer(s.text, result);
    if (state == NumberState::good) return result;
    const std::string_view name = table::first_name(fields[which][n].name);
    return read_value(s.text, context, name, {context.file, lines[which].number, s.column, s.width}, result)
               ? result
               : Value{};
  }
};

std::int64_t Row::integer(int field) const {
  return reader->value<std::int64_t>(field);
}
double Row::real(int field) const {
  return reader->value<double>(field);
}

bool Row::given(int field) const {
  const int which = reader->line_of(field);
  return !reader->slice(which, field).text.empty();
}

int Row::field_count() const {
  for (int n = reader->counts[0] + reader->counts[1]; n > 0; --n) {
    if (given(n - 1)) return n;
  }
  return 0;
}

Place Row::place() const {
  return {reader->context.file, reader->lines[0].number, 0, 0};
}

Place Row::place(int field) const {
  const int which = reader->line_of(field);
  const Slice s = reader->slice(which, field);
  return {reader->context.file, reader->lines[which].number, s.column, s.width};
}

void Deck::rows(const Block& block, Diagnostics& diagnostics,
                const std::function<void(const Row&)>& take) const {
  CLEAVE_ASSERT(block.index < data_->blocks.size() && block.known,
                "rows of a keyword that is not in the table");
  const table::Keyword& layout = *table::find(block.keyword);
  const table::Item* items = table::item(layout.first_item);
  const bool solid = block.keyword == "ELEMENT_SOLID";
  CLEAVE_ASSERT(solid || (layout.item_count == 1 && layout.repeat_set && items->kind == table::Kind::line &&
                          block.options.empty()),
                "rows are for keywords whose data set is one line");

  const Body& body = data_->bodies[block.index];
  if (!may_read(*data_, block.index, diagnostics)) return;
  const Text& text = *data_->sources.storage->texts[static_cast<std::size_t>(body.file)];
  const char* taken = body.begin;
  Row::Reader reader;
  reader.context = {&data_->parameters, &data_->sources, &diagnostics, block.keyword, body.file, body.epoch};
  reader.format = body.format;
  Row row;
  row.transform = block.transform;
  row.reader = &reader;
  const auto fields_of = [&](int item) { return &table::field(layout, items[item].first_field); };
  const int count = items[0].field_count;

  Line line;
  for (LineCursor lines(body); lines.next(line);) {
    if (static_cast<std::size_t>(line.text.data() - taken) >= Text::stretch)
      text.give_back(std::exchange(taken, line.text.data()), line.text.data());
    if (is_blank(line.text)) continue;  // nobody means an entity without an id
    reader.set(0, line, fields_of(0), count);
    reader.counts[1] = 0;
    // A solid with no more than two values on its line has its nodes on the next one.
    if (solid && !begins_value(reader.slice(0, 2).text)) {
      Line nodes;
      bool found = lines.next(nodes);
      while (found && is_blank(nodes.text)) found = lines.next(nodes);
      if (!found) {
        diagnostics.error(
            {body.file, line.number, 1, static_cast<int>(std::min<std::size_t>(line.text.size(), 80))},
            block.keyword, "N1", "the element has no line with its nodes");
        return;
      }
      reader.set(0, line, fields_of(1), 2);
      reader.set(1, nodes, fields_of(2), solid_fields - 2);
    }
    take(row);
  }
  if (taken != body.begin) text.give_back(taken, body.end);
}

}  // namespace cleave::deck
