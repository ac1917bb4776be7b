#pragma once
/// What a card holds: the lines that were read, their cells, and the layout that names them.

#include <memory>
#include <string>
#include <vector>

#include "deck/card.hpp"
#include "deck/layout_table.hpp"

namespace cleave::deck {

struct Cell {
  union {
    std::int64_t integer;
    double real;
    const char* text;  ///< of type A
  };
  std::uint32_t size = 0;   ///< of the text
  std::int32_t column = 0;  ///< from 1
  std::uint16_t width = 0;
  bool given = false;       ///< something was written and could be read
  bool unreadable = false;  ///< something was written that could not be read; a diagnostic has said so
  Cell() : integer(0) {}
};

struct Card::Data {
  struct LineRead {
    std::uint16_t first_field;  ///< of the layout
    std::uint16_t field_count;
    std::uint32_t first_cell;
    std::int32_t line;
  };
  struct Series {
    std::uint16_t field;
    std::int32_t line;
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
  };

  const table::Keyword* layout = nullptr;
  std::string keyword;
  std::shared_ptr<const std::vector<std::string>> options;
  Place place;
  std::vector<LineRead> lines;  ///< sorted by first_field, rows in reading order
  std::vector<Cell> cells;
  std::vector<Series> series;
  std::shared_ptr<const void> owner;  ///< keeps the texts alive

  /// The cell of a field in a row; nullptr where its line is absent. `field` is set to the layout's entry.
  const Cell* cell(std::string_view name, std::size_t row, const table::Field*& field,
                   const LineRead*& line) const;
  const Series* find_series(std::string_view name) const;
};

}  // namespace cleave::deck
