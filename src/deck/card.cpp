#include "deck/card.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "deck/card_data.hpp"

namespace cleave::deck {
namespace {

bool named(const table::Field& field, std::string_view name) {
  return table::among(field.name, name, '/');
}

/// The lines that hold the field of this number, as a range.
auto lines_of(const std::vector<Card::Data::LineRead>& lines, std::size_t field) {
  using LineRead = Card::Data::LineRead;
  const auto last = std::partition_point(lines.begin(), lines.end(),
                                         [&](const LineRead& l) { return l.first_field <= field; });
  auto first = last;
  if (first != lines.begin()) {
    const auto start = (last - 1)->first_field;
    first =
        std::partition_point(lines.begin(), last, [&](const LineRead& l) { return l.first_field < start; });
    if (field >= std::size_t{start} + (last - 1)->field_count) first = last;
  }
  return std::pair(first, last);
}

}  // namespace

const Cell* Card::Data::cell(std::string_view name, std::size_t row, const table::Field*& field,
                             const LineRead*& line) const {
  field = nullptr;
  line = nullptr;
  for (std::size_t f = 0; f < layout->field_count; ++f) {
    if (!named(table::field(*layout, f), name)) continue;
    if (field == nullptr) field = &table::field(*layout, f);
    const auto [first, last] = lines_of(lines, f);
    const auto count = static_cast<std::size_t>(last - first);
    if (row < count) {
      field = &table::field(*layout, f);
      line = &first[static_cast<std::ptrdiff_t>(row)];
      return &cells[line->first_cell + (f - line->first_field)];
    }
    row -= count;  // the same name may stand in alternative lines
  }
  CLEAVE_ASSERT(field != nullptr, "the layout of this keyword has no such field");
  return nullptr;
}

const Card::Data::Series* Card::Data::find_series(std::string_view name) const {
  for (const Series& s : series) {
    if (named(table::field(*layout, s.field), name)) return &s;
  }
  return nullptr;
}

const std::string& Card::keyword() const {
  return data_->keyword;
}

bool Card::option(std::string_view suffix) const {
  return std::find(data_->options->begin(), data_->options->end(), suffix) != data_->options->end();
}

bool Card::has_field(std::string_view name) const {
  for (std::size_t f = 0; f < data_->layout->field_count; ++f) {
    if (named(table::field(*data_->layout, f), name)) return true;
  }
  return false;
}

double Card::real(std::string_view name, std::size_t row) const {
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  if (cell == nullptr || !cell->given) return field->number;
  return field->type == 'I' ? static_cast<double>(cell->integer) : field->type == 'F' ? cell->real : 0.0;
}

std::int64_t Card::integer(std::string_view name, std::size_t row) const {
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  if (cell != nullptr && cell->given && field->type == 'I') return cell->integer;
  const double value = cell == nullptr || !cell->given ? field->number
                       : field->type == 'F'            ? cell->real
                                                       : 0.0;
  return std::fabs(value) < 9.2e18 ? static_cast<std::int64_t>(value) : 0;
}

std::string_view Card::text(std::string_view name, std::size_t row) const {
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  if (cell == nullptr || !cell->given || field->type != 'A') return field->text;
  return {cell->text, cell->size};
}

bool Card::given(std::string_view name, std::size_t row) const {
  if (const Data::Series* s = data_->find_series(name)) return row < s->reals.size() + s->integers.size();
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  return cell != nullptr && cell->given;
}

bool Card::unreadable(std::string_view name, std::size_t row) const {
  if (data_->find_series(name)) return false;
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  return cell != nullptr && cell->unreadable;
}

std::size_t Card::row_count(std::string_view name) const {
  if (const Data::Series* s = data_->find_series(name)) return s->reals.size() + s->integers.size();
  std::size_t count = 0;
  for (std::size_t f = 0; f < data_->layout->field_count; ++f) {
    if (!named(table::field(*data_->layout, f), name)) continue;
    const auto [first, last] = lines_of(data_->lines, f);
    count += static_cast<std::size_t>(last - first);
  }
  return count;
}

std::span<const std::int64_t> Card::integers(std::string_view name) const {
  const Data::Series* s = data_->find_series(name);
  CLEAVE_ASSERT(s != nullptr || has_field(name), "the layout of this keyword has no such series");
  return s == nullptr ? std::span<const std::int64_t>() : s->integers;
}

std::span<const double> Card::reals(std::string_view name) const {
  const Data::Series* s = data_->find_series(name);
  CLEAVE_ASSERT(s != nullptr || has_field(name), "the layout of this keyword has no such series");
  return s == nullptr ? std::span<const double>() : s->reals;
}

Place Card::place() const {
  return data_->place;
}

Place Card::place(std::string_view name, std::size_t row) const {
  if (const Data::Series* s = data_->find_series(name)) return {data_->place.file, s->line, 0, 0};
  const table::Field* field = nullptr;
  const Data::LineRead* line = nullptr;
  const Cell* cell = data_->cell(name, row, field, line);
  if (cell == nullptr) return data_->place;
  return {data_->place.file, line->line, cell->column, cell->width};
}

std::vector<std::string> Card::given_fields() const {
  std::vector<std::string> names;
  const auto add = [&](std::size_t f) {
    std::string name(table::first_name(table::field(*data_->layout, f).name));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  };
  // Lines are sorted by field, so each kind of line is looked at as one range.
  std::vector<bool> given(data_->layout->field_count, false);
  for (const Data::LineRead& line : data_->lines) {
    for (std::size_t k = 0; k < line.field_count; ++k) {
      if (data_->cells[line.first_cell + k].given) given[line.first_field + k] = true;
    }
  }
  for (const Data::Series& s : data_->series) {
    if (!s.integers.empty() || !s.reals.empty()) given[s.field] = true;
  }
  for (std::size_t f = 0; f < given.size(); ++f) {
    if (given[f]) add(f);
  }
  return names;
}

}  // namespace cleave::deck
