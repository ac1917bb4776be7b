#include "results/report_history.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "results/report_file.hpp"

namespace cleave::results {
namespace {

/// Splits at commas into `cells`; a trailing carriage return does not count.
void split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  if (line.ends_with('\r')) line.remove_suffix(1);
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    if (end == line.size()) return;
    begin = end + 1;
  }
}

double number(std::string_view cell) {
  while (cell.starts_with(' ') || cell.starts_with('+')) cell.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::size_t HistoryTable::rows() const {
  std::size_t count = 0;
  for (const Entity& entity : entities) count += entity.column.front().size();
  return count;
}

std::optional<HistoryTable> read_history(const std::filesystem::path& file) {
  const std::optional<std::string> bytes = read_whole(file);
  if (!bytes) return std::nullopt;
  const std::string& text = *bytes;

  HistoryTable table;
  table.name = file.stem().string();
  std::vector<std::string_view> cells;
  std::size_t width = 0, id_column = std::string::npos;
  std::unordered_map<long long, std::size_t> entity_of;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    split(std::string_view(text).substr(begin, end - begin), cells);
    begin = end + 1;
    if (width == 0) {  // the header
      width = cells.size();
      for (std::size_t c = 0; c < width; ++c) {
        if (cells[c] == "id")
          id_column = c;
        else
          table.columns.emplace_back(cells[c]);
      }
      continue;
    }
    if (cells.size() != width) {
      table.broken_rows += cells.size() > 1 || !cells[0].empty();
      continue;
    }
    const long long id = id_column < width ? static_cast<long long>(number(cells[id_column])) : 0;
    const auto [at, is_new] = entity_of.try_emplace(id, table.entities.size());
    if (is_new) table.entities.push_back({id, std::vector<std::vector<double>>(table.columns.size())});
    auto column = table.entities[at->second].column.begin();
    for (std::size_t c = 0; c < width; ++c)
      if (c != id_column) (column++)->push_back(number(cells[c]));
  }
  if (table.entities.empty()) return std::nullopt;
  return table;
}

std::size_t thin(HistoryTable& table, std::size_t wanted) {
  const std::size_t stride = (table.rows() + wanted - 1) / std::max<std::size_t>(wanted, 1);
  if (stride <= 1) return 1;
  for (HistoryTable::Entity& entity : table.entities) {
    for (std::vector<double>& column : entity.column) {
      std::size_t kept = 0;
      for (std::size_t row = 0; row < column.size(); ++row)
        if (row % stride == 0 || row + 1 == column.size()) column[kept++] = column[row];
      column.resize(kept);
    }
  }
  return stride;
}

}  // namespace cleave::results
